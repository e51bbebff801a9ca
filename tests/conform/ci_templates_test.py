#!/usr/bin/env python3
"""The templates for CI systems are YAML of the shape that these read, and the command in them is one that `tps` takes.

  ci_templates_test.py TPS SOURCE
"""
import pathlib
import shlex
import subprocess
import sys

import yaml

tps, source = sys.argv[1], pathlib.Path(sys.argv[2])
github = yaml.safe_load((source / "docs/ci/github-actions.yml").read_text(encoding="utf-8"))
gitlab = yaml.safe_load((source / "docs/ci/gitlab-ci.yml").read_text(encoding="utf-8"))
steps = github["jobs"]["conform"]["steps"]
lines = [line for step in steps for line in step.get("run", "").splitlines()] + gitlab["conform"]["script"]
commands = [shlex.split(line) for line in lines if "tps conform" in line]
assert len(commands) == 2, lines
for command in commands:
    words = command[1:command.index("--")] + ["--level", "1", "--tags", "load.plain"]
    del words[words.index("--report"):words.index("--report") + 2]
    done = subprocess.run([tps, *words, "--", tps, "serve"], capture_output=True, timeout=60)
    assert done.returncode == 0 and done.stdout, (command, done.stderr)
print(f"{len(commands)} templates")
