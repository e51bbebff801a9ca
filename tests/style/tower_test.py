#!/usr/bin/env python3
"""tower.py sees an include that runs up, round, to a verb, nowhere, or by a relative path, however it is written."""
import pathlib
import subprocess
import sys
import tempfile

TOWER = pathlib.Path(__file__).with_name("tower.py")
GOOD = {
    "reference/run/run.hpp": '#include "reference/scalars.hpp"\n#include <vector>',
    "reference/scalars.hpp": "",
    "verify/eval/eval.hpp": '#include "reference/run/run.hpp"',
    "verify/eval/eval_verb.cpp": '#include "verify/eval/eval.hpp"\n#include "verify/draw/draw.hpp"',
    "verify/draw/draw.hpp": '#include "verify/eval/eval.hpp"',
    "properties/law.hpp": '#include "verify/eval/eval.hpp"',
    "properties/runs/laws.hpp": '#include "properties/law.hpp"',
}
# file, what it includes besides, a part of what is said
FAULTS = [
    ("reference/run/run.hpp", '#include "verify/eval/eval.hpp"', "an arrow that runs up"),
    ("reference/run/run.hpp", "#  include <verify/eval/eval.hpp>", "an arrow that runs up"),
    ("reference/run/run.hpp", '#include "../../verify/eval/eval.hpp"', "paths begin at the root"),
    ("reference/run/run.hpp", '#include "./run.hpp"', "paths begin at the root"),
    ("reference/scalars.hpp", '#include "reference/run/run.hpp"', "in a circle"),
    ("verify/eval/eval.hpp", '#include "verify/draw/draw.hpp"', "in a circle"),
    ("properties/law.hpp", '#include "properties/runs/laws.hpp"', "in a circle"),
    ("verify/draw/draw.hpp", '#include "verify/eval/eval_verb.cpp"', "nobody uses a verb"),
    ("verify/draw/draw.hpp", '#include "verify/eval/none.hpp"', "which is not there"),
]


def seen(faulty=None, include=""):
    with tempfile.TemporaryDirectory() as root:
        for name, text in GOOD.items():
            path = pathlib.Path(root, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(f"{text}\n{include if name == faulty else ''}\n", encoding="utf-8")
        done = subprocess.run([sys.executable, TOWER, root], capture_output=True, text=True)
        return done.returncode, done.stderr


def main():
    wrong = [] if seen()[0] == 0 else [f"a good tree: {seen()}"]
    for name, include, said in FAULTS:
        code, text = seen(name, include)
        if code == 0 or said not in text:
            wrong.append(f"{name} with {include}: {code}, {text}")
    print(f"{len(FAULTS)} faults put into a tower, {len(wrong)} not seen")
    sys.exit("\n".join(wrong) or 0)


if __name__ == "__main__":
    main()
