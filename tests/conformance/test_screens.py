"""What `ladder tags` writes for screens, next to what a client reads from `ladder run`."""

import json
import os
import re
import signal
import subprocess

import pytest
from pymodbus.client import ModbusTcpClient

LADDER = os.environ["LADDER_BIN"]

# Longer than the slowest machine needs, in seconds.
PATIENCE = 30

# Each tag with its type, its value in the program, and the value that a screen shows.
TAGS = {
    "low": ("BOOL", "FALSE", False),
    "high": ("BOOL", "TRUE", True),
    "int": ("INT", "-2", -2),
    "word": ("WORD", "65535", 65535),
    "sint": ("SINT", "-3", -3),
    "dint": ("DINT", "-70000", -70000),
    "udint": ("UDINT", "4000000000", 4000000000),
    "real": ("REAL", "1.5", 1.5),
    "time": ("TIME", "T#70s", 70000),
    "lint": ("LINT", "-5000000000", -5000000000),
    "lreal": ("LREAL", "0.1", 0.1),
}

DECLARATIONS = "".join(f"    t_{name} : {ty} := {value};\n" for name, (ty, value, _) in TAGS.items())
PROGRAM = f"VAR\n{DECLARATIONS}END_VAR\n+--[ ]( t_low )--( )( lamp )--+\n"

SETTINGS = """\
[serve.modbus]
listen = "127.0.0.1:{port}"
words = "{words}"
[serve.modbus.map]
"coil 3" = "t_low"
"coil 4" = "t_high"
"""


@pytest.fixture(params=["big", "little"])
def words(request):
    return request.param


@pytest.fixture
def served(tmp_path, words):
    settings = SETTINGS.format(port=0, words=words)
    for nth, name in enumerate(list(TAGS)[2:]):
        settings += f'"holding {100 + 5 * nth}" = "t_{name}"\n'
    (tmp_path / "a.clad").write_text(PROGRAM)
    (tmp_path / "ladder.toml").write_text(settings)
    run = subprocess.Popen([LADDER, "run", "a.clad"], cwd=tmp_path, stderr=subprocess.PIPE, text=True)
    port = None
    while port is None:
        line = run.stderr.readline()
        assert line, "it ended"
        found = re.search(r"served on 127\.0\.0\.1:(\d+)", line)
        port = int(found[1]) if found else None
    client = ModbusTcpClient("127.0.0.1", port=port, timeout=PATIENCE)
    assert client.connect()
    yield tmp_path, client
    client.close()
    run.send_signal(signal.SIGTERM)
    run.stderr.read()
    assert run.wait(PATIENCE) == 0


def exported(folder, form):
    command = [LADDER, "tags", "a.clad", "--map", "modbus", "--format", form]
    return json.loads(subprocess.run(command, cwd=folder, capture_output=True, text=True, check=True).stdout)


def read(client, table, first, count):
    ask = {
        "Coil": client.read_coils,
        "Input": client.read_discrete_inputs,
        "InputRegister": client.read_input_registers,
        "HoldingRegister": client.read_holding_registers,
    }[table]
    answer = ask(first, count=count, device_id=1)
    assert not answer.isError(), answer
    return answer.registers or answer.bits[:count]


# As the node `function` runs its script.
RUN = "const [script, payload] = JSON.parse(require('fs').readFileSync(0)); console.log(JSON.stringify(new Function('msg', script)({ payload }).payload))"


def test_node_red(served):
    folder, client = served
    nodes = {node["id"]: node for node in exported(folder, "node-red")}
    named = {}
    for node in nodes.values():
        if node["type"] == "modbus-read":
            script = nodes[node["wires"][0][0]]["func"]
            got = read(client, node["dataType"], int(node["adr"]), int(node["quantity"]))
            asked = json.dumps([script, got])
            named |= json.loads(subprocess.run(["node", "-e", RUN], input=asked, capture_output=True, text=True, check=True).stdout)
    named.pop("lamp", None)
    assert named == {f"t_{name}": shown for name, (_, _, shown) in TAGS.items()}


def test_fuxa(served, words):
    folder, client = served
    [device] = exported(folder, "fuxa")
    got = {}
    for key, tag in device["tags"].items():
        assert key == tag["id"]
        table = {"000000": "Coil", "100000": "Input", "300000": "InputRegister", "400000": "HoldingRegister"}[tag["memaddress"]]
        kind = tag["type"]
        if kind == "Bool":
            [value] = read(client, table, tag["address"] - 1, 1)
        else:
            plain, low_first = kind.removesuffix("MLE"), kind.endswith("MLE")
            plain = client.DATATYPE[plain.upper()]
            got_words = read(client, table, tag["address"] - 1, plain.value[1])
            value = client.convert_from_registers(got_words[::-1] if low_first else got_words, plain)
        got[tag["name"]] = value
    got.pop("lamp", None)
    expected = {f"t_{name}": shown for name, (_, _, shown) in TAGS.items()}
    if words == "little":
        # It has no types for these.
        del expected["t_lint"], expected["t_lreal"]
    assert got == expected
