#!/usr/bin/env python3
"""The first lines of every known-answer file fit the schema; with a key too many, or one too few, they do not. What is said to be exact in
single precision is."""
import glob, itertools, json, os, struct, sys

import jsonschema

root = sys.argv[1]
with open(os.path.join(root, "data/schemas/vectors.schema.json"), encoding="utf-8") as file:
    line_of_vectors = jsonschema.Draft202012Validator(json.load(file))
judged = 0
for name in sorted(glob.glob(os.path.join(root, "data/vectors/*.jsonl"))):
    with open(name, encoding="utf-8") as lines:
        for line in itertools.islice(lines, 4):
            case = json.loads(line)
            error = jsonschema.exceptions.best_match(line_of_vectors.iter_errors(case))
            if error:
                sys.exit(f"{name}: {error.message}")
            spoiled = [{**case, "unknown": 1}, {key: case[key] for key in list(case)[:-1]}]
            if any(line_of_vectors.is_valid(wrong) for wrong in spoiled):
                sys.exit(f"{name}: the schema accepts a line with a wrong set of keys")
            judged += 1


def numbers(value):
    """Those of an input, finite ones."""
    if isinstance(value, (dict, list)):
        return [x for each in (value.values() if isinstance(value, dict) else value) for x in numbers(each)]
    return [float.fromhex(value)] if isinstance(value, str) and "0x" in value else []


in_float = 0
for name in glob.glob(os.path.join(root, "data/vectors/*.float32.jsonl")):
    with open(name, encoding="utf-8") as lines:
        for line in lines:
            for x in numbers(json.loads(line).get("in")):
                in_float += 1
                if struct.unpack("f", struct.pack("f", x))[0] != x:
                    sys.exit(f"{name}: {x.hex()} is no float: {line}")
print(f"{judged} lines, {in_float} floats")
if in_float < 1000:
    sys.exit("too few floats")
sys.exit(0 if judged > 400 else "too few lines")
