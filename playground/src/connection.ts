// The way to the language server: a worker, which takes and posts the messages of the protocol as strings.
import type { Transport } from '@codemirror/lsp-client';

/** The page's own server, and the one with everything built in. */
export type ServerFile = 'ladder.wasm' | 'ladder-complete.wasm';

const loaded = new Map<ServerFile, Promise<WebAssembly.Module>>();

/** A server, compiled while it comes: once for all workers of the page, and again only if that has failed. */
function load(file: ServerFile): Promise<WebAssembly.Module> {
    const module = loaded.get(file) ?? compile(file).catch((error: unknown) => {
        loaded.delete(file);
        throw error;
    });
    loaded.set(file, module);
    return module;
}

async function compile(file: ServerFile): Promise<WebAssembly.Module> {
    // The page says to the browser that it needs the first one: it may be there.
    const answer = await fetch(new URL(file, document.baseURI));
    if (!answer.ok) {
        throw new Error(`${answer.url}: ${answer.status}`);
    }
    // A server of files need not know the type of such a file.
    return WebAssembly.compileStreaming(new Response(answer.body, { headers: { 'content-type': 'application/wasm' } }));
}

export class Connection implements Transport {
    readonly #worker: Worker;
    readonly #handlers = new Set<(message: string) => void>();

    /** @param failed called with a sentence for people when the server has ended; nothing is answered any more */
    constructor(file: ServerFile, failed: (reason: string) => void) {
        this.#worker = new Worker(new URL('worker.js', document.baseURI), { type: 'module' });
        this.#worker.addEventListener('message', ({ data }: MessageEvent<string | { failed: string }>) => {
            if (typeof data === 'string') {
                this.#handlers.forEach((handler) => handler(data));
            } else if (typeof data.failed === 'string') {
                failed(data.failed);
            }
        });
        const notLoaded = () => failed('The language server could not be loaded.');
        this.#worker.addEventListener('error', notLoaded);
        load(file).then((module) => this.#worker.postMessage({ module }), notLoaded);
    }

    send(message: string): void {
        this.#worker.postMessage(message);
    }

    /** Puts files into what the server has for a disk; null removes one. */
    files(files: Readonly<Record<string, string | Uint8Array | null>>): void {
        this.#worker.postMessage({ files });
    }

    subscribe(handler: (message: string) => void): void {
        this.#handlers.add(handler);
    }

    unsubscribe(handler: (message: string) => void): void {
        this.#handlers.delete(handler);
    }

    end(): void {
        this.#worker.terminate();
    }
}
