#!/usr/bin/env python3
"""Whole runs of simulators that are right, and that are wrong in ways which a single step does not show.

  runs_test.py TPS SOURCE
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

from asking import TPS, Asking

asking = Asking(shrink_seconds=0)
RUN = "tps, path = sys.argv[1:]\ntrace = subprocess.run([tps, 'run', '-q', path, '-o', '-'], capture_output=True, text=True).stdout\n"


class Simulators(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def asked(self, body, *words):
        """A simulator in Python whose scene is at sys.argv[2]."""
        path = pathlib.Path(self.folder.name) / "simulator.py"
        path.write_text("import json, subprocess, sys\n" + body)
        scenes = [] if "--scenes" in words else ["--scenes", "6"]
        return asking.conform(*scenes, "--timeout", "120", *words, "--simulator", f"{sys.executable} -B {path} {TPS}")


class Ends(Simulators):
    """Nobody stops the run of a simulator."""

    def ending(self, reason):
        return ("start = json.load(open(sys.argv[2])).get('start_time', 0)\nprint('{\"trace\":1,\"form\":\"minimal\"}')\n"
                f"print(json.dumps({{'end': '{reason}', 'events': 0, 't': start}}))\n")

    def test_a_run_that_stops_before_its_time_is_wrong(self):
        for reason in ("interrupted", "max_events", "out_of_range"):
            code, out, _ = self.asked(self.ending(reason))
            self.assertEqual(code, 1, out)
            self.assertIn(f"the run ends as {reason} after 0 events; it was asked for the whole duration of the scene", out)

    def test_nor_may_it_say_that_it_was_its_time(self):
        for reason in ("duration", "no_more_events", "stalled"):
            self.assertEqual(self.asked(self.ending(reason))[0], 1, reason)

    def test_as_an_operation_it_may_stop_after_what_was_asked_for(self):
        simulate = ("for line in sys.stdin:\n    q = json.loads(line)\n    if 'bye' in q: break\n    reply = {'name': 'early', 'ops': ['simulate']}\n"
                    "    if 'op' in q:\n        scene = q['in']['scene']; open(sys.argv[2], 'w').write(json.dumps(scene))\n"
                    "        most = MOST\n"
                    "        lines = subprocess.run([sys.argv[1], 'run', '-q', sys.argv[2], '-o', '-', '--max-events', str(most)], capture_output=True, text=True).stdout.splitlines()\n"
                    "        reply = {'seq': q['seq'], 'out': {'trace': [json.loads(each) for each in lines]}}\n    print(json.dumps(reply), flush=True)\n")
        for most, right in (("q['in']['max_events']", 0), ("1", 1)):
            path = pathlib.Path(self.folder.name) / "simulate.py"
            path.write_text("import json, subprocess, sys\n" + simulate.replace("MOST", most))
            code, out, err = asking.conform("--timeout", "120", "--scenes", "6", "--ops", "simulate", "--", sys.executable, "-B", str(path), TPS, self.folder.name + "/scene.json")
            self.assertEqual(code, right, out + err)
            if right == 1:
                self.assertIn("the run ends as max_events after 1 events; it was asked for 1000 events", out)
                self.assertIn('"op":"simulate"', out)

    def test_an_answer_without_a_trace_is_wrong(self):
        path = pathlib.Path(self.folder.name) / "text.py"
        path.write_text("import json, sys\nfor line in sys.stdin:\n    q = json.loads(line)\n    if 'bye' in q: break\n"
                        "    print(json.dumps({'seq': q['seq'], 'out': {'trace': 'text'}} if 'op' in q else {'name': 'x', 'ops': ['simulate']}), flush=True)\n")
        code, out, _ = asking.conform("--scenes", "3", "--ops", "simulate", "--", sys.executable, "-B", str(path))
        self.assertEqual(code, 1, out)
        self.assertIn('it is {"trace":[line, …]}', out)


class LastLines(Simulators):
    def test_a_last_line_without_an_end_is_read(self):
        code, out, err = self.asked(RUN + "sys.stdout.write(trace.rstrip('\\n'))\n")
        self.assertEqual(code, 0, out + err)

    def test_what_stands_behind_the_last_line_end_is_judged(self):
        self.assertEqual(self.asked(RUN + "sys.stdout.write(trace + '{\"t\":1')\n")[0], 1)


class Draws(Simulators):
    """What a probability decides, where a minimal trace does not say what was drawn."""

    MINIMAL = ("def minimal(trace, header):\n    lines = [json.loads(each) for each in trace.splitlines()]\n    print(json.dumps({'trace': 1, 'form': 'minimal', **header}))\n"
               "    for line in lines[1:]:\n        if 'state' in line: continue\n        keep = {k: v for k, v in line.items() if k in ('t', 'kind', 'i', 'j', 'tether', 'wall', 'face', 'phase', 'end', 'events', 'members')}\n"
               "        if 'post' in line: keep['post'] = {k: {'velocity': v['velocity'], **({'spin': v['spin']} if 'spin' in v else {})} for k, v in line['post'].items()}\n"
               "        print(json.dumps(keep))\n")

    def test_that_it_was_not_judged_is_said(self):
        code, out, err = self.asked(self.MINIMAL + RUN + "minimal(trace, {'draws': 'recorded'})\n", "--scenes", "20")
        self.assertEqual(code, 0, out + err)
        self.assertIn("not judged, tethers: what a probability decides is taken as given where no draw is recorded", out)

    def test_draws_of_the_seed_are_computed(self):
        right = self.asked(self.MINIMAL + RUN + "minimal(trace, {'draws': 'philox'})\n", "--scenes", "20")
        self.assertEqual(right[0], 0, right[1])
        self.assertNotIn("not judged, tethers", right[1])
        always = ("scene = json.load(open(sys.argv[2]))\nfor pair in scene['pairs']:\n    form = pair.get('tethering', {}).get('form')\n"
                  "    if isinstance(form, dict): pair['tethering']['form'] = 'always'\nsys.argv[2] += '.always'\njson.dump(scene, open(sys.argv[2], 'w'))\n")
        wrong = self.asked(self.MINIMAL + always + RUN + "minimal(trace, {'draws': 'philox'})\n", "--scenes", "20")
        self.assertEqual(wrong[0], 1, wrong[1])
        self.assertIn("form a tether, but the draw is", wrong[1])

    def test_probabilities_of_zero_and_one_need_no_draw(self):
        for probability, tether, right in ((0, True, False), (0, False, True), (1, True, True), (1, False, False)):
            scene = {"tps": 1, "dimension": 2, "duration": 6, "species": {"A": {"mass": 1, "radius": 0.5}},
                     "pairs": [{"between": ["A", "A"], "blocking": {"c_rebound": 1},
                                "tethering": {"distance": 9, "c_retract": 1, "c_revolve": 1, "theta_revolve_deg": 45, "form": {"probability": probability}}}],
                     "particles": [{"species": "A", "position": [0, 0], "velocity": [1, 0]}, {"species": "A", "position": [3, 0], "velocity": [-1, 0]}]}
            event = {"t": 1, "kind": "rebound", "i": 0, "j": 1, "post": {"0": {"velocity": [-1, 0]}, "1": {"velocity": [1, 0]}}}
            if tether:
                event["tether"] = "formed"
            rows = [{"trace": 1, "form": "minimal", "scene": scene}, event, {"end": "max_events", "events": 1, "t": 1}]
            path = pathlib.Path(self.folder.name) / "pair.ndjson"
            path.write_text("".join(json.dumps(row) + "\n" for row in rows))
            done = subprocess.run([TPS, "check", "-q", path], capture_output=True, text=True)
            self.assertEqual(done.returncode == 0, right, done.stdout)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
