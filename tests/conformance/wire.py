"""A client on the bare wire, for what no well-behaved client does: it reads late, never answers, cancels at once."""

import json
import os
import queue
import subprocess
import threading

LADDER = os.environ["LADDER_BIN"]

# Far longer than anything takes, on a machine that is busy.
PATIENCE = 30


class Wire:
    """One server, and what it said. Requests of the server are kept in `asked` and never answered."""

    def __init__(self, capabilities: dict, *, root: str | None = None, options: list[str] | None = None):
        self.server = subprocess.Popen(
            [LADDER, "lsp", *(options or [])], stdin=subprocess.PIPE, stdout=subprocess.PIPE
        )
        self.reading = threading.Event()
        self.reading.set()
        self.said: queue.Queue = queue.Queue()
        self.answers: dict[int, dict] = {}
        self.notifications: list[dict] = []
        self.asked: list[dict] = []
        self.number = 0
        threading.Thread(target=self._read, daemon=True).start()
        result = self.request(
            "initialize", {"processId": None, "rootUri": root, "capabilities": capabilities}
        )
        self.offered = result["result"]["capabilities"]
        self.notify("initialized", {})

    def __enter__(self):
        return self

    def __exit__(self, kind, *_):
        if kind is not None:
            self.server.kill()
        self.server.stdin.close()
        self.server.wait(PATIENCE)

    def _read(self):
        out = self.server.stdout
        while True:
            self.reading.wait()
            length = 0
            while line := out.readline().strip():
                if line.lower().startswith(b"content-length:"):
                    length = int(line.split(b":")[1])
            if not length:
                self.said.put(None)
                return
            self.said.put(json.loads(out.read(length)))

    def send(self, message: dict):
        body = json.dumps({"jsonrpc": "2.0", **message}).encode()
        self.server.stdin.write(b"Content-Length: %d\r\n\r\n%s" % (len(body), body))
        self.server.stdin.flush()

    def notify(self, method: str, params):
        self.send({"method": method, "params": params})

    def ask(self, method: str, params) -> int:
        self.number += 1
        self.send({"id": self.number, "method": method, "params": params})
        return self.number

    def take(self):
        """Takes in one message, and says that nothing is answered that was not asked, and nothing twice."""
        message = self.said.get(timeout=PATIENCE)
        assert message is not None, "the server has gone"
        if "method" in message:
            (self.asked if "id" in message else self.notifications).append(message)
            return
        number = message["id"]
        assert isinstance(number, int) and 0 < number <= self.number, f"answer to nothing: {message}"
        assert number not in self.answers, f"answered twice: {message}"
        assert ("result" in message) != ("error" in message), message
        self.answers[number] = message

    def answer(self, number: int) -> dict:
        while number not in self.answers:
            self.take()
        return self.answers[number]

    def request(self, method: str, params) -> dict:
        return self.answer(self.ask(method, params))

    def open(self, uri: str, text: str, version: int = 1):
        item = {"uri": uri, "languageId": "clad", "version": version, "text": text}
        self.notify("textDocument/didOpen", {"textDocument": item})

    def change(self, uri: str, version: int, changes: list[dict]):
        params = {"textDocument": {"uri": uri, "version": version}, "contentChanges": changes}
        self.notify("textDocument/didChange", params)

    def end(self):
        """Ends the session as the protocol asks: every request has exactly one answer."""
        for number in range(1, self.number + 1):
            self.answer(number)
        self.request("shutdown", None)
        self.notify("exit", None)
        assert self.server.wait(PATIENCE) == 0
        while (message := self.said.get(timeout=PATIENCE)) is not None:
            assert "method" in message, f"answered twice, or never asked: {message}"
