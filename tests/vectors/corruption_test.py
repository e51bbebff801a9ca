#!/usr/bin/env python3
"""Breaks one field of a case at a time; verify_vectors.py and `tps vectors verify` must both notice.

corruption_test.py PROGRAM SOURCE_DIR WORK_DIR
"""
import copy, glob, json, math, os, subprocess, sys

program, source, work = sys.argv[1:]
sys.path.insert(0, os.path.join(source, "data"))
import verify_vectors


def moved(text):
    return math.nextafter(float.fromhex(text), math.inf).hex()


def swapped(value, words):
    return next(w for w in words if w != value)


def corruptions(case):
    """Every wrong case made of a right one."""
    def broken(change):
        wrong = copy.deepcopy(case)
        change(wrong)
        return wrong

    if "verdict" in case:
        yield broken(lambda c: c.update(verdict=swapped(c["verdict"], ["hit", "miss"])))
        known = "z" if "z" in case["proof"] else "A"
        yield broken(lambda c: c["proof"].update({known: c["proof"][known].replace("p", "1p", 1)}))
        if "D" in case["proof"]:
            yield broken(lambda c: c["proof"].update(D=c["proof"]["D"] + 1))
    if case.get("t"):
        yield broken(lambda c: c.update(t=[moved(x) for x in c["t"]]))
        yield broken(lambda c: c.update(t=None))
    if "lo" in case.get("proof", {}):
        for key in ("lo", "hi", "mid"):
            yield broken(lambda c: c["proof"].update({key: 2}))
        if case["t"][0] != case["t"][1]:
            yield broken(lambda c: c.update(nearest=swapped(c["nearest"], ["lo", "hi"])))
        if case["t"][0] != case["t"][1] != "inf":
            yield broken(lambda c: c.update(t=[c["t"][0], moved(c["t"][1])]))
    if "order" in case:
        yield broken(lambda c: c.update(order=swapped(c["order"], ["before", "after"])))
        yield broken(lambda c: c.update(order=swapped(c["order"], ["equal", "none"])))
    for key in case.get("out", {}):
        yield broken(lambda c: c["out"].update({key: [[moved(x) for x in e] for e in c["out"][key]]}))
        yield broken(lambda c: c["out"].pop(key))
        ends = case["out"][key][0]
        if ends[0] != ends[1] and case["nearest"][key][0] != "mid":
            yield broken(lambda c: c["nearest"][key].__setitem__(0, swapped(c["nearest"][key][0], ["lo", "hi"])))
    for key in ("i", "j"):
        if key in case:
            yield broken(lambda c: c.update({key: c[key] + 1}))
    yield broken(lambda c: c.update(accpet=["R"]))
    yield broken(lambda c: c.update(rev=-1))
    yield broken(lambda c: c.update(level=7))
    if "out" in case:
        forged = {key: case[key] for key in ("kind", "out", "nearest") if key in case}
        yield broken(lambda c: c.update(also=c.get("also", []) + [forged]))
        yield broken(lambda c: c.update(also="x"))
        yield broken(lambda c: c.update(also=[1]))
    if "kind" in case and "also" not in case:
        yield broken(lambda c: c.update(kind=swapped(c["kind"], ["sticks", "slides"] if case["kind"] in ("sticks", "slides") else ["retract", "revolve"])))


def noticed(case, op):
    try:
        verify_vectors.check(case, op)
    except verify_vectors.BROKEN:
        return True
    return False


missed, made, lines = [], 0, []
for name in sorted(glob.glob(os.path.join(source, "data/vectors/*.jsonl"))):
    with open(name) as file:
        header = json.loads(next(file))
        wrong = [c for line in [next(file), next(file)] for c in corruptions(json.loads(line))]
    made += len(wrong)
    missed += [c["id"] for c in wrong if not noticed(c, header["op"])]
    lines += [json.dumps({**header, "count": len(wrong)})] + [json.dumps(c) for c in wrong]

path = os.path.join(work, "corrupted.jsonl")
with open(path, "w") as file:
    file.write("\n".join(lines) + "\n")
run = subprocess.run([program, "vectors", "verify", path], capture_output=True, text=True)
print(f"{made} corrupted cases, {len(missed)} missed in Python; tps: {run.stdout.strip()}")
expected = f"{made} cases proven again, {made} wrong"
if missed or made < 500 or run.returncode != 1 or run.stdout.strip() != expected:
    sys.exit(f"missed: {missed[:10]}; expected of tps: {expected}, exit code 1; exit code {run.returncode}")
