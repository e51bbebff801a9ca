"""Every committed regression fits its schema; with a key too many, or one too few, it does not."""

import json
import pathlib
import sys

import jsonschema

root = pathlib.Path(sys.argv[1])
line_of_regressions = jsonschema.Draft202012Validator(
    json.loads((root / "data/schemas/regression.schema.json").read_text(encoding="utf-8")))
judged = 0
for path in sorted((root / "data/regressions").glob("*.jsonl")):
    for line in path.read_text(encoding="utf-8").splitlines():
        regression = json.loads(line)
        error = jsonschema.exceptions.best_match(line_of_regressions.iter_errors(regression))
        if error:
            sys.exit(f"{path}: {error.message}")
        spoiled = [{**regression, "unknown": 1}, {key: regression[key] for key in list(regression)[:-1]}]
        if any(line_of_regressions.is_valid(wrong) for wrong in spoiled):
            sys.exit(f"{path}: the schema accepts a line with a wrong set of keys")
        judged += 1
print(f"{judged} lines")
sys.exit(0 if judged >= 5 else "too few lines")
