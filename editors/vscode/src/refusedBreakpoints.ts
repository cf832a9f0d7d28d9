// Next to a breakpoint that the debugger refuses: why.
import * as vscode from 'vscode';

import { type Message, Refusals } from './refusals.ts';

const KIND = vscode.window.createTextEditorDecorationType({ rangeBehavior: vscode.DecorationRangeBehavior.ClosedClosed });

/** What is shown of one debug session, from its messages. */
export class RefusedBreakpoints implements vscode.Disposable {
    readonly #refusals = new Refusals();
    readonly #shown = vscode.window.onDidChangeVisibleTextEditors(() => this.#show());

    asks(message: Message): void {
        this.#refusals.asks(message);
    }

    hears(message: Message): void {
        if (this.#refusals.hears(message)) {
            this.#show();
        }
    }

    #show(): void {
        for (const editor of vscode.window.visibleTextEditors) {
            const { document } = editor;
            const refused = this.#refusals.of(document.uri.fsPath).filter(({ line }) => line < document.lineCount);
            editor.setDecorations(KIND, refused.map(({ line, message }) => ({
                range: new vscode.Range(document.lineAt(line).range.end, document.lineAt(line).range.end),
                renderOptions: {
                    after: {
                        contentText: `Breakpoint: ${message}`,
                        color: new vscode.ThemeColor('editorError.foreground'),
                        margin: '0 0 0 3ch',
                    },
                },
            })));
        }
    }

    dispose(): void {
        this.#shown.dispose();
        vscode.window.visibleTextEditors.forEach((editor) => editor.setDecorations(KIND, []));
    }
}
