#!/usr/bin/env python3
"""1,000 registers at 100 Hz from `ladder run`, beside its scan of 10 ms, next to the bare exchange.

    cargo build --release -p ladder-cli --bins
    python3 -m venv /tmp/modbus && /tmp/modbus/bin/pip install pymodbus==3.16.1
    /tmp/modbus/bin/python tests/benches/modbus.py target/release/ladder

The client is pymodbus: eight requests of 125 registers, one after the other, every 10 ms. The bare exchange is the same client
with a server that sends the same bytes back and does nothing else. Both are asked in turns, so that what else the machine does
hits both alike. Shown are the times of a cycle of eight requests, and what `ladder run` says of its scans.
"""

import argparse
import re
import socket
import struct
import subprocess
import tempfile
import time
from multiprocessing import Process
from pathlib import Path

from pymodbus.client import ModbusTcpClient

REQUESTS, REGISTERS = 8, 125
EVERY = 0.010

PROGRAM = """VAR
    rows : ARRAY[0..999] OF INT;
END_VAR

+--[ADD]( rows[0], rows[0], 1 )--+
"""

SETTINGS = """[simulate]
interval = "10ms"

[serve.modbus]
listen = "127.0.0.1:0"

[serve.modbus.map]
"holding 0..999" = "rows[0..999]"
"""


def answer_bare(listening):
    """Answers every request for registers with the same number of bytes."""
    body = bytes(2 * REGISTERS)
    while True:
        client = listening.accept()[0]
        client.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        while len(request := client.recv(12, socket.MSG_WAITALL)) == 12:
            head = struct.pack(">2sHHBBB", request[:2], 0, 3 + len(body), request[6], 3, len(body))
            client.sendall(head + body)


def bare():
    """A process that does so; where it listens."""
    listening = socket.create_server(("127.0.0.1", 0))
    Process(target=answer_bare, args=(listening,), daemon=True).start()
    return listening.getsockname()[1]


def cycles(port, seconds):
    """The times of the cycles, and how many began late by a whole one."""
    client = ModbusTcpClient("127.0.0.1", port=port)
    assert client.connect()
    times, late = [], 0
    start = time.perf_counter()
    for number in range(int(seconds / EVERY)):
        due = start + number * EVERY
        time.sleep(max(0.0, due - time.perf_counter()))
        began = time.perf_counter()
        late += began - due > EVERY
        for request in range(REQUESTS):
            answer = client.read_holding_registers(request * REGISTERS, count=REGISTERS, device_id=1)
            assert not answer.isError(), answer
        times.append(time.perf_counter() - began)
    client.close()
    return times, late


def at(times, share):
    return sorted(times)[min(int(len(times) * share), len(times) - 1)] * 1e3


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("ladder", type=Path)
    parser.add_argument("--seconds", type=float, default=5, help="of each turn")
    parser.add_argument("--turns", type=int, default=4)
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "rows.clad").write_text(PROGRAM, encoding="utf-8")
        Path(folder, "ladder.toml").write_text(SETTINGS, encoding="utf-8")
        length = f"{int(given.seconds * given.turns * 2 + 5)}s"
        run = subprocess.Popen(
            [given.ladder.resolve(), "run", "rows.clad", "--for", length], cwd=folder, stderr=subprocess.PIPE, text=True
        )
        lines = iter(run.stderr.readline, "")
        address = next(found for line in lines if (found := re.search(r"127\.0\.0\.1:(\d+)", line)))
        servers = {"ladder run": int(address[1]), "bare exchange": bare()}
        all_times = {name: [] for name in servers}
        all_late = dict.fromkeys(servers, 0)
        for _ in range(given.turns):
            for name, port in servers.items():
                times, late = cycles(port, given.seconds)
                all_times[name] += times
                all_late[name] += late
        for name, times in all_times.items():
            print(
                f"{name:14} {len(times)} cycles, {all_late[name]} late; "
                f"50 % {at(times, 0.5):.2f} ms, 99 % {at(times, 0.99):.2f} ms, at most {at(times, 1):.2f} ms"
            )
        ours, theirs = all_times.values()
        print(f"ratio          50 % {at(ours, 0.5) / at(theirs, 0.5):.2f}, 99 % {at(ours, 0.99) / at(theirs, 0.99):.2f}")
        print(*(line.strip() for line in lines), sep="\n")


if __name__ == "__main__":
    main()
