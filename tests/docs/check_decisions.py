"""Every test that docs/decisions.md names as pinning a decision exists: patterns are matched against ctest's list."""
import fnmatch
import pathlib
import re
import subprocess
import sys

root, build = map(pathlib.Path, sys.argv[1:3])
listing = subprocess.run(["ctest", "-N"], cwd=build, capture_output=True, text=True, check=True).stdout
names = re.findall(r"Test\s+#\d+: (\S+)", listing)
failures = []
for line in (root / "docs" / "decisions.md").read_text().splitlines():
    row = re.match(r"\| ([DN]\d+) \|", line)
    if not row:
        continue
    pins = re.findall(r"`([a-z_]+\.[^`]*)`", line.rsplit("|", 2)[1])
    if not pins:
        failures.append(f"{row.group(1)} names no test that pins it")
    for pin in pins:
        if not fnmatch.filter(names, pin):
            failures.append(f"{row.group(1)} is pinned by {pin}, which matches none of the {len(names)} tests")
sys.exit("docs/decisions.md: " + "; ".join(failures) if failures else 0)
