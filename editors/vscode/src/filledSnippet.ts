// A rung that a proposal with places to fill was put into is laid out when the last of them is filled, when Escape ends the filling, or
// when the cursor leaves it. What was accepted stays: the words in places that nobody filled are names like any other.
import * as vscode from 'vscode';

/** The command of a proposal with places to fill, once it was accepted. */
const INSERTED = 'ladder.snippet.inserted';

/** After Tab in such a proposal. */
const TABBED = 'ladder.snippet.tabbed';

/** After Escape in such a proposal. */
const LEFT = 'ladder.snippet.left';

/** Has proposals with places to fill say that they were accepted. */
export function followed<Items extends vscode.CompletionItem[] | vscode.CompletionList | null | undefined>(found: Items): Items {
    const items: readonly vscode.CompletionItem[] = Array.isArray(found) ? found : (found?.items ?? []);
    for (const item of items) {
        if (item.insertText instanceof vscode.SnippetString) {
            const lineEnds = item.insertText.value.split('\n').length - 1;
            item.command ??= { command: INSERTED, title: 'Lay Out the Rung Once It Is Filled', arguments: [lineEnds] };
        }
    }
    return found;
}

/** Asks for what typing the last character of a line brings about. */
async function layOut(document: vscode.TextDocument, line: number): Promise<void> {
    if (document.isClosed || line >= document.lineCount) {
        return;
    }
    const { text } = document.lineAt(line);
    const end = Math.max(text.lastIndexOf(')'), text.lastIndexOf('>')) + 1;
    if (end > 0) {
        const options = { tabSize: 4, insertSpaces: true };
        const at = new vscode.Position(line, end);
        // The extension's own middleware makes the edits.
        await vscode.commands.executeCommand('vscode.executeFormatOnTypeProvider', document.uri, at, text.charAt(end - 1), options);
    }
}

export class FilledSnippet implements vscode.Disposable {
    /** The line of the place that is being filled, and how many more lines the proposal has. */
    #open: { readonly document: vscode.TextDocument; line: number; readonly lineEnds: number } | undefined;
    readonly #followed: vscode.Disposable;

    constructor() {
        this.#followed = vscode.Disposable.from(
            vscode.commands.registerCommand(INSERTED, (lineEnds: number) => this.#begin(lineEnds)),
            vscode.commands.registerCommand(TABBED, () => this.#tabbed()),
            vscode.commands.registerCommand(LEFT, () => this.#leave()),
            vscode.workspace.onDidChangeTextDocument(({ document, contentChanges }) => {
                for (const { range, text } of contentChanges) {
                    if (this.#open?.document === document && range.end.line < this.#open.line) {
                        this.#open.line += text.split('\n').length - 1 - (range.end.line - range.start.line);
                    }
                }
            }),
            vscode.window.onDidChangeTextEditorSelection(({ textEditor, selections }) => {
                if (this.#open?.document === textEditor.document) {
                    this.#follow(this.#open, selections);
                }
            }),
            vscode.window.onDidChangeActiveTextEditor(() => this.#leave()),
        );
    }

    dispose(): void {
        this.#followed.dispose();
    }

    #begin(lineEnds: number): void {
        const editor = vscode.window.activeTextEditor;
        this.#open = editor && { document: editor.document, line: editor.selection.active.line, lineEnds };
    }

    /** The editor selects the next place to fill, which may be in another line; a cursor in another line has left them. */
    #follow(open: { line: number; readonly lineEnds: number }, selections: readonly vscode.Selection[]): void {
        const next = selections.find(({ active, isEmpty }) => !isEmpty && Math.abs(active.line - open.line) <= open.lineEnds);
        if (next) {
            open.line = next.active.line;
        } else if (selections.every(({ active }) => active.line !== open.line)) {
            this.#leave();
        }
    }

    /** Places to fill are selected; at the end nothing is. */
    #tabbed(): void {
        const editor = vscode.window.activeTextEditor;
        if (editor?.document === this.#open?.document && editor?.selection.isEmpty) {
            this.#leave();
        }
    }

    #leave(): void {
        const open = this.#open;
        this.#open = undefined;
        if (open) {
            void layOut(open.document, open.line);
        }
    }
}
