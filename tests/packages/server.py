"""Whether packages/server.json is what the registry of servers for assistants takes, in its form of 2025-09-29.

    python3 tests/packages/server.py ROOT

The form is at the address that the file begins with. Checked is what it demands of the fields that the file has: a field that is
not known here is reported, so that it is looked up before it is added.
"""

import json
import re
import sys
from pathlib import Path

FORM = "https://static.modelcontextprotocol.io/schemas/2025-09-29/server.schema.json"
ADDRESS = r"https://[^\s/]+(/\S*)?"
# No range, and nothing that moves.
VERSION = r"(?!latest$)\d+\.\d+\.\d+(-[0-9A-Za-z.-]+)?"

# Of each object its fields: whether one must be there, and what it is, as a pattern or as further fields.
ARGUMENT = {"type": (True, "positional"), "value": (True, ".+"), "valueHint": (False, ".+")}
FIELDS = {
    "$schema": (True, re.escape(FORM)),
    "name": (True, r"(?=.{3,200}$)[a-zA-Z0-9.-]+/[a-zA-Z0-9._-]+"),
    "description": (True, r".{1,100}"),
    "version": (True, VERSION),
    "repository": (True, {"url": (True, ADDRESS), "source": (True, "github")}),
    "websiteUrl": (True, ADDRESS),
    "packages": (
        True,
        [
            {
                "registryType": (True, "npm|pypi|oci|nuget|mcpb"),
                "identifier": (True, r"\S+"),
                "version": (True, VERSION),
                "runtimeHint": (False, "npx|uvx|docker|dnx"),
                "transport": (True, {"type": (True, "stdio")}),
                "runtimeArguments": (False, [ARGUMENT]),
                "packageArguments": (False, [ARGUMENT]),
            }
        ],
    ),
}


def problems(value, wanted, place):
    match wanted:
        case str() if not isinstance(value, str) or not re.fullmatch(wanted, value):
            yield f"{place}: {json.dumps(value)} is not as {wanted}"
        case [item]:
            if not isinstance(value, list) or not value:
                yield f"{place}: a list with something in it is expected"
                return
            for number, part in enumerate(value):
                yield from problems(part, item, f"{place}[{number}]")
        case dict():
            if not isinstance(value, dict):
                yield f"{place}: an object is expected"
                return
            yield from (f"{place}: {name} is missing" for name, (is_needed, _) in wanted.items() if is_needed and name not in value)
            for name, part in value.items():
                if name not in wanted:
                    yield f"{place}: {name} is not known"
                else:
                    yield from problems(part, wanted[name][1], f"{place}.{name}")


def main():
    path = Path(sys.argv[1]) / "packages/server.json"
    server = json.loads(path.read_text(encoding="utf-8"))
    found = list(problems(server, FIELDS, "server"))
    found += [f"{package['registryType']} has another version than the server" for package in server["packages"] if package.get("version") != server["version"]]
    for sentence in found:
        print(f"packages/server.json: {sentence}")
    sys.exit(bool(found))


main()
