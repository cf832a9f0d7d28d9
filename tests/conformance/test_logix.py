"""`ladder online` next to a Logix controller: a host of sessions, connections and packets that others wrote."""

import csv
import os
import subprocess
import sys
from pathlib import Path

import pytest

LADDER = os.environ["LADDER_BIN"]

# Longer than the slowest machine needs, in seconds.
PATIENCE = 60

# `run` and `step` are first of all those of the program that is called as the file.
PROGRAM = """\
# ladder: profile logix #
TYPE
    Motor : STRUCT
        speed   : REAL;
        cmd     : INT;
        running : BOOL;
        fault   : BOOL;
        past    : ARRAY[0..3] OF INT;
    END_STRUCT;
END_TYPE
VAR
    run     : BOOL;
    level   : REAL;
    count   : DINT;
    tall    : SINT;
    missing : BOOL;
    recipe  : STRING[82];
    grid    : ARRAY[0..1, 0..2] OF INT;
    lamps   : ARRAY[0..63] OF BOOL;
    table   : ARRAY[0..999] OF DINT;
    warmup  : TON;
    pump    : Motor;
    step    : DINT;
END_VAR
+--[ ]( run )--( )( missing )--+
+--[GE]( table[999], 0 )--( )( missing )--+
+--[ ]( missing )--[TON]( warmup, T#5s )--( )( missing )--+
"""

VALUES = {
    "run": "FALSE",
    "level": "12.5",
    "count": "-7",
    "grid[1, 2]": "12",
    "lamps[5]": "TRUE",
    "lamps[6]": "FALSE",
    "warmup.PT": "T#5s",
    "warmup.ET": "T#1s250ms",
    "warmup.Q": "FALSE",
    "pump.speed": "3.5",
    "pump.cmd": "42",
    "pump.running": "FALSE",
    "pump.fault": "TRUE",
    "pump.past[3]": "4",
    "step": "20",
}


@pytest.fixture(params=[[], ["--small"]], ids=["large packets", "small packets"])
def host(request):
    script = Path(__file__).with_name("logix_host.py")
    host = subprocess.Popen([sys.executable, script, "--tags", "1000", *request.param], stdout=subprocess.PIPE, text=True)
    yield int(host.stdout.readline())
    host.terminate()
    told = host.stdout.read()
    host.wait(PATIENCE)
    assert told == "", told


def test_values(host, tmp_path):
    (tmp_path / "Main.clad").write_text(PROGRAM)
    ladder = [LADDER, "online", "Main.clad", "--from", f"logix:127.0.0.1:{host}/0", "--once", "--tags-out", "values.csv"]
    asked = subprocess.run(ladder, cwd=tmp_path, capture_output=True, text=True, timeout=PATIENCE)
    # 1: the values contradict the program.
    assert asked.returncode in (0, 1), asked.stderr
    rows = list(csv.reader((tmp_path / "values.csv").open(newline="")))
    values = dict(rows[1:])
    assert {name: values.get(name) for name in VALUES} == VALUES
    # What is of another type, and what is not there, is told and not guessed.
    assert "tall" not in values and "missing" not in values
    assert "tall" in asked.stderr and "INT" in asked.stderr and "missing" in asked.stderr


def test_nobody_there(tmp_path):
    (tmp_path / "Main.clad").write_text(PROGRAM)
    ladder = [LADDER, "online", "Main.clad", "--from", "logix:127.0.0.1:1/0", "--once"]
    asked = subprocess.run(ladder, cwd=tmp_path, capture_output=True, text=True, timeout=PATIENCE)
    assert asked.returncode == 2
    assert "cannot be reached" in asked.stderr
