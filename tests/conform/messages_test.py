#!/usr/bin/env python3
"""What a new user reads: each class with a case and its commands, each failure with what to do about it.

  messages_test.py TPS SOURCE LIBRARY_IN_FLOAT
"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

from asking import ADAPTERS, BROKEN, TPS, Asking, adapter

FLOAT = sys.argv[3]
asking = Asking(shrink_seconds=0)
conform, report = asking.conform, asking.report
FEATURES = ("--features", "no-groups,no-draws,no-phases,no-impulses")


class Classes(unittest.TestCase):
    def test_a_class_that_passes_shows_a_case_and_its_command(self):
        lines = conform("--tags", "block_time.touching", *adapter("by_approach"))[1].splitlines()
        at = lines.index("OTHER READING")
        self.assertIn("its time is right", lines[at + 2])
        self.assertTrue(lines[at + 3].startswith("      tps eval block_time "), lines[at + 3])

    def test_another_name_is_another_reading_in_laws_too(self):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "protocol.py").write_text((ADAPTERS / "protocol.py").read_text())
            text = (ADAPTERS / "timing.py").read_text()
            self.assertEqual(text.count('"turning"'), 1)
            (pathlib.Path(folder) / "timing.py").write_text(text.replace('"turning"', '"hit"'))
            code, found = report("--ops", "tether_time", "--cases", "30", "--", sys.executable, "-B", f"{folder}/timing.py")
        classes = {row["name"]: row["classes"] for row in found["rows"]}
        self.assertEqual((code, found["classes"]["WRONG"]), (0, 0), found["sentence"])
        self.assertEqual(classes["tether_time.tangent"]["OTHER READING"], 10)
        self.assertGreater(classes["Eq2Laws.Law6AwayFromBoundariesTheVerdictIsRight"]["OTHER READING"], 0)

    def test_what_is_all_right_has_no_worst_answer(self):
        for words in (("--scalar", "float", "--tags", "load.*,block_time.*"), ("--tags", "load.*", "--", TPS, "serve")):
            for row in report(*words)[1]["rows"]:
                self.assertTrue("worst" not in row or row["classes"]["ROUNDING"] > 0, row)
        self.assertIn("  –  ", conform("--tags", "load.*", "--", TPS, "serve")[1])

    def test_a_float_program_that_says_double_is_recognised(self):
        _, found = report("--bits", "53", "--tags", "tether_time.plain,collision_impulse.plain,load.plain", "--library", FLOAT)
        self.assertEqual({row["name"]: row.get("equals") for row in found["rows"]}, {row["name"]: ["float32 inside"] for row in found["rows"]})


class Times(unittest.TestCase):
    """What a verdict may be: a word of the operation that agrees with t."""

    def reply(self, folder, out):
        """A program that answers everything with this."""
        path = pathlib.Path(folder) / "same.py"
        path.write_text("import json, sys\nfor line in sys.stdin:\n    q = json.loads(line)\n    if 'bye' in q: break\n"
                        f"    print(json.dumps({{'name': 'same'}} if 'hello' in q else {{'seq': q['seq'], 'out': {out!r}}}), flush=True)\n")
        return "--", sys.executable, "-B", str(path)

    def test_words_that_are_no_verdict_are_wrong(self):
        with tempfile.TemporaryDirectory() as folder:
            for out, said in [({"verdict": "banana", "t": None}, 'verdict is "banana"; the verdicts of block_time are static, receding,'),
                              ({"verdict": "RECEDING", "t": None}, 'verdict is "RECEDING"; the'), ({"verdict": 3, "t": None}, "verdict is 3; the"),
                              ({"verdict": None, "t": None}, "verdict is null; the"), ({"verdict": "taut", "t": 0}, 'verdict is "taut"; the'),
                              ({"verdict": "hit", "t": None}, 'verdict is "hit", which has a time, and t is null'),
                              ({"verdict": "miss", "t": 1}, 'verdict is "miss", which has no time, and t is 1'), ({}, "out has neither verdict nor t")]:
                code, found, _ = conform("--tags", "block_time.plain", *self.reply(folder, out))
                self.assertEqual((code, found.count(said)), (1, 1), f"{out}\n{found}")
                self.assertNotIn("(FMA)", found)

    def test_a_program_that_is_wrong_about_both_images_fuses_nothing(self):
        as_printed = ADAPTERS.parents[2] / "docs/tutorial/as_printed.py"
        self.assertNotIn("(FMA)", conform("--tags", "block_time.plain", "--", sys.executable, "-B", str(as_printed))[1])

    def test_the_programs_of_the_tutorial_answer_every_question(self):
        for name in ("by_approach", "stable", "rebound"):
            program = ADAPTERS.parents[2] / f"docs/tutorial/{name}.py"
            code, found, _ = conform("--level", "2", "--tags", "block_time.any_scale,tether_time.any_scale", "--", sys.executable, "-B", str(program))
            self.assertEqual(code, 0, found)


class States(unittest.TestCase):
    """A state that is none is WRONG, whatever is the matter with it."""

    def test_what_is_wrong_with_a_state_is_said(self):
        with tempfile.TemporaryDirectory() as folder:
            for change, said in [("s[0]['id'] = '0'", "which is no particle"), ("s[0]['id'] = None", "which is no particle"),
                                 ("out['state'] = 3", "state is 3; it is a list of particles"), ("s[1] = 7", "state has 7, which is no particle"),
                                 ("s.append(dict(s[0]))", "twice"), ("s.append(dict(s[0], id=99))", "particles; the scene has"),
                                 ("s.pop()", "particles; the scene has")]:
                path = pathlib.Path(folder) / "proxy.py"
                path.write_text("import json, subprocess, sys\n"
                                f"serve = subprocess.Popen([{TPS!r}, 'serve'], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)\n"
                                "for line in sys.stdin:\n"
                                "    serve.stdin.write(line); serve.stdin.flush()\n"
                                "    if 'bye' in line: break\n"
                                "    reply = json.loads(serve.stdout.readline()); out = reply.get('out', {}); s = out.get('state', [])\n"
                                f"    if s:\n        {change}\n"
                                "    print(json.dumps(reply), flush=True)\n")
                code, found, err = conform("--tags", "next_event.gas,next_event.step_rebound", "--", sys.executable, "-B", str(path))
                self.assertEqual(code, 1, f"{change}\n{found}{err}")
                self.assertIn(said, found, change)
                self.assertRegex(found, r"35 of 35: gas 10, step_rebound 25|25 of 35: gas 10, step_rebound 15", change)


class Hello(unittest.TestCase):
    def test_what_a_program_says_of_itself_is_of_the_right_kind(self):
        with tempfile.TemporaryDirectory() as folder:
            for hello, said in [({"name": 3}, "has no name"), ({"name": "x", "ops": "block_time"}, 'ops = "block_time"; allowed is a list of words'),
                                ({"name": "x", "ops": None}, "ops = null"), ({"name": "x", "features": {"2d": True}}, "features = "),
                                ({"name": "x", "features": ["2d", 3]}, "features = "), ({"name": "x", "group": "both"}, 'group = "both"; allowed are "inner" and "outer"')]:
                path = pathlib.Path(folder) / "hello.py"
                path.write_text(f"import json\ninput()\nprint(json.dumps({hello!r}), flush=True)\ninput()\n")
                code, _, err = conform("--", sys.executable, "-B", str(path))
                self.assertEqual((code, said in err), (4, True), f"{hello}: {err}")


class Operations(unittest.TestCase):
    def test_one_that_is_none_is_refused_with_the_list(self):
        code, _, err = conform("--ops", "block_tim", *adapter("scalar"))
        self.assertEqual(code, 2)
        self.assertIn("block_tim is no operation; there are distance, block_time, tether_time,", err)

    def test_one_that_is_asked_for_and_not_offered_fails(self):
        code, found = report("--ops", "block_time,wall_time", *adapter("by_approach"))
        self.assertEqual(code, 1)
        self.assertEqual([row["name"] for row in found["rows"] if not row["accepted"]], ["wall_time.offered"])

    def test_laws_that_need_what_is_not_offered_are_listed(self):
        out = conform("--cases", "1", *adapter("by_approach"))[1]
        self.assertIn("not asked either: laws 1–3 of eq. (1) need distance; laws 1–4 of order need order;", out)

    def test_a_law_of_one_timing_query_is_asked_of_either(self):
        for op in ("block_time", "tether_time"):
            _, found = report("--ops", op, *adapter("scalar"))
            self.assertGreaterEqual(sum(row["asked"] > 0 for row in found["rows"] if row["of"] == "laws"), 8)


class Failures(unittest.TestCase):
    def test_a_crash_names_its_question_and_how_to_ask_it_again(self):
        code, out, _ = conform("--tags", "load.plain", "--", sys.executable, "-B", str(BROKEN), "crash")
        self.assertEqual(code, 4)
        at = next(n for n, line in enumerate(out.splitlines()) if line.startswith("FAILED load.plain.00000: crashed"))
        right, again = out.splitlines()[at + 1:at + 3]
        self.assertTrue(right.startswith("      tps eval load m_A="), right)
        self.assertTrue(again.endswith(f"| {sys.executable} -B {BROKEN} crash"), again)
        replay = subprocess.run(["sh", "-c", again], capture_output=True)
        self.assertNotEqual(replay.returncode, 0)

    def test_the_last_lines_of_standard_error_are_whole(self):
        script = "import sys; sys.stderr.write('a first line\\n' + 'x' * 390 + '\\n    ~~~~^^^\\nValueError: the last one\\n'); sys.exit(1)"
        out = conform("--tags", "load.plain", "--", sys.executable, "-c", script)[2]
        self.assertTrue(out.rstrip().endswith("on standard error: ValueError: the last one"), out)

    def test_a_run_that_does_not_end_is_judged_and_can_be_made_again(self):
        """Without D11 scene ENDLESS of contacts rebounds for ever."""
        with tempfile.TemporaryDirectory() as folder:
            for path in ADAPTERS.glob("*.py"):
                text = path.read_text().replace("pairs.answered.add((i, j, limit))", "pass").replace("while still <=", "while True or still <=")
                (pathlib.Path(folder) / path.name).write_text(text)
            code, out, _ = conform("--features", "contacts", "--first-scene", "0", "--scenes", "1", "--timeout", "2", "--simulator",
                                   f"{sys.executable} -B -u {folder}/paper_loop.py")
        self.assertEqual(code, 4, out)
        self.assertIn("hung: no end within 2000 ms; the ", out)
        self.assertIn("events that it wrote until then were judged: OTHER READING, ", out)
        self.assertIn("another reading of the paper, D11: ", out)
        self.assertIn("tps scene random --seed 1 --number 0 --features contacts -o scene.json", out)


class Hints(unittest.TestCase):
    def test_who_knows_no_groups_is_told_how_to_be_asked(self):
        # Scenes with grouping and without, none of which goes on for thousands of events.
        _, found = report("--features", "no-draws,no-phases,no-impulses", "--first-scene", "8", "--scenes", "8", "--simulator",
                          f"{sys.executable} -B {ADAPTERS}/paper_loop.py")
        self.assertTrue(found["classes"]["RIGHT"] > 0 and found["classes"]["WRONG"] > 0, found["classes"])
        self.assertTrue(found["notes"]["hint"].endswith("--features no-groups"), found["notes"])

    def test_who_is_wrong_in_every_scene_gets_no_hint(self):
        _, found = report(*FEATURES, "--scenes", "4", "--simulator", f"{sys.executable} -c pass")
        self.assertNotIn("hint", found["notes"])


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
