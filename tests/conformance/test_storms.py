"""Sessions that no editor means to have: bursts, cancel storms, a client that reads late or never answers."""

import random
import time

import pytest

from wire import Wire

URI = "file:///storm/motor.clad"
ASKING = {"textDocument": {"diagnostic": {}}}
RUNGS = "+--[ ]( a )--[TON]( t, T#5s )--( )( y )--+\n" * 40


def capabilities(encoding: str = "utf-8", **more) -> dict:
    return {"general": {"positionEncodings": [encoding]}, **more}


def front(text: str) -> dict:
    return {"range": {"start": {"line": 0, "character": 8}, "end": {"line": 0, "character": 8}}, "text": text}


def place(line: int = 0, character: int = 8) -> dict:
    return {"textDocument": {"uri": URI}, "position": {"line": line, "character": character}}


OPTIONS = {"tabSize": 4, "insertSpaces": True}
WHOLE = {"start": {"line": 0, "character": 0}, "end": {"line": 90, "character": 0}}


def everything(uri: str, line: int, character: int) -> list[tuple[str, dict]]:
    """Requests about a document and a place in it."""
    document = {"textDocument": {"uri": uri}}
    here = {**document, "position": {"line": line, "character": character}}
    return [
        ("textDocument/hover", here),
        ("textDocument/completion", here),
        ("textDocument/signatureHelp", here),
        ("textDocument/definition", here),
        ("textDocument/references", {**here, "context": {"includeDeclaration": True}}),
        ("textDocument/documentHighlight", here),
        ("textDocument/documentSymbol", document),
        ("textDocument/foldingRange", document),
        ("textDocument/selectionRange", {**document, "positions": [here["position"]]}),
        ("textDocument/semanticTokens/full", document),
        ("textDocument/inlayHint", {**document, "range": WHOLE}),
        ("textDocument/codeAction", {**document, "range": WHOLE, "context": {"diagnostics": []}}),
        ("textDocument/codeLens", document),
        ("textDocument/formatting", {**document, "options": OPTIONS}),
        ("textDocument/diagnostic", document),
        ("workspace/symbol", {"query": "a"}),
    ]


# A plain string, changed by counting units of the encoding along a line.

UNITS = {
    "utf-8": lambda character: len(character.encode()),
    "utf-16": lambda character: len(character.encode("utf-16-le")) // 2,
    "utf-32": lambda character: 1,
}


def lines_of(text: str) -> list[str]:
    """The lines with their ends: LF, CRLF and a lone CR end one, nothing else does."""
    lines, start, at = [], 0, 0
    while at < len(text):
        if text[at] in "\r\n":
            at += 2 if text[at : at + 2] == "\r\n" else 1
            lines.append(text[start:at])
            start = at
        else:
            at += 1
    return [*lines, text[start:]]


def offset(text: str, encoding: str, line: int, character: int) -> int:
    lines = lines_of(text)
    if line >= len(lines):
        return len(text)
    at = sum(len(it) for it in lines[:line])
    units = 0
    for found in lines[line].rstrip("\r\n"):
        units += UNITS[encoding](found)
        if units > character:
            break
        at += 1
    return at


PIECES = ["[ ]( a )", "( )( y )", "--", "\\", "/", "+", "|", "\n", "\r\n", "\r", "# ä😀 #", "#", "[TON]( t, ", " ", "é", "\u2028", "x"]


@pytest.mark.parametrize("encoding", UNITS)
def test_random_edits_next_to_a_plain_string(encoding: str):
    """After some hundred edits everything is answered as for a text that was opened as the model has it."""
    dice = random.Random(encoding)
    model = "".join(dice.choice(PIECES) for _ in range(80)) + "\n" + RUNGS[:300]
    with Wire(capabilities(encoding, **ASKING)) as client:
        assert client.offered["positionEncoding"] == encoding
        client.open(URI, model)
        version = 1
        for nth in range(8):
            for _ in range(40):
                changes = []
                for _ in range(dice.randint(1, 3)):
                    line, character = dice.randint(0, 14), dice.choice([dice.randint(0, 40), 4_000_000_000])
                    to_line, to_character = line + dice.choice([0, 0, 0, 1]), character + dice.randint(0, 6)
                    new = "".join(dice.choice(PIECES) for _ in range(dice.randint(0, 3)))
                    start, end = offset(model, encoding, line, character), offset(model, encoding, to_line, to_character)
                    start, end = min(start, end), max(start, end)
                    model = model[:start] + new + model[end:]
                    changes.append({
                        "range": {
                            "start": {"line": line, "character": character},
                            "end": {"line": to_line, "character": min(to_character, 4_294_967_295)},
                        },
                        "text": new,
                    })
                version += 1
                client.change(URI, version, changes)
            # In a folder of its own, so that neither sees the other.
            fresh = f"file:///fresh{nth}/motor.clad"
            client.open(fresh, model)
            line, character = dice.randint(0, 14), dice.randint(0, 40)
            for (method, edited), (_, opened) in zip(
                everything(URI, line, character), everything(fresh, line, character), strict=True
            ):
                if method == "workspace/symbol":
                    continue
                found, wanted = client.request(method, edited), client.request(method, opened)
                alike = [repr(it.get("result", it.get("error"))) for it in (found, wanted)]
                alike = [it.replace(fresh, URI).replace(f"fresh{nth}", "storm") for it in alike]
                # Their identities are the server's own.
                if method != "textDocument/semanticTokens/full":
                    assert alike[0] == alike[1], f"{method} at {line}:{character} of\n{model}"
                else:
                    assert found["result"]["data"] == wanted["result"]["data"], method
            client.notify("textDocument/didClose", {"textDocument": {"uri": fresh}})
        client.end()


def test_a_burst_of_1000_edits_with_requests_between():
    with Wire(capabilities()) as client:
        client.open(URI, RUNGS)
        asked = []
        for version in range(2, 1002):
            client.change(URI, version, [front("x")])
            if version % 10 == 0:
                asked.append((version, client.ask("textDocument/hover", place())))
            if version % 50 == 0:
                for method, params in everything(URI, 3, 20):
                    if method != "textDocument/diagnostic":
                        client.ask(method, params)
        for version, number in asked:
            hover = client.answer(number)["result"]
            width = hover["range"]["end"]["character"] - hover["range"]["start"]["character"]
            assert width == version, "each hover sees the text that was sent before it"
        while not any(it["params"].get("version") == 1001 for it in client.notifications):
            client.take()
        versions = [
            it["params"]["version"]
            for it in client.notifications
            if it["method"] == "textDocument/publishDiagnostics"
        ]
        assert versions == sorted(versions), "no diagnostics of an older text after those of a newer"
        client.end()


def test_requests_about_a_text_that_is_no_more():
    """Every request has an answer, whether the text has moved on, lies elsewhere or is closed."""
    with Wire(capabilities(**ASKING)) as client:
        for round in range(20):
            client.open(URI, RUNGS)
            numbers = [client.ask(method, params) for method, params in everything(URI, 39, 30)]
            client.change(URI, 2, [{"text": "" if round % 2 else "+--[ ]( b )--( )( z )--+\n"}])
            numbers += [client.ask(method, params) for method, params in everything(URI, 39, 30)]
            # Older than what is there: refused, and said.
            client.change(URI, 1, [front("x")])
            client.notify("textDocument/didClose", {"textDocument": {"uri": URI}})
            numbers += [client.ask(method, params) for method, params in everything(URI, 39, 30)]
            for number in numbers:
                error = client.answer(number).get("error")
                assert error is None or error["code"] in (-32801, -32800, -32803), error
        client.end()


def test_cancel_storms():
    with Wire(capabilities(**ASKING)) as client:
        client.open(URI, RUNGS * 8)
        dice = random.Random(7)
        for version in range(2, 30):
            client.change(URI, version, [front("x")])
            numbers = [client.ask(method, params) for method, params in everything(URI, 3, 20)]
            dice.shuffle(numbers)
            for number in numbers:
                client.notify("$/cancelRequest", {"id": number})
            # Those that were answered long ago, and those that never were, are nothing.
            client.notify("$/cancelRequest", {"id": dice.choice([1, 999_999])})
        hover = client.request("textDocument/hover", place())["result"]
        assert hover["range"]["end"]["character"] - hover["range"]["start"]["character"] == 29
        for number in range(1, client.number + 1):
            error = client.answer(number).get("error")
            assert error is None or error["code"] in (-32800, -32801), error
        client.end()


def test_a_client_that_reads_late():
    with Wire(capabilities()) as client:
        client.open(URI, RUNGS * 5)
        client.request("textDocument/hover", place())
        client.reading.clear()
        asked = []
        # As much as goes into the pipes; a client that waits for more to be taken must read.
        for version in range(2, 202):
            client.change(URI, version, [front("x")])
            if version % 4 == 0:
                asked.append(client.ask("textDocument/documentSymbol", {"textDocument": {"uri": URI}}))
        time.sleep(1)
        client.reading.set()
        for number in asked:
            assert client.answer(number)["result"]
        client.end()


def test_a_client_that_never_answers(tmp_path):
    """The server asks for settings, registrations, progress and refreshes; nothing waits for the answers."""
    (tmp_path / "ladder.toml").write_text("")
    yes = {"dynamicRegistration": True}
    refreshes = {"refreshSupport": True}
    workspace = {
        "configuration": True,
        "didChangeConfiguration": yes,
        "didChangeWatchedFiles": yes,
        "diagnostics": refreshes,
        "inlayHint": refreshes,
        "codeLens": refreshes,
        "semanticTokens": refreshes,
    }
    more = {"workspace": workspace, "window": {"workDoneProgress": True}, **ASKING}
    with Wire(capabilities(**more), root=tmp_path.as_uri()) as client:
        uri = (tmp_path / "motor.clad").as_uri()
        client.open(uri, RUNGS)
        for version in range(2, 200):
            client.notify("workspace/didChangeConfiguration", {"settings": None})
            # Each time the other files see something else.
            text = f"+--<FUN>( f{version} )--[ ]( a )--( )( y )--+\n"
            client.change(uri, version, [{"text": text}])
            settings = {"changes": [{"uri": (tmp_path / "ladder.toml").as_uri(), "type": 2}]}
            client.notify("workspace/didChangeWatchedFiles", settings)
        begun = time.monotonic()
        for method, params in everything(uri, 0, 9):
            assert "result" in client.request(method, params), method
        assert time.monotonic() - begun < 10
        assert len(client.asked) > 50, "it has asked, and nobody answered"
        client.end()


def test_the_server_ends_with_its_parent(tmp_path):
    """An editor that is killed leaves nobody after, even while something else holds the pipe open."""
    import os
    import signal
    import subprocess
    import sys

    from wire import LADDER

    script = (
        "import json, os, subprocess, sys, time\n"
        f"server = subprocess.Popen([{LADDER!r}, 'lsp'], stdin=subprocess.PIPE, stdout=subprocess.DEVNULL)\n"
        "message = json.dumps({'jsonrpc': '2.0', 'id': 1, 'method': 'initialize',\n"
        "    'params': {'processId': os.getpid(), 'capabilities': {}}}).encode()\n"
        "server.stdin.write(b'Content-Length: %d\\r\\n\\r\\n%s' % (len(message), message))\n"
        "server.stdin.flush()\n"
        # A grandchild inherits the pipe, and keeps it open.
        "subprocess.Popen(['sleep', '30'], pass_fds=[server.stdin.fileno()], stdout=subprocess.DEVNULL)\n"
        "print(server.pid, flush=True)\n"
        "time.sleep(60)\n"
    )
    editor = subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True)
    server = int(editor.stdout.readline())
    time.sleep(0.5)
    editor.send_signal(signal.SIGKILL)
    editor.wait()
    begun = time.monotonic()
    while time.monotonic() - begun < 15:
        try:
            # Nobody waits for an orphan here but the system, so a zombie has ended, too.
            with open(f"/proc/{server}/stat") as stat:
                if stat.read().rsplit(")", 1)[1].split()[0] == "Z":
                    return
            os.kill(server, 0)
        except (ProcessLookupError, FileNotFoundError):
            return
        time.sleep(0.1)
    os.kill(server, signal.SIGKILL)
    raise AssertionError("the server outlives its editor")
