// Records a session that asks a server all that an editor may ask: node record.mjs LADDER. The recording is made by
// `ladder lsp --mirror`; only the folder in it is another one afterwards.

import { spawn } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { FOLDER, files, framed, messagesOf, moved, recordingOf } from "./session.mjs";

const folder = mkdtempSync(path.join(tmpdir(), "ladder-record-"));
const all = files();
for (const [name, content] of all) {
    writeFileSync(path.join(folder, name), content);
}
const mirror = path.join(folder, "recording");
const server = spawn(process.argv[2], ["lsp", "--mirror", mirror], { stdio: ["pipe", "pipe", "inherit"] });

const answers = new Map();
const heard = new Map();
let bytes = Buffer.alloc(0);
server.stdout.on("data", (data) => {
    bytes = Buffer.concat([bytes, data]);
    for (;;) {
        const body = bytes.indexOf("\r\n\r\n") + 4;
        const length = Number(/Content-Length: (\d+)/.exec(bytes.subarray(0, body).toString())?.[1]);
        if (body < 4 || bytes.length < body + length) {
            return;
        }
        hear(JSON.parse(bytes.subarray(body, body + length).toString()));
        bytes = bytes.subarray(body + length);
    }
});

function hear(message) {
    if (message.method && message.id !== undefined) {
        const result = message.method === "workspace/configuration" ? [null] : null;
        send({ jsonrpc: "2.0", id: message.id, result });
    } else if (message.method) {
        heard.get(message.method)?.(message.params);
    } else {
        answers.get(message.id)?.(message);
    }
}

const send = (message) => server.stdin.write(framed(message));
const notify = (method, params) => send({ jsonrpc: "2.0", method, params });
let asked = 0;
function ask(method, params) {
    const id = ++asked;
    send({ jsonrpc: "2.0", id, method, params });
    return new Promise((resolve) => answers.set(id, ({ result, error }) => {
        if (error) {
            console.log(`${method} ${params.command ?? ""}: ${error.message}`);
        }
        resolve(result);
    }));
}
const command = (name, ...given) => ask("workspace/executeCommand", { command: name, arguments: given });
const hearing = (method) => new Promise((resolve) => heard.set(method, resolve));

const uri = (name) => `file://${folder}/${name}`;
const textDocument = { uri: uri("motor.clad") };
const at = (line, character) => ({ textDocument, position: { line, character } });
const whole = { start: { line: 0, character: 0 }, end: { line: 1000, character: 0 } };

await ask("initialize", {
    processId: process.pid,
    rootUri: `file://${folder}`,
    workspaceFolders: [{ uri: `file://${folder}`, name: "examples" }],
    capabilities: {
        general: { positionEncodings: ["utf-16"] },
        workspace: {
            configuration: true,
            didChangeConfiguration: { dynamicRegistration: true },
            didChangeWatchedFiles: { dynamicRegistration: true },
            workspaceEdit: { documentChanges: true },
            symbol: {},
        },
        textDocument: {
            publishDiagnostics: { relatedInformation: true, dataSupport: true, versionSupport: true },
            hover: { contentFormat: ["markdown"] },
            completion: { completionItem: { snippetSupport: true, documentationFormat: ["markdown"] } },
            codeAction: { codeActionLiteralSupport: { codeActionKind: { valueSet: [] } } },
            semanticTokens: { requests: { full: { delta: true }, range: true }, tokenTypes: [], tokenModifiers: [], formats: [] },
        },
    },
});
notify("initialized", {});
const diagnostics = hearing("textDocument/publishDiagnostics");
const text = all.get("motor.clad").toString();
notify("textDocument/didOpen", { textDocument: { ...textDocument, languageId: "clad", version: 1, text } });
await diagnostics;
const rung = text.split("\n").findIndex((line) => line.includes("( )("));
const column = text.split("\n")[rung].indexOf("( ") + 2;
for (const [line, character] of [[rung, 4], [rung, column], [rung, text.split("\n")[rung].lastIndexOf(")") - 2], [0, 0]]) {
    for (const method of ["hover", "definition", "declaration", "typeDefinition", "documentHighlight", "signatureHelp", "prepareRename"]) {
        await ask(`textDocument/${method}`, at(line, character));
    }
    await ask("textDocument/completion", at(line, character));
    await ask("textDocument/references", { ...at(line, character), context: { includeDeclaration: true } });
    await ask("textDocument/rename", { ...at(line, character), newName: "renamed" });
    await ask("textDocument/selectionRange", { textDocument, positions: [{ line, character }] });
}
for (const method of ["documentSymbol", "foldingRange", "codeLens", "documentLink", "semanticTokens/full"]) {
    await ask(`textDocument/${method}`, { textDocument });
}
await ask("textDocument/inlayHint", { textDocument, range: whole });
await ask("textDocument/codeAction", { textDocument, range: whole, context: { diagnostics: [] } });
await ask("workspace/symbol", { query: "run" });
await ask("workspace/symbol", { query: "" });

// What a person types: a rung, letter by letter, with an error in it for a while.
let version = 1;
const typed = "+--[ ]( start )--[/]( halt )--( )( lamp )--+\n";
for (let length = 0; length < typed.length; length += 3) {
    const place = { line: rung, character: length };
    notify("textDocument/didChange", {
        textDocument: { ...textDocument, version: ++version },
        contentChanges: [{ range: { start: place, end: place }, text: typed.slice(length, length + 3) }],
    });
    if (length % 12 === 0) {
        await ask("textDocument/completion", at(rung, length + 3));
    }
}
await ask("textDocument/formatting", { textDocument, options: { tabSize: 4, insertSpaces: true } });
await ask("textDocument/codeAction", { textDocument, range: whole, context: { diagnostics: [] } });
await ask("textDocument/semanticTokens/full", { textDocument });

const lines = { first: 0, last: 1000 };
await command("ladder.diagram", { uri: textDocument.uri, lines });
await command("ladder.diagramText", { uri: textDocument.uri, lines });
await command("ladder.crossReference", { uri: textDocument.uri });
await command("ladder.rulePage", { rule: "never-written" });
await command("ladder.fence", { text: "+--[ ]( a )--( )( b )--+\n" });
const notations = await command("ladder.notations", {});
for (const { name } of notations?.notations ?? notations ?? []) {
    await command("ladder.convert", { uri: textDocument.uri, to: name });
}

// All other programs run, in steps, and as their scenarios say.
for (const name of [...all.keys()].filter((name) => name.endsWith(".clad"))) {
    const document = { uri: uri(name) };
    if (name !== "motor.clad") {
        const text = all.get(name).toString();
        notify("textDocument/didOpen", { textDocument: { ...document, languageId: "clad", version: 1, text } });
    }
    const started = await command("ladder.simulate.start", { uri: document.uri });
    const session = started?.session;
    await command("ladder.simulate.step", { session, scans: 200 });
    const tags = (await command("ladder.simulate.tags", { session, containing: "" }))?.tags ?? [];
    const tag = tags.find((tag) => tag.type === "BOOL")?.name;
    if (tag) {
        await command("ladder.simulate.force", { session, tag, value: true });
        await command("ladder.simulate.step", { session, scans: 300 });
        await command("ladder.simulate.why", { session, tag });
        await command("ladder.simulate.history", { session, tags: [tag], scans: 10 });
        await command("ladder.simulate.unforce", { session });
    }
    await command("ladder.simulate.back", { session, scans: 7 });
    await command("ladder.simulate.stepBlock", { session });
    await command("ladder.simulate.stepRung", { session });
    await command("ladder.simulate.record", { session });
    await command("ladder.simulate.state", { session });
    await command("ladder.simulate.stop", { session });
}
const scenarios = { uri: uri("motor.ladder-test") };
notify("textDocument/didOpen", {
    textDocument: { ...scenarios, languageId: "ladder-test", version: 1, text: all.get("motor.ladder-test").toString() },
});
await ask("textDocument/hover", { textDocument: scenarios, position: { line: 0, character: 10 } });
await ask("textDocument/completion", { textDocument: scenarios, position: { line: 1, character: 0 } });
await ask("workspace/willRenameFiles", { files: [{ oldUri: uri("motor.clad"), newUri: uri("engine.clad") }] });
notify("textDocument/didOpen", {
    textDocument: { uri: uri("ladder.toml"), languageId: "toml", version: 1, text: "[simulate]\ninterval = 3\nodd = 1\n" },
});
await ask("textDocument/hover", { textDocument: { uri: uri("not%20there.clad") }, position: { line: 0, character: 0 } });
notify("textDocument/didClose", { textDocument: scenarios });
await ask("shutdown");
notify("exit");
await new Promise((resolve) => server.on("close", resolve));

const recorded = moved(messagesOf(readFileSync(mirror)), folder, FOLDER);
writeFileSync(new URL("recording", import.meta.url), recordingOf(recorded));
rmSync(folder, { recursive: true });
console.log(`${recorded.length} messages`);
