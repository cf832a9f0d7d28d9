"""Programs as Structured Text and as PLCopen XML, compiled by matiec and run: each compiles, and does what the simulator shows, or is
refused with a reason.

    compiled.py [--only st|plcopen] [--sample N] [FOLDER]

FOLDER has further programs, each a `.clad` file; N of them are taken. LADDER_PEERS names the folder with the compiler (`matiec/`), with what makes
Structured Text of PLCopen XML (`xml2st/`), and with what runs the result (`iec_trace.py`).
"""

import argparse
import csv
import importlib.util
import io
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path
from xml.etree import ElementTree

LADDER = os.environ["LADDER_BIN"]
ROOT = Path(__file__).resolve().parents[2]
SCANS = 12
NAMESPACE = "{http://www.plcopen.org/xml/tc6_0201}"
ENDS = {"st": ".st", "plcopen": ".xml"}
VALUES = {"BOOL": ["0", "1"], "REAL": ["0.0", "1.5", "-2.25"], "LREAL": ["0.0", "1.5", "-2.25"]}
# The report names what the generator leaves out: what runs there is another program.
LEFT_OUT = "pass over jumps, labels and returns"

NO_RUN = re.compile(r"gcc: .*config\.h:\d+:\d+: error: unknown type name", re.DOTALL)


def tracer(tools):
    os.environ["IEC2C"] = str(tools / "matiec" / "iec2c")
    os.environ["IEC_LIB"] = str(tools / "matiec" / "lib")
    os.environ["XML2ST"] = str(tools / "xml2st" / "xml2st.py")
    spec = importlib.util.spec_from_file_location("iec_trace", tools / "iec_trace.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.trace


def inputs_in_text(text):
    """What the program declares as inputs: their names, and their types."""
    declared = re.search(r"VAR_INPUT\n(.*?)END_VAR", text.rpartition("\nPROGRAM ")[2], re.DOTALL)
    return re.findall(r"^ *(\w+) : (BOOL|S?INT|DINT|L?REAL);", declared[1], re.MULTILINE) if declared else []


def inputs_in_xml(text):
    found = ElementTree.fromstring(text).findall(f".//{NAMESPACE}pou[@pouType='program']")
    variables = found[-1].iterfind(f"{NAMESPACE}interface/{NAMESPACE}inputVars/{NAMESPACE}variable")
    kinds = [(each.get("name"), each.find(f"{NAMESPACE}type")[0].tag.removeprefix(NAMESPACE)) for each in variables]
    return [(name, kind) for name, kind in kinds if kind in ("BOOL", "SINT", "INT", "DINT", "REAL", "LREAL")]


def inputs_of(found, name):
    """Values for inputs; the same in every run."""
    dice = random.Random(name)
    cell = lambda kind: dice.choice(VALUES.get(kind, ["0", "1", "3", "7"])) if dice.random() < 0.4 else ""
    return [[name for name, _ in found]] + [[cell(kind) for _, kind in found] for _ in range(SCANS)] if found else []


def renamed(text):
    """What variables are called here, by their names there."""
    return {there.upper(): own for there, own in re.findall(r"^ *(\w+) .*\(\* called ([^ ;*]+)", text, re.MULTILINE)}


def is_same(own, other):
    try:
        one, two = float(own), float(other)
    except ValueError:
        return own == other
    # An ULINT is printed as if it had a sign.
    return abs(one - two) <= 1e-6 * max(abs(one), abs(two), 1e-9) or one - two == 2.0**64


def attempt(trace, folder, job):
    """None where all is the same, `refused`, or what is wrong."""
    program, notation = job
    target = folder / f"{program.parent.name}-{program.stem}{ENDS[notation]}"
    said = subprocess.run(
        [LADDER, "convert", str(program), "--to", notation, "-o", str(target)], capture_output=True, text=True, check=False
    )
    if not target.exists():
        return "refused" if said.stderr.strip() else "refused without a reason"
    text = target.read_text()
    names = {there: own for own, there in renamed(text).items()} if notation == "st" else {}
    source = program.read_text()
    found = inputs_in_text(text) if notation == "st" else inputs_in_xml(text)
    found = [(name, kind) for name, kind in found if re.search(rf"\b{names.get(name, name)}\b", source, re.IGNORECASE)]
    rows = inputs_of(found, program.stem)
    command = [LADDER, "sim", str(program), "--scans", str(SCANS), "--dt", "10ms", "--format", "csv"]
    given = None
    if rows:
        given, own = target.with_suffix(".csv"), target.with_suffix(".own.csv")
        for file, head in ((given, rows[0]), (own, [names.get(name, name) for name in rows[0]])):
            with file.open("w", newline="") as out:
                csv.writer(out).writerows([head, *rows[1:]])
        command += ["--inputs", str(own)]
    simulated = subprocess.run(command, capture_output=True, text=True, check=False)
    here = list(csv.reader(io.StringIO(simulated.stdout)))
    try:
        head, there = trace(str(target), SCANS, 10, given and str(given))
    except (ValueError, subprocess.TimeoutExpired) as error:
        # A global of a type of one's own is compiled; what runs the program has no room for it.
        return None if NO_RUN.search(str(error)) else str(error)[-600:]
    # What is refused as a whole has no program there; what is refused in part compiles without that part.
    if ": refused: " in said.stderr or LEFT_OUT in said.stderr:
        return "refused"
    places = {name: place for place, name in enumerate(head)}
    called = {own.upper(): name.upper() for name, own in names.items()}
    # What is a fault here is there whatever the standard's functions make of it; Structured Text has it checked.
    if notation == "plcopen" and "fault" in simulated.stderr:
        return None
    for column, name in enumerate(here[0] if here else []):
        place = places.get(called.get(name.upper(), name.upper()))
        for scan, (own, other) in enumerate(zip(here[1:], there)):
            if place is not None and not is_same(own[column], other[place]):
                return f"scan {scan}: {name} is {own[column]}, there {other[place]}"
    return None


def alone(program, work):
    """A copy in a folder of its own: programs of one folder share their globals and types."""
    copy = work / program.stem / program.name
    copy.parent.mkdir()
    return Path(shutil.copy(program, copy))


def main():
    tools = os.environ.get("LADDER_PEERS")
    if not tools:
        print("skip       LADDER_PEERS names no folder: nothing is compiled")
        return
    words = argparse.ArgumentParser()
    words.add_argument("--only", choices=ENDS)
    words.add_argument("--sample", type=int)
    words.add_argument("folder", nargs="?")
    given = words.parse_args()
    trace = tracer(Path(tools))
    programs = sorted((ROOT / "examples").glob("*.clad")) + sorted((ROOT / "tests/peers/programs").glob("*.clad"))
    with tempfile.TemporaryDirectory() as work, ThreadPoolExecutor(2) as pool:
        further = sorted(Path(given.folder).glob("*.clad")) if given.folder else []
        step = max(len(further) // given.sample, 1) if given.sample else 1
        programs += [alone(program, Path(work)) for program in further[::step]]
        jobs = [(program, notation) for notation in ENDS if given.only in (None, notation) for program in programs]
        found = list(pool.map(partial(attempt, trace, Path(work)), jobs))
    wrong = [(job, what) for job, what in zip(jobs, found) if what not in (None, "refused")]
    for (program, notation), what in wrong:
        print(f"{program}, {notation}: {what}")
    if wrong:
        sys.exit(f"{len(wrong)} of {len(jobs)} texts are not the same where they are compiled")
    refused = Counter(notation for (_, notation), what in zip(jobs, found) if what == "refused")
    shown = ", ".join(f"{refused[notation]} are refused as {notation}" for notation in ENDS)
    print(f"{len(programs)} programs: {shown}, all others do the same where they are compiled")


if __name__ == "__main__":
    main()
