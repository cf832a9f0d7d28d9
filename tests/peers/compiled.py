"""Structured Text that Ladder writes, compiled by matiec and run: it compiles, and does what the simulator shows, or is refused with a reason.

    compiled.py [FOLDER]

FOLDER has further programs, each a `.clad` file. LADDER_PEERS names the folder with the compiler (`matiec/`) and with what runs its
programs (`iec_trace.py`). The compiler runs no FOR with one turn, which is why none is written.
"""

import csv
import importlib.util
import io
import os
import random
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

LADDER = os.environ["LADDER_BIN"]
ROOT = Path(__file__).resolve().parents[2]
SCANS = 12
VALUES = {"BOOL": ["0", "1"], "REAL": ["0.0", "1.5", "-2.25"], "LREAL": ["0.0", "1.5", "-2.25"]}


def tracer(tools):
    os.environ["IEC2C"] = str(tools / "matiec" / "iec2c")
    os.environ["IEC_LIB"] = str(tools / "matiec" / "lib")
    spec = importlib.util.spec_from_file_location("iec_trace", tools / "iec_trace.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.trace


def inputs_of(text, name):
    """Values for what the program declares as inputs; the same in every run."""
    dice = random.Random(name)
    program = text.rpartition("\nPROGRAM ")[2]
    declared = re.search(r"VAR_INPUT\n(.*?)END_VAR", program, re.DOTALL)
    found = re.findall(r"^ *(\w+) : (BOOL|S?INT|DINT|L?REAL);", declared[1], re.MULTILINE) if declared else []
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


def attempt(trace, program, folder):
    """None where all is the same, `refused`, or what is wrong."""
    target = folder / f"{program.parent.name}-{program.stem}.st"
    said = subprocess.run(
        [LADDER, "convert", str(program), "--to", "st", "-o", str(target)], capture_output=True, text=True, check=False
    )
    if not target.exists():
        return "refused" if said.stderr.strip() else "refused without a reason"
    text = target.read_text()
    names = {there: own for own, there in renamed(text).items()}
    rows = inputs_of(text, program.stem)
    command = [LADDER, "sim", str(program), "--scans", str(SCANS), "--dt", "10ms", "--format", "csv"]
    given = None
    if rows:
        given, own = target.with_suffix(".csv"), target.with_suffix(".own.csv")
        for file, head in ((given, rows[0]), (own, [names.get(name, name) for name in rows[0]])):
            with file.open("w", newline="") as out:
                csv.writer(out).writerows([head, *rows[1:]])
        command += ["--inputs", str(own)]
    simulated = subprocess.run(command, capture_output=True, text=True, check=False).stdout
    here = list(csv.reader(io.StringIO(simulated)))
    try:
        head, there = trace(str(target), SCANS, 10, given and str(given))
    except (ValueError, subprocess.TimeoutExpired) as error:
        return str(error)[-600:]
    places = {name: place for place, name in enumerate(head)}
    called = {own.upper(): name.upper() for name, own in names.items()}
    for column, name in enumerate(here[0] if here else []):
        place = places.get(called.get(name.upper(), name.upper()))
        for scan, (own, other) in enumerate(zip(here[1:], there)):
            if place is not None and not is_same(own[column], other[place]):
                return f"scan {scan}: {name} is {own[column]}, there {other[place]}"
    return None


def main(folder=None):
    tools = os.environ.get("LADDER_PEERS")
    if not tools:
        print("skip       LADDER_PEERS names no folder: no text is compiled")
        return
    trace = tracer(Path(tools))
    programs = sorted((ROOT / "examples").glob("*.clad")) + sorted((ROOT / "tests/peers/programs").glob("*.clad"))
    programs += sorted(Path(folder).glob("*.clad")) if folder else []
    with tempfile.TemporaryDirectory() as work, ThreadPoolExecutor(2) as pool:
        found = list(pool.map(lambda program: attempt(trace, program, Path(work)), programs))
    wrong = [(program, what) for program, what in zip(programs, found) if what not in (None, "refused")]
    for program, what in wrong:
        print(f"{program}: {what}")
    if wrong:
        sys.exit(f"{len(wrong)} of {len(programs)} programs are not the same where they are compiled")
    print(f"{len(programs)} programs: {found.count('refused')} are refused, all others do the same where they are compiled")


main(*sys.argv[1:])
