#!/usr/bin/env python3
"""Every wrong adapter of mutants.py and every wrong simulator of simulator_mutants.py fails `tps conform` where it is wrong, with the hypothesis
that fits; the right ones pass.

  mutants_test.py TPS SOURCE [--only NAME]
"""
import argparse
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

import mutants
import simulator_mutants


FLOAT = "float32 inside"


def mutate(adapters, mutant):
    for file, old, new in ((mutant.file, mutant.old, mutant.new), *getattr(mutant, "also", ())):
        path = adapters / file
        text = path.read_text()
        if text.count(old) != 1:
            raise SystemExit(f"{mutant.name}: {file} has {text.count(old)} times: {old}")
        path.write_text(text.replace(old, new))


def report_on(tps, source, mutant, program, *options):
    with tempfile.TemporaryDirectory() as folder:
        adapters = pathlib.Path(folder) / "python"
        shutil.copytree(source / "data/adapters/python", adapters, ignore=shutil.ignore_patterns("__pycache__"))
        mutate(adapters, mutant)
        command = [tps, "conform", "--quiet", "--level", getattr(mutant, "level", "1"), "--cases", "5", "--shrink-seconds", "0", "--format", "json", *options,
                   "--", sys.executable, "-B", "-E", "-S", str(adapters / program)]
        done = subprocess.run(command, capture_output=True, timeout=600)
        if not done.stdout:
            raise SystemExit(f"{mutant.name}: {done.stderr.decode()}")
        return done.returncode, json.loads(done.stdout)


def on_adapter(tps, source, mutant):
    return report_on(tps, source, mutant, "scalar.py", "--ops", mutant.asked())


def on_simulator(tps, source, mutant):
    return report_on(tps, source, mutant, "paper_loop.py", "--ops", mutant.ops, "--features", mutant.features, "--scenes", str(mutant.scenes),
                     "--first-scene", str(mutant.first))


def faults_of_wrong_adapter(mutant, code, report):
    rows = [row for row in report["rows"] if row["classes"][mutant.kind] > 0]
    if code != 1:
        yield f"exit code {code}: {report['sentence']}"
    if not rows:
        yield f"no row is {mutant.kind}"
    found = {name for row in rows for name in row.get("equals", [])}
    if mutant.equals and mutant.equals not in found:
        yield f"hypotheses {sorted(found)}, expected {mutant.equals}"
    if FLOAT in found and mutant.equals != FLOAT:
        yield f"{FLOAT} is named"


def faults_of_wrong_simulator(mutant, code, report):
    if code != (0 if mutant.kind == "OTHER READING" else 1):
        yield f"exit code {code}: {report['sentence']}"
    row = next((row for row in report["rows"] if row["name"] == mutant.row), None)
    if row is None or row["classes"][mutant.kind] == 0:
        yield f"{mutant.row} has no {mutant.kind}: {[r['name'] + ' ' + json.dumps(r['classes']) for r in report['rows']]}"
    elif mutant.says not in json.dumps(row, ensure_ascii=False):
        yield f"{mutant.row} does not say {mutant.says}: {row['example']['why']}"


def faults_of_right(mutant, code, report):
    if code != 0:
        yield f"exit code {code}: {report['sentence']}"
        for row in report["rows"]:
            if not row["accepted"]:
                yield json.dumps(row.get("example"))


TRIALS = ((mutants.WRONG, on_adapter, faults_of_wrong_adapter), (mutants.RIGHT, on_adapter, faults_of_right),
          (simulator_mutants.WRONG, on_simulator, faults_of_wrong_simulator), (simulator_mutants.RIGHT, on_simulator, faults_of_right))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("tps")
    parser.add_argument("source", type=pathlib.Path)
    parser.add_argument("--only")
    options = parser.parse_args()
    bad = 0
    for trial, ask, faults in TRIALS:
        for mutant in trial:
            if options.only and mutant.name != options.only:
                continue
            for fault in faults(mutant, *ask(options.tps, options.source, mutant)):
                print(f"{mutant.name}: {fault}")
                bad += 1
    wrong, right = (sum(len(t[0]) for t in TRIALS[k::2]) for k in (0, 1))
    print(f"{wrong} wrong programs, {right} right ones: {bad} faults")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
