#!/usr/bin/env python3
"""What a program says of itself, and what `tps conform` shows of it: capabilities, numbers that are none, drawings of every failing case.

  reports_test.py TPS SOURCE
"""
import json
import pathlib
import subprocess
import sys
import unittest
import xml.etree.ElementTree

TPS, SOURCE = sys.argv[1:]
ADAPTERS = pathlib.Path(SOURCE) / "data/adapters/python"

# Every number half as much again, every order reversed; the laws of JSON are kept.
SCALED = """
import groups, paper_loop, responses, timing
from protocol import serve
def scaled(x):
    if isinstance(x, list): return [scaled(y) for y in x]
    if isinstance(x, dict): return {key: scaled(y) for key, y in x.items()}
    if isinstance(x, float): return 1.5 * x
    return {"before": "after", "after": "before"}.get(x, x)
def wrong(operation): return lambda **given: scaled(operation(**given))
OPERATIONS = {**timing.OPERATIONS, **responses.OPERATIONS, **groups.OPERATIONS, "next_event": paper_loop.next_event}
serve("scaled", {**{name: wrong(operation) for name, operation in OPERATIONS.items()},
      "simulate": lambda scene, max_events: {"trace": scaled(list(paper_loop.run(scene, max_events)))}},
      features=["no-groups", "no-draws", "no-phases", "no-impulses"])
"""

# A program of the plane that cannot do anything with three coordinates, or with an infinite mass.
PLANAR = """
import math, groups, responses, timing
from protocol import serve
def planar(operation):
    def asked(**given):
        for key, value in given.items():
            if isinstance(value, list) and key[0] in "uvd" and len(value) != 2: return {}
            if value == math.inf: return {}
        return operation(**given)
    return asked
serve("planar", {name: planar(operation) for name, operation in {**timing.OPERATIONS, **responses.OPERATIONS}.items() if name != "order"}, FEATURES)
"""

NO_NUMBERS = """
import json, sys
for line in sys.stdin:
    request = json.loads(line)
    print('{"name":"x","ops":["load"]}' if "hello" in request else '{"seq":%d,"out":{"v_load":[NaN,-Infinity]}}' % request["seq"], flush=True)
"""


def conform(script, *words):
    program = f"import sys; sys.path.insert(0, {str(ADAPTERS)!r})\n{script}"
    done = subprocess.run([TPS, "conform", "--quiet", "--level", "1", "--cases", "5", "--shrink-seconds", "0", *words,
                           "--", sys.executable, "-B", "-c", program], capture_output=True, timeout=120)
    return done.returncode, done.stdout.decode(), done.stderr.decode()


class Capabilities(unittest.TestCase):
    def test_what_a_program_does_not_take_is_not_asked(self):
        code, out, err = conform(PLANAR.replace("FEATURES", 'features=["2d", "no-infinite-masses"]'), "--format", "json")
        self.assertEqual(code, 0, out + err)
        found = json.loads(out)
        self.assertGreater(found["asked"], 150)
        self.assertIn("2d, no-infinite-masses", found["notes"]["says what it takes"])

    def test_who_does_not_say_it_is_asked(self):
        self.assertEqual(conform(PLANAR.replace("FEATURES", "bits=53"), "--ops", "load")[0], 1)

    def test_a_word_that_is_none_is_refused(self):
        code, _, err = conform(PLANAR.replace("FEATURES", 'features=["2D"]'), "--ops", "load")
        self.assertEqual(code, 4)
        self.assertIn("features in the answer to hello: 2D is no feature of scenes; there are 2d, 3d", err)


class NoNumbers(unittest.TestCase):
    def test_they_are_wrong_and_no_breach_of_the_protocol(self):
        code, out, _ = conform(NO_NUMBERS, "--format", "json", "--ops", "load")
        found = json.loads(out)
        self.assertEqual((code, found["failed"]), (1, 0), out)
        row = next(row for row in found["rows"] if row["name"] == "load.plain")
        self.assertEqual(row["classes"]["WRONG"], row["asked"])
        self.assertIn("is not a number", row["example"]["why"])


class Drawings(unittest.TestCase):
    def test_every_failing_case_is_drawn(self):
        code, out, _ = conform(SCALED, "--format", "html", "--scenes", "3")
        self.assertEqual(code, 1)
        page = xml.etree.ElementTree.fromstring(out.replace("<!doctype html>", "").replace('<meta charset="utf-8">', ""))
        undrawn, drawn = [], set()
        for section in page.findall(".//section"):
            title = section.find(".//h3").text
            if not title.endswith("WRONG"):
                continue
            shapes = [shape.get("class") for shape in section.findall("./svg/*")]
            drawn.add(title.split(".")[0])
            if not shapes:
                undrawn.append(title)
            elif title.startswith(("block_time.plain", "collision_impulse.plain", "load.plain", "apply_impulse.plain", "group.", "next_event.plain")):
                self.assertLessEqual({"right", "found"}, set(shapes), title)
        self.assertEqual(undrawn, [])
        self.assertLessEqual({"block_time", "tether_time", "order", "apply_impulse", "collision_impulse", "revolution_impulse", "tether_response", "load",
                              "restitution_impulse", "group", "next_event", "run", "Eq4Laws"}, drawn)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
