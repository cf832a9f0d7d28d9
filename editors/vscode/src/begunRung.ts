// A rung that Enter has begun goes again when the cursor leaves it and nothing was typed there, as editors of code take back the
// blanks of an indentation.
import * as vscode from 'vscode';

/** What Enter begins a rung with. */
const BEGUN = /^\+-*$/;

export class BegunRung implements vscode.Disposable {
    #begun: { readonly document: vscode.TextDocument; line: number } | undefined;
    readonly #followed: vscode.Disposable;

    constructor() {
        this.#followed = vscode.Disposable.from(
            vscode.workspace.onDidChangeTextDocument(({ document, contentChanges }) => {
                for (const change of contentChanges) {
                    this.#follow(document, change);
                }
            }),
            vscode.window.onDidChangeTextEditorSelection(({ textEditor }) => this.#look(textEditor)),
        );
    }

    /** Enter has made edits; the cursor was on this line. */
    begin(document: vscode.TextDocument, line: number): void {
        const isBegun = line < document.lineCount && BEGUN.test(document.lineAt(line).text);
        this.#begun = isBegun ? { document, line } : undefined;
        const editor = vscode.window.activeTextEditor;
        if (editor) {
            // The cursor may have gone on meanwhile.
            this.#look(editor);
        }
    }

    dispose(): void {
        this.#followed.dispose();
    }

    /** Whatever is done in the line is meant; what is done above it moves it. */
    #follow(document: vscode.TextDocument, { range, text }: vscode.TextDocumentContentChangeEvent): void {
        const begun = this.#begun;
        if (begun?.document !== document || range.start.line > begun.line) {
            return;
        }
        if (range.end.line < begun.line) {
            begun.line += text.split('\n').length - 1 - (range.end.line - range.start.line);
        } else {
            this.#begun = undefined;
        }
    }

    #look(editor: vscode.TextEditor): void {
        const begun = this.#begun;
        if (begun?.document !== editor.document || editor.selections.some(({ active }) => active.line === begun.line)) {
            return;
        }
        this.#begun = undefined;
        const { range } = begun.document.lineAt(begun.line);
        void editor.edit((builder) => builder.delete(range));
    }
}
