"""Values that several files repeat, each at places that a pattern finds: whether all agree, and how another value is written.

A pattern is a regular expression in which `{name}` is where the value of that name is; a file may have it more than once.
"""

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def found(places, shapes):
    """For each place its file, the text of that, the name of the value, and where in the text it is."""
    for file, pattern in places:
        name = re.search(r"\{([a-z]+)\}", pattern)[1]
        text = (ROOT / file).read_text(encoding="utf-8")
        filled = pattern.replace(f"{{{name}}}", f"({shapes[name]})")
        yield file, text, name, list(re.finditer(filled, text, re.MULTILINE))


def differences(places, shapes, values, source):
    """A sentence for each place that has another value than `source`, the file that decides, or none."""
    for file, text, name, matches in found(places, shapes):
        if not matches:
            yield f"{file}: the {name} is missing"
        for match in matches:
            if match[1] != values[name]:
                line = text.count("\n", 0, match.start(1)) + 1
                yield f"{file}:{line}: the {name} is {match[1]}, and in {source} it is {values[name]}"


def write(places, shapes, values):
    """Writes the values at all places; a file that has them stays as it is."""
    for file, text, name, matches in found(places, shapes):
        written = text
        for match in reversed(matches):
            written = written[: match.start(1)] + values[name] + written[match.end(1) :]
        if written != text:
            (ROOT / file).write_text(written, encoding="utf-8")
