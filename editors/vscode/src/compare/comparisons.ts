// Programs next to their text at HEAD: asked for again when one of both has changed and a person has stopped typing.
import * as vscode from 'vscode';

import type { Compared } from '../../../../panels/compare/messages.ts';
import type { Server } from '../server.ts';
import { Head } from './head.ts';

/** So long after the last edit, in milliseconds. */
const AFTER_EDIT = 400;

export class Comparisons implements vscode.Disposable {
    readonly #server: Server;
    readonly #head = new Head();
    readonly #differs = new vscode.EventEmitter<vscode.TextDocument>();
    readonly #later = new Map<string, NodeJS.Timeout>();
    readonly #subscriptions: vscode.Disposable;

    /** The comparison of a document may have another answer now. */
    readonly onMayDiffer = this.#differs.event;

    constructor(server: Server) {
        this.#server = server;
        const all = () => vscode.workspace.textDocuments.forEach((document) => this.#differs.fire(document));
        this.#subscriptions = vscode.Disposable.from(
            this.#head,
            this.#differs,
            this.#head.onDidMove(all),
            server.onDidStart(all),
            vscode.workspace.onDidChangeTextDocument(({ document }) => this.#edited(document)),
        );
    }

    /**
     * What changed in a program since HEAD; with drawings in these colours if they are wanted.
     *
     * @throws where there is nothing to compare with, or the text has moved on
     */
    async compare(document: vscode.TextDocument, drawings?: 'light' | 'dark'): Promise<Compared> {
        const base = await this.#head.text(document);
        const { version } = document;
        const uri = document.uri.toString();
        if (document.getText() === base) {
            return { uri, version, summary: '', changes: [] };
        }
        return this.#server.execute('ladder.compare', { uri, base, ...(drawings && { drawings }) });
    }

    #edited(document: vscode.TextDocument): void {
        if (document.languageId !== 'clad') {
            return;
        }
        const uri = document.uri.toString();
        clearTimeout(this.#later.get(uri));
        const fire = () => {
            this.#later.delete(uri);
            this.#differs.fire(document);
        };
        this.#later.set(uri, setTimeout(fire, AFTER_EDIT));
    }

    dispose(): void {
        this.#later.forEach((later) => clearTimeout(later));
        this.#subscriptions.dispose();
    }
}
