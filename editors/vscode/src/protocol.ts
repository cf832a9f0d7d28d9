// What the simulator of the language server says and is asked, as docs/protocol.md of the project defines it.
import type { Range } from 'vscode-languageclient/node';

export type Value = boolean | number | string;

export interface Tag {
    readonly name: string;
    readonly type: string;
    readonly value: Value;
    readonly role: 'input' | 'output' | 'internal';
    readonly forced: boolean;
}

/** Whether power flows in one wire, block or connector. */
export interface Power {
    readonly range: Range;
    readonly on: boolean;
}

export interface Fault {
    readonly message: string;
    readonly range: Range;
    readonly scan: number;
}

export interface State {
    readonly session: string;
    readonly uri: string;
    /** Of the text that the session runs. */
    readonly version: number;
    /** The text has moved on since. */
    readonly stale: boolean;
    readonly status: 'paused' | 'running' | 'ended' | 'faulted';
    readonly scan: number;
    readonly timeMs: number;
    readonly tags: readonly Tag[];
    readonly power: readonly Power[];
    readonly faults: readonly Fault[];
}

/** What each command takes besides the session, and what it answers. */
export interface Commands {
    start: { argument: { uri: string; options: { intervalMs: number } }; answer: { session: string; state: State } };
    step: { argument: { scans: number }; answer: State };
    run: { argument: object; answer: State };
    pause: { argument: object; answer: State };
    set: { argument: { tag: string; value: Value }; answer: State };
    force: { argument: { tag: string; value: Value }; answer: State };
    unforce: { argument: { tag?: string }; answer: State };
    reset: { argument: object; answer: State };
    stop: { argument: object; answer: { session: string; stopped: true } };
}

export const stateNotification = 'ladder/simulationState';
