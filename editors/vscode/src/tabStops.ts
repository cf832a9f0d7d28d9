// Tab and Shift+Tab in ladder files: from operand to operand on a rung, what the editor does elsewhere.
import * as vscode from 'vscode';

import { isDrawn, nextStop } from '../../../panels/nextStop.ts';

export async function goToStop(backwards: boolean): Promise<void> {
    const editor = vscode.window.activeTextEditor;
    if (!editor) {
        return;
    }
    const { document, selections } = editor;
    if (!selections.every(({ active, isSingleLine }) => isSingleLine && isDrawn(document.lineAt(active.line).text))) {
        await vscode.commands.executeCommand(backwards ? 'outdent' : 'tab');
        return;
    }
    editor.selections = selections.map(({ active }) => {
        const column = nextStop(document.lineAt(active.line).text, active.character, backwards);
        return new vscode.Selection(active.line, column, active.line, column);
    });
}
