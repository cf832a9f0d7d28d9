// The server with everything built in: it translates programs of other systems, and proves. It is loaded when something is asked of it
// for the first time, works in a worker of its own, and keeps no state: each request comes with the files that it is about.
import { Connection } from './connection.ts';
import type { OtherCommands } from '../../panels/protocol.ts';

/** The commands that the page's own server does not have. */
export type CompleteCommand = 'ladder.notations' | 'ladder.convert' | 'ladder.proveProperties';

export type Files = Readonly<Record<string, string | Uint8Array>>;

interface Answer {
    readonly id?: number;
    readonly result?: unknown;
    readonly error?: { readonly message: string };
}

interface Pending {
    readonly resolve: (result: unknown) => void;
    readonly reject: (error: Error) => void;
}

export class Complete {
    #connection: Connection | undefined;
    #id = 0;
    #pending: Pending | undefined;
    #last: Promise<unknown> = Promise.resolve();
    readonly #loading: (isLoading: boolean) => void;
    #isLoaded = false;

    /** @param loading called when the server begins to be loaded, and when it is there or could not be loaded */
    constructor(loading: (isLoading: boolean) => void) {
        this.#loading = loading;
    }

    /** Asks for something about these files: one request after the other. */
    execute<Name extends CompleteCommand>(command: Name, argument: OtherCommands[Name]['argument'], files: Files): Promise<OtherCommands[Name]['answer']> {
        const answer = this.#last.then(() => this.#ask(command, argument, files));
        this.#last = answer.catch(() => undefined);
        return answer as Promise<OtherCommands[Name]['answer']>;
    }

    /** Gives up what is asked: a server that works hears nothing, so another one takes its place when it is needed. */
    cancel(): void {
        this.#end(new Error('it was stopped.'));
    }

    async #ask(command: string, argument: object, files: Files): Promise<unknown> {
        const connection = await this.#connected();
        connection.files(files);
        try {
            return await this.#request(connection, 'workspace/executeCommand', { command, arguments: [argument] });
        } finally {
            connection.files(Object.fromEntries(Object.keys(files).map((name) => [name, null])));
        }
    }

    async #connected(): Promise<Connection> {
        if (this.#connection) {
            return this.#connection;
        }
        const connection = new Connection('ladder-complete.wasm', (reason) => this.#end(new Error(reason)));
        connection.subscribe((message) => this.#take(JSON.parse(message) as Answer));
        this.#connection = connection;
        if (!this.#isLoaded) {
            this.#loading(true);
        }
        try {
            await this.#request(connection, 'initialize', { capabilities: {} });
            this.#isLoaded = true;
        } finally {
            this.#loading(false);
        }
        return connection;
    }

    #request(connection: Connection, method: string, params: object): Promise<unknown> {
        this.#id += 1;
        const message = JSON.stringify({ jsonrpc: '2.0', id: this.#id, method, params });
        return new Promise((resolve, reject) => {
            this.#pending = { resolve, reject };
            connection.send(message);
        });
    }

    #take({ id, result, error }: Answer): void {
        const pending = id === this.#id ? this.#pending : undefined;
        if (!pending) {
            return;
        }
        this.#pending = undefined;
        if (error) {
            pending.reject(new Error(error.message));
        } else {
            pending.resolve(result);
        }
    }

    #end(error: Error): void {
        this.#connection?.end();
        this.#connection = undefined;
        const pending = this.#pending;
        this.#pending = undefined;
        pending?.reject(error);
    }
}
