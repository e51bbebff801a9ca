"""Replies that answer nothing must not pass: refusals, silence, skips of what is offered, empty objects.

refusals_test.py PROGRAM SOURCE_DIR
"""
import json, os, subprocess, sys, tempfile

program, source = sys.argv[1:]
scratch = tempfile.TemporaryDirectory()


def tps(*words, text=""):
    return subprocess.run([program, *words], input=text, capture_output=True, text=True)


def verify(path, replies):
    return tps("vectors", "verify", path, "--answers", "-", text="".join(json.dumps(r) + "\n" for r in replies))


tried = 0
for name in ("load.plain", "block_time.plain", "order.plain", "tether_response.plain", "group.chain", "next_event.gas"):
    path = os.path.join(source, "data/vectors", name + ".jsonl")
    op = name.split(".")[0]
    right = [json.loads(r) for r in tps("serve", text=tps("vectors", "requests", path).stdout).stdout.splitlines()]
    others = len(right) - 1
    hello = {"name": "mine", "version": "1", "ops": [op]}
    refused = f"1 answers judged, 0 wrong, {others} refused or without an answer\n"
    expected = {
        "all right": (right, 0, f"{len(right)} answers judged, 0 wrong\n"),
        "refused": ([right[0]] + [{"seq": r["seq"], "error": "bad_input"} for r in right[1:]], 1, refused),
        "silent": (right[:1], 1, refused),
        "skipped": ([right[0]] + [{"seq": r["seq"], "skip": "unknown_op"} for r in right[1:]], 1, refused),
        "all skipped, offered": ([hello] + [{"seq": r["seq"], "skip": "unknown_op"} for r in right], 1,
                                 f"0 answers judged, 0 wrong, {len(right)} refused or without an answer\n"),
        "not offered": ([{"seq": r["seq"], "skip": "unknown_op"} for r in right], 5,
                        f"0 answers judged, 0 wrong, {len(right)} of operations that are not offered\n"),
        "answered twice": (right + right[:1], 3, ""),
        "empty": ([{"seq": r["seq"], "out": {}} for r in right], 1, f"{len(right)} answers judged, {len(right)} wrong\n"),
    }
    for what, (replies, code, says) in expected.items():
        tried += 1
        run = verify(path, replies)
        if (run.returncode, run.stdout) != (code, says):
            sys.exit(f"{name}, {what}: exit code {run.returncode}, {run.stdout!r}; expected {code}, {says!r}\n{run.stderr[:500]}")

# A header that names an operation which there is not: nobody can answer, and nobody is excused.
lines = open(path).read().replace('"op":"next_event"', '"op":"warp"')
for words in (("requests", "-"), ("verify", "-")):
    run = tps("vectors", *words, text=lines)
    if run.returncode != (3 if words[0] == "requests" else 1) or "warp" not in run.stderr:
        sys.exit(f"an operation that there is not, {words}: exit code {run.returncode}\n{run.stderr[:500]}")
    tried += 1
unknown = os.path.join(scratch.name, "warp.jsonl")
with open(unknown, "w") as file:
    file.write(lines)
run = tps("vectors", "verify", path, unknown, "--answers", "-", text="".join(json.dumps(r) + "\n" for r in right) +
          "".join(json.dumps({"seq": len(right) + n + 1, "skip": "unknown_op"}) + "\n" for n in range(lines.count("\n") - 1)))
if run.returncode != 1 or f"{lines.count(chr(10)) - 1} wrong" not in run.stdout:
    sys.exit(f"skips of an operation that there is not: exit code {run.returncode}, {run.stdout}\n{run.stderr[:500]}")
tried += 1

# Two cases of one id may be proven together, and answered by their numbers; a reply that names the id answers nobody knows which.
twice = os.path.join(scratch.name, "twice.jsonl")
with open(path) as whole, open(twice, "w") as copy:
    copy.write(whole.read())
ids = [json.loads(line)["id"] for line in open(path).readlines()[1:]]
count = len(ids)
by_number = [{**r, "seq": n + 1} for n, r in enumerate(right + right)]
by_id = [{"id": name, "out": r["out"]} for name, r in zip(ids, right)]
for words, replies, code, says in (((), [], 0, "0 wrong"), (("--answers", "-"), by_number, 0, "0 wrong"), (("--answers", "-"), by_id, 1, f"{count} wrong")):
    run = tps("vectors", "verify", path, twice, *words, text="".join(json.dumps(r) + "\n" for r in replies))
    if run.returncode != code or says not in run.stdout or (code == 1) != (f"the id stands twice, first at {path}:2" in run.stderr):
        sys.exit(f"two cases of one id, {words}: exit code {run.returncode}, {run.stdout}\n{run.stderr[:500]}")
    tried += 1
print(f"{tried} sets of replies")
