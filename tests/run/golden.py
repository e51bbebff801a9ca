#!/usr/bin/env python3
"""Compares the SHA-256 of every scene's trace with the recorded one (golden.json beside this file).

golden.py TPS SCENES [--write | --quick]

One line a scene, scalar of the hardware and timing. The same hashes hold for g++ and clang, with and without
optimisation: the engine uses +, -, *, / and sqrt, which IEEE 754 defines to the bit. Revolution alone asks the C
library for pow and tan, which it does not: "libm" in golden.json names the traces that do, and the C library
under which they were recorded; they are compared under that one only. --quick leaves out the long runs whose like is
compared in shorter ones: it takes a third of the time.
"""
import concurrent.futures
import hashlib
import json
import pathlib
import platform
import subprocess
import sys
import tempfile

RECORD = pathlib.Path(__file__).with_name("golden.json")
SCALARS = {"float": ("paper", "stable", "certified"), "double": ("paper", "stable", "certified"),
           "long-double": ("paper", "stable")}
# The terminal takes two thirds of the time. In double it is run with each timing; what is special about the other scalars
# shows in the other scenes.
LONG = {("terminal", "float"), ("terminal", "long-double")}


def trace_of(tps, scene, scalar, timing):
    """SHA-256 of the trace, and whether it asked libm. The header names the program's version: left out."""
    with tempfile.NamedTemporaryFile(suffix=".ndjson") as trace:
        done = subprocess.run([tps, "run", scene, "-q", "--scalar", scalar, "--timing", timing, "-o", trace.name],
                              capture_output=True, text=True)
        if done.returncode not in (0, 6):
            sys.exit(f"tps run {scene} --scalar {scalar} --timing {timing} exits {done.returncode}: {done.stderr}")
        lines = pathlib.Path(trace.name).read_bytes().splitlines(keepends=True)
    header = json.loads(lines[0])
    del header["version"]
    digest = hashlib.sha256(json.dumps(header, sort_keys=True).encode())
    for line in lines[1:]:
        digest.update(line)
    asks_libm = any(b'"kind":"revolve"' in line for line in lines)
    return digest.hexdigest(), asks_libm


def main():
    tps, scenes = sys.argv[1:3]
    runs = [(scene, scalar, timing) for scene in sorted(pathlib.Path(scenes).glob("*.json"))
            for scalar, timings in SCALARS.items() for timing in timings
            if "--quick" not in sys.argv or (scene.stem, scalar) not in LONG]
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        found = list(pool.map(lambda run: trace_of(tps, *run), runs))
    names = [f"{scene.stem} {scalar} {timing}" for scene, scalar, timing in runs]
    libc = " ".join(platform.libc_ver())
    if "--write" in sys.argv:
        record = {"libm": {"library": libc, "traces": [n for n, (_, asks) in zip(names, found) if asks]},
                  "sha256": {n: digest for n, (digest, _) in zip(names, found)}}
        RECORD.write_text(json.dumps(record, indent=1) + "\n")
        return
    record = json.loads(RECORD.read_text())
    same_libm = libc == record["libm"]["library"]
    left_out = [] if same_libm else record["libm"]["traces"]
    recorded = {n for n in record["sha256"] if "--quick" not in sys.argv or tuple(n.split()[:2]) not in LONG}
    wrong = sorted(set(names) ^ recorded)
    wrong += [n for n, (digest, _) in zip(names, found) if n not in left_out and record["sha256"].get(n) != digest]
    if left_out:
        print(f"not compared, since {libc} is not {record['libm']['library']}: {', '.join(left_out)}")
    if wrong:
        sys.exit("these traces are not the recorded ones: " + ", ".join(wrong) +
                 "\nIf that is meant, say why in the commit and record them: tests/run/golden.py TPS SCENES --write")
    print(f"{len(names) - len(left_out)} traces are the recorded ones")


if __name__ == "__main__":
    main()
