"""Random grids of Click: through Ladder and back, read by laddercodec and run by pyrung; and run by Ladder itself, scan
by scan next to pyrung.

    grids.py [COUNT] [SEED]
"""

import csv
import json
import os
import random
import re
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
        self.numbers = {"T": 0, "CT": 0, "shift": 16, "drum": 0}

    def one(self, *choices):
        return self.random.choice(choices)

    def number(self, low, high):
        return self.random.randint(low, high)

    def fresh(self, what):
        self.numbers[what] += 1
        return self.numbers[what]

    def contact(self):
        bit = self.one(f"X00{self.number(1, 6)}", f"X00{self.number(1, 6)}", f"C{self.number(1, 12)}")
        # pyrung looks for the edge since the end of the last scan, and misses that of a bit which a rung below has set.
        return self.one(
            bit,
            bit,
            f"~{bit}",
            f"rise(X00{self.number(1, 6)})",
            f"fall(X00{self.number(1, 6)})",
            f"DS{self.number(1, 6)}{self.one('==', '!=', '<', '<=', '>', '>=')}{self.number(-3, 9)}",
        )

    def pulse(self):
        return f"{self.one('rise', 'fall')}(X00{self.number(1, 6)})"

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
        kind = self.number(0, 23)
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
        if kind == 14:
            n = self.fresh("T")
            return f"off_delay(T{n},TD{n},preset={self.number(1, 4)},unit=Ts)", []
        if kind == 15:
            n = self.fresh("CT")
            return f"count_down(CT{n},CTD{n},preset={self.number(1, 5)})", [".reset()"]
        if kind == 16:
            return self.drum(), self.one([".reset()"], [".reset()", self.jump()], [".reset()", ".jog()"])
        if kind == 17:
            return self.one(
                f"pack_words(DS1..DS2,DD1{once})",
                f"unpack_to_words(DD1,DS5..DS6{once})",
                f"pack_bits(C1..C8,DH3{once})",
                f"unpack_to_bits(DH1,C1..C4{once})",
            ), []
        if kind == 18:
            form = f"suppress_zero={self.number(0, 1)},exponential=0,termination_code={self.one('none', '$0D')}"
            return f"copy({self.one('DS', 'DS', 'DD')}{self.number(1, 3)},TXT1,convert=to_text({form}){once})", []
        if kind == 19:
            return f"copy({self.one('TXT1', 'TXT2')},DS{self.number(1, 6)},convert={self.one('to_value', 'to_ascii')}{once})", []
        if kind == 20:
            return f"copy(DS{self.number(1, 3)},TXT{self.number(1, 3)},convert=to_binary{once})", []
        if kind == 21:
            blanks = self.one("", "", ",allow_whitespace=1")
            return f"pack_text(TXT1..TXT{self.number(1, 4)},{self.one('DS4', 'DD2')}{blanks}{once})", []
        if kind == 22:
            return f"copy({self.one('DS[DS1]', 'DS[DS2+3]', 'DD1', 'DH1', '12.5', '-70000')},{self.one('DS5', 'DD3', 'DS6')}{once})", []
        text = self.one("7", "42", "-3", " 5", "Z")
        return f'copy("{text}",TXT{self.number(1, 3)}{once})', []

    def drum(self):
        """A drum with outputs of its own."""
        n = self.fresh("drum")
        steps, outputs = self.number(1, 4), self.number(1, 3)
        pattern = ",".join("[" + ",".join(self.one("0", "1") for _ in range(outputs)) + "]" for _ in range(steps))
        bits = ",".join(f"C{100 + 10 * n + k}" for k in range(outputs))
        at = f"current_step=DS{20 + n}"
        flag = f"completion_flag=C{109 + 10 * n}"
        if self.one(True, False):
            events = ",".join(self.one(f"X00{self.number(1, 6)}", f"C{self.number(1, 6)}") for _ in range(steps))
            return f"event_drum(outputs=[{bits}],events=[{events}],pattern=[{pattern}],{at},{flag})"
        presets = ",".join(self.one(str(self.number(1, 4)), "DS3") for _ in range(steps))
        time = f"unit={self.one('Ts', 'Ts', 'Tms')}"
        more = f"accumulator=TD{100 + n}"
        return f"time_drum(outputs=[{bits}],presets=[{presets}],{time},pattern=[{pattern}],{at},{more},{flag})"

    def jump(self):
        return f".jump({self.one('DS1', self.number(1, 3))})"

    def rung(self):
        output, pins = self.output()
        width = self.number(1, 3)
        first = [self.contact() for _ in range(width)]
        # As the vendor says a counter counts the rise of its rung; in pyrung it counts every scan with power.
        if output.startswith("count"):
            first[0] = self.pulse()
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
            if pin == ".down()":
                cells[0] = self.pulse()
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
    # Of what its importer writes pyrung does not take all.
    plain = file.with_name("plain.csv")
    plain.write_text(file.read_text().replace("$0D", "13"))
    source = re.sub(r"\.jump\((.+), ([^,()]+)\)", r".jump(\1, step=\2)", ladder_to_pyrung(plain))
    names = {"none": None}
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


ADDRESS = re.compile(r"(X|Y|C|DS|DD|DH|DF|TXT)\[(\d+)\]|(T|CT)(\d+)\.(DN|ACC)")


def address(name):
    """The address that a tag of ladder text is. None: a tag that Ladder made, or what Click has not."""
    found = ADDRESS.fullmatch(name)
    if not found:
        return None
    bank, number, block, count, member = found.groups()
    if bank in ("X", "Y"):
        return f"{bank}{int(number):03}"
    if bank:
        return f"{bank}{number}"
    return f"{block if member == 'DN' else block + 'D'}{count}"


def simulate(program, seed):
    """As `run`, by Ladder's simulator."""
    inputs = random.Random(seed)
    rows = [[inputs.random() < 0.5 for _ in range(6)] for _ in range(SCANS)]
    declared = re.findall(r"^ +([A-Z]+\d*) +: (ARRAY\[1\.\.(\d+)\]|\w+)", program.read_text(), re.MULTILINE)
    count = next((int(size) for name, _, size in declared if name == "X"), 0)
    watched = [[name] if size else [f"{name}.DN", f"{name}.ACC"] for name, _, size in declared]
    watched = ",".join(name for names in watched for name in names)
    given = program.with_name("inputs.csv")
    with given.open("w", newline="") as handle:
        out = csv.writer(handle, lineterminator="\n")
        out.writerow([f"X[{n + 1}]" for n in range(count)])
        out.writerows([int(value) for value in row[:count]] for row in rows)
    more = ["--inputs", given] if count else []
    more += ["--watch", watched] if watched else []
    done = ladder("sim", program, "--scans", SCANS, "--dt", "1s", "--format", "json", *more)
    result = json.loads(done.stdout)
    names = [address(tag["name"]) for tag in result["tags"]]
    trace = []
    for row, scan in zip(rows, result["scans"], strict=True):
        found = {name: value for name, value in zip(names, scan["values"]) if name and value not in (0, "", "\0")}
        trace.append(found | {f"X00{n + 1}": True for n, on in enumerate(row) if on})
    return trace


def ladder(*arguments):
    command = [LADDER, *map(str, arguments)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(command)}: exit {done.returncode}\n{done.stdout}{done.stderr}")
    return done


def plain_address(name):
    """The address that a tag of pyrung is. None: a member of a timer or counter that Click has not."""
    block, _, member = name.partition("_")
    if member:
        return block if member in ("Done", "Acc") else None
    return name


def comparable(trace, counters):
    """What both have: a text that is not there is none. As the vendor says the bit of a counter that counts down is on
    where its value is not above the set point; pyrung counts from 0 to its negative."""
    for scan in trace:
        names = {name: plain_address(name) for name in scan}
        there = {name for name in names.values() if name and name not in counters}
        yield {names[name]: value for name, value in scan.items() if names[name] in there and value != "\0"}


def differs(one, other, where):
    for scan, (left, right) in enumerate(zip(one, other, strict=True)):
        for name in left.keys() | right.keys():
            if (left.get(name) or 0) != (right.get(name) or 0):
                return f"scan {scan}: {name} is {left.get(name)!r}, and {right.get(name)!r} {where}"
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
        found = differs(trace, run(back, seed), "after Ladder")
        down = set(re.findall(r"count_down\((CT\d+)", file.read_text()))
        both = [list(comparable(trace, down)) for trace in (trace, simulate(folder / "main.clad", seed))]
        found = found or differs(*both, "in its simulator")
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
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 240
    first = int(sys.argv[2]) if len(sys.argv) > 2 else 1
    results = []
    for number in range(count):
        with tempfile.TemporaryDirectory() as folder:
            results.append(check(number, first + number, Path(folder)))
    equal, busy = (sum(column) for column in zip(*results))
    print(f"{equal} of {count} random grids mean the same after they went through Ladder; {busy} of them do something")
    sys.exit(equal != count or busy < count // 2)


main()
