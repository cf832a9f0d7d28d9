// Programs of other systems, with their diagram next to them. One in Python is opened as such when a person says so.
import * as vscode from 'vscode';

import { reasonOf } from '../../../panels/reason.ts';
import { drawingOf, Drawings, SCHEME } from './drawings.ts';
import { CLICK, isForeign } from './foreignProgram.ts';
import type { Server } from './server.ts';

export class Click implements vscode.Disposable {
    readonly #server: Server;
    readonly #drawings = new Drawings();
    readonly #changed = new vscode.EventEmitter<vscode.Uri>();
    readonly #subscriptions: vscode.Disposable;

    constructor(server: Server) {
        this.#server = server;
        this.#subscriptions = vscode.Disposable.from(
            this.#changed,
            vscode.workspace.registerTextDocumentContentProvider(SCHEME, {
                onDidChange: this.#changed.event,
                provideTextDocumentContent: (uri) => this.#drawings.text(uri.toString()),
            }),
            server.onDidReceivePreview((previewed) => {
                const drawing = this.#drawings.take(previewed);
                if (drawing !== undefined) {
                    this.#changed.fire(vscode.Uri.parse(drawing));
                }
            }),
            server.onDidStart(() => void this.#followAgain()),
            vscode.window.onDidChangeActiveTextEditor(markForeign),
            vscode.workspace.onDidCloseTextDocument((document) => this.#drawings.end(document.uri.toString())),
        );
        markForeign(vscode.window.activeTextEditor);
    }

    /** The Python file of the active editor is a Click program from now on. */
    async open(): Promise<void> {
        const document = vscode.window.activeTextEditor?.document;
        if (document?.languageId === 'python') {
            await vscode.languages.setTextDocumentLanguage(document, CLICK);
            markForeign(vscode.window.activeTextEditor);
        }
    }

    /** Shows the ladder text of the active editor's program next to it. */
    async preview(): Promise<void> {
        const document = vscode.window.activeTextEditor?.document;
        if (document && isForeign(document)) {
            await this.show(document);
        }
    }

    /** @returns the document with the ladder text of a program; none if there is something wrong with it, which is shown */
    async drawing(program: vscode.TextDocument): Promise<vscode.TextDocument | undefined> {
        try {
            const uri = vscode.Uri.from(drawingOf(program.uri));
            this.#drawings.begin(uri.toString(), await this.#server.execute('ladder.preview', { uri: program.uri.toString() }));
            this.#changed.fire(uri);
            return await vscode.workspace.openTextDocument(uri);
        } catch (error) {
            void vscode.window.showErrorMessage(`Ladder: ${reasonOf(error)}`);
            return undefined;
        }
    }

    /** The same, and shows it next to the program. */
    async show(program: vscode.TextDocument): Promise<vscode.TextDocument | undefined> {
        const drawing = await this.drawing(program);
        if (drawing) {
            await vscode.window.showTextDocument(drawing, { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true });
        }
        return drawing;
    }

    dispose(): void {
        this.#subscriptions.dispose();
    }

    /** A server that was started again knows of no drawing. */
    async #followAgain(): Promise<void> {
        for (const { uri } of vscode.workspace.textDocuments.filter(isForeign)) {
            if (this.#drawings.has(uri.toString())) {
                // One that cannot be read now is marked by its diagnostics.
                await this.#server.execute('ladder.preview', { uri: uri.toString() }).catch(() => undefined);
            }
        }
    }
}

/** Menus ask for this: only the content of an XML file shows whether it is a program. */
function markForeign(editor: vscode.TextEditor | undefined): void {
    void vscode.commands.executeCommand('setContext', 'ladder.foreign', editor !== undefined && isForeign(editor.document));
}
