"""A registry of crates for packages/rehearse: it takes what is published, and has all other crates from crates.io.

python3 packages/registries/crates.py FOLDER [UPLOAD=STATUS]...

It prints the port that it serves at. UPLOAD=STATUS refuses one upload, by its number, with that status: 429 with a time until which
to wait, as crates.io does.
"""

import email.utils
import hashlib
import json
import struct
import sys
import threading
import time
import urllib.error
import urllib.request
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

INDEX = "https://index.crates.io"
CRATES = "https://static.crates.io/crates"

folder = Path(sys.argv[1])
refused = dict(map(int, argument.split("=")) for argument in sys.argv[2:])
uploads = 0
others = {}
lock = threading.Lock()


def line_of(metadata, crate):
    """What the index says of a crate: nearly what was sent with it."""

    def dependency(sent):
        renamed = sent.pop("explicit_name_in_toml", None)
        return sent | {"req": sent.pop("version_req"), **({"name": renamed, "package": sent["name"]} if renamed else {})}

    return {
        "name": metadata["name"],
        "vers": metadata["vers"],
        "deps": [dependency(sent) for sent in metadata["deps"]],
        "features": {},
        # Version 2 of a line, which has features in words of their own.
        "features2": metadata["features"],
        "v": 2,
        "cksum": hashlib.sha256(crate).hexdigest(),
        "yanked": False,
        "links": metadata["links"],
        "rust_version": metadata.get("rust_version"),
    }


def of_others(place):
    """The index of crates.io, once for each crate."""
    with lock:
        if place not in others:
            try:
                with urllib.request.urlopen(f"{INDEX}/{place}") as answer:
                    others[place] = answer.read()
            except urllib.error.HTTPError as error:
                if error.code not in (404, 410, 451):
                    raise
                others[place] = None
        return others[place]


class Registry(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"

    def log_message(self, *_):
        pass

    def answer(self, content, status=200, **headers):
        self.send_response(status)
        for name, value in headers.items():
            self.send_header(name, value)
        self.send_header("Content-Length", str(len(content)))
        self.end_headers()
        self.wfile.write(content)

    def refuse(self, status, why):
        self.answer(json.dumps({"errors": [{"detail": why}]}).encode(), status)

    def do_GET(self):
        what, place = self.path.strip("/").split("/", 1)
        if place == "config.json":
            here = f"http://127.0.0.1:{self.server.server_port}"
            self.answer(json.dumps({"dl": here + "/dl/{crate}/{crate}-{version}.crate", "api": here}).encode())
        elif (folder / what / place).is_file():
            self.answer((folder / what / place).read_bytes())
        elif what == "dl":
            self.answer(b"", 302, Location=f"{CRATES}/{place}")
        elif (lines := of_others(place)) is not None:
            self.answer(lines)
        else:
            self.answer(b"", 404)

    def do_PUT(self):
        global uploads
        body = self.rfile.read(int(self.headers["Content-Length"]))
        (length,) = struct.unpack_from("<I", body)
        metadata, crate = json.loads(body[4 : 4 + length]), body[8 + length :]
        name, version = metadata["name"], metadata["vers"]
        uploads += 1
        status = refused.pop(uploads, None)
        kept = folder / "dl" / name / f"{name}-{version}.crate"
        if status == 429:
            until = email.utils.formatdate(time.time() + 2, usegmt=True)
            self.refuse(429, f"You have published too many new crates in a short period of time. Please try again after {until}.")
        elif status:
            self.refuse(status, "this upload fails, as was asked for")
        elif kept.exists():
            self.refuse(400, f"crate version `{version}` is already uploaded")
        else:
            kept.parent.mkdir(parents=True, exist_ok=True)
            kept.write_bytes(crate)
            line = folder / "index" / name[:2] / name[2:4] / name
            line.parent.mkdir(parents=True, exist_ok=True)
            with line.open("a", encoding="utf-8") as index:
                index.write(json.dumps(line_of(metadata, crate)) + "\n")
            self.answer(b'{"warnings": {"invalid_categories": [], "invalid_badges": [], "other": []}}')


server = ThreadingHTTPServer(("127.0.0.1", 0), Registry)
print(server.server_port, flush=True)
server.serve_forever()
