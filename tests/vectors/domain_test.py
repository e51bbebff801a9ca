"""Questions that no operation admits, made of every kind of committed case: verify_vectors.py and `tps vectors verify` must refuse
each of them by name, and go on with the cases between them.

domain_test.py PROGRAM SOURCE_DIR WORK_DIR
"""
import copy, glob, json, os, subprocess, sys

program, source, work = sys.argv[1:]
sys.path.insert(0, os.path.join(source, "data"))
import verify_domain, verify_vectors

WRONG = {
    "vector": [["inf", "0x0p+0"], ["0x0p+0"], ["0x0p+0"] * 4, "0x0p+0", [], ["nan", "0x0p+0"], None, {}, "MIXED"],
    "mass": ["0x0p+0", "-0x1p+0", "nan", None, [], "heavy"],
    "direction": [["0x1p+0", "0x1p+0"], ["0x0p+0", "0x0p+0"], ["0x1p+0"], "0x1p+0", ["nan", "0x1p+0"]],
    "spin": ["inf", "nan", ["0x0p+0", "0x0p+0"], [], None, "fast"],
    "signed": ["0x1.0000000000001p+0", "-0x1p+1", "nan"],
    "rate": ["0x0p+0", "-0x1p+0", "inf"],
    "not_negative": ["-0x1p-60", "inf", "nan"],
    "length": ["0x0p+0", "-0x1p-1", "inf", "nan"],
    "coefficient": ["0x1.cp+2", "-0x1p-60", "0x1.0000000000001p+0", "inf"],
    "angle": ["0x0p+0", "0x1.68p+7", "0x1.68p+6", "-0x1p+0", "0x1p-30"],
}


def kind_of(key):
    if key in ("u_A", "u_B", "v_A", "v_B", "dp", "u", "v", "position", "velocity"):
        return "vector"
    kind = {"normal": "direction", "spin_A": "spin", "spin_B": "spin", "beta0": "signed", "gamma": "rate", "s": "not_negative", "mu": "not_negative"}
    if key in kind:
        return kind[key]
    if key in ("m_A", "m_B", "m", "mass"):
        return "mass"
    if key in ("L", "distance", "R_A", "R_B"):
        return "length"
    if key.startswith("theta"):
        return "angle"
    return "coefficient" if key.startswith("c_") or key == "c" else None


def places(value, path=()):
    """Every number or vector with a domain, as a path."""
    if isinstance(value, dict):
        for key, inside in value.items():
            if kind_of(key):
                yield (*path, key)
            else:
                yield from places(inside, (*path, key))
    elif isinstance(value, list):
        for n, inside in enumerate(value[:2]):
            yield from places(inside, (*path, n))


def changed(question, path, value):
    wrong = copy.deepcopy(question)
    at = wrong
    for step in path[:-1]:
        at = at[step]
    if value == "MIXED":
        value = at[path[-1]][:2] if len(at[path[-1]]) == 3 else at[path[-1]] + ["0x0p+0"]
    at[path[-1]] = value
    return wrong


def wrong_questions(question):
    for path in places(question):
        for value in WRONG[kind_of(path[-1])]:
            yield changed(question, path, value)
    yield {**question, "surplus": 1}
    for key in question:
        yield {k: x for k, x in question.items() if k != key}
    if "m_A" in question:
        yield {**question, "m_A": "inf", "m_B": "inf"}
    if "m_A" in question and "u_A" in question:
        yield {**question, "u_B": question["u_A"]}
    if "collisions" in question:
        for i, j in ((0, 0), (-1, 0), (0, len(question["bodies"])), (0.5, 1)):
            yield {**question, "collisions": [{**question["collisions"][0], "i": i, "j": j}]}


made, missed, seen = 0, [], set()
for name in sorted(glob.glob(os.path.join(source, "data/vectors/*.jsonl"))):
    with open(name) as file:
        header, right = json.loads(next(file)), json.loads(next(file))
    if header["op"] in seen and header["op"] != "group":
        continue
    seen.add(header["op"])
    questions = list(wrong_questions(right["in"]))
    made += len(questions)
    for number, question in enumerate(questions):
        try:
            verify_vectors.check({**right, "in": question}, header["op"])
            missed.append(f"Python: {right['id']} {question}")
        except verify_domain.OutsideDomain:
            pass
        except verify_vectors.BROKEN as error:  # only what takes the loads before it to see
            if "between two bodies" not in str(error):
                missed.append(f"Python says {error!r}: {right['id']} {question}")
    for first in range(0, len(questions), 10):  # fewer than are shown
        cases = [c for q in questions[first:first + 10] for c in ({**right, "in": q}, right)]
        path = os.path.join(work, "domain.jsonl")
        with open(path, "w") as file:
            file.writelines(json.dumps(line) + "\n" for line in [{**header, "count": len(cases)}, *cases])
        run = subprocess.run([program, "vectors", "verify", path], capture_output=True, text=True)
        bad = len(cases) // 2
        expected = f"{len(cases)} cases proven again, {bad} wrong\n"
        if run.returncode != 1 or run.stdout != expected or run.stderr.count("no question of the operation") != bad:
            missed.append(f"tps: exit code {run.returncode}, {run.stdout!r}, {run.stderr[:2000]}")
print(f"{made} questions outside of {len(seen)} operations")
if missed or made < 300 or len(seen) != len(verify_domain.KEYS) + 3:  # order, group, next_event
    sys.exit("\n".join(missed[:5]) + f"\n{len(missed)} missed")
