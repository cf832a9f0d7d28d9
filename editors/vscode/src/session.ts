// One simulation of one document's text: sends its commands in order and keeps its last state.
import type { TextDocument, TextDocumentContentChangeEvent } from 'vscode';

import { findLineTags, type LineTags } from './lineValues.ts';
import type { Commands, Power, State } from './protocol.ts';
import { rangesAfterEdit } from './rangesAfterEdit.ts';

/** Sends `ladder.simulate.<name>` with one object. */
export type Send = <Name extends keyof Commands>(
    name: Name,
    argument: Commands[Name]['argument'] & { session?: string },
) => Promise<Commands[Name]['answer']>;

export class Session {
    readonly document: TextDocument;
    state: State;
    /** The text has moved on; the places in the state are about the old one. */
    stale = false;
    /** What was painted when the text moved on, where it stands now. */
    staleRanges: readonly Power['range'][] = [];
    /** Tags whose change stops a run. */
    watchedTags: readonly string[] = [];
    /** What the server had to say at the start. */
    readonly notes: readonly string[];
    readonly lineTags: LineTags;

    readonly #send: Send;
    #last: Promise<unknown> = Promise.resolve();

    private constructor(document: TextDocument, state: State, notes: readonly string[], lineTags: LineTags, send: Send) {
        this.document = document;
        this.state = state;
        this.notes = notes;
        this.lineTags = lineTags;
        this.#send = send;
    }

    static async start(document: TextDocument, textIn: (range: Power['range']) => string, send: Send): Promise<Session> {
        const { state, notes = [] } = await send('start', { uri: document.uri.toString() });
        return new Session(document, state, notes, findLineTags(state, textIn), send);
    }

    get id(): string {
        return this.state.session;
    }

    /** Sent once the commands before it are answered: the server may work on several at once. */
    command<Name extends keyof Commands>(name: Name, argument: Commands[Name]['argument']): Promise<Commands[Name]['answer']> {
        const sent = this.#last.then(() => this.#send(name, { ...argument, session: this.id }));
        this.#last = sent.catch(() => undefined);
        return sent;
    }

    /** As `command`, but at once: a pause must not wait for the end of what it pauses. */
    urgent<Name extends keyof Commands>(name: Name, argument: Commands[Name]['argument']): Promise<Commands[Name]['answer']> {
        return this.#send(name, { ...argument, session: this.id });
    }

    /** @returns whether this made it stale */
    edited(changes: readonly TextDocumentContentChangeEvent[]): boolean {
        const first = !this.stale;
        if (first) {
            this.stale = true;
            this.staleRanges = this.state.power.map(({ range }) => range);
        }
        this.staleRanges = rangesAfterEdit(this.staleRanges, changes);
        return first;
    }
}
