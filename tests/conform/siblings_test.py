#!/usr/bin/env python3
"""A program that remembers its answers by too few of its inputs is WRONG in the siblings of the operation, whichever input it leaves out.

  siblings_test.py TPS SOURCE
"""
import json
import pathlib
import sys
import tempfile
import unittest

from asking import ADAPTERS, SOURCE, Asking

sys.path.insert(0, str(ADAPTERS))
import effects  # noqa: E402
import groups  # noqa: E402
import responses  # noqa: E402
import timing  # noqa: E402

asking = Asking(shrink_seconds=0)
OPERATIONS = {**timing.OPERATIONS, **responses.OPERATIONS, **groups.OPERATIONS, **effects.OPERATIONS}
#: The right adapter, which remembers an answer by all inputs but one.
FORGETFUL = """import sys
sys.path.insert(0, sys.argv[1])
import effects, groups, responses, timing
from protocol import serve
place = int(sys.argv[2])
def remembering(operation):
    known = {}
    def answer(**numbers):
        forgotten = sorted(numbers)[place:place + 1]
        key = repr({name: value for name, value in numbers.items() if name not in forgotten})
        if key not in known:
            known[key] = operation(**numbers)
        return known[key]
    return answer
all = {**timing.OPERATIONS, **responses.OPERATIONS, **groups.OPERATIONS, **effects.OPERATIONS}
serve("forgetful", {name: remembering(operation) for name, operation in all.items()})
"""


def inputs():
    """Of each operation, from its known answers."""
    for op in OPERATIONS:
        file = min((pathlib.Path(SOURCE) / "data/vectors").glob(f"{op}.*.jsonl"))
        yield op, set(json.loads(file.read_text(encoding="utf-8").splitlines()[1])["in"])


class Siblings(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.program = pathlib.Path(folder.name) / "forgetful.py"
        self.program.write_text(FORGETFUL)

    def wrong_without(self, place):
        """Operations that are wrong where each forgets the input at that place of its sorted ones."""
        code, report = asking.report("--level", "2", "--tags", "*.siblings", "--", sys.executable, "-B", "-E", "-S", str(self.program), str(ADAPTERS), str(place))
        rows = {row["name"].removesuffix(".siblings"): row["classes"]["WRONG"] for row in report["rows"]}
        self.assertEqual(set(rows), set(OPERATIONS))
        for row in report["rows"]:
            if row["classes"]["WRONG"] > 0:
                self.assertIn("the answer to another question: remembered by too few of its numbers", row["equals"])
        return code, {op for op, wrong in rows.items() if wrong > 0}

    def test_whoever_remembers_all_conforms(self):
        self.assertEqual(self.wrong_without(99), (0, set()))

    def test_what_is_asked_in_between_changes_nothing(self):
        """A program that keeps the tightest limit that it was ever asked about."""
        self.program.write_text(FORGETFUL.replace("remembering(operation) for", "tightening(operation) for").replace("all = {", """LEAST = {}
def tightening(operation):
    def answer(**numbers):
        if "L" in numbers:
            of = str([numbers[name] for name in ("u_A", "u_B", "v_A", "v_B") if name in numbers])
            numbers["L"] = LEAST[of] = min(numbers["L"], LEAST.get(of, numbers["L"]))
        return operation(**numbers)
    return answer
all = {"""))
        code, report = asking.report("--level", "2", "--tags", "block_time.siblings", "--", sys.executable, "-B", "-E", "-S", str(self.program), str(ADAPTERS), "99")
        self.assertEqual(code, 1)
        self.assertIn("/again", report["rows"][0]["example"]["id"])

    def test_each_input_matters(self):
        """But to an order, which is one of four words."""
        counts = {op: len(keys) for op, keys in inputs() if op != "order"}
        for place in range(max(counts.values())):
            with self.subTest(place):
                code, wrong = self.wrong_without(place)
                self.assertEqual((code, wrong - {"order"}), (1, {op for op, count in counts.items() if place < count}))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
