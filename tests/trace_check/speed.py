"""Is checking slower than simulating? Gases of 10^2, 10^3 and 10^4 spheres, run and checked one after the other.

Prints a line of docs/check.md for each: wall-clock times of `tps run -o` and `tps check`, their ratio, microseconds of
processor time an event, and the largest memory of the check. --events N sets the events of the gas of 10^3 spheres (10^6 is
the documented figure and takes minutes), that of 10^2 has
a tenth of them and that of 10^4 a fiftieth.
"""

import argparse
import os
import subprocess
import tempfile
import time


def timed(command):
    """Seconds of wall clock and of processor time of a command, and its largest memory in MB."""
    start = time.perf_counter()
    with subprocess.Popen(command, stdout=subprocess.DEVNULL) as process:
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        raise SystemExit(f"{' '.join(command)} returned {process.returncode}")
    return time.perf_counter() - start, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("tps")
    parser.add_argument("--events", type=int, default=20000)
    arguments = parser.parse_args()
    tps = arguments.tps
    with tempfile.TemporaryDirectory() as folder:
        scene, trace = os.path.join(folder, "gas.json"), os.path.join(folder, "gas.ndjson")
        for particles, events in ((100, arguments.events // 10), (1000, arguments.events), (10000, arguments.events // 50)):
            subprocess.run([tps, "scene", "gas", "--particles", str(particles), "--duration", "inf", "-o", scene], check=True)
            run, _, _ = timed([tps, "run", scene, "-q", "--max-events", str(events), "-o", trace])
            check, processor, memory = timed([tps, "check", "-q", trace])
            print(f"| {particles} | {events} | {run:.2f} s | {check:.2f} s | {check / run:.2f} | "
                  f"{1e6 * processor / events:.0f} | {memory:.0f} MB |", flush=True)


if __name__ == "__main__":
    main()
