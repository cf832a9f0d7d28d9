#!/usr/bin/env python3
"""ldfmt next to `ruff format` and `taplo fmt`: bytes a second of the whole process, and peak memory.

    cargo build --release -p ladder-cli
    python3 -m venv /tmp/formatters && /tmp/formatters/bin/pip install ruff taplo
    python3 tests/benches/formatters.py target/release/ldfmt /tmp/formatters/bin

Every formatter gets its own language, in inputs of the same size: one file, and 1,000 files; as people type it,
and as the formatter itself leaves it. All run on one core (taskset; ruff and ldfmt are reported to use one thread),
in turns, so that what else the machine does hits all alike. Shown are the medians of the runs; the time is the
processor's, user and system, which a busy machine disturbs least. A formatter that takes over ten seconds is run once.

Python is that of the standard library: its top-level functions and classes in another order. TOML and ladder
text are made up: tables of packages; sections, comments, rungs with one to three branches, and timers. The wires
of the ladder text are as short as they can be, so that there is as much to read as possible in each byte.
"""

import argparse
import ast
import os
import random
import shutil
import statistics
import subprocess
import sys
import sysconfig
import tempfile
from pathlib import Path

CORE = "0"


def python_pieces():
    """Functions and classes of the standard library, each with its text."""
    pieces = []
    for path in sorted(Path(sysconfig.get_paths()["stdlib"]).glob("*.py")):
        try:
            text = path.read_text(encoding="utf-8")
            tree = ast.parse(text)
        except (UnicodeDecodeError, SyntaxError):
            continue
        lines = text.splitlines(keepends=True)
        for node in tree.body:
            if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
                first = min([node.lineno, *(d.lineno for d in node.decorator_list)])
                pieces.append("".join(lines[first - 1 : node.end_lineno]).rstrip("\n") + "\n\n")
    return pieces


def python(size, rng, pieces=[]):
    if not pieces:
        pieces.extend(python_pieces())
    text = []
    length = 0
    while length < size:
        piece = rng.choice(pieces)
        if len(piece) > max(2000, (size - length) * 2):
            continue
        text.append(piece)
        length += len(piece.encode())
    return "".join(text)


def toml(size, rng):
    text = []
    length = 0
    number = 0
    while length < size:
        number += 1
        names = [f"crate-{rng.randrange(9999)}" for _ in range(rng.randrange(1, 9))]
        listed = ",".join(f'"{name}"' for name in names)
        gap = " " * rng.randrange(3)
        piece = (
            f"[package.p{number}]\nname{gap}={gap}\"crate-{number}\"\nversion = \"1.{number}.0\"   # pinned\n"
            f"checksum=\"{rng.getrandbits(256):064x}\"\ndependencies = [{listed}]\n"
            f"features={{default=[ 'std' ],extra=['{names[0]}']}}\n\n"
        )
        text.append(piece)
        length += len(piece)
    return "".join(text)


def ladder(size, rng):
    contacts = ["[ ](start{n})", "[/]( stop_{n} )", "[ ]( level_high)", "[GT](level_{n},-5)", "[P]( edge{n} )", "[ ]( t{n} . Q )"]
    coils = ["( )( run_{n})", "(S)(alarm{n})", "[TON]( t{n},T#5s )", "[ADD](total_{n}, total_{n},n)", "[calc]( y{n},a+b*-c )"]
    text = []
    length = 0
    number = 0

    def contact():
        return rng.choice(contacts).replace("{n}", str(rng.randrange(500)))

    while length < size:
        number += 1
        a, b, c = contact(), contact(), contact()
        d = rng.choice(coils).replace("{n}", str(rng.randrange(500)))
        shape = rng.randrange(10)
        if shape == 0:
            piece = f"VAR\nlevel_{number} :INT:=5; start_{number},stop_{number} : bool;\nEND_VAR\n\n"
        elif shape == 1:
            piece = f"# what the rung below does, number {number} #\n"
        elif shape <= 4:
            piece = f"+--{a}-{b}--{d}--+\n\n"
        elif shape == 5:
            piece = f"+--{a}--{b}--{c}----{d}--+ # after #\n"
        elif shape <= 7:
            piece = f"+--\\--{a}--\\--{b}---{d}--+\n|  /--{c}--/\n\n"
        elif shape == 8:
            piece = f"+--\\--{a}--\\--\\--{b}--\\--{d}--+\n|  /--{c}--/  /--{a}--/      |\n\n"
        else:
            piece = f"+--\\--{a}--\\--\\--{d}--\\--+\n|  |   |\n   /--\\--{b}--/  /--( )( z )--/ |\n    /--{c}--\\\n /--( )( w )--+\n\n"
        text.append(piece)
        length += len(piece)
    return "".join(text)


class Formatter:
    def __init__(self, name, make, extension, command):
        self.name, self.make, self.extension, self.command = name, make, extension, command

    def write_inputs(self, folder, size, files):
        rng = random.Random(1)
        for number in range(files):
            text = self.make(size // files, rng)
            (folder / f"f{number:04}{self.extension}").write_text(text, encoding="utf-8")

    def run(self, folder):
        """Seconds of the processor and peak bytes of one run over the folder."""
        environment = dict(os.environ, RAYON_NUM_THREADS="1", TOKIO_WORKER_THREADS="1", NO_COLOR="1")
        child = subprocess.Popen(
            ["taskset", "-c", CORE, *self.command(folder)],
            cwd=folder, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        )
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        if child.returncode != 0:
            sys.exit(f"{self.name} ended with {child.returncode}")
        return usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024


def bytes_in(folder):
    return sum(path.stat().st_size for path in folder.iterdir())


def median(values):
    return statistics.median(values)


def in_another_process(work, *arguments):
    """What this process takes would count as what the formatters take that it starts."""
    child = os.fork()
    if child == 0:
        work(*arguments)
        os._exit(0)
    if os.waitpid(child, 0)[1] != 0:
        sys.exit("the inputs could not be made")


def prepare(formatter, size, files, typed, formatted):
    typed.mkdir()
    formatter.write_inputs(typed, size, files)
    shutil.copytree(typed, formatted)
    formatter.run(formatted)
    # What is formatted is larger or smaller; the inputs are to be of one size.
    grown = bytes_in(formatted) / bytes_in(typed)
    shutil.rmtree(formatted)
    formatted.mkdir()
    formatter.write_inputs(formatted, int(size / grown), files)
    # Some formatters need a second run to come to rest.
    formatter.run(formatted)
    formatter.run(formatted)


def measure(formatters, size, files, runs, work):
    prepared = []
    for formatter in formatters:
        typed, formatted, here = (work / f"{formatter.name}-{files}-{part}" for part in ("typed", "formatted", "here"))
        in_another_process(prepare, formatter, size, files, typed, formatted)
        prepared.append((formatter, typed, formatted, here))
    results = {}
    for _ in range(runs):
        for formatter, typed, formatted, here in prepared:
            for state, source in (("as typed", typed), ("formatted", formatted)):
                if results.get((formatter.name, state), [(0, 0)])[0][1] > 10:
                    continue
                shutil.rmtree(here, ignore_errors=True)
                shutil.copytree(source, here)
                seconds, memory = formatter.run(here)
                length = bytes_in(source)
                entry = results.setdefault((formatter.name, state), [])
                entry.append((length / seconds / 1e6, seconds, memory, length))
    for (name, state), entries in results.items():
        speed = median(e[0] for e in entries)
        seconds = median(e[1] for e in entries)
        memory = median(e[2] for e in entries)
        length = entries[0][3]
        largest = length / files
        print(
            f"| {name} | {files} | {state} | {length / 1e6:.1f} MB | {seconds:.3f} s | {speed:.1f} MB/s "
            f"| {memory / 1e6:.0f} MB | {memory / largest:.1f} |" if files == 1 else
            f"| {name} | {files} | {state} | {length / 1e6:.1f} MB | {seconds:.3f} s | {speed:.1f} MB/s | {memory / 1e6:.0f} MB | |",
            flush=True,
        )


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("ldfmt", type=Path, help="the program ldfmt")
    parser.add_argument("others", type=Path, help="the folder that holds ruff and taplo")
    parser.add_argument("--size", type=int, default=10_000_000, help="bytes of input (10,000,000)")
    parser.add_argument("--runs", type=int, default=7, help="runs of each (7)")
    parser.add_argument("--only", nargs="*", help="the names of the formatters to measure (all)")
    parser.add_argument("--in", dest="place", type=Path, help="where to put the inputs (the system's own place for such)")
    arguments = parser.parse_args()
    ldfmt = str(arguments.ldfmt.resolve())
    ruff, taplo = (str((arguments.others / name).resolve()) for name in ("ruff", "taplo"))
    formatters = [
        Formatter("ldfmt", ladder, ".clad", lambda folder: [ldfmt, "."]),
        Formatter("ruff", python, ".py", lambda folder: [ruff, "format", "--isolated", "--no-cache", "--quiet", "."]),
        Formatter("taplo", toml, ".toml", lambda folder: [taplo, "fmt", *sorted(os.listdir(folder))]),
    ]
    formatters = [f for f in formatters if arguments.only is None or f.name in arguments.only]
    print("| formatter | files | input | size | time | speed | peak memory | memory / file |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- |")
    with tempfile.TemporaryDirectory(dir=arguments.place) as work:
        for files in (1, 1000):
            measure(formatters, arguments.size, files, arguments.runs, Path(work))


if __name__ == "__main__":
    main()
