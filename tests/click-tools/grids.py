"""Random grids of Click: through Ladder and back, read by laddercodec and run by pyrung.

    grids.py [COUNT] [SEED]
"""

import csv
import os
import random
import subprocess
import sys
import tempfile
import warnings
from pathlib import Path

from laddercodec import read_csv
from pyrung import PLC
from pyrung.click import ladder_to_pyrung

LADDER = os.environ["LADDER_BIN"]
COLUMNS = [chr(ord("A") + n) for n in range(26)] + [f"A{chr(ord('A') + n)}" for n in range(5)]
SCANS = 20


class Grids:
    """Makes programs, and counts timers, counters and registers: each has one place in a program."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.numbers = {"T": 0, "CT": 0, "shift": 16}

    def one(self, *choices):
        return self.random.choice(choices)

    def number(self, low, high):
        return self.random.randint(low, high)

    def fresh(self, what):
        self.numbers[what] += 1
        return self.numbers[what]

    def contact(self):
        bit = self.one(f"X00{self.number(1, 6)}", f"X00{self.number(1, 6)}", f"C{self.number(1, 12)}")
        return self.one(
            bit,
            bit,
            f"~{bit}",
            f"rise({bit})",
            f"fall({bit})",
            f"DS{self.number(1, 6)}{self.one('==', '!=', '<', '<=', '>', '>=')}{self.number(-3, 9)}",
        )

    def formula(self):
        ds = lambda: f"DS{self.number(1, 6)}"
        return self.one(
            f"{ds()} + {self.number(1, 9)}",
            f"({ds()} - {ds()}) * 2",
            f"{ds()} MOD 7",
            f"SUM ( DS1 : DS{self.number(2, 6)} )",
            f"SUM ( DS1 : DS3 ) - {ds()}",
        )

    def output(self):
        """An output with its pins."""
        once = self.one("", "", ",oneshot=1")
        relation = self.one("==", "!=", "<", "<=", ">", ">=")
        kind = self.number(0, 14)
        if kind <= 2:
            return f"out({self.one('C', 'Y00')}{self.number(1, 6)})", []
        if kind == 3:
            return f"latch(C{self.number(1, 12)})", []
        if kind == 4:
            return f"reset(C{self.number(1, 6)}..C{self.number(7, 12)})", []
        if kind == 5:
            n = self.fresh("T")
            pins = self.one([], [".reset()"])
            return f"on_delay(T{n},TD{n},preset={self.number(1, 9)},unit=Ts)", pins
        if kind == 6:
            n = self.fresh("CT")
            return f"count_up(CT{n},CTD{n},preset={self.number(1, 5)})", self.one([".reset()"], [".down()", ".reset()"])
        if kind == 7:
            return f"copy({self.one(self.number(-9, 9), 'DS1', 'DS2')},DS{self.number(1, 6)}{once})", []
        if kind == 8:
            return f"blockcopy(DS1..DS3,DS7..DS9{once})", []
        if kind == 9:
            return f"fill({self.number(0, 9)},DS4..DS6{once})", []
        if kind == 10:
            return f"math({self.formula()},DS{self.number(1, 6)},mode=decimal{once})", []
        if kind == 11:
            return f"math(DH1 {self.one('AND', 'OR', 'XOR')} 00{self.number(10, 99)}h,DH2,mode=hex{once})", []
        if kind == 12:
            more = self.one("", ",continuous=1")
            return f"search(DS1..DS9 {relation} {self.number(0, 9)},result=DS11,found=C14{more}{once})", []
        if kind == 13:
            n = self.fresh("shift")
            self.numbers["shift"] += 3
            return f"shift(C{n}..C{n + 3})", [".clock()", ".reset()"]
        return self.one(f"pack_bits(C1..C8,DH3{once})", f"unpack_to_bits(DH1,C1..C4{once})"), []

    def rung(self):
        output, pins = self.output()
        width = self.number(1, 3)
        first = [self.contact() for _ in range(width)]
        rows = [self.row("R", first, output)]
        # Branches around the first contacts; with pins the rows below are theirs.
        if not pins and self.one(True, False):
            length = self.number(1, width)
            rows[0][1 + length] = "T:" + rows[0][1 + length] if length < width else "T"
            for _ in range(self.number(1, 2)):
                below = [self.contact() for _ in range(length)]
                rows.append(self.row("", below, None))
            for row in rows[1:-1]:
                row[1 + length] = "|"
        for pin in pins:
            cells = [self.contact() for _ in range(self.number(1, 2))]
            if pin == ".reset()" and output.startswith("shift") and self.one(True, False):
                cells = [output[6:].split("..")[0], *cells]
            rows.append(self.row("", cells, pin))
        return rows

    @staticmethod
    def row(marker, cells, output):
        fill = "-" if output else ""
        return [marker, *cells, *[fill] * (len(COLUMNS) - len(cells)), output or ""]

    def program(self):
        rungs = [self.rung() for _ in range(self.number(3, 9))]
        rows = [row for rung in rungs for row in rung]
        return [*rows, self.row("R", [], "end()")]


def write(rows, file):
    with file.open("w", newline="") as handle:
        out = csv.writer(handle, lineterminator="\n")
        out.writerow(["marker", *COLUMNS, "AF"])
        out.writerows(rows)


def run(file, seed):
    """What every watched address holds, scan by scan, as pyrung runs the program of a file."""
    source = ladder_to_pyrung(file)
    names = {}
    exec(compile(source, str(file), "exec"), names)
    plc = PLC(names["logic"], dt=1.0)
    inputs = random.Random(seed)
    trace = []
    for _ in range(SCANS):
        plc.patch({f"X00{n}": inputs.random() < 0.5 for n in range(1, 7)})
        plc.step()
        # Names with a point are the controller's own.
        tags = plc.current_state.tags.items()
        trace.append({name: value for name, value in tags if value and "." not in name})
    return trace


def ladder(*arguments):
    command = [LADDER, *map(str, arguments)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(command)}: exit {done.returncode}\n{done.stdout}{done.stderr}")
    return done


def differs(one, other):
    for scan, (left, right) in enumerate(zip(one, other, strict=True)):
        for name in left.keys() | right.keys():
            if left.get(name) != right.get(name):
                return f"scan {scan}: {name} is {left.get(name)}, and {right.get(name)} after Ladder"
    return None


def is_busy(trace):
    """Whether a program does more than take its inputs."""
    return any(not name.startswith("X") for scan in trace for name in scan)


def check(number, seed, folder):
    rows = Grids(seed).program()
    file = folder / "main.csv"
    write(rows, file)
    back = folder / "back" / "main.csv"
    back.parent.mkdir(exist_ok=True)
    try:
        read_csv(file)
        ladder("convert", file, "-o", folder / "main.clad", "--force")
        ladder("convert", folder / "main.clad", "-o", back, "--force")
        read_csv(back)
        trace = run(file, seed)
        found = differs(trace, run(back, seed))
    except Exception as error:  # whatever is wrong, the grid is shown with it
        found = f"{type(error).__name__}: {error}"
    if found is None:
        return True, is_busy(trace)
    print(f"grid {number} (seed {seed}): {found}\n{file.read_text()}")
    if back.exists():
        print(back.read_text())
    return False, False


def main():
    # What runs is made from a grid, and in no file.
    warnings.filterwarnings("ignore", message="Unable to perform strict DSL")
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 85
    first = int(sys.argv[2]) if len(sys.argv) > 2 else 1
    results = []
    for number in range(count):
        with tempfile.TemporaryDirectory() as folder:
            results.append(check(number, first + number, Path(folder)))
    equal, busy = (sum(column) for column in zip(*results))
    print(f"{equal} of {count} random grids mean the same after they went through Ladder; {busy} of them do something")
    sys.exit(equal != count or busy < count // 2)


main()
