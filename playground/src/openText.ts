// A text that is open: its editor, its name, and the version of it that the server has.
import { LSPPlugin } from '@codemirror/lsp-client';
import { EditorState, type Extension } from '@codemirror/state';
import { EditorView } from '@codemirror/view';

import type { Range } from '../../panels/protocol.ts';
import type { SimulatedText } from '../../panels/session.ts';
import { FOLDER, type Server } from './server.ts';

export class OpenText implements SimulatedText {
    readonly view: EditorView;
    readonly #server: Server;
    readonly #extensions: Extension;
    #name: string;

    constructor(parent: HTMLElement, server: Server, name: string, extensions: Extension) {
        this.#server = server;
        this.#extensions = extensions;
        this.#name = name;
        this.view = new EditorView({ parent, state: this.#state('') });
    }

    get name(): string {
        return this.#name;
    }

    get uri(): string {
        return `${FOLDER}/${encodeURIComponent(this.#name)}`;
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

    /** Another text takes its place, with nothing to undo. */
    open(name: string, text: string): void {
        this.#name = name;
        this.view.setState(this.#state(text));
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

    #state(doc: string): EditorState {
        return EditorState.create({ doc, extensions: [this.#extensions, this.#server.client.plugin(this.uri)] });
    }
}
