"""The schemas of what we read, judged by a validator that shares no code with ours (python3-jsonschema).

1. data/schemas/*.json are valid schemas; every key of what we read has a description, and an example that fits.
2. Every good scene, and every scene under data/scenes, is accepted.
3. Every broken scene whose fault the schema can express is refused; the others are listed here with the reason.
4. The scenarios that `tps import` is tested with are accepted.
"""

import json
import pathlib
import re
import sys
import unittest

import jsonschema

ROOT = pathlib.Path(__file__).resolve().parents[2]
BROKEN = ROOT / "tests/scene/broken"
SCENE = json.loads((ROOT / "data/schemas/scene.schema.json").read_text(encoding="utf-8"))
ARSLAB_TPS = json.loads((ROOT / "data/schemas/arslab_tps.schema.json").read_text(encoding="utf-8"))

# Faults of meaning: the shape is right.
SEMANTIC = {
    "box", "box_open", "start_too_near_across_an_edge",
    "capacity", "containment_without_room", "distance_overflow", "distance_zero", "gap_too_small", "id_twice",
    "impulse_of_three", "impulse_on_a_wall", "impulse_on_infinite_mass", "infinite_masses_part", "drag_with_grouping", "friction_with_drag", "friction_without_meaning", "spin_of_two", "drag_with_a_moving_wall", "drag_without_meaning", "kicks_without_meaning", "pair_twice",
    "permanent_breaks", "phase_of_permanent", "phases_of_nothing", "phases_overlap", "start_outside_containment",
    "start_too_far", "start_too_near", "outside_of_a_box", "outside_of_a_box_values", "starts_in_walls", "tether_of_infinite_masses", "tether_of_permanent", "tether_to_nobody",
    "tethering_without_distance", "tethers_wrong", "unknown_species", "vector_length", "walls",
}
# Numbers in strings: a standard validator sees their pattern, not their value.
NUMBERS_IN_STRINGS = {"hex_float_out_of_range", "seed_too_large"}
# No JSON, or JSON that says a thing twice: json.loads takes some of it, the schema never sees the fault.
NOT_JSON = {
    "blank", "byte_order_mark", "comment", "deep", "duplicate_keys", "empty", "invalid_utf8", "minus_infinity", "nan",
    "nul_bytes", "single_quotes", "too_large_number", "trailing_comma", "trailing_garbage", "truncated", "utf16",
}


def validator(schema):
    return jsonschema.Draft202012Validator(schema)


def accepts(path):
    return validator(SCENE).is_valid(json.loads(path.read_text(encoding="utf-8")))


def subschemas(schema, place=""):
    yield place, schema
    for group in ("properties", "$defs"):
        for name, sub in schema.get(group, {}).items():
            yield from subschemas(sub, f"{place}/{group}/{name}")
    if isinstance(schema.get("items"), dict):
        yield from subschemas(schema["items"], place + "/items")


class SchemaFiles(unittest.TestCase):
    def test_are_valid_schemas(self):
        files = sorted((ROOT / "data/schemas").glob("*.json"))
        self.assertTrue(files)
        for file in files:
            jsonschema.Draft202012Validator.check_schema(json.loads(file.read_text(encoding="utf-8")))

    def test_every_key_is_described(self):
        for root in (SCENE, ARSLAB_TPS):
            for place, schema in subschemas(root):
                if "/properties/" in place or "/$defs/" in place:
                    target = root["$defs"].get(schema.get("$ref", "").removeprefix("#/$defs/"), {})
                    self.assertTrue(place.endswith("/items") or "description" in {**target, **schema}, place)

    def test_every_key_has_examples_and_they_fit(self):
        for root in (SCENE, ARSLAB_TPS):
            for place, schema in subschemas(root):
                if "not" in schema or place.endswith("/items"):
                    continue
                target = root["$defs"].get(schema.get("$ref", "").removeprefix("#/$defs/"), {})
                examples = {**target, **schema}.get("examples", [])
                self.assertTrue(examples, place)
                whole = {**schema, "$defs": root["$defs"]}
                for example in examples + ([schema["default"]] if "default" in schema else []):
                    validator(whole).validate(example)

    def test_patterns_describe_hexadecimal_floats(self):
        number = re.compile(SCENE["$defs"]["number"]["pattern"])
        for text in ("0x1.8p+1", "-0X.8P2", "0x1.p0", "+0x10p-4"):
            self.assertTrue(number.search(text), text)
        for text in ("", "1.5", "0x1.8", "0x.p1", "inf", "nan", "0x1p", "0x1p1 "):
            self.assertFalse(number.search(text), text)


class Scenes(unittest.TestCase):
    def test_good_ones_are_accepted(self):
        files = sorted((ROOT / "tests/scene/good").glob("*.json")) + sorted((ROOT / "data/scenes").glob("*.json"))
        self.assertGreater(len(files), 4)
        for file in files:
            with self.subTest(file.name):
                validator(SCENE).validate(json.loads(file.read_text(encoding="utf-8")))

    def test_broken_ones_are_refused_where_the_schema_can_see_it(self):
        names = {file.stem for file in BROKEN.glob("*.json")}
        self.assertLessEqual(SEMANTIC | NUMBERS_IN_STRINGS | NOT_JSON, names)
        for name in sorted(names - NOT_JSON):
            with self.subTest(name):
                self.assertEqual(accepts(BROKEN / f"{name}.json"), name in SEMANTIC | NUMBERS_IN_STRINGS)


class Scenarios(unittest.TestCase):
    def test_those_that_are_imported_are_accepted(self):
        files = sorted((ROOT / "tests/import/data").glob("*.json"))
        self.assertTrue(files)
        for file in files:
            with self.subTest(file.name):
                validator(ARSLAB_TPS).validate(json.loads(file.read_text(encoding="utf-8")))


if __name__ == "__main__":
    sys.exit(unittest.main(verbosity=1))
