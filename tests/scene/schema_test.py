"""The JSON Schema of scenes takes what the reader takes, and refuses what is wrong by itself: a key, a type, a bound, a name.
The reader is asked a thousand times: by the Python module.

    schema_test.py PROGRAM FOLDER
"""

import json
import pathlib
import re
import shutil
import subprocess
import sys
import tomllib
import unittest

import pinball

try:
    import jsonschema
except ImportError:
    print("python3-jsonschema is not there")
    sys.exit(77)

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
PROGRAM, FOLDER = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
EVERY_KEY = (HERE / "every_key.toml").read_text().splitlines()
KEY = re.compile(r"^([a-z_]+) = (.*)$")
FILES = ["tube.msh", "tube.k", "tube.vtk", "tube.g", "tube.inp", "tube.rad"]


def run(*words):
    return subprocess.run([PROGRAM, *words], capture_output=True, text=True)


SCHEMA = json.loads(run("schema").stdout)
VALIDATOR = jsonschema.Draft7Validator(SCHEMA)


def validator_of(schema):
    return jsonschema.Draft7Validator({**schema, "definitions": SCHEMA["definitions"]})


def seen(schema, value, place, found):
    """Collects the keys of definitions that a value has, and the values that they have."""
    if "$ref" in schema:
        place = schema["$ref"].rsplit("/", 1)[1]
        return seen(SCHEMA["definitions"][place], value, place, found)
    for one in schema.get("anyOf", []):
        if ("$ref" in one or "items" in one) and validator_of(one).is_valid(value):
            seen(one, value, place, found)
    if isinstance(value, list) and "items" in schema:
        for item in value:
            seen(schema["items"], item, place, found)
    if isinstance(value, dict):
        for key, item in value.items():
            if key in schema.get("properties", {}):
                found.setdefault((place, key), schema["properties"][key])
                seen(schema["properties"][key], item, place, found)


def wrong_values(schema):
    """Values that a key cannot have, each with what is wrong."""
    yield "type", "[[]]" if schema.get("type") != "array" else "{ a = 1 }"
    if schema.get("type") in ("number", "integer") or schema.get("anyOf", [{}])[0].get("type") == "number":
        bound = schema if "type" in schema else schema["anyOf"][0]
        yield "type", "true"
        if schema.get("type") == "integer":
            yield "type", "2.5"
        if "minimum" in bound:
            yield "bound", str(bound["minimum"] - 1)
        if "exclusiveMinimum" in bound:
            yield "bound", str(bound["exclusiveMinimum"])
        for most, more in [("maximum", 1), ("exclusiveMaximum", 0)]:
            if most in bound:
                yield "bound", str(bound[most] + more)
    elif schema.get("type") == "boolean":
        yield "type", "1"
    elif "enum" in schema:
        yield "name", '"such_a_name"'
        yield "type", "7"
    elif schema.get("type") == "string":
        yield "type", "7"
        if "pattern" in schema:
            yield "name", '"with blanks"'
    elif schema.get("type") == "array":
        yield "type", '"x"'
        if "maxItems" in schema:
            yield "type", f"[{', '.join(['1'] * (schema['maxItems'] + 1))}]"
        if "enum" in schema["items"]:
            yield "name", '["such_a_name"]'


class Schema(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(FOLDER, ignore_errors=True)
        FOLDER.mkdir(parents=True)
        for name in FILES:
            (FOLDER / name).write_text("")

    def problem_of_reader(self, lines):
        """What the reader says of a scene: (line, text)."""
        path = FOLDER / "scene.toml"
        path.write_text("\n".join(lines) + "\n")
        try:
            pinball.read_scene(str(path))
        except pinball.InputError as error:
            at = re.fullmatch(rf"{re.escape(str(path))}:(\d+):\d+: (.*)", str(error), re.S)
            self.assertIsNotNone(at, error)
            return int(at[1]), at[2]
        return None

    def refused_by_schema(self, lines):
        return not VALIDATOR.is_valid(tomllib.loads("\n".join(lines)))

    def test_is_a_schema(self):
        jsonschema.Draft7Validator.check_schema(SCHEMA)

    def test_defaults_are_values_that_keys_may_have(self):
        for place, table in SCHEMA["definitions"].items():
            for key, value in table.get("properties", {}).items():
                if "default" in value:
                    with self.subTest(f"{place}.{key}"):
                        validator_of(value).validate(value["default"])

    def test_takes_all_scenes_that_come_along(self):
        scenes = sorted((ROOT / "data/scenes").glob("*.toml"))
        for deck in [*(ROOT / "data/decks").glob("*.k"), *(ROOT / "data/decks/abaqus").glob("*.inp")]:
            scenes.append(FOLDER / f"{deck.name}.toml")
            self.assertEqual(run("convert", str(deck), str(scenes[-1])).returncode, 0, deck)
        self.assertEqual(run("new", "first", "--out", str(FOLDER)).returncode, 0)
        scenes.append(FOLDER / "first.toml")
        self.assertGreater(len(scenes), 40)
        for path in scenes:
            with self.subTest(path.name):
                VALIDATOR.validate(tomllib.loads(path.read_text()))

    def test_the_scene_of_every_key_has_every_key(self):
        VALIDATOR.validate(tomllib.loads("\n".join(EVERY_KEY)))
        self.assertIsNone(self.problem_of_reader(EVERY_KEY))
        found = {}
        seen(SCHEMA, tomllib.loads("\n".join(EVERY_KEY)), "scene", found)
        # What many tables have in common, such as which nodes, is there once.
        there = {(key, json.dumps(value)) for (_, key), value in found.items()}
        lacking = [f"{place}.{key}" for place, table in SCHEMA["definitions"].items()
                   for key, value in table.get("properties", {}).items() if (key, json.dumps(value)) not in there]
        self.assertEqual(lacking, [])

    def test_refuses_what_the_reader_refuses(self):
        """One key of the scene of all at a time."""
        counts = dict.fromkeys(["key", "type", "bound", "name"], 0)
        table = ""
        for number, line in enumerate(EVERY_KEY):
            if line.startswith("["):
                table = line.strip("[]")
            match = KEY.match(line)
            if not match or table.startswith("variant"):
                continue
            key, value = match[1], match[2]
            changes = [("key", f"{key}_x = {value}")]
            changes += [(kind, f"{key} = {wrong}") for kind, wrong in wrong_values(self.schema_at(number))]
            for kind, changed in changes:
                lines = EVERY_KEY[:number] + [changed] + EVERY_KEY[number + 1:]
                with self.subTest(f"line {number + 1}: {line} -> {changed}"):
                    problem = self.problem_of_reader(lines)
                    self.assertIsNotNone(problem, "the reader takes it")
                    self.assertEqual(problem[0], number + 1, problem[1])
                    self.assertTrue(self.refused_by_schema(lines), f"the schema takes it, the reader: {problem[1]}")
                    counts[kind] += 1
        print(counts)
        self.assertGreaterEqual(sum(counts.values()), 200)
        self.assertTrue(all(count >= 20 for count in counts.values()), counts)

    def schema_at(self, number):
        """The schema of the key of a line, found by leaving it out."""
        before = tomllib.loads("\n".join(EVERY_KEY))
        without = tomllib.loads("\n".join(EVERY_KEY[:number] + EVERY_KEY[number + 1:]))
        path = first_difference(before, without)
        return resolve(path, before)


def first_difference(one, other, path=()):
    """Where a key is that one has and the other has not."""
    if isinstance(one, dict):
        for key, value in one.items():
            if key not in other:
                return (*path, key)
            found = first_difference(value, other[key], (*path, key))
            if found:
                return found
    elif isinstance(one, list):
        for number, (a, b) in enumerate(zip(one, other)):
            found = first_difference(a, b, (*path, number))
            if found:
                return found
    return None


def resolve(path, scene):
    """The schema of the key at a path of a scene that is right."""
    schema, value = SCHEMA, scene
    for step in path:
        schema = chosen(schema, value)
        schema = schema["properties"][step] if isinstance(step, str) else schema["items"]
        value = value[step]
    return chosen(schema, value) if "$ref" in schema else schema


def chosen(schema, value):
    """Behind references and alternatives: what holds for a value."""
    while True:
        if "$ref" in schema:
            schema = SCHEMA["definitions"][schema["$ref"].rsplit("/", 1)[1]]
        elif "anyOf" in schema and "properties" not in schema:
            schema = next(one for one in schema["anyOf"] if validator_of(one).is_valid(value))
        else:
            return schema


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
