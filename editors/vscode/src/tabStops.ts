// Tab and Shift+Tab in ladder files: from operand to operand on a rung, each selected; what the editor does elsewhere.
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
    editor.selections = selections.map(({ active: { line }, start, end }) => {
        const stop = nextStop(document.lineAt(line).text, { start: start.character, end: end.character }, backwards);
        return new vscode.Selection(line, stop.start, line, stop.end);
    });
}
