"""`tps conform` as the tests call it, and the programs that they ask. The first two arguments of a test are the program and the source folder."""
import json
import pathlib
import subprocess
import sys

TPS, SOURCE = sys.argv[1:3]
ADAPTERS = pathlib.Path(SOURCE) / "data/adapters/python"
BROKEN = pathlib.Path(SOURCE) / "tests/properties/implementation.py"


def adapter(name):
    return ["--", sys.executable, "-B", str(ADAPTERS / f"{name}.py")]


class Asking:
    def __init__(self, shrink_seconds):
        self.shrink_seconds = str(shrink_seconds)

    def conform(self, *words):
        """Its exit code and what it prints."""
        level = [] if "--level" in words else ["--level", "1"]
        cases = [] if "--cases" in words else ["--cases", "5"]
        done = subprocess.run([TPS, "conform", "--quiet", *level, *cases, "--shrink-seconds", self.shrink_seconds, *words], capture_output=True, timeout=600)
        return done.returncode, done.stdout.decode(), done.stderr.decode()

    def report(self, *words):
        code, out, _ = self.conform("--format", "json", *words)
        return code, json.loads(out)
