#!/usr/bin/env python3
"""`tps conform` asks simulators for the effects of the outlook by their words: a right one conforms, and one that knows a scene a little
otherwise does not.

  effects_test.py TPS SOURCE
"""
import json
import pathlib
import subprocess
import sys
import unittest

import told_otherwise
from asking import TPS, Asking, adapter

asking = Asking(shrink_seconds=0)
SIMULATOR = pathlib.Path(__file__).resolve().parent / "told_otherwise.py"
#: A word, and the row in which its events are counted.
ROWS = {"gravity": "gravity", "random-impulses": "random_impulse", "thermostat": "thermostat", "drag": "rebound", "friction": "friction", "walls": "wall",
        "block": "wall", "periodic": "rebound"}
#: Where particles part soon, or seldom come to the place, it takes more scenes.
SCENES = {"drag": 10, "friction": 10, "block": 6}


def report(lie, features, scenes):
    return asking.report("--features", features, "--scenes", str(scenes), "--simulator", f"{sys.executable} -B -E -S {SIMULATOR} {TPS} {lie}")


def scene(features, number):
    done = subprocess.run([TPS, "scene", "random", "--features", features, "--number", str(number)], capture_output=True)
    return json.loads(done.stdout) if done.returncode == 0 else None


class Effects(unittest.TestCase):
    def test_a_right_simulator_conforms_and_met_the_effect(self):
        for word, row in ROWS.items():
            with self.subTest(word):
                code, found = report("none", word, SCENES.get(word, 3))
                self.assertEqual(code, 0, found["sentence"])
                asked = {each["name"]: each["asked"] for each in found["rows"]}
                self.assertGreaterEqual(asked.get(f"run.{row}", 0), 10, asked)
                self.assertNotIn("effects of the outlook", found["notes"])

    def test_a_verdict_without_them_says_so(self):
        _, found = report("none", "no-groups", 3)
        self.assertEqual(found["notes"]["effects of the outlook"], f"not asked; --features {','.join(ROWS)} asks for those that the simulator has")

    def test_who_knows_a_scene_otherwise_is_wrong(self):
        for lie, (word, _) in told_otherwise.LIES.items():
            with self.subTest(lie):
                code, found = report(lie, word, SCENES.get(word, 3))
                self.assertEqual(code, 1, found["sentence"])
                self.assertGreaterEqual(found["classes"]["WRONG"], 1)

    def test_words_are_taken_in_turn_and_together(self):
        words = list(ROWS)
        scenes = [made for number in range(60) if (made := scene(",".join(words), number))]
        self.assertGreaterEqual(len(scenes), 40)
        has = {"gravity": lambda s: "gravity" in s, "drag": lambda s: "drag" in s, "walls": lambda s: "walls" in s, "periodic": lambda s: "box" in s,
               "thermostat": lambda s: any("thermostat" in each for each in s["species"].values()),
               "friction": lambda s: any("friction" in each for each in s["pairs"])}
        for word, is_in in has.items():
            self.assertGreaterEqual(sum(map(is_in, scenes)), 5, word)
        both = [s for s in scenes if has["walls"](s) and has["friction"](s)]
        self.assertGreaterEqual(len(both), 3)

    def test_what_is_not_named_is_not_there(self):
        for number in range(20):
            made = scene("walls,no-gravity", number)
            if made:
                self.assertNotIn("gravity", made)
                self.assertNotIn("drag", made)
                self.assertIn("walls", made)

    def test_single_steps_are_asked_without_effects(self):
        code, found = asking.report("--ops", "next_event", "--features", "walls,gravity", *adapter("paper_loop"))
        asked = {row["name"]: row["asked"] for row in found["rows"]}
        self.assertEqual(code, 0, found["sentence"])
        self.assertGreaterEqual(asked["next_event.step_rebound"], 5)

    def test_words_that_exclude_each_other_are_refused(self):
        for words, why in (("groups,walls", "beside that nothing is grouped"), ("contacts,gravity", "scenes of contacts have neither groups nor anything but ties"),
                           ("gravity,no-gravity", "give one")):
            done = subprocess.run([TPS, "scene", "random", "--features", words], capture_output=True, text=True)
            self.assertEqual(done.returncode, 2)
            self.assertIn(f"{words.replace(',', ' and ')} exclude each other: {why}", done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
