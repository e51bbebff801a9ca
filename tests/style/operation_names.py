"""The names of operations are written in one place, verify/operations/catalogue.cpp; other code says Op::block_time, which the
compiler knows. Left out are names that are also words of other formats (distance, load, order, group), comments, and requests
that a text shows as an example. Argument: the source folder."""
import pathlib
import re
import sys

source = pathlib.Path(sys.argv[1])
CATALOGUE = source / "verify/operations/catalogue.cpp"
names = set(re.findall(r'Op::(\w+),\s+\.name = "\1"', CATALOGUE.read_text()))
listed = set(re.search(r"enum class Op \{(.*?)\}", CATALOGUE.with_suffix(".hpp").read_text(), re.S).group(1).replace(",", " ").split())
if not names or names != listed:
    sys.exit(f"in the catalogue, not in Op or the reverse: {sorted(names ^ listed)}")
quoted = re.compile(r'(?<!"op":)"(%s)"' % "|".join(names - {"distance", "load", "order", "group"}))
files = [path for folder in ("reference", "verify", "properties", "site") for path in (source / folder).rglob("*.[ch]pp")
         if path != CATALOGUE and not path.stem.endswith("_test") and "node_modules" not in path.parts]
found = [f"{path.relative_to(source)}:{number}: {line.strip()}" for path in files
         for number, line in enumerate(path.read_text().splitlines(), 1) if quoted.search(line.split("//")[0])]
if found or len(files) < 100:
    sys.exit("\n".join(found) or "the sources are not where they were")
print(f"{len(names)} operations, named in {CATALOGUE.relative_to(source)} alone of {len(files)} files")
