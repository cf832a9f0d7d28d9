"""Reads Structured Text with blark.

    reads.py FOLDER

blark knows no CONFIGURATION: what stands in one is read as the sections that it holds. Nor does it know that a list of values may
follow the name of an array's type: there it is read without them.
"""

import re
import sys
from pathlib import Path

from blark.parse import new_parser


def parts(text):
    """The units of a text, and the variables of its configuration."""
    body, _, configuration = text.partition("\nCONFIGURATION ")
    units = re.split(r"(?<=END_FUNCTION_BLOCK\n)|(?<=END_FUNCTION\n)|(?<=END_TYPE\n)", body)
    return [*units, *re.findall(r"VAR_GLOBAL.*?END_VAR", configuration, re.DOTALL)]


def main(folder):
    parser = new_parser()
    files = sorted(Path(folder).glob("*.st"))
    wrong = 0
    # What is written along is the same in many texts.
    known = set()
    for file in files:
        for part in parts(file.read_text()):
            if part in known:
                continue
            known.add(part)
            part = re.sub(r"(: \w+_TO_\w+) := \[[^\]]*\];", r"\1;", part)
            try:
                parser.parse(part, start="iec_source")
            except Exception as error:  # whatever its parser has to say
                wrong += 1
                print(f"{file.name}: {error}\n{part}")
    if wrong or len(files) < 50:
        sys.exit(f"blark cannot read {wrong} of {len(files)} texts")
    print(f"blark reads {len(files)} texts")


main(*sys.argv[1:])
