// The language server in WebAssembly: it answers as the native one does, and keeps what the playground promises of size and time.
//
// `LADDER_WASM` is the folder of the small server and of the complete one, `LADDER_BIN` the native one.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { test } from "node:test";
import { brotliCompressSync } from "node:zlib";
import { FOLDER, Session, files, messagesOf, moved, recordingOf, root } from "./session.mjs";

const bytesOf = (name) => readFileSync(path.join(process.env.LADDER_WASM, name));
const small = bytesOf("ladder.wasm");
const complete = bytesOf("ladder-complete.wasm");
const module = await WebAssembly.compile(complete);

/** What a page is built without. */
const NOT_IN_A_PAGE = ["ladder.compare"];

/** What a server offers, without what a page is built without. */
function offered(message) {
    const provider = message.result?.capabilities?.executeCommandProvider;
    if (provider) {
        provider.commands = provider.commands.filter((command) => !NOT_IN_A_PAGE.includes(command));
    }
    return message;
}

/** What a message is in the comparison: states of a simulation come by the clock, how many is a matter of chance. */
const isCompared = (message) => message.method !== "ladder/simulationState";

/** Answers by their numbers, and the rest by what it is about, each in its order. */
function sorted(said) {
    const groups = {};
    for (const message of said.filter(isCompared)) {
        const about = message.method ? `${message.method} ${message.params?.uri ?? ""}` : `answer ${JSON.stringify(message.id)}`;
        (groups[about] ??= []).push(message);
    }
    return groups;
}

/** What a client gets to know in the end does not depend on how many texts were checked on the way. */
function newest(groups) {
    for (const [about, messages] of Object.entries(groups)) {
        if (about.startsWith("textDocument/publishDiagnostics")) {
            groups[about] = messages.slice(-1);
        }
    }
    return groups;
}

test("a recorded session is answered as by the native server", async () => {
    const messages = messagesOf(readFileSync(new URL("recording", import.meta.url)));
    const session = await Session.start(module, files());
    for (const message of messages) {
        await session.send(message);
    }

    const folder = mkdtempSync(path.join(tmpdir(), "ladder-replay-"));
    for (const [name, content] of files()) {
        writeFileSync(path.join(folder, name), content);
    }
    const recording = path.join(folder, "recording");
    writeFileSync(recording, recordingOf(moved(messages, FOLDER, folder)));
    const played = spawnSync(process.env.LADDER_BIN, ["lsp", "--replay", recording], { encoding: "utf8", maxBuffer: 1 << 28 });
    rmSync(folder, { recursive: true });
    assert.equal(played.status, 0, played.stderr);
    const native = moved(played.stdout.trim().split("\n").map((line) => offered(JSON.parse(line))), folder, FOLDER);

    const [expected, found] = [newest(sorted(native)), newest(sorted(session.said))];
    const requests = messages.filter((message) => message.method && message.id !== undefined);
    assert.ok(requests.length > 150);
    for (const { id } of requests) {
        assert.ok(found[`answer ${id}`], `request ${id} has no answer`);
    }
    for (const about of new Set([...Object.keys(expected), ...Object.keys(found)])) {
        assert.deepEqual(found[about], expected[about], about);
    }
});

test("the session of the page about the protocol is answered as it is printed there", async () => {
    const page = readFileSync(path.join(root, "docs/protocol.md"), "utf8");
    const shown = [...page.matchAll(/```json\n(.*?)```/gs)].map(([, json]) => offered(JSON.parse(json)));
    const left = shown.filter((message) => NOT_IN_A_PAGE.includes(message.params?.command)).map(({ id }) => id);
    const ofClient = ["ladder/toDebugger", "ladder/simulationShown", "initialized", "textDocument/didOpen", "textDocument/didChange", "exit"];
    const session = await Session.start(module);
    let compared = 0;
    for (const message of shown.filter(({ id }) => id === undefined || !left.includes(id))) {
        if (message.method && (message.id !== undefined || ofClient.includes(message.method))) {
            await session.send(message);
        } else if (message.id !== undefined) {
            assert.deepEqual(session.said.find((it) => it.id === message.id && !it.method), message);
            compared += 1;
        } else if (message.method !== "ladder/simulationState") {
            assert.ok(session.said.some((it) => JSON.stringify(sortedKeys(it)) === JSON.stringify(sortedKeys(message))), message.method);
        }
    }
    assert.ok(compared > 40);
});

function sortedKeys(value) {
    if (Array.isArray(value)) {
        return value.map(sortedKeys);
    }
    if (value && typeof value === "object") {
        return Object.fromEntries(Object.keys(value).sort().map((key) => [key, sortedKeys(value[key])]));
    }
    return value;
}

test("what is wrong with a message does not end the server", async () => {
    const session = await Session.start(module);
    for (const message of ["{", "[]", '{"jsonrpc":"2.0","id":5}', "\ud800"]) {
        session.server.receive(message);
    }
    await session.send({ jsonrpc: "2.0", id: 6, method: "initialize", params: { capabilities: {} } });
    const answered = session.said.map((message) => [message.id, message.error?.code]);
    assert.deepEqual(answered.sort(), [[5, -32600], [6, undefined], [null, -32600], [null, -32700], [null, -32700]].sort());
});

test("a file that is written later is read when the client says so", async () => {
    const session = await Session.start(module, new Map([["ladder.toml", ""]]));
    const uri = `file://${FOLDER}/caller.clad`;
    const findings = () => session.said.filter((it) => it.params?.uri === uri).at(-1).params.diagnostics.map((it) => it.code);
    const capabilities = { workspace: { didChangeWatchedFiles: { dynamicRegistration: true } } };
    await session.send({ jsonrpc: "2.0", id: 1, method: "initialize", params: { rootUri: `file://${FOLDER}`, capabilities } });
    await session.send({ jsonrpc: "2.0", method: "initialized", params: {} });
    const text = "+--( )( z )--<CALL>( count )--+\n";
    await session.send({
        jsonrpc: "2.0", method: "textDocument/didOpen",
        params: { textDocument: { uri, languageId: "clad", version: 1, text } },
    });
    assert.deepEqual(findings(), ["unknown-function"]);
    session.server.write("called.clad", "+--( )( y )--+\n+--<FUN>( count )--( )( y )--+\n");
    const changed = { jsonrpc: "2.0", method: "workspace/didChangeWatchedFiles", params: { changes: [{ uri: `file://${FOLDER}/called.clad`, type: 1 }] } };
    await session.send(changed);
    assert.deepEqual(findings(), []);
    session.server.write("called.clad", null);
    await session.send(changed);
    assert.deepEqual(findings(), ["unknown-function"]);
});

test("a run keeps to its clock, and hears what is said meanwhile", async () => {
    const session = await Session.start(module);
    const uri = `file://${FOLDER}/run.clad`;
    await session.send({ jsonrpc: "2.0", id: 1, method: "initialize", params: { capabilities: {} } });
    await session.send({
        jsonrpc: "2.0", method: "textDocument/didOpen",
        params: { textDocument: { uri, languageId: "clad", version: 1, text: "+--[ ]( a )--( )( y )--+\n" } },
    });
    const command = (id, name, given) => session.ask(id, "workspace/executeCommand", { command: `ladder.simulate.${name}`, arguments: [given] });
    command(2, "start", { uri, options: { intervalMs: 10 } });
    command(3, "run", { session: "s1" });
    const begun = performance.now();
    while (performance.now() - begun < 500) {
        await new Promise((resolve) => setTimeout(resolve, Math.max(0, session.server.turn())));
    }
    command(4, "set", { session: "s1", tag: "a", value: true });
    const paused = command(5, "pause", { session: "s1" }).result;
    const due = (performance.now() - begun) / 10;
    assert.equal(paused.status, "paused");
    assert.ok(paused.scan > due / 2 && paused.scan <= due + 2, `${paused.scan} scans, ${due} were due`);
    // As fast as it goes.
    command(6, "run", { session: "s1", realTime: false });
    for (let turns = 0; turns < 20; turns += 1) {
        session.server.turn();
    }
    const fast = command(7, "pause", { session: "s1" }).result;
    assert.ok(fast.scan > paused.scan + 1000, `${fast.scan - paused.scan} scans`);
});

test("it is small enough to be loaded", () => {
    for (const [name, bytes] of [["ladder.wasm", small], ["ladder-complete.wasm", complete]]) {
        const size = brotliCompressSync(bytes).length;
        console.log(`${name}: ${bytes.length} bytes, ${size} after compression`);
        assert.ok(size < MOST_BYTES[name], `${name}: ${size} bytes after compression`);
    }
});

/** What a page loads does not grow unseen. */
const MOST_BYTES = { "ladder.wasm": 1_540_000, "ladder-complete.wasm": 2_450_000 };

test("first diagnostics come soon, and a scan of 1,000 rungs is short", async () => {
    const begun = performance.now();
    const session = await Session.start(await WebAssembly.compile(small));
    session.ask(1, "initialize", { capabilities: {} });
    let text = "";
    for (let rung = 0; rung < 1000; rung += 1) {
        text += `+--[ ]( x${rung} )--[/]( y${rung} )--( )( z${rung} )--+\n`;
    }
    const uri = `file://${FOLDER}/large.clad`;
    const open = { textDocument: { uri, languageId: "clad", version: 1, text } };
    session.server.receive(JSON.stringify({ jsonrpc: "2.0", method: "textDocument/didOpen", params: open }));
    session.until((message) => message.method === "textDocument/publishDiagnostics");
    const diagnostics = performance.now() - begun;

    const options = { show: { lines: [{ first: 0, last: 40 }], tags: [] } };
    session.ask(2, "workspace/executeCommand", { command: "ladder.simulate.start", arguments: [{ uri, options }] });
    const scans = 5000;
    const times = [3, 4, 5, 6, 7].map((id) => {
        const begun = performance.now();
        session.ask(id, "workspace/executeCommand", { command: "ladder.simulate.step", arguments: [{ session: "s1", scans }] });
        return ((performance.now() - begun) * 1000) / scans;
    });
    const scan = Math.min(...times);
    console.log(`diagnostics after ${diagnostics.toFixed(0)} ms, a scan takes ${scan.toFixed(1)} us`);
    assert.ok(diagnostics < 1000, `${diagnostics} ms`);
    assert.ok(scan < 20, `${scan} us`);
});
