"""One function writes JSON (json_text, reference/text/plain_json.hpp): no other calls the library's dump(), which leaves
control and reordering characters raw. Argument: the source folder."""
import pathlib
import sys

source = pathlib.Path(sys.argv[1])
WRITER = source / "reference/text/plain_json.cpp"
files = [path for folder in ("reference", "verify", "properties") for path in (source / folder).rglob("*.[ch]pp")
         if path != WRITER and not path.stem.endswith("_test")]
found = [f"{path.relative_to(source)}:{number}: {line.strip()}" for path in files
         for number, line in enumerate(path.read_text().splitlines(), 1) if ".dump(" in line]
if found or len(files) < 100 or ".dump(" not in WRITER.read_text():
    sys.exit("\n".join(found) or "the writer of JSON, or the sources, are not where they were")
print(f"{len(files)} files, JSON written by {WRITER.relative_to(source)} alone")
