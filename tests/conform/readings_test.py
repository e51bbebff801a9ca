#!/usr/bin/env python3
"""Who decides otherwise where the paper is silent is called so by `tps conform`, with the decision's number; the same simulator without that passes.

  readings_test.py TPS
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

TPS = sys.argv[1]
CONTACTS = 5  # the number of a scene in which D12 shows
SIMULATOR = pathlib.Path(__file__).resolve().parent / "other_readings.py"


def verdict(reading, features, first, scenes):
    done = subprocess.run([TPS, "conform", "--quiet", "--format", "json", "--features", features, "--first-scene", str(first), "--scenes", str(scenes),
                           "--simulator", f"{sys.executable} -B {SIMULATOR} {reading}"], capture_output=True, timeout=120)
    return done.returncode, json.loads(done.stdout)


class Readings(unittest.TestCase):
    def named(self, reading, features, first, scenes=1):
        """Scenes in which the reading shows."""
        code, honest = verdict("none", features, first, scenes)
        self.assertEqual((code, honest["classes"]["RIGHT"]), (0, honest["asked"]))
        code, other = verdict(reading, features, first, scenes)
        self.assertEqual((code, other["classes"]["WRONG"]), (0, 0), other["sentence"])
        whole = next(row for row in other["rows"] if row["name"] == "run.whole")
        self.assertGreaterEqual(whole["classes"]["OTHER READING"], 1)
        self.assertIn(f"another reading of the paper, {reading}:", whole["example"]["why"])
        return other

    def test_d9_a_wall_joins_the_group(self):
        notes = self.named("D9", "groups,no-phases,no-impulses,no-draws", 13)["notes"]
        self.assertIn("a wall joins a group (D9)", notes)

    def test_d11_a_pair_is_asked_again(self):
        self.named("D11", "no-phases,no-impulses,no-groups", 28)

    def test_d12_differs_by_less_than_the_check_allows(self):
        """Contacts that neither approach nor recede but for rounding: the traces differ, and both are right."""
        number, features = CONTACTS, "contacts"
        with tempfile.NamedTemporaryFile(suffix=".json") as scene:
            subprocess.run([TPS, "scene", "random", "--features", features, "--number", str(number), "-o", scene.name], check=True)
            one, other = (subprocess.run([sys.executable, "-B", str(SIMULATOR), reading, scene.name], capture_output=True, check=True).stdout
                          for reading in ("none", "D12"))
        self.assertNotEqual(one, other)
        code, found = verdict("D12", features, number, 1)
        self.assertEqual((code, found["classes"]["RIGHT"]), (0, found["asked"]))

    def test_d13_another_order_of_ties(self):
        self.named("D13", "no-phases,no-impulses", 0, 5)

    def test_d16_no_pull_by_rounding(self):
        self.named("D16", "no-phases,no-impulses,no-groups", 478)


class Mistakes(unittest.TestCase):
    FEATURES = "groups,no-phases,no-impulses,no-draws"

    def test_an_expiry_that_is_not_renewed_is_wrong_by_d10(self):
        code, found = verdict("expiry", self.FEATURES, 0, 10)
        self.assertEqual(code, 1)
        self.assertGreater(found["classes"]["WRONG"], 0)
        self.assertIn("D10:", json.dumps(found["rows"]))

    def test_restitution_in_the_order_of_loads_is_wrong(self):
        code, found = verdict("unwinding", self.FEATURES, 0, 10)
        self.assertEqual(code, 1)
        self.assertGreater(next(row for row in found["rows"] if row["name"] == "run.restitute")["classes"]["WRONG"], 0)


class Loads(unittest.TestCase):
    def test_who_sees_the_other_sign_of_a_vanishing_v_n_does_not_load(self):
        """Scene 22: v_n is below rounding at the first event; the reference loads, this simulator does not."""
        code, found = verdict("none", "groups,no-phases,no-impulses,no-draws", 22, 1)
        self.assertEqual((code, found["classes"]["WRONG"]), (0, 0), found["sentence"])


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
