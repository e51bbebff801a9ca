#!/usr/bin/env python3
"""How many known answers `tps conform` asks a second of `tps serve`: by the clock, and by its own processor time.

  rate.py TPS [OPERATION…]

The clock says little on a busy machine. Making the questions and judging the answers is not in it; what `tps serve` takes is
printed by tests/protocol/bulk.py.
"""
import json
import subprocess
import sys

tps, *operations = sys.argv[1:]
tags = ",".join(f"{op}.*" for op in operations or ["block_time", "tether_time"])
done = subprocess.run([tps, "conform", "--quiet", "--level", "2", "--tags", tags, "--format", "json", "--", tps, "serve"], capture_output=True, check=True)
report = json.loads(done.stdout)
asked, environment = report["asked"], report["environment"]
print(f"{asked} cases: {asked / environment['seconds']:.0f} a second by the clock, {asked / environment['cpu_seconds']:.0f} a second of processor time")
