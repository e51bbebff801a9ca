"""Validates every line of traces against the schema: validate_trace.py SCHEMA TRACE…

Prints the first violation and exits with 1; a line that is no JSON is one."""
import json
import sys

import jsonschema

with open(sys.argv[1]) as text:
    schema = json.load(text)
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)
for path in sys.argv[2:]:
    with open(path) as lines:
        for number, line in enumerate(lines, 1):
            error = jsonschema.exceptions.best_match(validator.iter_errors(json.loads(line)))
            if error is not None:
                sys.exit(f"{path}:{number}: {error.json_path}: {error.message[:400]}")
