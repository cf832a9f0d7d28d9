// Recorded sessions, and the server in WebAssembly as their other side.

import { readFileSync, readdirSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { Server } from "../../src/server.js";

export const root = fileURLToPath(new URL("../../..", import.meta.url));

/** The folder of the page's files, in addresses and paths. */
export const FOLDER = "/work";

const HEADER = "ladder lsp recording 1\n";

/** The client's messages in what `ladder lsp --mirror` has written. */
export function messagesOf(recording) {
    if (!recording.subarray(0, HEADER.length).equals(Buffer.from(HEADER))) {
        throw new Error("this is not a recording");
    }
    const pieces = [];
    for (let at = HEADER.length; at < recording.length; ) {
        const end = recording.indexOf("\n", at);
        const length = Number(recording.subarray(at, end).toString().split(" ")[1]);
        pieces.push(recording.subarray(end + 1, end + 1 + length));
        at = end + 1 + length + 1;
    }
    const bytes = Buffer.concat(pieces);
    const messages = [];
    for (let at = 0; at < bytes.length; ) {
        const body = bytes.indexOf("\r\n\r\n", at) + 4;
        const length = Number(/Content-Length: (\d+)/.exec(bytes.subarray(at, body).toString())[1]);
        messages.push(JSON.parse(bytes.subarray(body, body + length).toString()));
        at = body + length;
    }
    return messages;
}

/** The same the other way round, a message a piece, a millisecond apart. */
export function recordingOf(messages) {
    const pieces = messages.map((message, nth) => {
        const piece = framed(message);
        return `${nth * 1000} ${Buffer.byteLength(piece)}\n${piece}\n`;
    });
    return HEADER + pieces.join("");
}

export function framed(message) {
    const body = JSON.stringify(message);
    return `Content-Length: ${Buffer.byteLength(body)}\r\n\r\n${body}`;
}

/** Messages with one folder for another. */
export function moved(messages, from, to) {
    return JSON.parse(JSON.stringify(messages).replaceAll(from, to));
}

/** The files that a recorded session works on: the examples of the project, in a workspace. */
export function files() {
    const examples = new URL("examples/", `file://${root}/`);
    const names = readdirSync(examples).filter((name) => /\.(clad|ladder-test)$/.test(name));
    const found = names.map((name) => [name, readFileSync(new URL(name, examples))]);
    return new Map([...found, ["ladder.toml", Buffer.from("[simulate]\ninterval = \"10ms\"\n")]]);
}

/** A server, and all that it has said. */
export class Session {
    said = [];

    static async start(module, files = new Map()) {
        const session = new Session();
        session.server = await Server.start(module);
        for (const [name, content] of files) {
            session.server.write(name, content);
        }
        return session;
    }

    /** Sends a message and waits until all that follows from it is done: what is due later than `patience` may wait. */
    async send(message, patience = 400) {
        this.server.receive(JSON.stringify(message));
        for (;;) {
            const wait = this.server.turn();
            this.said.push(...[...this.server.said()].map((json) => JSON.parse(json)));
            if (wait < 0 || wait > patience) {
                return;
            }
            await new Promise((resolve) => setTimeout(resolve, wait));
        }
    }

    /** Sends a request and returns its answer as soon as it is there, without a pause. */
    ask(id, method, params) {
        this.server.receive(JSON.stringify({ jsonrpc: "2.0", id, method, params }));
        return this.until((message) => message.id === id && !message.method);
    }

    /** The next message of this kind. */
    until(is) {
        for (;;) {
            if (this.server.turn() < 0) {
                const found = [...this.server.said()].map((json) => JSON.parse(json)).find(is);
                if (!found) {
                    throw new Error("the server does nothing, and has not said what is waited for");
                }
                return found;
            }
            const found = [...this.server.said()].map((json) => JSON.parse(json)).find(is);
            if (found) {
                return found;
            }
        }
    }
}
