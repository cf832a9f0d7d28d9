// The way to the language server: a worker, which takes and posts the messages of the protocol as strings.
import type { Transport } from '@codemirror/lsp-client';

let loaded: Promise<WebAssembly.Module> | undefined;

/** The server, compiled while it comes: once for all workers of the page, and again only if that has failed. */
function load(): Promise<WebAssembly.Module> {
    loaded ??= compile().catch((error: unknown) => {
        loaded = undefined;
        throw error;
    });
    return loaded;
}

async function compile(): Promise<WebAssembly.Module> {
    // The page says to the browser that it needs this file: it may be there.
    const answer = await fetch(new URL('ladder.wasm', document.baseURI));
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
    constructor(failed: (reason: string) => void) {
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
        load().then((module) => this.#worker.postMessage({ module }), notLoaded);
    }

    send(message: string): void {
        this.#worker.postMessage(message);
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
