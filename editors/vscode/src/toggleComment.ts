// The command behind Ctrl+/ in ladder files.
import * as vscode from 'vscode';

import { toggleComment } from './comment.ts';

/** The lines of a selection; one that ends before a line's first character does not count that line. */
function lastLine({ start, end }: vscode.Selection): number {
    return end.character === 0 && end.line > start.line ? end.line - 1 : end.line;
}

export async function toggleCommentInEditor(): Promise<void> {
    const editor = vscode.window.activeTextEditor;
    if (!editor) {
        return;
    }
    const { document } = editor;
    const edits: { range: vscode.Range; text: string }[] = [];
    for (const selection of editor.selections) {
        const first = selection.start.line;
        const range = new vscode.Range(new vscode.Position(first, 0), document.lineAt(lastLine(selection)).range.end);
        const toggled = toggleComment(document.getText(range).split(/\r\n|\r|\n/));
        if ('refused' in toggled) {
            const line = first + toggled.refused;
            void vscode.window.showWarningMessage(`Line ${line} holds a "#", which would end the comment. Write it without.`);
            return;
        }
        edits.push({ range, text: toggled.lines.join(document.eol === vscode.EndOfLine.CRLF ? '\r\n' : '\n') });
    }
    await editor.edit((builder) => {
        for (const { range, text } of edits) {
            builder.replace(range, text);
        }
    });
}
