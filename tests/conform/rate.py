#!/usr/bin/env python3
"""How many known answers `tps conform` asks a second of `tps serve`: by the clock, and by its own processor time.

  rate.py TPS [--least RATE] [--ops OPERATION,…]

The clock says little on a busy machine. Making the questions and judging the answers is not in it; what `tps serve` takes is
printed by tests/protocol/bulk.py. With --least fewer than that a second of processor time fail.
"""
import argparse
import json
import subprocess
import sys

parser = argparse.ArgumentParser()
parser.add_argument("tps")
parser.add_argument("--least", type=float, default=0)
parser.add_argument("--ops", default="block_time,tether_time")
options = parser.parse_args()
tags = ",".join(f"{op}.*" for op in options.ops.split(","))
done = subprocess.run([options.tps, "conform", "--quiet", "--level", "2", "--tags", tags, "--format", "json", "--", options.tps, "serve"],
                      capture_output=True, check=True)
report = json.loads(done.stdout)
asked, environment = report["asked"], report["environment"]
by_clock, by_processor = (asked / environment[key] for key in ("seconds", "cpu_seconds"))
print(f"{asked} cases: {by_clock:.0f} a second by the clock, {by_processor:.0f} a second of processor time")
sys.exit(by_processor < options.least)
