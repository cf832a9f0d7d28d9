// The way to the language server: a worker, which takes and posts the messages of the protocol as strings.
import type { Transport } from '@codemirror/lsp-client';

/** Texts by their names in the workspace; null removes one. */
export type Files = Readonly<Record<string, string | null>>;

export class Connection implements Transport {
    readonly #worker: Worker;
    readonly #handlers = new Set<(message: string) => void>();

    /**
     * @param files what the server finds in its memory when it begins
     * @param failed called with a sentence for people when the server has ended; nothing is answered any more
     */
    constructor(files: Files, failed: (reason: string) => void) {
        this.#worker = new Worker(new URL('worker.js', document.baseURI), { type: 'module' });
        this.#worker.addEventListener('message', ({ data }: MessageEvent<string | { failed: string }>) => {
            if (typeof data === 'string') {
                this.#handlers.forEach((handler) => handler(data));
            } else if (typeof data.failed === 'string') {
                failed(data.failed);
            }
        });
        this.#worker.addEventListener('error', () => failed('The language server could not be loaded.'));
        this.write(files);
    }

    /** Puts files into the memory that the server has for a disk. */
    write(files: Files): void {
        this.#worker.postMessage({ files });
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
