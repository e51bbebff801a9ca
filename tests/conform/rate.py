#!/usr/bin/env python3
"""How many known answers a second `tps conform` asks of `tps serve`.

  rate.py TPS [--least RATE] [--ops OPERATION,…]

First the asking alone, by the clock and by processor time of `tps conform`. Then all of it, the questions made and proved, asked, answered and judged: by
the clock, and by processor time of both programs; the same with one stratum is taken off, so that starting them is not in it. The clock says little on a
busy machine. What `tps serve` takes is printed by tests/protocol/bulk.py. With --least fewer than that a second of processor time, of asking, fail.
"""
import argparse
import json
import resource
import subprocess
import sys
import time

parser = argparse.ArgumentParser()
parser.add_argument("tps")
parser.add_argument("--least", type=float, default=0)
parser.add_argument("--ops", default="block_time,tether_time")
options = parser.parse_args()
ops = options.ops.split(",")


def asked(tags):
    """The report, and the seconds that it took by the clock and by processors."""
    def now():
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        return time.monotonic(), used.ru_utime + used.ru_stime
    before = now()
    done = subprocess.run([options.tps, "conform", "--quiet", "--level", "2", "--tags", tags, "--format", "json", "--", options.tps, "serve"],
                          capture_output=True, check=True)
    return json.loads(done.stdout), [after - start for start, after in zip(before, now())]


few, taken_by_few = asked(f"{ops[0]}.plain")
report, taken = asked(",".join(f"{op}.*" for op in ops))
cases, environment = report["asked"], report["environment"]
by_clock, by_processor = (cases / environment[key] for key in ("seconds", "cpu_seconds"))
print(f"{cases} cases asked: {by_clock:.0f} a second by the clock, {by_processor:.0f} a second of processor time")
by_clock_in_all, by_processor_in_all = ((cases - few["asked"]) / (one - other) for one, other in zip(taken, taken_by_few))
print(f"made, proved, asked, answered and judged: {by_clock_in_all:.0f} a second by the clock, {by_processor_in_all:.0f} a second of processor time")
sys.exit(by_processor < options.least)
