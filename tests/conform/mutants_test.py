#!/usr/bin/env python3
"""Every wrong adapter of mutants.py fails `tps conform` in the operation that it breaks, with the hypothesis that fits; the right ones pass.

  mutants_test.py TPS SOURCE [--only NAME]
"""
import argparse
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

from mutants import RIGHT, WRONG


def mutate(adapters, mutant):
    path = adapters / mutant.file
    text = path.read_text()
    if text.count(mutant.old) != 1:
        raise SystemExit(f"{mutant.name}: {mutant.file} has {text.count(mutant.old)} times: {mutant.old}")
    path.write_text(text.replace(mutant.old, mutant.new))


def report_on(tps, source, mutant):
    with tempfile.TemporaryDirectory() as folder:
        adapters = pathlib.Path(folder) / "python"
        shutil.copytree(source / "data/adapters/python", adapters, ignore=shutil.ignore_patterns("__pycache__"))
        mutate(adapters, mutant)
        command = [tps, "conform", "--quiet", "--level", "1", "--cases", "5", "--shrink-seconds", "0", "--format", "json",
                   "--ops", mutant.asked(), "--", sys.executable, "-B", str(adapters / "scalar.py")]
        done = subprocess.run(command, capture_output=True, timeout=60)
        if not done.stdout:
            raise SystemExit(f"{mutant.name}: {done.stderr.decode()}")
        return done.returncode, json.loads(done.stdout)


def faults_of_wrong(mutant, code, report):
    rows = [row for row in report["rows"] if row["classes"][mutant.kind] > 0]
    if code != 1:
        yield f"exit code {code}: {report['sentence']}"
    if not rows:
        yield f"no row is {mutant.kind}"
    found = {name for row in rows for name in row.get("equals", [])}
    if mutant.equals and mutant.equals not in found:
        yield f"hypotheses {sorted(found)}, expected {mutant.equals}"


def faults_of_right(mutant, code, report):
    if code != 0:
        yield f"exit code {code}: {report['sentence']}"
        for row in report["rows"]:
            if not row["accepted"]:
                yield json.dumps(row.get("example"))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("tps")
    parser.add_argument("source", type=pathlib.Path)
    parser.add_argument("--only")
    options = parser.parse_args()
    bad = 0
    for mutants, faults in ((WRONG, faults_of_wrong), (RIGHT, faults_of_right)):
        for mutant in mutants:
            if options.only and mutant.name != options.only:
                continue
            code, report = report_on(options.tps, options.source, mutant)
            for fault in faults(mutant, code, report):
                print(f"{mutant.name}: {fault}")
                bad += 1
    print(f"{len(WRONG)} wrong adapters, {len(RIGHT)} right ones: {bad} faults")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
