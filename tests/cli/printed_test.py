"""What is written may be shown on a terminal: no control, reordering, hiding or non-character of other people's files comes
out raw, in text or in JSON, and JSON still says the same. Argument: the program."""
import json
import os
import pathlib
import re
import sys
import tempfile

import processes

HOSTILE = "a\x1b[31m\x9b31m\u202e\u2028\u2029\u2066\u200b\ufeff\ufffe\U0001ffff\x7f\u0085\\\"é漢"
UNPRINTABLE = re.compile("[\0-\x08\x0b-\x1f\x7f-\x9f\xad\u061c\u180e\u200b-\u200f\u2028-\u202e\u2060-\u206f\ufdd0-\ufdef\ufeff\ufff9-\ufffb\ufffe\uffff\U0001fffe\U0001ffff\U000e0000-\U000e0fff]")

SCENE = {"tps": 1, "title": HOSTILE, "dimension": 2, "duration": 10, "species": {HOSTILE: {"mass": 1, "radius": 0.5}},
         "pairs": [{"between": [HOSTILE, HOSTILE], "blocking": {"c_rebound": 1}}],
         "particles": [{"species": HOSTILE, "position": [0, 0], "velocity": [1, 0]}, {"species": HOSTILE, "position": [3, 0]}]}


# A program whose words would be lines of their own in a report.
FORGER = """import json, sys
for line in sys.stdin:
    r = json.loads(line)
    out = {"verdict": "hit\\nFORGED", "t": "0x1p+0", "order": "before\\nFORGED", "kind": "retract\\r\\nFORGED"}
    hello = {"name": "forger", "ops": ["block_time", "tether_time", "order", "tether_response"]}
    if "bye" in r:
        break
    print(json.dumps(hello if "hello" in r else {"seq": r["seq"], "out": out}), flush=True)
"""


def main():
    tps = os.path.abspath(sys.argv[1])
    failures = processes.Failures()
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)

        def printed(words, given=None, codes=(0, 1, 3)):
            code, out, err = processes.run([tps, *words.split()], cwd=folder, input=None if given is None else given.encode())
            for name, text in (("standard output", out), ("standard error", err)):
                found = UNPRINTABLE.search(text)
                failures.expect(found is None, f"{words}: {name} has {found and ascii(found[0])}: {ascii(text[:200])}")
            failures.expect("\ufffd" not in out.replace("\\ufffd", ""), f"{words}: not UTF-8")  # as processes.run() decodes it
            failures.expect(code in codes, f"{words}: exit code {code}")
            return out

        # Files themselves may be spelt raw: this is how they come.
        (folder / "scene").write_text(json.dumps(SCENE, ensure_ascii=False))
        (folder / "bad").write_text(json.dumps({**SCENE, HOSTILE: 1}, ensure_ascii=False))
        case = {"id": "load.x." + HOSTILE, "rev": 1, "in": {"m_A": 1, "m_B": HOSTILE, "v_A": [1, 0], HOSTILE: [0, 0]}}
        header = {"schema": "vectors", "version": 1, "semantics": 1, "op": "load", "stratum": HOSTILE, "why": "", "generator": "x", "seed": 0, "first": 0, "count": 1}
        (folder / "known").write_text("\n".join(json.dumps(line, ensure_ascii=False) for line in (header, case)) + "\n")
        (folder / "replies").write_text(json.dumps({"id": case["id"], "error": HOSTILE}, ensure_ascii=False) + "\n")

        lines = printed("run scene -q -o -").splitlines()
        failures.expect(json.loads(lines[0])["scene"]["title"] == HOSTILE, "the trace has the title")
        (folder / "trace").write_text("\n".join(lines) + "\n")
        failures.expect(json.loads(lines[0])["scene"]["species"].keys() == {HOSTILE}, "the trace has the species")
        (folder / "raw").write_text("\n".join(json.dumps(json.loads(line), ensure_ascii=False, separators=(",", ":")) for line in lines) + "\n")
        printed("run --resume raw -q")
        failures.expect(json.loads(printed("explain scene --format json"))["title"] == HOSTILE, "explain has the title")
        failures.expect(json.loads(printed("run scene -q --format json"))["title"] == HOSTILE, "the summary has the title")
        requests = [json.loads(line) for line in printed("vectors requests known").splitlines()]
        failures.expect([request["in"] for request in requests] == [case["in"]], "requests ask what the cases ask")
        for words in ("explain scene", "run scene", "check trace", "check raw", "check trace --format json", "check trace --format junit", "explain bad", "run bad",
                      "vectors verify known", "vectors verify known --answers replies", "run " + re.sub(r"\s", "", HOSTILE), "explain trace"):
            printed(words)
        for request in ({"seq": 1, "op": HOSTILE, "in": {}}, {"seq": HOSTILE}, {HOSTILE: 1}, {"seq": 1, "op": "load", "in": {HOSTILE: 1}}):
            reply = printed("serve", json.dumps(request, ensure_ascii=False) + "\n")
            failures.expect(json.loads(reply).keys() & {"skip", "error"}, f"serve: {ascii(reply)}")
        printed("serve", HOSTILE + "\n")
        (folder / "forger.py").write_text(FORGER)
        for verb, code in (("properties --quiet --cases 2", 4), ("conform --quiet --level 1 --cases 2 --all", 1)):
            report = printed(f"{verb} -- {sys.executable} forger.py", codes=(code,))
            failures.expect("FORGED" in report, f"{verb}: quotes no word of the program")
            failures.expect("FORGED" not in [line.strip()[:6] for line in report.splitlines()], f"{verb}: a word of the program is a line")
    return failures.conclude("what is printed")


if __name__ == "__main__":
    sys.exit(main())
