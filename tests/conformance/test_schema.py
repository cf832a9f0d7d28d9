"""The schema of ladder.toml takes what is right and refuses what is wrong."""

import json
import pathlib
import tomllib

import jsonschema
import pytest

ROOT = pathlib.Path(__file__).parents[2]
SCHEMA = json.loads((ROOT / "docs/schema/ladder.schema.json").read_text())


def test_it_is_a_schema():
    jsonschema.Draft7Validator.check_schema(SCHEMA)


@pytest.mark.parametrize("file", sorted((ROOT / "tests/settings/good").iterdir()), ids=lambda file: file.stem)
def test_what_is_right(file):
    jsonschema.validate(tomllib.loads(file.read_text()), SCHEMA)


@pytest.mark.parametrize("file", sorted((ROOT / "tests/settings/broken").iterdir()), ids=lambda file: file.stem)
def test_what_is_wrong(file):
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate(tomllib.loads(file.read_text()), SCHEMA)
