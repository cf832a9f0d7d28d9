// Says to the server in which line a person types, so that the findings of a half-typed rung wait.
import * as vscode from 'vscode';

import type { Server } from './server.ts';

/** Follows the cursor of the editor that has the focus. */
export function sayTypedLine(server: Server): vscode.Disposable {
    let said: { readonly uri: string; readonly line: number | null } | undefined;
    const say = (uri: string, line: number | null) => {
        if (said?.uri !== uri || said.line !== line) {
            said = { uri, line };
            // Without a server there is nobody to ask.
            server.execute('ladder.cursor', said).catch(() => undefined);
        }
    };
    const follow = (editor: vscode.TextEditor | undefined) => {
        const uri = editor?.document.languageId === 'clad' ? editor.document.uri.toString() : undefined;
        if (said && said.uri !== uri) {
            say(said.uri, null);
        }
        if (uri !== undefined && editor) {
            say(uri, editor.selection.active.line);
        }
    };
    const begin = () => {
        said = undefined;
        follow(vscode.window.activeTextEditor);
    };
    begin();
    return vscode.Disposable.from(
        vscode.window.onDidChangeActiveTextEditor(follow),
        vscode.window.onDidChangeTextEditorSelection(({ textEditor }) => {
            if (textEditor === vscode.window.activeTextEditor) {
                follow(textEditor);
            }
        }),
        server.onDidStart(begin),
    );
}
