"""What packages/rehearse has for Open VSX, and for GitHub where a workflow asks it who it is: the requests of `ovsx` that publish, and no more.

python3 packages/registries/open_vsx.py

It prints the port that it serves at.
"""

import io
import json
import zipfile
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from urllib.parse import parse_qs, urlsplit

IDENTITY = "who the workflow is"
TOKEN = "what it may publish with"
published = set()


class Registry(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"

    def log_message(self, *_):
        pass

    def answer(self, status=200, **content):
        body = json.dumps(content).encode()
        self.send_response(status)
        self.send_header("Content-Type", "application/json")
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    def body(self):
        """What was sent, at once or in chunks."""
        if "Content-Length" in self.headers:
            return self.rfile.read(int(self.headers["Content-Length"]))
        chunks = []
        while size := int(self.rfile.readline(), 16):
            chunks.append(self.rfile.read(size))
            self.rfile.readline()
        self.rfile.readline()
        return b"".join(chunks)

    def do_GET(self):
        if self.path.startswith("/identity"):
            self.answer(value=IDENTITY)
        elif self.path == "/api/version":
            self.answer(version="1.4.0")
        else:
            self.answer(404)

    def do_POST(self):
        body = self.body()
        place = urlsplit(self.path)
        if place.path == "/api/-/trusted-publishing/token":
            known = json.loads(body)["token"] == IDENTITY
            self.answer(**({"value": TOKEN} if known else {"error": "this is not a trusted publisher"}))
        elif place.path == "/api/-/publish":
            self.publish(body, parse_qs(place.query).get("token", [self.headers.get("Authorization", "")])[0])
        else:
            self.answer(404)

    def publish(self, package, token):
        if not token.endswith(TOKEN):
            self.answer(401, error="Invalid access token.")
            return
        with zipfile.ZipFile(io.BytesIO(package)) as files:
            manifest = json.loads(files.read("extension/package.json"))
        version = f"{manifest['publisher']}.{manifest['name']} {manifest['version']}"
        if version in published:
            self.answer(400, error=f"Extension {version} is already published.")
            return
        published.add(version)
        self.answer(201, namespace=manifest["publisher"], name=manifest["name"], version=manifest["version"], targetPlatform="universal")


server = ThreadingHTTPServer(("127.0.0.1", 0), Registry)
print(server.server_port, flush=True)
server.serve_forever()
