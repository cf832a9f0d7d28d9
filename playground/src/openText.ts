// A text that is open: its editor, its name, and the version of it that the server has.
import { history, isolateHistory } from '@codemirror/commands';
import { setDiagnostics } from '@codemirror/lint';
import { LSPPlugin } from '@codemirror/lsp-client';
import { Compartment, EditorState, type Extension } from '@codemirror/state';
import { EditorView, type ViewUpdate } from '@codemirror/view';

import type { Range } from '../../panels/protocol.ts';
import type { SimulatedText } from '../../panels/session.ts';
import { type Opened, opened, opening, opens, opensAnother } from './opened.ts';
import { FOLDER, type Server } from './server.ts';

export class OpenText implements SimulatedText {
    readonly view: EditorView;
    readonly #server: Server;
    readonly #past = new Compartment();
    readonly #listeners = new Set<(update: ViewUpdate) => void>();

    constructor(parent: HTMLElement, server: Server, name: string, extensions: Extension) {
        this.#server = server;
        const plugin = new Compartment();
        const pluginOf = (file: string) => server.client.plugin(uriOf(file));
        const state = EditorState.create({
            extensions: [
                extensions,
                this.#past.of(history()),
                EditorView.updateListener.of((update) => this.#listeners.forEach((listener) => listener(update))),
                opening({ name, id: '' }),
                plugin.of(pluginOf(name)),
                EditorState.transactionExtender.of((transaction) => {
                    const effect = transaction.effects.find((it) => it.is(opens));
                    return effect ? { effects: plugin.reconfigure(pluginOf(effect.value.name)) } : null;
                }),
            ],
        });
        this.view = new EditorView({ parent, state });
    }

    get opened(): Opened {
        return this.view.state.field(opened);
    }

    get name(): string {
        return this.opened.name;
    }

    get uri(): string {
        return uriOf(this.name);
    }

    /** What was typed and not sent yet is a newer version than any that the server has. */
    get version(): number {
        const version = this.#server.client.workspace.getFile(this.uri)?.version ?? 0;
        const unsent = LSPPlugin.get(this.view)?.unsyncedChanges.empty === false;
        return unsent ? version + 1 : version;
    }

    get text(): string {
        return this.view.state.doc.toString();
    }

    /** Another text takes its place, and Undo brings back the one that was there. */
    open(now: Opened, text: string): void {
        const { view } = this;
        // What is asked in a dialog is about the text that goes.
        view.dom.querySelectorAll<HTMLElement>('.cm-dialog-close').forEach((button) => button.click());
        const none = setDiagnostics(view.state, []);
        view.dispatch(none, {
            changes: { from: 0, to: view.state.doc.length, insert: text },
            selection: { anchor: 0 },
            effects: [opens.of(now), EditorView.scrollIntoView(0)],
            annotations: isolateHistory.of('full'),
        });
    }

    /** There is nothing to undo any more. */
    forget(): void {
        this.view.dispatch({ effects: this.#past.reconfigure([]) });
        this.view.dispatch({ effects: this.#past.reconfigure(history()) });
    }

    onEdit(edited: () => void): void {
        this.#listeners.add(({ docChanged }) => docChanged && edited());
    }

    /** @param changed called when another text has taken the place of one: what was open, its text, and what is open now */
    onOpen(changed: (before: Opened, text: string, now: Opened) => void): void {
        this.#listeners.add(({ transactions, startState, state }) => {
            if (transactions.some(opensAnother)) {
                changed(startState.field(opened), startState.doc.toString(), state.field(opened));
            }
        });
    }

    offset({ line, character }: Range['start']): number {
        const { doc } = this.view.state;
        const { from, to } = doc.line(Math.min(Math.max(line + 1, 1), doc.lines));
        return Math.min(from + character, to);
    }

    place(offset: number): Range['start'] {
        const { number, from } = this.view.state.doc.lineAt(offset);
        return { line: number - 1, character: offset - from };
    }

    reveal(place: Range['start']): void {
        this.view.dispatch({ effects: EditorView.scrollIntoView(this.offset(place), { y: 'nearest', yMargin: 60 }) });
    }

    select({ start, end }: Range, focus: boolean): void {
        const selection = { anchor: this.offset(start), head: this.offset(end) };
        this.view.dispatch({ selection, effects: EditorView.scrollIntoView(selection.anchor, { y: 'nearest', yMargin: 60 }) });
        if (focus) {
            this.view.focus();
        }
    }
}

const uriOf = (name: string) => `${FOLDER}/${encodeURIComponent(name)}`;
