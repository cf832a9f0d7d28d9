"""`ladder run` next to a Modbus client that others wrote."""

import json
import os
import re
import signal
import socket
import struct
import subprocess
import time
from pathlib import Path

import pytest
from pymodbus.client import ModbusTcpClient
from pymodbus.pdu import ExceptionResponse

LADDER = os.environ["LADDER_BIN"]

# Longer than the slowest machine needs, in seconds.
PATIENCE = 30

PROGRAM = """\
VAR_INPUT
    start AT %IX0.0 : BOOL;
    go              : BOOL;
    wanted          : REAL;
    number          : LINT;
END_VAR
VAR_OUTPUT
    run AT %QX1.2 : BOOL;
    level AT %MD0 : REAL;
    echo          : LINT;
END_VAR
VAR
    row : ARRAY[1..1000] OF INT;
    n   : DINT;
END_VAR
+--[ ]( go )--( )( run )--+
+--[MOV]( level, wanted )--[MOV]( echo, number )--+
+--[ADD]( n, n, 1 )--[MOV]( row[1000], 7 )--+
"""

SETTINGS = """\
[serve.modbus]
listen = "127.0.0.1:0"
write = ["go", "wanted", "number"]
unit = 1
[serve.modbus.map]
"coil 0" = "go"
"holding 0" = "wanted"
"holding 10" = "number"
"holding 20" = "echo"
"input 0" = "row[1..1000]"
"input 2000" = "n"
"""


@pytest.fixture
def served(tmp_path):
    (tmp_path / "a.clad").write_text(PROGRAM)
    (tmp_path / "ladder.toml").write_text(SETTINGS)
    run = subprocess.Popen([LADDER, "run", "a.clad"], cwd=tmp_path, stderr=subprocess.PIPE, text=True)
    port = None
    while port is None:
        line = run.stderr.readline()
        assert line, "it ended"
        found = re.search(r"served on 127\.0\.0\.1:(\d+)", line)
        port = int(found[1]) if found else None
    yield port
    run.send_signal(signal.SIGTERM)
    rest = run.stderr.read()
    assert run.wait(PATIENCE) == 0, rest


@pytest.fixture
def client(served):
    client = ModbusTcpClient("127.0.0.1", port=served, timeout=PATIENCE)
    assert client.connect()
    yield client
    client.close()


def becomes(read, wanted):
    """Reads until that is there: what is written arrives with the next scan."""
    end = time.monotonic() + PATIENCE
    while (got := read()) != wanted:
        assert time.monotonic() < end, got


def test_bits(client):
    assert not client.write_coil(0, True, device_id=1).isError()
    becomes(lambda: client.read_coils(10, count=1, device_id=1).bits[:1], [True])
    assert client.read_discrete_inputs(0, count=1, device_id=1).bits[0] is False
    assert not client.write_coils(0, [False], device_id=1).isError()
    becomes(lambda: client.read_coils(10, count=1, device_id=1).bits[:1], [False])


@pytest.mark.parametrize(
    "value, kind, at, echo",
    [(1.5, "FLOAT32", 0, 2048), (-(2**53) - 1, "INT64", 10, 20)],
)
def test_numbers_of_several_words(client, value, kind, at, echo):
    kind = client.DATATYPE[kind]
    words = client.convert_to_registers(value, kind)
    assert not client.write_registers(at, words, device_id=1).isError()
    becomes(
        lambda: client.convert_from_registers(client.read_holding_registers(echo, count=len(words), device_id=1).registers, kind),
        value,
    )


@pytest.mark.parametrize(
    "ask, code",
    [
        (lambda client: client.read_holding_registers(5000, count=1, device_id=1), 2),
        (lambda client: client.read_coils(9, count=4, device_id=1), 2),
        (lambda client: client.write_coil(10, True, device_id=1), 2),
        (lambda client: client.write_register(0, 1, device_id=1), 3),
        (lambda client: client.mask_write_register(address=0, and_mask=0, or_mask=0, device_id=1), 1),
        (lambda client: client.readwrite_registers(read_address=0, read_count=1, write_address=0, values=[1], device_id=1), 1),
        (lambda client: client.read_coils(0, count=1, device_id=7), 11),
    ],
)
def test_what_is_refused(client, ask, code):
    answer = ask(client)
    assert isinstance(answer, ExceptionResponse) and answer.exception_code == code, answer


def test_a_thousand_registers(client):
    parts = [client.read_input_registers(at, count=125, device_id=1).registers for at in range(0, 1000, 125)]
    assert sum(parts, []) == [0] * 999 + [7]


def test_others_are_served_beside_half_a_frame(served, client):
    lame = socket.create_connection(("127.0.0.1", served))
    lame.sendall(struct.pack(">HHHB", 1, 0, 6, 1))
    n = lambda: client.convert_from_registers(client.read_input_registers(2000, count=2, device_id=1).registers, client.DATATYPE.INT32)
    before = n()
    becomes(lambda: n() > before, True)
    lame.close()


@pytest.mark.parametrize("library", ["modbus-serial", "jsmodbus"])
def test_the_clients_of_fuxa_and_node_red(served, library):
    script = Path(__file__).with_name("clients") / "ask.js"
    asked = subprocess.run(["node", script, library, str(served)], capture_output=True, text=True, timeout=4 * PATIENCE)
    assert asked.returncode == 0, asked.stderr
    assert json.loads(asked.stdout) == {"bit": [True], "real": [0x3FC0, 0], "last": [0, 7], "refused": [2, 2, 3]}
