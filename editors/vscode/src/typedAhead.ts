// What the drawing does of itself while a person types, also for one who types faster than the answers come. VS Code drops
// the edits after a key that another has overtaken; here they are asked for again, for the text as it is by then.
import * as vscode from 'vscode';

import { BegunRung } from './begunRung.ts';
import { LINE_END, Overtaken } from './overtaken.ts';

type Ask = (position: vscode.Position, typed: string, token: vscode.CancellationToken) => Promise<vscode.TextEdit[]>;

/** Makes edits if the document still has the version that they are for. */
async function make(document: vscode.TextDocument, version: number, edits: vscode.TextEdit[], undoStops: boolean): Promise<boolean> {
    const editor = vscode.window.visibleTextEditors.find((candidate) => candidate.document === document);
    if (document.isClosed || document.version !== version) {
        return false;
    }
    if (!editor) {
        // Another tab is in front of it by now.
        const all = new vscode.WorkspaceEdit();
        all.set(document.uri, edits);
        return vscode.workspace.applyEdit(all);
    }
    const write = (builder: vscode.TextEditorEdit) => {
        for (const { range, newText } of edits) {
            if (range.isEmpty) {
                builder.insert(range.start, newText);
            } else {
                builder.replace(range, newText);
            }
        }
    };
    return editor.edit(write, { undoStopBefore: undoStops, undoStopAfter: undoStops });
}

/**
 * The edits without what would be put where the cursor is: VS Code moves the cursor after it, and the rest of a word, or of a
 * branch that its right rail was drawn for, is typed in the wrong place. It is drawn with Enter, or when the file is saved.
 */
function besideCursor(document: vscode.TextDocument, edits: vscode.TextEdit[]): vscode.TextEdit[] {
    const editor = vscode.window.visibleTextEditors.find((candidate) => candidate.document === document);
    const cursors = editor?.selections.map(({ active }) => active) ?? [];
    return edits.filter(({ range }) => !range.isEmpty || cursors.every((cursor) => !cursor.isEqual(range.start)));
}

export class TypedAhead implements vscode.Disposable {
    /** Per document, the lines whose edits are still to be made. */
    readonly #overtaken = new Map<vscode.TextDocument, Overtaken>();
    readonly #begunRung = new BegunRung();
    readonly #followed: vscode.Disposable;

    constructor() {
        this.#followed = vscode.Disposable.from(
            vscode.workspace.onDidChangeTextDocument(({ document, contentChanges }) => {
                for (const { range, text } of contentChanges) {
                    const added = text.split(LINE_END).length - 1;
                    this.#overtaken.get(document)?.shift(range.start.line, range.end.line, added);
                }
            }),
            vscode.workspace.onDidCloseTextDocument((document) => this.#overtaken.delete(document)),
        );
    }

    /** A character was typed. Makes what the server answers. */
    async typed(document: vscode.TextDocument, position: vscode.Position, character: string, token: vscode.CancellationToken, ask: Ask): Promise<void> {
        const { version } = document;
        const isAtEnd = document.lineAt(position).text.slice(position.character).trim() === '';
        const waiting = this.#of(document);
        const own = waiting.add(position.line, character);
        const asked = await ask(position, character, token);
        const edits = character === LINE_END ? asked : besideCursor(document, asked);
        // One undo takes back Enter and what it has begun.
        const undoStops = character !== LINE_END;
        const isMade = document.version === version && (edits.length === 0 || (await make(document, version, edits, undoStops)));
        if (isMade && edits.length > 0 && character === LINE_END) {
            this.#begunRung.begin(document, position.line);
        }
        if (isMade || !isAtEnd) {
            waiting.remove(own);
        } else {
            own.isLate = true;
            await this.#catchUp(document, waiting, ask);
        }
    }

    dispose(): void {
        this.#followed.dispose();
        this.#begunRung.dispose();
        this.#overtaken.clear();
    }

    #of(document: vscode.TextDocument): Overtaken {
        const known = this.#overtaken.get(document) ?? new Overtaken();
        this.#overtaken.set(document, known);
        return known;
    }

    /** Asks about one line after the other until all edits are made. */
    async #catchUp(document: vscode.TextDocument, waiting: Overtaken, ask: Ask): Promise<void> {
        if (waiting.isCatchingUp) {
            return;
        }
        waiting.isCatchingUp = true;
        try {
            for (let next = waiting.late(); next && !document.isClosed; next = waiting.late()) {
                const { version } = document;
                const line = document.lineAt(Math.min(next.line, document.lineCount - 1));
                const asked = await ask(line.range.end, next.typed, new vscode.CancellationTokenSource().token);
                // Nothing was written on it: after Enter the next one was pressed. Then only what is above is drawn, as an END_VAR is.
                const isLeft = line.isEmptyOrWhitespace;
                const edits = besideCursor(document, isLeft ? asked.filter(({ range }) => range.end.line < line.lineNumber) : asked);
                // The typist's step of undo, not one of its own.
                if (document.version === version && (edits.length === 0 || (await make(document, version, edits, false)))) {
                    waiting.remove(next);
                    if (edits.length > 0 && next.typed === LINE_END) {
                        this.#begunRung.begin(document, next.line);
                    }
                }
            }
        } finally {
            waiting.isCatchingUp = false;
        }
    }
}
