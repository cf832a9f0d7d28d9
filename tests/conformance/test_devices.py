"""`ladder run` next to a Modbus server that others wrote: a device of remote inputs and outputs."""

import asyncio
import os
import signal
import subprocess
import threading
import time

import pytest
from pymodbus.datastore import ModbusDeviceContext, ModbusSequentialDataBlock, ModbusServerContext
from pymodbus.server import ModbusTcpServer

LADDER = os.environ["LADDER_BIN"]

# Longer than the slowest machine needs, in seconds.
PATIENCE = 30

UNIT = 5

PROGRAM = """\
VAR_INPUT
    rio_ok : BOOL;
    level  : REAL;
    rows   : ARRAY[1..300] OF INT;
END_VAR
VAR_OUTPUT
    speed  : DINT := -2;
    echo   : REAL;
    last   : INT;
END_VAR
+--[ ]( %IX10.7 )--[/]( %IX11.0 )--( )( %QX10.1 )--+
+--[ ]( rio_ok )--[MOV]( speed, 70000 )--[MOV]( echo, level )--[MOV]( last, rows[300] )--+
"""

SETTINGS = """\
[[device]]
name = "rio"
modbus = "127.0.0.1:{port}"
unit = {unit}
poll = "10ms"
ok = "rio_ok"
[device.read]
"discrete 0..15" = "%IX10.0"
"input 2" = "level"
"holding 100" = "rows"
[device.write]
"coil 0..7" = "%QX10.0"
"holding 4" = "speed"
"holding 6" = "echo"
"holding 8" = "last"
"""


class Device:
    """A server of pymodbus on a thread of its own."""

    def __init__(self):
        # Blocks of this kind count from 1.
        bits = lambda: ModbusSequentialDataBlock(1, [0] * 64)
        words = lambda: ModbusSequentialDataBlock(1, [0] * 500)
        self.context = ModbusServerContext(
            devices={UNIT: ModbusDeviceContext(di=bits(), co=bits(), ir=words(), hr=words())}, single=False
        )
        self.is_ready = threading.Event()
        self.thread = threading.Thread(target=lambda: asyncio.run(self.serve()), daemon=True)
        self.thread.start()
        assert self.is_ready.wait(PATIENCE)

    async def serve(self):
        self.loop = asyncio.get_running_loop()
        self.server = ModbusTcpServer(self.context, address=("127.0.0.1", 0))
        await self.server.listen()
        self.port = self.server.transport.sockets[0].getsockname()[1]
        self.is_ready.set()
        await self.server.serving

    def wait_for(self, what):
        return asyncio.run_coroutine_threadsafe(what, self.loop).result(PATIENCE)

    def close(self):
        self.wait_for(self.server.shutdown())
        self.thread.join(PATIENCE)

    def set(self, function, address, values):
        self.wait_for(self.server.async_setValues(UNIT, function, address, values))

    def becomes(self, function, address, values):
        get = lambda: self.wait_for(self.server.async_getValues(UNIT, function, address, len(values)))
        end = time.monotonic() + PATIENCE
        while (got := get()) != values:
            assert time.monotonic() < end, got
            time.sleep(0.01)


@pytest.fixture
def device():
    device = Device()
    yield device
    device.close()


@pytest.fixture
def run(device, tmp_path):
    (tmp_path / "a.clad").write_text(PROGRAM)
    (tmp_path / "ladder.toml").write_text(SETTINGS.format(port=device.port, unit=UNIT))
    run = subprocess.Popen([LADDER, "run", "a.clad"], cwd=tmp_path, stderr=subprocess.PIPE, text=True)
    yield run
    if run.poll() is None:
        run.kill()
        run.wait()


def test_inputs_and_outputs(device, run):
    # 1.5, the high word first; the last of 300 registers, which take three requests.
    device.set(4, 2, [0x3FC0, 0])
    device.set(3, 399, [1234])
    device.set(2, 7, [True])
    device.becomes(1, 0, [False, True])
    device.becomes(3, 4, [1, 4464, 0x3FC0, 0, 1234])
    device.set(2, 8, [True])
    device.becomes(1, 1, [False])
    # At a clean end the outputs are what they were before the program ran.
    run.send_signal(signal.SIGTERM)
    rest = run.stderr.read()
    assert run.wait(PATIENCE) == 0, rest
    assert "device rio answers" in rest
    device.becomes(3, 4, [0xFFFF, 0xFFFE, 0, 0, 0])
