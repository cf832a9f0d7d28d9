"""`ladder check --format sarif` writes what the standard's own schema takes.

sarif-2.1.0.schema.json is the schema that OASIS publishes with the standard. It allows no member that it does not name.
"""

import copy
import json
import pathlib
import subprocess

import jsonschema
import pytest
from conftest import LADDER

SCHEMA = json.loads((pathlib.Path(__file__).parent / "sarif-2.1.0.schema.json").read_text())

# A warning with a fix, and an error with related places and a fix.
WRONG = "+--[ ]( a )( )( y )--+\n\n+--[TOM]( t, T#5s )--( )( z )--+\n"


@pytest.fixture
def document(tmp_path: pathlib.Path):
    (tmp_path / "wrong one.clad").write_text(WRONG)
    run = subprocess.run(
        [LADDER, "check", "--format", "sarif", "."], cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert run.returncode == 1, run.stderr
    return json.loads(run.stdout)


def test_it_is_what_the_standard_says(document):
    assert [result["ruleId"] for result in document["runs"][0]["results"]] == ["missing-wire", "unknown-instruction"]
    jsonschema.validate(document, SCHEMA)


def test_a_member_that_the_standard_does_not_know_is_refused(document):
    wrong = copy.deepcopy(document)
    wrong["runs"][0]["results"][0]["rule"] = "missing-wire"
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate(wrong, SCHEMA)
