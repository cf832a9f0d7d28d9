"""A Logix controller for tests: sessions, connections and packets are of cm-ethernetip; tags and types are told here, as real
controllers do it (Rockwell's 1756-PM020), since that package tells them in a form of its own.

    logix_host.py [--port N] [--tags N] [--small]

Prints the port. Every service that is not one of reading is printed, too: `refused 4D`.
"""

import argparse
import asyncio
import struct
from dataclasses import dataclass, field

from ethernetip.cip.identity_info import IdentityInfo
from ethernetip.cip.service import CipServiceResponse
from ethernetip.cip.status import CipStatus
from ethernetip.logix.logix_dispatcher import LogixDispatcher
from ethernetip.protocol.eip_adapter import EipAdapter

# The most bytes of data in one answer: so that lists, types and arrays come in several.
MOST = 480

ATOMIC = {"BOOL": (0xC1, 1), "SINT": (0xC2, 1), "INT": (0xC3, 2), "DINT": (0xC4, 4), "LINT": (0xC5, 8), "USINT": (0xC6, 1),
          "REAL": (0xCA, 4), "LREAL": (0xCB, 8), "DWORD": (0xD3, 4)}
PACK = {"BOOL": "<?", "SINT": "<b", "INT": "<h", "DINT": "<i", "LINT": "<q", "USINT": "<B", "REAL": "<f", "LREAL": "<d", "DWORD": "<I"}

PARTIAL, PATH_UNKNOWN, NOT_SUPPORTED, REFUSED, NOT_SHOWN = 0x06, 0x05, 0x08, 0x01, 0x0F
BASE_TAG = 1 << 26


@dataclass
class Structure:
    """`members`: name, type, how many (0: not an array) or the number of a bit, offset."""

    number: int
    name: str
    size: int
    members: list
    # Of one a member is not shown, so it is refused as a whole.
    is_shown: bool = True

    def definition(self):
        codes = (
            struct.pack("<HHI", count, 0x8000 | kind.number if isinstance(kind, Structure) else ATOMIC[kind][0], at)
            for _, kind, count, at in self.members
        )
        names = b"\0".join(name.encode() for name, *_ in self.members)
        # A predefined type has its name alone.
        mark = b"" if self.number > 0xEFF else b";nEBECAHA"
        return b"".join(codes) + self.name.encode() + mark + b"\0" + names + b"\0"

    @property
    def words(self):
        # From this a reader takes 21 bytes away again.
        return (len(self.definition()) + 21 + 3) // 4


@dataclass
class Tag:
    name: str
    kind: object
    lengths: tuple = ()
    data: bytearray = field(default_factory=bytearray)

    def __post_init__(self):
        self.data = self.data or bytearray(self.size * self.count)

    @property
    def size(self):
        return self.kind.size if isinstance(self.kind, Structure) else ATOMIC[self.kind][1]

    @property
    def count(self):
        count = 1
        for length in self.lengths:
            count *= length
        return count // 32 if self.kind == "DWORD" else count

    @property
    def symbol_type(self):
        code = 0x8000 | self.kind.number if isinstance(self.kind, Structure) else ATOMIC[self.kind][0]
        return code | len(self.lengths) << 13

    def put(self, kind, at, *values):
        for value in values:
            struct.pack_into(PACK[kind], self.data, at, value)
            at += ATOMIC[kind][1]
        return self


def type_code(kind):
    return struct.pack("<HH", 0x02A0, kind.number) if isinstance(kind, Structure) else struct.pack("<H", ATOMIC[kind][0])


class Controller(LogixDispatcher):
    def __init__(self, more, is_small):
        identity = IdentityInfo(vendor_id=1, device_type=14, product_code=166, major_revision=33, minor_revision=11,
                                serial_number=0x1234, product_name="1756-L83E/B")
        super().__init__(identity=identity)
        self.identity = identity
        self.is_small = is_small
        self.structures, tags = machine()
        tags += [Tag(f"tag_{n:04}", "DINT").put("DINT", 0, n) for n in range(more)]
        # Numbers of controller tags and of each program's begin with 1.
        self.scopes = {None: {}}
        for tag in tags:
            program, _, name = tag.name.rpartition(".")
            scope = self.scopes.setdefault(program or None, {})
            scope[len(scope) + 1] = (name, tag)
        for program in [program for program in self.scopes if program]:
            self.scopes[None][len(self.scopes[None]) + 1] = (program, None)

    def dispatch(self, service, path, data):
        symbols = (path.symbolic_name or "").split(".") if path.symbolic_name else []
        if path.class_id == 0x06 and service == 0x5B and self.is_small:
            return self.error(service, REFUSED, 0x0109)
        if path.class_id in (0x01, 0x02, 0x06, 0x64):
            return super().dispatch(service, path, data)
        if path.class_id == 0xAC and service == 0x03:
            return CipServiceResponse.success(service, version(data))
        if path.class_id == 0x6C and path.instance_id in self.structures:
            structure = self.structures[path.instance_id]
            if service == 0x03:
                return CipServiceResponse.success(service, makeup(structure, data))
            if service == 0x4C:
                start, length = struct.unpack("<IH", data)
                return self.part(service, structure.definition(), b"", start, start + length)
        if path.class_id == 0x6B and service == 0x55:
            return self.names(service, symbols[0] if symbols else None, path.instance_id, data)
        if path.class_id in (None, 0x6B) and service in (0x4C, 0x52):
            return self.read(service, path, symbols, data)
        print(f"refused {service:02X}", flush=True)
        return self.error(service, NOT_SUPPORTED)

    def error(self, service, status, *more):
        return CipServiceResponse.error(service, CipStatus(general_status=status, additional_status=more))

    def part(self, service, whole, head, start, end):
        """What fits of it, with the word that there is more."""
        fit = min(start + MOST - len(head), end, len(whole))
        status = CipStatus(general_status=PARTIAL if fit < min(end, len(whole)) else 0, additional_status=())
        return CipServiceResponse(service_code=service | 0x80, status=status, data=head + whole[start:fit])

    def names(self, service, program, first, data):
        count, *attributes = struct.unpack(f"<{len(data) // 2}H", data)
        found = b""
        for number, (name, tag) in self.scopes.get(program, {}).items():
            if number < first:
                continue
            known = {
                1: struct.pack("<H", len(name)) + name.encode(),
                2: struct.pack("<H", tag.symbol_type if tag else 0x1068),
                3: bytes(4), 5: bytes(4), 6: struct.pack("<I", BASE_TAG),
                8: struct.pack("<III", *(tag.lengths if tag else ()), *[0] * (3 - len(tag.lengths if tag else ()))),
                10: b"\0",
            }
            entry = struct.pack("<I", number) + b"".join(known[attribute] for attribute in attributes[:count])
            if len(found) + len(entry) > MOST:
                status = CipStatus(general_status=PARTIAL, additional_status=())
                return CipServiceResponse(service_code=service | 0x80, status=status, data=found)
            found += entry
        return CipServiceResponse.success(service, found)

    def read(self, service, path, symbols, data):
        program = symbols.pop(0) if symbols and symbols[0].startswith("Program:") else None
        scope = self.scopes.get(program, {})
        if path.class_id is None and symbols:
            name = symbols.pop(0).lower()
            tag = next((tag for own, tag in scope.values() if own.lower() == name), None)
        else:
            _, tag = scope.get(path.instance_id, (None, None))
        if tag is None:
            return self.error(service, PATH_UNKNOWN)
        kind, at = tag.kind, (path.element_id or 0) * tag.size
        bit = None
        for symbol in symbols:
            member = next((member for member in getattr(kind, "members", []) if member[0] == symbol), None)
            if member is None:
                return self.error(service, PATH_UNKNOWN)
            kind, at, bit = member[1], at + member[3], member[2] if member[1] == "BOOL" else None
        count, start = (struct.unpack("<H", data)[0], 0) if service == 0x4C else struct.unpack("<HI", data)
        if not getattr(kind, "is_shown", True):
            return self.error(service, NOT_SHOWN)
        if bit is not None:
            return CipServiceResponse.success(service, type_code("BOOL") + bytes([tag.data[at] >> bit & 1]))
        whole = tag.data[at : at + count * (kind.size if isinstance(kind, Structure) else ATOMIC[kind][1])]
        return self.part(service, bytes(whole), type_code(kind), start, len(whole))


def version(data):
    """Nothing is ever edited."""
    count, *attributes = struct.unpack(f"<{len(data) // 2}H", data)
    values = {1: b"\1\0", 2: b"\1\0", 3: bytes(4), 4: bytes(4), 10: bytes(4)}
    return struct.pack("<H", count) + b"".join(struct.pack("<HH", number, 0) + values[number] for number in attributes)


def makeup(structure, data):
    count, *attributes = struct.unpack(f"<{len(data) // 2}H", data)
    values = {
        1: struct.pack("<H", structure.number),
        2: struct.pack("<H", len(structure.members)),
        4: struct.pack("<I", structure.words),
        5: struct.pack("<I", structure.size),
    }
    return struct.pack("<H", count) + b"".join(struct.pack("<HH", number, 0) + values[number] for number in attributes)


def machine():
    """A pump and two lines, with something of every type."""
    timer = Structure(0xF83, "TIMER", 12, [
        ("CTL", "DINT", 0, 0), ("PRE", "DINT", 0, 4), ("ACC", "DINT", 0, 8), ("EN", "BOOL", 7, 3), ("TT", "BOOL", 6, 3), ("DN", "BOOL", 5, 3),
    ])
    counter = Structure(0xF82, "COUNTER", 12, [
        ("CTL", "DINT", 0, 0), ("PRE", "DINT", 0, 4), ("ACC", "DINT", 0, 8), ("CU", "BOOL", 7, 3), ("CD", "BOOL", 6, 3), ("DN", "BOOL", 5, 3),
        ("OV", "BOOL", 4, 3), ("UN", "BOOL", 3, 3),
    ])
    string = Structure(0xFCE, "ASCIISTRING82", 88, [("LEN", "DINT", 0, 0), ("DATA", "SINT", 82, 4)])
    motor = Structure(0x101, "Motor", 40, [
        ("speed", "REAL", 0, 0), ("cmd", "INT", 0, 4), ("ZZZZZZZZZZMotor2", "SINT", 0, 6), ("running", "BOOL", 0, 6), ("fault", "BOOL", 1, 6),
        ("past", "INT", 4, 8), ("delay", timer, 0, 16), ("flags", "DWORD", 2, 28),
    ])
    line = Structure(0x102, "Line", 88, [("number", "SINT", 0, 0), ("motors", motor, 2, 4)])
    closed = Structure(0x103, "Closed", 8, [("open", "DINT", 0, 0), ("secret", "DINT", 0, 4)], is_shown=False)
    text = Tag("recipe", string).put("DINT", 0, 5)
    text.data[4:9] = "grün!".encode("latin-1")
    tags = [
        Tag("start", "BOOL"), Tag("run", "BOOL").put("BOOL", 0, True),
        Tag("level", "REAL").put("REAL", 0, 12.5), Tag("exact", "LREAL").put("LREAL", 0, 0.1),
        Tag("count", "DINT").put("DINT", 0, -7), Tag("small", "SINT").put("SINT", 0, -3), Tag("tall", "INT").put("INT", 0, 300),
        Tag("wide", "LINT").put("LINT", 0, -(1 << 40)), Tag("byte", "USINT").put("USINT", 0, 200),
        Tag("table", "DINT", (2000,)).put("DINT", 0, *range(2000)),
        Tag("grid", "INT", (2, 3)).put("INT", 0, 0, 1, 2, 10, 11, 12),
        Tag("lamps", "DWORD", (64,)).put("DWORD", 0, 1 << 5, 1 << 31),
        text,
        Tag("warmup", timer).put("DINT", 4, 5000, 1250).put("USINT", 3, 0xC0),
        Tag("pieces", counter).put("DINT", 4, 10, 12).put("USINT", 3, 0xA0),
        Tag("pump", motor).put("REAL", 0, 3.5).put("INT", 4, 42).put("USINT", 6, 0b10).put("INT", 8, 1, 2, 3, 4).put("DINT", 20, 2000, 2000)
        .put("USINT", 19, 0x20).put("DWORD", 28, 0, 1 << 3),
        Tag("lines", line, (4,)).put("SINT", 2 * 88, 3).put("INT", 2 * 88 + 4 + 40 + 4, 9),
        Tag("safe", closed).put("DINT", 0, 77, 88),
        Tag("Program:Main.step", "DINT").put("DINT", 0, 20), Tag("Program:Main.run", "BOOL"), Tag("Program:Main.wait", timer).put("DINT", 4, 100, 7),
        Tag("Program:Other.step", "DINT").put("DINT", 0, 99),
    ]
    return {structure.number: structure for structure in (timer, counter, string, motor, line, closed)}, tags


async def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--port", type=int, default=0)
    parser.add_argument("--tags", type=int, default=0, help="so many more, tag_0000 on")
    parser.add_argument("--small", action="store_true", help="large packets are refused, as old processors do")
    given = parser.parse_args()
    controller = Controller(given.tags, given.small)
    adapter = EipAdapter(controller, controller.identity)
    await adapter.listen("127.0.0.1", given.port)
    print(adapter.port, flush=True)
    await asyncio.Event().wait()


if __name__ == "__main__":
    asyncio.run(main())
