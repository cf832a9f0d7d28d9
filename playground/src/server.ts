// The language server as the page sees it: its commands with their types, and what it says unasked.
import type { LSPClientConfig, LSPClientExtension } from '@codemirror/lsp-client';
import type { Extension } from '@codemirror/state';

import {
    type Commands, type DebuggerMessage, fromDebuggerNotification, type OtherCommands, shownNotification, type State, stateNotification, toDebuggerNotification,
} from '../../panels/protocol.ts';
import { Client } from './client.ts';
import { Connection } from './connection.ts';
import { sanitized } from './sanitized.ts';

/** The folder that the server works in. */
export const FOLDER = 'file:///work';
/** The first answer waits until the server has been loaded. In milliseconds. */
const TIMEOUT = 60_000;

export interface ServerEvents {
    state(state: State): void;
    debugger(message: DebuggerMessage): void;
    /** A sentence for people. */
    message(text: string): void;
    /** The server has ended. */
    failed(reason: string): void;
}

const capabilities: LSPClientExtension = {
    clientCapabilities: {
        textDocument: {
            codeAction: {
                codeActionLiteralSupport: { codeActionKind: { valueSet: ['quickfix', 'refactor', 'source'] } },
                isPreferredSupport: true,
            },
            onTypeFormatting: {},
        },
    },
};

export class Server {
    readonly client: Client;
    readonly #events: ServerEvents;
    #connection: Connection;
    #beside: Readonly<Record<string, string>> = {};

    constructor(extensions: readonly (Extension | LSPClientExtension)[], events: ServerEvents) {
        this.#events = events;
        const config: LSPClientConfig = {
            rootUri: FOLDER,
            timeout: TIMEOUT,
            sanitizeHTML: sanitized,
            extensions: [capabilities, ...extensions],
            notificationHandlers: {
                [stateNotification]: (_, state: State) => {
                    events.state(state);
                    return true;
                },
                [fromDebuggerNotification]: (_, message: DebuggerMessage) => {
                    events.debugger(message);
                    return true;
                },
                'window/showMessage': (_, { message }: { message: string }) => {
                    events.message(message);
                    return true;
                },
            },
        };
        this.client = new Client(config);
        this.#connection = this.#connect();
    }

    #connect(): Connection {
        const connection = new Connection('ladder.wasm', (reason) => this.#events.failed(reason));
        this.client.connect(connection);
        return connection;
    }

    /** Starts the server again, with what the editors hold. */
    restart(): void {
        this.#connection.end();
        this.client.disconnect();
        this.#connection = this.#connect();
        this.files(this.#beside);
    }

    /** What was typed is sent before anything is asked about it. */
    execute<Name extends keyof OtherCommands>(command: Name, argument: OtherCommands[Name]['argument']): Promise<OtherCommands[Name]['answer']> {
        return this.#execute(command, argument);
    }

    /** Puts files next to the texts that are open. */
    files(files: Readonly<Record<string, string | null>>): void {
        this.#connection.files(files);
    }

    /** These files and no others of those that were put here before are next to the program. */
    beside(files: Readonly<Record<string, string>>): void {
        const gone = Object.keys(this.#beside).filter((name) => !(name in files));
        this.#beside = files;
        const all = { ...files, ...Object.fromEntries(gone.map((name) => [name, null])) };
        if (Object.keys(all).length > 0) {
            this.files(all);
            const changes = Object.entries(all).map(([name, text]) => ({ uri: `${FOLDER}/${encodeURIComponent(name)}`, type: text === null ? 3 : 1 }));
            this.client.notification('workspace/didChangeWatchedFiles', { changes });
        }
    }

    simulate<Name extends keyof Commands>(name: Name, argument: object): Promise<Commands[Name]['answer']> {
        return this.#execute(`ladder.simulate.${name}`, argument);
    }

    /** A request for the debugger of a session. */
    debug(session: string, seq: number, command: string, given: object = {}): void {
        const message = { seq, type: 'request', command, arguments: given };
        this.client.notification<DebuggerMessage>(toDebuggerNotification, { session, message });
    }

    /** The last state of a session is on the screen. */
    hasShown(session: string): void {
        this.client.notification(shownNotification, { session });
    }

    async #execute<Answer>(command: string, argument: object): Promise<Answer> {
        this.client.sync();
        return this.client.request('workspace/executeCommand', { command, arguments: [argument] });
    }
}
