// The server of `../server`, in WebAssembly: what crosses between it and JavaScript. `worker.js` runs it in a page, the tests in
// Node.

const encoder = new TextEncoder();
const decoder = new TextDecoder();

/** The server of one page. It works while `turn` runs, and only then. */
export class Server {
    #exports;

    /**
     * @param {WebAssembly.Module} module
     * @param {() => number} now A clock that goes on, in milliseconds.
     */
    static async start(module, now = () => performance.now()) {
        const server = new Server();
        const { exports } = await WebAssembly.instantiate(module, { page: { now } });
        server.#exports = exports;
        exports.begin();
        return server;
    }

    /** Writes a file; `null` removes it. The name is as seen from the workspace's folder. */
    write(name, content) {
        const bytes = encoder.encode(name);
        if (content === null) {
            this.#comesIn(bytes);
            this.#exports.remove();
            return;
        }
        const file = typeof content === "string" ? encoder.encode(content) : content;
        this.#comesIn(bytes, file);
        this.#exports.write(bytes.length);
    }

    /** Takes a message of the protocol: JSON, without a header. */
    receive(message) {
        this.#comesIn(encoder.encode(message));
        this.#exports.receive();
    }

    /** Works for a moment. Returns the milliseconds after which it has to be called again, negative for never. */
    turn() {
        return this.#exports.turn();
    }

    /** What the server has said since this was asked last: messages of the protocol. */
    *said() {
        while (this.#exports.next()) {
            yield this.#spoken();
        }
    }

    #comesIn(...parts) {
        let at = this.#exports.room(parts.reduce((length, part) => length + part.length, 0));
        for (const part of parts) {
            new Uint8Array(this.#exports.memory.buffer, at, part.length).set(part);
            at += part.length;
        }
    }

    #spoken() {
        const bytes = new Uint8Array(this.#exports.memory.buffer, this.#exports.spoken(), this.#exports.length());
        return decoder.decode(bytes);
    }
}
