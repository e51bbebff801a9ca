"""The README shows the one list of packages that ./run installs from."""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
listed = (root / ".ci" / "packages.txt").read_text().split()
readme = (root / "README.md").read_text()
shown = re.search(r"Packages \(Debian;.*?\):\n`([^`]*)`", readme, re.S)
if shown is None:
    sys.exit("README.md: no list of packages after 'Packages (Debian; …):'")
if shown.group(1).split() != listed:
    sys.exit(f"README.md lists {shown.group(1).split()},\n.ci/packages.txt lists {listed}; make them equal")
