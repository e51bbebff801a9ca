"""Deliberate bugs (mutants.json): is each still there to be made, what does its source look like, which law kills it.

  mutate.py check ROOT              each text to be replaced stands exactly once in its file, and each effect of the engine
                                    has two mutants: in its file, or with its name as "effect"
  mutate.py overlay NAME ROOT OUT   writes OUT/FILE with the bug NAME
  mutate.py table ROOT PROGRAMS [--cases N] [--seed S] [--only NAME …] [--write PAGE]
                                    runs the laws on every mutant built in PROGRAMS, prints which law killed it after
                                    how many cases; exit code 1 if one survives
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys

LIST = pathlib.Path(__file__).with_name("mutants.json")
TESTS = ("statistics", "cells")  # programs of tests, the others have laws
TIMEOUT = 300  # seconds for one law on one mutant; the laws themselves take less than ten


def mutants():
    return json.loads(LIST.read_text(encoding="utf-8"))


def faults(root):
    names = [mutant["name"] for mutant in mutants()]
    for name in sorted({name for name in names if names.count(name) > 1}):
        yield f"{LIST.name}: {name} stands there twice; every mutant has a name of its own"
    for mutant in mutants():
        source = (root / mutant["file"]).read_text(encoding="utf-8")
        count = source.count(mutant["find"])
        if count != 1:
            yield (f"{LIST.name}: {mutant['name']}: the text to be replaced stands {count} times in {mutant['file']}, "
                   f"allowed: once; change \"find\" to what the source now says:\n{mutant['find']}")
        if mutant["find"] == mutant["replace"]:
            yield f"{LIST.name}: {mutant['name']}: replaces a text by itself"
    of_effect = [mutant.get("effect", pathlib.PurePath(mutant["file"]).stem) for mutant in mutants()]
    for effect in sorted(path.stem for path in (root / "reference/engine/effects").glob("*.hpp")):
        if of_effect.count(effect) < 2:
            yield f"{LIST.name}: {of_effect.count(effect)} mutants of the effect {effect}; allowed: two or more; add one"


def write_overlay(name, root, out):
    mutant = next(mutant for mutant in mutants() if mutant["name"] == name)
    source = (root / mutant["file"]).read_text(encoding="utf-8")
    if source.count(mutant["find"]) != 1:
        sys.exit("\n".join(faults(root)))
    target = out / mutant["file"]
    target.parent.mkdir(parents=True, exist_ok=True)
    text = source.replace(mutant["find"], mutant["replace"])
    # Left alone where nothing has changed, so that a new entry in the list builds no other mutant again.
    if not target.exists() or target.read_text(encoding="utf-8") != text:
        target.write_text(text, encoding="utf-8")


def tests_of(program):
    """Names of the tests of a GoogleTest program that run the reference in double."""
    listing = subprocess.run([program, "--gtest_list_tests"], capture_output=True, text=True, check=True).stdout
    suite = ""
    for line in listing.splitlines():
        if re.match(r"^\S+\.$", line):
            suite = line
        elif line.startswith("  "):
            yield suite + line.split()[0]


def law_of(test):
    if found := re.search(r"Law(\d+)(\w+)$", test):
        return f"law {found[1]} {found[2]}"
    if found := re.search(r"OutlookRuns\.(\w+)/(\w+)$", test):
        how = re.sub("(?<!^)([A-Z])", r" \1", found[1]).lower()
        return f"runs with {found[2].replace('_', ' ')} {how}"
    return test.split(".")[0]


def case_of_death(program, test, parameters):
    """After how many cases a test fails; None where it passes."""
    environment = os.environ | {"RC_PARAMS": parameters}
    try:
        run = subprocess.run([program, f"--gtest_filter={test}"], capture_output=True, text=True, env=environment,
                             timeout=TIMEOUT, errors="replace", check=False)
    except subprocess.TimeoutExpired:
        return "hangs"
    if run.returncode == 0:
        return None
    found = re.search(r"Falsifiable after (\d+) test", run.stdout)
    return int(found[1]) if found else "crashes" if run.returncode < 0 else "fails"


def killers(mutant, programs, parameters):
    """(law, cases) of every law that kills a mutant, the quickest first."""
    deaths = []
    for kind in mutant["programs"]:
        program = programs / f"mutant_{mutant['name']}_{kind}"
        for test in tests_of(program):
            cases = case_of_death(program, test, parameters)
            if cases is not None:
                deaths.append((test if kind in TESTS else law_of(test), cases))
    return sorted(deaths, key=lambda death: (not isinstance(death[1], int), death[1] if isinstance(death[1], int) else 0))


def row(mutant, deaths):
    told = ", ".join(f"{law} ({cases})" for law, cases in deaths) or "**survives**"
    file = pathlib.PurePath(mutant["file"]).name
    return f"| `{mutant['name']}` | `{file}` | {mutant['sentence']} | {told} |"


def table(options):
    chosen = [m for m in mutants() if not options.only or m["name"] in options.only]
    parameters = f"seed={options.seed} max_success={options.cases} noshrink=1"
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        found = list(pool.map(lambda m: killers(m, options.programs, parameters), chosen))
    lines = ["| mutant | in | what is wrong | killed by (after so many cases) |", "|---|---|---|---|"]
    lines += [row(mutant, deaths) for mutant, deaths in zip(chosen, found)]
    print("\n".join(lines))
    if options.write:
        page = options.write.read_text(encoding="utf-8")
        page = re.sub(r"(?ms)^\| mutant \|.*?(?=^$|\Z)", lambda _: "\n".join(lines) + "\n", page, count=1)
        options.write.write_text(page, encoding="utf-8")
    survivors = [mutant["name"] for mutant, deaths in zip(chosen, found) if not deaths]
    for name in survivors:
        print(f"mutate.py: {name} survives: no law fails in {options.cases} cases", file=sys.stderr)
    print(f"{len(chosen) - len(survivors)} of {len(chosen)} mutants killed", file=sys.stderr)
    return 1 if survivors else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    verbs = parser.add_subparsers(dest="verb", required=True)
    check = verbs.add_parser("check")
    check.add_argument("root", type=pathlib.Path)
    overlay = verbs.add_parser("overlay")
    overlay.add_argument("name")
    overlay.add_argument("root", type=pathlib.Path)
    overlay.add_argument("out", type=pathlib.Path)
    report = verbs.add_parser("table")
    report.add_argument("root", type=pathlib.Path)
    report.add_argument("programs", type=pathlib.Path)
    report.add_argument("--cases", type=int, default=200)
    report.add_argument("--seed", type=int, default=20260101)
    report.add_argument("--jobs", type=int, default=2)
    report.add_argument("--only", nargs="*")
    report.add_argument("--write", type=pathlib.Path)
    options = parser.parse_args()
    if options.verb == "overlay":
        write_overlay(options.name, options.root, options.out)
        return 0
    found = list(faults(options.root))
    if found:
        print("\n".join(found))
        return 1
    if options.verb == "check":
        print(f"{len(mutants())} mutants can be made")
        return 0
    return table(options)


if __name__ == "__main__":
    sys.exit(main())
