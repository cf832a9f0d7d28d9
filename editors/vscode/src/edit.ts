// Keys that draw: a contact, a coil, a block, a branch; a block moved or deleted. Each is one step of undo.
import * as vscode from 'vscode';

import type { EditKind } from './protocol.ts';
import type { Server } from './server.ts';

/** Makes a change of the drawing at the selection. */
export async function editDrawing(server: Server, edit: EditKind): Promise<void> {
    const editor = vscode.window.activeTextEditor;
    if (editor?.document.languageId !== 'clad') {
        return;
    }
    const { document, selection } = editor;
    const place = ({ line, character }: vscode.Position) => ({ line, character });
    const range = { start: place(selection.start), end: place(selection.end) };
    const { version } = document;
    try {
        const { edits, cursor } = await server.execute('ladder.edit', { uri: document.uri.toString(), range, edit });
        if (document.version !== version) {
            return;
        }
        await editor.edit((builder) => {
            for (const { range: { start, end }, newText } of edits) {
                builder.replace(new vscode.Range(start.line, start.character, end.line, end.character), newText);
            }
        });
        if (cursor) {
            const at = new vscode.Position(cursor.line, cursor.character);
            editor.selection = new vscode.Selection(at, document.getWordRangeAtPosition(at)?.end ?? at);
        }
    } catch (error) {
        void vscode.window.showWarningMessage(`Ladder: ${error instanceof Error ? error.message : String(error)}`);
    }
}
