"""An effect that a program brings along is one of the program's: explained, run, traced, read back, checked, resumed and shown, in a
scene that calls for it; without it the same scene is refused.

  turns_test.py PROGRAM_WITH_TURNS PLAIN_PROGRAM
"""
import json
import pathlib
import subprocess
import sys
import tempfile

SCENE = {
    "tps": 1, "dimension": 2, "duration": 12, "seed": 7, "title": "A charged ball among others, in a room, turned seven times",
    "species": {"ball": {"mass": 1.25, "radius": 1, "random_impulses": {"tau": 3, "shape": 2, "mean": 0.25}}},
    "pairs": [{"between": ["ball", "ball"], "blocking": {"c_rebound": 0.9}}],
    "walls": [{"box": {"low": [-6, -6], "high": [6, 6]}, "c_rebound": 1}],
    "impulses": [{"at": 4, "particle": 5, "impulse": [0.5, 0.25]}],
    "turns": [{"at": t, "particle": who, "towards": way} for t, who, way in
              ((4, 5, "left"), (1, 3, "left"), (1, 5, "right"), (2.5, 3, "left"), (6, 3, "right"), (7, 9, "left"), (9, 5, "left"))],
    "particles": [{"id": 3, "species": "ball", "position": [-3, 0], "velocity": [1.1, 0.3]},
                  {"id": 5, "species": "ball", "position": [0, 0.2], "velocity": [-0.7, 0.4]},
                  {"id": 9, "species": "ball", "position": [3, -1], "velocity": [-0.2, -0.9]}],
}


class Trial:
    def __init__(self, program, folder):
        self.program, self.folder, self.problems = program, pathlib.Path(folder), []

    def call(self, *words, program=None):
        done = subprocess.run([program or self.program, *map(str, words)], capture_output=True, text=True, check=False, cwd=self.folder)
        return done.returncode, done.stdout, done.stderr

    def expect(self, holds, what):
        if not holds:
            self.problems.append(what)

    def write(self, name, content):
        path = self.folder / name
        path.write_text(content if isinstance(content, str) else json.dumps(content))
        return path

    def findings(self, trace, *more):
        code, out, err = self.call("check", trace, "--format", "json", *more)
        if code not in (0, 1):
            raise SystemExit(f"check of {trace}: exit code {code}, {err}")
        return [(f["rule"], f["message"]) for f in json.loads(out)["findings"]]


def explained(t):
    _, text, _ = t.call("explain", "scene.json")
    t.expect('turns: velocities turned by a right angle at given times\n  because  "turns" (line 1)\n  cost     7 events\n' in text, "explain does not tell of turns")
    t.expect(text.index("\nturns:") > text.index("\nwalls:"), "turns do not stand behind the effects of the catalogue")
    _, text, _ = t.call("explain", "without.json")
    t.expect('  turns: the scene has no "turns"\n' in text, "explain does not say that turns are not called for")


def traced(t):
    """@return the lines of the whole run"""
    code, _, err = t.call("run", "scene.json", "-o", "whole.tps", "-q", "--state-every", 5)
    t.expect(code == 0, f"run: exit code {code}, {err}")
    lines = (t.folder / "whole.tps").read_text().splitlines()
    t.expect([w["towards"] for w in json.loads(lines[0])["scene"]["turns"]] == ["left", "right", "left", "left", "right", "left", "left"],
             "the scene in the header has its turns in another order than that of their times and particles")
    turns = [json.loads(line) for line in lines if '"kind":"turn"' in line]
    t.expect([(float.fromhex(e["t"]), e["i"], e["towards"], e["quarters"]) for e in turns] ==
             [(1, 3, "left", 1), (1, 5, "right", -1), (2.5, 3, "left", 2), (4, 5, "left", 0), (6, 3, "right", 1), (7, 9, "left", 1), (9, 5, "left", 1)],
             "the turns of the trace are not those of the scene")
    for e in turns:
        before, after = ([float.fromhex(x) for x in e[side][str(e["i"])]["velocity"]] for side in ("pre", "post"))
        sign = 1 if e["towards"] == "left" else -1
        t.expect(after == [-sign * before[1], sign * before[0]], f"event {e['k']} is no quarter turn")
        t.expect([float.fromhex(x) for x in e["change"]] == [a - b for a, b in zip(after, before)], f"event {e['k']} has another change of velocity")
    at_four = [json.loads(line)["kind"] for line in lines if '"t":"0x1p+2","dt"' in line]
    t.expect(at_four == ["scheduled_impulse", "turn"], f"at one time the order is {at_four}")
    states = [json.loads(line) for line in lines if line.startswith('{"state"')]
    t.expect(states[-1]["progress"].get("turns") == 7 and states[-1]["counts"].get("turn") == 7, "the last state does not count the turns")
    t.expect([float.fromhex(x) for x in states[-1]["quantities"]["turns_quarters"]] == [1, 1, 1], "the last state does not have the quarters")
    return lines


def checked(t, lines):
    t.expect(t.findings("whole.tps") == [], f"an honest trace does not conform: {t.findings('whole.tps')[:3]}")
    code, _, err = t.call("run", "scene.json", "-o", "certified.tps", "-q", "--timing", "certified")
    t.expect(code == 0 and t.findings("certified.tps") == [], f"an honest certified trace does not conform {err}")
    header = json.loads(lines[0])
    header["form"] = "minimal"
    events = [json.loads(line) for line in lines[1:] if '"kind"' in line]
    minimal = [{k: v for k, v in e.items() if k in ("t", "kind", "i", "j", "wall", "face")} |
               {"post": {i: {"velocity": p["velocity"]} for i, p in e["post"].items()}} for e in events]
    t.write("minimal.tps", "\n".join(json.dumps(line) for line in [header, *minimal, json.loads(lines[-1])]) + "\n")
    t.expect(t.findings("minimal.tps") == [], f"an honest minimal trace does not conform: {t.findings('minimal.tps')[:3]}")


def damaged(t, lines):
    """Damage to the third turn, and by whom it is found."""
    at = [n for n, line in enumerate(lines) if '"kind":"turn"' in line][2]

    def spoilt(change):
        event = json.loads(lines[at])
        replaced = change(event)
        t.write("spoilt.tps", "\n".join(lines[:at] + ([] if replaced is None else [json.dumps(event)]) + lines[at + 1:]) + "\n")
        return t.findings("spoilt.tps")

    def swap(event):
        velocity = event["post"]["3"]["velocity"]
        velocity.reverse()
        return event

    for what, change, rule, words in (
            ("a velocity that is mirrored", swap, "impulse", "a turn to the left makes that"),
            ("the other way", lambda e: e.update(towards="right") or e, "impulse", '"towards" is not "left"'),
            ("another count", lambda e: e.update(quarters=3) or e, "impulse", '"quarters" is not 2'),
            ("another change", lambda e: e.update(change=e["change"][::-1]) or e, "impulse", '"change" is not'),
            ("another impulse", lambda e: e.update(dp=["0x1p+0", "0x1p+0"]) or e, "impulse", "the impulse of the turn is"),
            ("another particle", lambda e: e.update(i=5, pre={"5": e["pre"]["3"]}, post={"5": e["post"]["3"]}) or e, "earliest", "the scene has no turn on particle 5"),
            ("another time", lambda e: e.update(t="0x1.4001p+1") or e, "earliest", "the turn is due at"),
            ("no event", lambda e: None, "earliest", "the turn of time t = 2.5 has not happened yet"),
            ("a field missing", lambda e: e.pop("quarters") and e, "schema", 'lacks "quarters", which a turn has'),
            ("a field twice named", lambda e: e.update(sense="left") or e, "schema", "/sense is not known here")):
        found = spoilt(change)
        t.expect(any(r == rule and words in m for r, m in found), f"{what} is not found by rule {rule} ({words}): {found[:4]}")
    rebound = next(n for n, line in enumerate(lines) if '"kind":"rebound"' in line)
    event = json.loads(lines[rebound])
    event["quarters"] = 1
    t.write("spoilt.tps", "\n".join([*lines[:rebound], json.dumps(event), *lines[rebound + 1:]]) + "\n")
    found = t.findings("spoilt.tps")
    t.expect(("schema", "/quarters is not for a rebound") in found, f"a rebound with quarters: {found[:3]}")
    for what, change, words in (("too many turns in a state", lambda s: s["progress"].update(turns=9), "/progress/turns is more than the turns of the scene"),
                                ("another number of turns in a state", lambda s: s["progress"].update(turns=6), "the progress of turns is not that of the events"),
                                ("no turns in a state", lambda s: s["progress"].pop("turns"), "the progress of turns is missing")):
        last = max(n for n, line in enumerate(lines) if line.startswith('{"state"'))
        state = json.loads(lines[last])
        change(state)
        del state["checksum"]
        t.write("spoilt.tps", "\n".join([*lines[:last], json.dumps(state), *lines[last + 1:]]) + "\n")
        found = t.findings("spoilt.tps")
        t.expect(("states", words) in found, f"{what}: {found[:3]}")


def resumed(t, lines):
    """From between two turns of one particle: what follows is that of the whole run, its count of quarters included."""
    t.call("run", "scene.json", "-q", "--state-every", 5, "--until", 3, "--checkpoint", "kept.json", "-o", "legs.tps")
    kept = json.loads((t.folder / "kept.json").read_text().splitlines()[-1])
    t.expect([float.fromhex(x) for x in kept["quantities"]["turns_quarters"]] == [2, -1, 0], "the checkpoint does not have the quarters")
    code, _, err = t.call("run", "--resume", "legs.tps", "-q")
    t.expect(code == 0, f"resume: exit code {code}, {err}")
    t.expect((t.folder / "legs.tps").read_text().splitlines()[-5:] == lines[-5:], "the end of a run in two legs is not that of one")
    events = [[line for line in whole if line.startswith('{"k"')] for whole in (lines, (t.folder / "legs.tps").read_text().splitlines())]
    t.expect(events[0] == events[1], "a run in two legs has other events than one")


def shown(t):
    code, _, err = t.call("view", "whole.tps", "-o", "page.html")
    t.expect(code == 0 and '"turn"' in (t.folder / "page.html").read_text(), f"view: exit code {code}, {err}")
    code, _, err = t.call("draw", "whole.tps", "-o", "picture.svg")
    t.expect(code == 0, f"draw: exit code {code}, {err}")


def refused(t, plain):
    code, _, err = t.call("run", "scene.json", "-q", program=plain)
    t.expect(code == 3 and 'unknown key "turns"' in err, f"without the effect: exit code {code}, {err}")
    code, _, err = t.call("check", "whole.tps", program=plain)
    t.expect(code == 3 and 'unknown key "turns"' in err, f"check without the effect: exit code {code}, {err}")
    code, _, err = t.call("run", "scene.json", "-q", "--scalar", "float")
    t.expect(code == 3 and "the scene calls for turns" in err and "--scalar double" in err, f"in float: exit code {code}, {err}")
    for what, key, value, words in (
            ("a word that is none", "turns", [{"at": 1, "particle": 3, "towards": "up"}], '/turns/0/towards: found "up"; allowed: "left" or "right"'),
            ("a time before the start", "turns", [{"at": -1, "particle": 3, "towards": "left"}], "/turns/0/at: found -1"),
            ("nobody", "turns", [{"at": 1, "particle": 4, "towards": "left"}], "/turns/0/particle: no particle has the id 4"),
            ("a body", "grouping", {"dt_restitute": 0.01}, '/turns: "turns" are defined without "grouping"')):
        t.write("wrong.json", {**SCENE, key: value})
        code, _, err = t.call("run", "wrong.json", "-q")
        t.expect(code == 3 and words in err, f"{what}: exit code {code}, {err}")


def main():
    with tempfile.TemporaryDirectory() as folder:
        t = Trial(pathlib.Path(sys.argv[1]).resolve(), folder)
        t.write("scene.json", SCENE)
        t.write("without.json", {k: v for k, v in SCENE.items() if k != "turns"})
        explained(t)
        lines = traced(t)
        checked(t, lines)
        damaged(t, lines)
        resumed(t, lines)
        shown(t)
        refused(t, str(pathlib.Path(sys.argv[2]).resolve()))
    sys.exit("\n".join(t.problems) if t.problems else 0)


main()
