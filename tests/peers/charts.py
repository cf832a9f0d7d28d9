"""Charts (SFC) that are made up here, as PLCopen XML and as the Structured Text that is made of it: compiled by matiec and run, each does what
the simulator shows of it.

    charts.py [COUNT] [--first SEED] [--keep FOLDER]

LADDER_PEERS names the folder with the compiler (`matiec/`), with what makes Structured Text of PLCopen XML (`xml2st/`), and with what runs the
result (`iec_trace.py`). FOLDER is for the charts that differ.
"""

import argparse
import csv
import io
import os
import random
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path

from compiled import LADDER, is_same, tracer

SCANS = 60
QUALIFIERS = ["N", "N", "N", "S", "R", "P", "P0", "P1", "L", "D", "SL", "SD", "DS"]
TIMED = {"L", "D", "SL", "SD", "DS"}
INPUTS = ["a", "b", "c", "d"]
OUTPUTS = [f"y{number}" for number in range(5)]
COUNTS = [f"n{number}" for number in range(3)]


class Chart:
    """A chart that grows from its first step, by what a person draws: sequences, alternatives, parallels, jumps."""

    def __init__(self, dice, step, prefix=""):
        self.dice, self.unit, self.prefix = dice, step, prefix
        self.elements, self.steps, self.actions, self.transitions = [], [], {}, {}
        self.number = 0
        first = self.step(None, initial=True)
        self.sequence(first, dice.randint(1, 4), 0, closes=True)
        for name, local in self.steps:
            if dice.random() < 0.75:
                self.action_block(local)
        if dice.random() < 0.5:
            dice.shuffle(self.elements)

    def local(self):
        self.number += 1
        return self.number

    def point(self, *sources):
        lines = "".join(f'<connection refLocalId="{source}"/>' for source in sources)
        return f"<connectionPointIn>{lines}</connectionPointIn>"

    PLACE = '<position x="0" y="0"/>'

    def step(self, source, initial=False):
        local = self.local()
        name = f"{self.prefix}S{len(self.steps)}"
        self.steps.append((name, local))
        point = self.point(source) if source else ("" if not initial else "")
        self.elements.append([local, "step", name, initial, source])
        return local

    def transition(self, source, priority=None):
        local = self.local()
        self.elements.append([local, "transition", source, priority])
        return local

    def jump(self, source, target):
        self.elements.append([self.local(), "jump", source, target])

    def join(self, kind, *sources):
        local = self.local()
        self.elements.append([local, kind, *sources])
        return local

    def sequence(self, step, length, depth, closes):
        """Goes on from a step; comes back with the last one, which nothing follows, or closes with a jump."""
        dice = self.dice
        for _ in range(length):
            kind = dice.random()
            if kind < 0.45 or depth > 1:
                step = self.step(self.transition(step))
            elif kind < 0.75:
                fork = self.join("selectionDivergence", step)
                ends = []
                ranks = dice.random() < 0.6
                count = dice.randint(2, 3)
                order = dice.sample(range(1, 9), count)
                for branch in range(count):
                    first = self.transition(fork, order[branch] if ranks and dice.random() < 0.9 else None)
                    if dice.random() < 0.25:
                        self.jump(first, dice.choice(self.steps)[0])
                        continue
                    if dice.random() < 0.2:
                        ends.append(first)
                        continue
                    last = self.sequence(self.step(first), dice.randint(0, 1), depth + 1, False)
                    ends.append(self.transition(last))
                if not ends:
                    return step
                step = self.step(self.join("selectionConvergence", *ends) if len(ends) > 1 else ends[0])
            else:
                begin = self.transition(step)
                fork = self.join("simultaneousDivergence", begin)
                lasts = []
                for _ in range(dice.randint(2, 3)):
                    lasts.append(self.sequence(self.step(fork), dice.randint(0, 1), depth + 1, False))
                step = self.step(self.transition(self.join("simultaneousConvergence", *lasts)))
        if closes:
            back = self.steps[0][0] if dice.random() < 0.8 else dice.choice(self.steps)[0]
            self.jump(self.transition(step), back)
        return step

    def action_block(self, step):
        dice = self.dice
        own = next(name for name, local in self.steps if local == step)
        made = []
        for _ in range(dice.randint(1, 3)):
            qualifier = dice.choice(QUALIFIERS)
            time = f' duration="T#{dice.choice([0, 1, 2, 3, 5, 7, 10, 20]) * self.unit}ms"' if qualifier in TIMED else ""
            if dice.random() < 0.5:
                what = f'<reference name="{dice.choice(OUTPUTS)}"/>'
            elif dice.random() < 0.5:
                name = f"{self.prefix}A{dice.randint(0, 3)}"
                self.actions.setdefault(name, None)
                what = f'<reference name="{name}"/>'
            else:
                what = f"<inline><ST><xhtml:p><![CDATA[{self.statement(own)}]]></xhtml:p></ST></inline>"
            made.append(
                f'<action localId="0" qualifier="{qualifier}"{time}><relPosition x="0" y="0"/>{what}</action>'
            )
        self.elements.append([self.local(), "actions", step, "".join(made)])

    def statement(self, *known):
        """The compiler knows of steps only what is above."""
        dice = self.dice
        step = dice.choice([self.steps[0][0], *known])
        count = dice.choice(COUNTS)
        return dice.choice(
            [
                f"{count} := {count} + 1;",
                f"{count} := {count} + 1; IF {count} > 5 THEN {count} := 0; END_IF;",
                f"{dice.choice(OUTPUTS)} := {dice.choice(INPUTS)};",
                f"{dice.choice(OUTPUTS)} := NOT {dice.choice(OUTPUTS)};",
                f"IF {step}.X THEN {count} := {count} + 10; END_IF;",
                f"last := {step}.T;",
                f"tim(IN := {dice.choice(INPUTS)}, PT := T#{3 * self.unit}ms); {dice.choice(OUTPUTS)} := tim.Q;",
                f"edge(CLK := {dice.choice(INPUTS)}); IF edge.Q THEN {count} := {count} + 1; END_IF;",
            ]
        )

    def condition(self, source):
        dice = self.dice
        one, two = dice.sample(INPUTS, 2)
        step = dice.choice([self.steps[0][0], *(name for name, local in self.steps if local == source)])
        return dice.choice(
            [
                one,
                f"NOT {one}",
                f"{one} OR {two}",
                f"{one} AND NOT {two}",
                "TRUE",
                f"{step}.T >= T#{dice.choice([1, 2, 4, 10]) * self.unit}ms",
                f"{one} AND {step}.X",
                f"NOT {step}.X OR {two}",
                f"{dice.choice(COUNTS)} > {dice.randint(0, 3)}",
                f"{dice.choice(OUTPUTS)} OR {one}",
            ]
        )

    def ladder(self, name, base=0):
        """Contacts with a coil, as an action or a transition has them."""
        dice = self.dice
        one, two = dice.sample(INPUTS, 2)
        negated = dice.choice(["true", "false"])
        storage = "" if name not in OUTPUTS else dice.choice(["", ' storage="set"', ' storage="reset"'])
        return (
            f'<leftPowerRail localId="{base + 1}">{self.PLACE}<connectionPointOut formalParameter=""/></leftPowerRail>'
            f'<contact localId="{base + 2}" negated="{negated}">{self.PLACE}<connectionPointIn><connection refLocalId="{base + 1}"/>'
            f"</connectionPointIn><connectionPointOut/><variable>{one}</variable></contact>"
            f'<contact localId="{base + 3}">{self.PLACE}<connectionPointIn><connection refLocalId="{base + 1}"/>'
            f"</connectionPointIn><connectionPointOut/><variable>{two}</variable></contact>"
        ), (
            f'<coil localId="{base + 4}"{storage}>{self.PLACE}<connectionPointIn><connection refLocalId="{base + 2}"/>'
            f'<connection refLocalId="{base + 3}"/></connectionPointIn><connectionPointOut/><variable>{name}</variable></coil>'
        )

    def xml(self):
        dice = self.dice
        out, drawn = [], []
        for local, kind, *rest in self.elements:
            head = f'<{kind} localId="{local}"'
            if kind == "step":
                name, initial, source = rest
                told = f' name="{name}" initialStep="{str(initial).lower()}"'
                point = self.point(source) if source else ""
                out.append(
                    f'{head}{told}>{self.PLACE}{point}<connectionPointOut formalParameter=""/>'
                    f'<connectionPointOutAction formalParameter=""/></step>'
                )
            elif kind == "transition":
                source, priority = rest
                rank = f' priority="{priority}"' if priority is not None else ""
                form = dice.random()
                if form < 0.7:
                    inside = f'<inline name=""><ST><xhtml:p><![CDATA[{self.condition(source)}]]></xhtml:p></ST></inline>'
                elif form < 0.8:
                    name = f"{self.prefix}T{local}"
                    self.transitions[name] = f"<ST><xhtml:p><![CDATA[:= {self.condition(source)};]]></xhtml:p></ST>"
                    inside = f'<reference name="{name}"/>'
                elif form < 0.9:
                    name = f"{self.prefix}T{local}"
                    self.transitions[name] = f"<LD>{''.join(self.ladder(name))}</LD>"
                    inside = f'<reference name="{name}"/>'
                else:
                    base = 1000 + 10 * local
                    contacts, coil = self.ladder("", base)
                    drawn.append(contacts)
                    if dice.random() < 0.5:
                        drawn.append(self.block(base))
                        inside = (
                            f'<connectionPointIn><connection refLocalId="{base + 5}" formalParameter="{self.output}">'
                            f'<position x="0" y="0"/><position x="0" y="0"/></connection></connectionPointIn>'
                        )
                    else:
                        inside = self.point(base + 2, base + 3)
                out.append(
                    f"{head}{rank}>{self.PLACE}{self.point(source)}<connectionPointOut/><condition>{inside}</condition></transition>"
                )
            elif kind == "jump":
                source, target = rest
                out.append(f'<jumpStep localId="{local}" targetName="{target}">{self.PLACE}{self.point(source)}</jumpStep>')
            elif kind == "actions":
                step, made = rest
                out.append(f'<actionBlock localId="{local}">{self.PLACE}{self.point(step)}{made}</actionBlock>')
            else:
                points = "".join(self.point(source) for source in rest)
                outs = '<connectionPointOut formalParameter=""/>' * 2 if "Divergence" in kind else "<connectionPointOut/>"
                out.append(f"{head}>{self.PLACE}{points}{outs}</{kind}>")
        actions = "".join(f'<action name="{name}"><body>{self.body()}</body></action>' for name in self.actions)
        transitions = "".join(
            f'<transition name="{name}"><body>{body}</body></transition>' for name, body in self.transitions.items()
        )
        inside = f"<actions>{actions}</actions>" if actions else ""
        inside += f"<transitions>{transitions}</transitions>" if transitions else ""
        return f"{inside}<body><SFC>{''.join(out + drawn)}</SFC></body>"

    def block(self, base):
        """A timer, or a function, after the contacts."""
        self.timers = getattr(self, "timers", 0)
        pin = lambda name, source: (
            f'<variable formalParameter="{name}"><connectionPointIn><relPosition x="0" y="0"/>'
            f'<connection refLocalId="{source}"/></connectionPointIn></variable>'
        )
        leaves = lambda name: (
            f'<variable formalParameter="{name}"><connectionPointOut><relPosition x="0" y="0"/></connectionPointOut></variable>'
        )
        if self.dice.random() < 0.5:
            self.output = "OUT"
            return (
                f'<block localId="{base + 5}" typeName="AND">{self.PLACE}<inputVariables>{pin("IN1", base + 2)}{pin("IN2", base + 3)}'
                f'</inputVariables><inOutVariables/><outputVariables>{leaves("OUT")}</outputVariables></block>'
            )
        self.output = "Q"
        self.timers += 1
        return (
            f'<inVariable localId="{base + 6}">{self.PLACE}<connectionPointOut/><expression>T#{2 * self.unit}ms</expression></inVariable>'
            f'<block localId="{base + 5}" typeName="TON" instanceName="tt{self.timers}">{self.PLACE}<inputVariables>{pin("IN", base + 2)}'
            f'{pin("PT", base + 6)}</inputVariables><inOutVariables/><outputVariables>{leaves("Q")}{leaves("ET")}</outputVariables></block>'
        )

    def body(self):
        if self.dice.random() < 0.5:
            return f"<ST><xhtml:p><![CDATA[{self.statement()} {self.statement()}]]></xhtml:p></ST>"
        return f"<LD>{''.join(self.ladder(self.dice.choice(OUTPUTS)))}</LD>"


def variables(kind, names, ty):
    inside = "".join(f'<variable name="{name}"><type>{ty}</type></variable>' for name in names)
    return f"<{kind}>{inside}</{kind}>" if names else ""


def unit(name, kind, chart, body, more=""):
    timers = [f"tt{number + 1}" for number in range(getattr(chart, "timers", 0))]
    interface = (
        variables("inputVars", INPUTS, "<BOOL/>")
        + variables("outputVars", OUTPUTS, "<BOOL/>")
        + variables("localVars", COUNTS, "<INT/>")
        + variables("localVars", ["last"], "<TIME/>")
        + variables("localVars", ["tim", *timers], '<derived name="TON"/>')
        + variables("localVars", ["edge"], '<derived name="R_TRIG"/>')
        + more
    )
    return f'<pou name="{name}" pouType="{kind}"><interface>{interface}</interface>{body}</pou>'


def project(dice, step):
    chart = Chart(dice, step)
    body = chart.xml()
    if dice.random() < 0.25:
        block = unit("Chart", "functionBlock", chart, body)
        calls = "".join(
            f"{name}({', '.join(f'{one} := {one}' for one in INPUTS)});"
            + "".join(f"{prefix}{output} := {name}.{output};" for output in OUTPUTS)
            for name, prefix in (("one", "p"), ("two", "q"))
        )
        interface = (
            variables("inputVars", INPUTS, "<BOOL/>")
            + variables("outputVars", [f"{prefix}{output}" for prefix in "pq" for output in OUTPUTS], "<BOOL/>")
            + variables("localVars", ["one", "two"], '<derived name="Chart"/>')
        )
        second = calls.split("two(")
        calls = f"{second[0]} IF a THEN two({second[1].replace(';', ';', 1)} END_IF;"
        units = block + (
            f'<pou name="Main" pouType="program"><interface>{interface}</interface>'
            f"<body><ST><xhtml:p><![CDATA[{calls}]]></xhtml:p></ST></body></pou>"
        )
    else:
        units = unit("Main", "program", chart, body)
    return (
        '<?xml version="1.0" encoding="utf-8"?>\n<project xmlns="http://www.plcopen.org/xml/tc6_0201" '
        'xmlns:xhtml="http://www.w3.org/1999/xhtml"><fileHeader companyName="x" productName="x" productVersion="1" '
        'creationDateTime="2026-01-01T00:00:00"/><contentHeader name="x"><coordinateInfo><fbd><scaling x="1" y="1"/></fbd><ld><scaling x="1" y="1"/></ld>'
        '<sfc><scaling x="1" y="1"/></sfc></coordinateInfo></contentHeader>\n<types><dataTypes/><pous>'
        f"{units}</pous></types>\n<instances><configurations><configuration name=\"c\"><resource name=\"r\">"
        '<task name="t" priority="0" interval="T#STEPms"><pouInstance name="i" typeName="Main"/></task>'
        "</resource></configuration></configurations></instances></project>\n"
    ).replace("STEP", str(step)).replace("><", ">\n<").replace(">\n<![CDATA[", "><![CDATA[").replace("]]>\n<", "]]><")


def inputs(dice):
    cell = lambda: dice.choice(["0", "1"]) if dice.random() < 0.3 else ""
    return [INPUTS] + [[cell() for _ in INPUTS] for _ in range(SCANS)]


def attempt(trace, folder, keep, seed):
    """None where all is the same, or what is wrong."""
    dice = random.Random(seed)
    file, given = folder / f"chart{seed}.xml", folder / f"chart{seed}.in.csv"
    step = dice.choice([10, 10, 100, 250, 500])
    file.write_text(project(dice, step))
    with given.open("w", newline="") as out:
        csv.writer(out).writerows(inputs(dice))
    text = file.with_suffix(".st")
    try:
        head, there = trace(str(file), SCANS, step, str(given), str(text))
    except (ValueError, subprocess.TimeoutExpired) as error:
        return "skipped: " + str(error)[-300:]
    for program in (file, text):
        found = difference(program, given, step, (head, there))
        if found and keep:
            for kept in (program, given):
                (Path(keep) / kept.name).write_text(kept.read_text())
        if found:
            return f"{program.suffix[1:]}: {found}"
    return None


def difference(program, given, step, trace):
    """What a program does otherwise here, or None."""
    head, there = trace
    command = [LADDER, "sim", str(program), "--scans", str(SCANS), "--dt", f"{step}ms", "--format", "csv", "--inputs", str(given)]
    simulated = subprocess.run(command, capture_output=True, text=True, check=False)
    here = list(csv.reader(io.StringIO(simulated.stdout)))
    if len(here) != SCANS + 1 or "not read" in simulated.stderr:
        return simulated.stderr[-500:] or "no run"
    places = {name: place for place, name in enumerate(head)}
    compared = 0
    for column, name in enumerate(here[0]):
        place = places.get(name.upper())
        if place is None or name in ("scan", "time_ms"):
            continue
        compared += 1
        for scan, (own, other) in enumerate(zip(here[1:], there)):
            if not is_same(own[column], other[place]):
                return f"scan {scan}: {name} is {own[column]}, there {other[place]}"
    return None if compared else "nothing is compared"


def main():
    tools = os.environ.get("LADDER_PEERS")
    if not tools:
        print("skip       LADDER_PEERS names no folder: no chart is compiled")
        return
    words = argparse.ArgumentParser()
    words.add_argument("count", type=int, nargs="?", default=20)
    words.add_argument("--first", type=int, default=0)
    words.add_argument("--keep")
    told = words.parse_args()
    trace = tracer(Path(tools))
    # The compiler may go on for ever where a text has errors.
    run = subprocess.run
    subprocess.run = lambda *words, **named: run(*words, **(named | {"timeout": 20}))
    seeds = range(told.first, told.first + told.count)
    with tempfile.TemporaryDirectory() as work, ThreadPoolExecutor(2) as pool:
        found = list(pool.map(partial(attempt, trace, Path(work), told.keep), seeds))
    skipped = [what for what in found if what and what.startswith("skipped")]
    wrong = [(seed, what) for seed, what in zip(seeds, found) if what and not what.startswith("skipped")]
    for seed, what in wrong:
        print(f"chart {seed}: {what}")
    if skipped:
        print(f"{len(skipped)} charts do not compile there: {skipped[0]}")
    if wrong:
        sys.exit(f"{len(wrong)} of {told.count} charts are not the same where they are compiled")
    print(f"{told.count - len(skipped)} charts are the same where they are compiled")


if __name__ == "__main__":
    main()
