"""What .github/workflows/ runs, ./run or .ci/run knows; and the hours of fuzzing name each target.

  workflow_test.py ROOT
"""
import os
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
known = (root / "run").read_text(encoding="utf-8")
wrong, explored, seen = [], [], 0
for file in sorted((root / ".github" / "workflows").glob("*.yml")):
    text = file.read_text(encoding="utf-8")
    listed = [words for found in re.findall(r"command:((?:\n +- .*)+)", text) for words in re.findall(r"- (.*)", found)]
    commands = [command for command in re.findall(r"- run: (\S.*)", text) if "${{" not in command] + [f"./run {words}" for words in listed]
    for command in commands:
        seen += 1
        program, *words = command.split()
        if not os.access(root / program, os.X_OK):
            wrong.append(f"{file.name}: {program} is no program of the repository")
        if words[:1] == ["fuzz"]:
            explored += words[3:]
            words = words[:1]
        for word in words if program == "./run" else []:
            if re.fullmatch(r"[a-z-]*[a-z]", word) and not word.startswith("-") and not re.search(rf"^ *{word}\)", known, re.M):
                wrong.append(f"{file.name}: ./run has no {word}")
if sorted(explored) != sorted(path.name for path in (root / "tests" / "fuzz" / "corpus").iterdir()):
    wrong.append(f".github/workflows explores {' '.join(sorted(explored))}, which are not the targets of tests/fuzz/corpus, each once")
if not seen:
    wrong.append(".github/workflows runs nothing")
sys.exit("\n".join(wrong) or 0)
