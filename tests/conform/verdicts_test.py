#!/usr/bin/env python3
"""Verdicts of `tps conform`: exit codes, profiles, expected failures, reports, programs that break the protocol.

  verdicts_test.py TPS SOURCE LIBRARY…
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

from asking import ADAPTERS, BROKEN, SOURCE, TPS, Asking, adapter

LIBRARIES = sys.argv[3:]
asking = Asking(shrink_seconds=0.1)
conform, report = asking.conform, asking.report


class Profiles(unittest.TestCase):
    def test_the_printed_formula_passes_but_not_as_stable(self):
        code, found = report(*adapter("by_approach"))
        self.assertEqual((code, found["classes"]["WRONG"]), (0, 0))
        self.assertGreater(found["classes"]["WORSE THAN STABLE"], 20)
        code, found = report("--profile", "double-stable", *adapter("by_approach"))
        self.assertEqual((code, found["verdict"]), (1, "not conforming"))

    def test_certified_answers_pass_every_profile(self):
        for profile in ("certified", "double-stable", "double-paper"):
            code, out, _ = conform("--profile", profile, "--ops", "block_time,load,order,group", "--", TPS, "serve")
            self.assertEqual(code, 0, out)

    def test_doubles_are_not_certified(self):
        self.assertEqual(conform("--profile", "certified", "--ops", "load", *adapter("scalar"))[0], 1)

    def test_the_reference_in_each_scalar_passes(self):
        for scalar in ("float", "double", "long-double"):
            code, out, _ = conform("--scalar", scalar)
            self.assertEqual(code, 0, out)

    def test_float_is_judged_as_float_and_not_as_double(self):
        words = ("--ops", "block_time,collision_impulse", "--scalar", "float")
        self.assertEqual(conform(*words)[0], 0)
        with tempfile.TemporaryDirectory() as folder:
            source = ADAPTERS / "timing.py"
            for name in ("protocol.py", "timing.py"):
                (pathlib.Path(folder) / name).write_text((ADAPTERS / name).read_text())
            wrong = source.read_text().replace('"t": c / (-h', '"t": (1 + 2**-22) * c / (-h')
            (pathlib.Path(folder) / "timing.py").write_text(wrong)
            mine = ["--ops", "block_time", "--", sys.executable, "-B", f"{folder}/timing.py"]
            self.assertEqual(conform(*mine)[0], 1)
            self.assertEqual(conform("--profile", "float", *mine)[0], 0)

    def test_a_profile_of_ones_own(self):
        with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
            file.write('{"conform_profile":1,"name":"mine","fails":["WORSE THAN STABLE"]}')
            file.flush()
            code, found = report("--profile", file.name, "--tags", "block_time.far", *adapter("by_approach"))
            self.assertEqual((code, found["profile"]["name"]), (1, "mine"))
            file.seek(0)
            file.write('{"conform_profile":1,"name":"mine","fails":["WORSE THAN STABLY"]}')
            file.flush()
            code, _, err = conform("--profile", file.name, *adapter("by_approach"))
            self.assertEqual(code, 3)
            self.assertIn("WORSE THAN STABLY", err)
            self.assertIn("/fails/0", err)

    def test_libraries_pass(self):
        for library in LIBRARIES:
            code, out, _ = conform("--library", library)
            self.assertEqual(code, 0, out)


class Hypotheses(unittest.TestCase):
    def test_the_printed_rule_is_recognised(self):
        _, found = report("--tags", "tether_time.plain", *adapter("as_printed"))
        self.assertEqual(found["rows"][0]["equals"], ["the smaller non-negative root without a test for approach, as printed (D1)"])

    def test_each_has_a_program_that_makes_it(self):
        sys.path.insert(0, str(pathlib.Path(__file__).parent))
        import mutants
        names = subprocess.run([TPS, "conform", "--hypotheses"], capture_output=True, check=True).stdout.decode().splitlines()
        made = {mutant.equals for mutant in mutants.WRONG} | {"the smaller non-negative root without a test for approach, as printed (D1)"}
        made |= {"written with n digits", "written with n decimals"} if {"written with 10 digits", "written with 6 decimals"} <= made else set()
        self.assertEqual(set(names) - made, set())


class ExpectedFailures(unittest.TestCase):
    def verdict(self, lines, *words):
        with tempfile.NamedTemporaryFile("w") as file:
            file.write(lines)
            file.flush()
            return conform("--expect-fail", file.name, *words)

    def test_what_may_fail_may(self):
        words = ("--tags", "block_time.*", *adapter("as_printed"))
        self.assertEqual(conform(*words)[0], 1)
        self.assertEqual(self.verdict("# D1\nblock_time.*\n", *words)[0], 0)

    def test_what_may_fail_must(self):
        code, out, _ = self.verdict("load.plain\n", "--ops", "load", *adapter("scalar"))
        self.assertEqual(code, 1)
        self.assertIn("expected to fail but passes: load.plain", out)


class Protocol(unittest.TestCase):
    """A program that gives no answer has no verdict, and the message says what it did."""

    def test_failures_are_told_apart(self):
        for mode, word in (("crash", "crashed: signal 11"), ("exit", "ended with exit code 3"), ("hang", "hung"), ("garbage", "garbage"),
                           ("wrong_seq", "seq"), ("truncated", "in the middle of a line"), ("no_hello", "no name")):
            code, out, err = conform("--timeout", "0.5", "--tags", "load.plain", "--", sys.executable, "-B", str(BROKEN), mode)
            self.assertEqual(code, 4, mode + out)
            self.assertIn(word, out + err, mode)

    def test_an_endless_line_is_bounded(self):
        code, out, err = conform("--tags", "load.plain", "--", "cat", "/dev/zero")
        self.assertEqual(code, 4)
        self.assertIn("a line without an end", out + err)

    def test_nothing_asked_is_no_verdict(self):
        code, out, _ = conform("--tags", "next_event.gas", *adapter("scalar"))
        self.assertEqual(code, 5)
        self.assertIn("nothing was asked", out)

    def test_one_implementation_is_named(self):
        self.assertEqual(conform()[0], 2)
        self.assertEqual(conform("--scalar", "double", *adapter("scalar"))[0], 2)

    def test_nan_is_no_number(self):
        code, found = report("--ops", "load", "--", sys.executable, "-B", str(BROKEN), "nan")
        self.assertEqual(code, 1)
        self.assertIn("is not a number", [row for row in found["rows"] if row["of"] == "load"][0]["example"]["why"])


class Simulators(unittest.TestCase):
    """A command that is given a scene file and writes a trace."""
    FEATURES = ("--features", "no-groups,no-draws,no-phases,no-impulses", "--scenes", "2")

    def verdict(self, script, *words):
        return conform(*self.FEATURES, "--timeout", "1", *words, "--simulator", f'{sys.executable} -B -c "{script}"')

    def test_the_papers_loop_passes(self):
        code, out, _ = conform(*self.FEATURES, "--simulator", f"{sys.executable} -B {ADAPTERS}/paper_loop.py")
        self.assertEqual(code, 0, out)
        self.assertIn("whole runs", out)

    def test_the_reference_passes_with_every_feature(self):
        code, found = report("--scenes", "60", "--simulator", f"{TPS} run -q --timing certified -o -")
        self.assertEqual((code, found["classes"]["RIGHT"]), (0, found["asked"]))
        met = {row["hazard"] for row in found["rows"] if row["asked"] >= 2}
        self.assertLessEqual({"whole", "rebound", "retract", "revolve", "break", "formed", "load", "restitute", "drawn", "infinite mass", "phase",
                              "scheduled_impulse", "end"}, met)

    def test_failures_are_told_apart(self):
        for script, word in (("import time; time.sleep(9)", "hung"), ("import os; os.abort()", "crashed: signal 6"), ("raise ValueError", "exit code 1"),
                             ("while True: print('x' * 1000)", "floods")):
            code, out, _ = self.verdict(script)
            self.assertEqual(code, 4, out)
            self.assertIn(word, out)

    def test_a_refusal_is_no_crash(self):
        code, out, _ = self.verdict("import sys; sys.exit(3)")
        self.assertEqual(code, 1)
        self.assertIn("REFUSED", out)

    def test_nothing_is_no_trace(self):
        code, out, _ = self.verdict("pass")
        self.assertEqual(code, 1)
        self.assertIn("no trace that can be judged", out)

    def test_a_run_without_an_end_is_judged_by_what_it_wrote(self):
        loop = pathlib.Path(ADAPTERS / "paper_loop.py").read_text().replace("pairs.answered.add((i, j, limit))", "pass").replace("(t, pairs.ids", "(0, pairs.ids")
        with tempfile.TemporaryDirectory() as folder:
            for name in ("protocol", "pairs", "responses", "timing"):
                (pathlib.Path(folder) / f"{name}.py").write_text((ADAPTERS / f"{name}.py").read_text())
            (pathlib.Path(folder) / "paper_loop.py").write_text(loop)
            # Long enough for an interpreter to start on a busy machine.
            code, out, _ = conform(*self.FEATURES[:2], "--scenes", "1", "--timeout", "2", "--simulator", f"{sys.executable} -B -E -S {folder}/paper_loop.py")
        self.assertEqual(code, 1, out)
        self.assertIn("WRONG", out)

    def test_scenes_come_one_by_one_too(self):
        done = subprocess.run([TPS, "scene", "random", "--number", "7", "--features", "no-groups,2d"], capture_output=True)
        scene = json.loads(done.stdout)
        self.assertEqual((scene["dimension"], "grouping" in scene, scene["title"]), (2, False, "random scene 7 of seed 1"))
        done = subprocess.run([TPS, "scene", "random", "--features", "no-grops"], capture_output=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn(b"no-groups", done.stderr)


class Reports(unittest.TestCase):
    WORDS = ("--tags", "block_time.plain,block_time.far", *adapter("as_printed"))

    def test_junit_counts_its_cases(self):
        code, out, _ = conform("--format", "junit", *self.WORDS)
        suite = xml.etree.ElementTree.fromstring(out)
        self.assertEqual((code, suite.get("tests"), suite.get("failures")), (1, "2", "1"))
        self.assertEqual(len(suite.findall("testcase")), 2)

    def test_markdown_has_the_sentence_and_the_row(self):
        out = conform("--format", "markdown", *self.WORDS)[1]
        self.assertIn("NOT conforming", out)
        self.assertIn("| block_time.plain |", out)

    def test_markdown_shows_a_name_as_it_is(self):
        hostile = "<img src=x>|`a`*b*[c](d)&amp;"
        with tempfile.TemporaryDirectory() as folder:
            profile = pathlib.Path(folder) / "profile.json"
            profile.write_text(json.dumps({"conform_profile": 1, "name": hostile, "fails": ["WRONG"]}))
            out = conform("--format", "markdown", "--profile", str(profile), *self.WORDS)[1]
        self.assertIn("Profile &lt;img src=x&gt;\\|\\`a\\`\\*b\\*\\[c\\](d)&amp;amp;,", out)
        self.assertNotIn("<img", out)

    def test_the_badge_names_profile_and_data(self):
        out = conform("--format", "svg", *self.WORDS)[1]
        root = xml.etree.ElementTree.fromstring(out)
        self.assertIn("TPS default: not conforming, known answers 1.20261122", root.get("aria-label"))

    def test_html_draws_the_cases(self):
        out = conform("--format", "html", "--tags", "block_time.plain,collision_impulse.plain", "--", sys.executable, "-B", str(BROKEN), "half_rebound")[1]
        page = xml.etree.ElementTree.fromstring(out.replace("<!doctype html>", "").replace('<meta charset="utf-8">', ""))
        self.assertEqual(len(page.findall(".//svg")), 1)
        drawn = [circle.get("class") for circle in page.findall(".//svg/circle")]
        self.assertLessEqual({"right", "found", "body"}, set(drawn))
        self.assertIn("c instead of 1 + c", out)

    def test_environment_is_probed(self):
        contracted = [library for library in LIBRARIES if "contracted" in library]
        environment = report("--tags", "load.plain", "--library", contracted[0])[1]["environment"]
        self.assertEqual((environment["exact"], environment["flushes"], environment["contracts"]), (True, False, True))
        code, found = report("--ops", "load", "--cases", "100", "--library", contracted[0])
        self.assertEqual((code, found["classes"]["NOT BITWISE"] > 0), (0, True))
        environment = report("--tags", "load.plain", *adapter("scalar"))[1]["environment"]
        self.assertEqual((environment["exact"], environment["flushes"], environment["contracts"]), (True, False, False))

    def test_json_fits_its_schema(self):
        import jsonschema
        schema = jsonschema.Draft202012Validator(json.loads((pathlib.Path(SOURCE) / "data/schemas/conform.schema.json").read_text()))
        found = report(*self.WORDS)[1]
        schema.validate(found)
        crashed = report("--tags", "load.plain", "--", sys.executable, "-B", str(BROKEN), "crash")[1]
        schema.validate(crashed)
        self.assertEqual(len(crashed["failed_at"]), len(crashed["failures"]))
        self.assertTrue(crashed["failed_at"][0]["commands"][0].startswith("tps eval apply_impulse"))
        self.assertFalse(schema.is_valid({**found, "unknown": 1}))

    def test_text_ends_with_the_sentence(self):
        out = conform(*self.WORDS)[1]
        self.assertTrue(out.splitlines()[-1].endswith("what fails: block_time"), out)
        self.assertIn("your answer equals: ", out)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
