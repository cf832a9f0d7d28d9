"""Reads Structured Text with blark.

    reads.py FOLDER

blark knows no CONFIGURATION: what stands in one is read as the sections that it holds.
"""

import re
import sys
from pathlib import Path

from blark.parse import new_parser


def parts(text):
    """The text before the configuration, and the variables of that."""
    body, _, configuration = text.partition("\nCONFIGURATION ")
    return [body, *re.findall(r"VAR_GLOBAL.*?END_VAR", configuration, re.DOTALL)]


def main(folder):
    parser = new_parser()
    files = sorted(Path(folder).glob("*.st"))
    wrong = 0
    for file in files:
        for part in parts(file.read_text()):
            try:
                parser.parse(part, start="iec_source")
            except Exception as error:  # whatever its parser has to say
                wrong += 1
                print(f"{file.name}: {error}\n{part}")
    if wrong or len(files) < 50:
        sys.exit(f"blark cannot read {wrong} of {len(files)} texts")
    print(f"blark reads {len(files)} texts")


main(*sys.argv[1:])
