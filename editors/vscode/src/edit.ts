// Keys that change the text through the server: a contact, a coil, a block, a branch; a block moved or deleted; lines that
// become comments. Each is one step of undo.
import * as vscode from 'vscode';

import type { Lines } from '../../../panels/diagram/messages.ts';
import type { EditedDrawing, EditKind } from '../../../panels/protocol.ts';
import { reasonOf } from '../../../panels/reason.ts';
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
    await make(editor, server.execute('ladder.edit', { uri: document.uri.toString(), range, edit }));
}

/** The lines of a selection; one that ends before a line's first character does not count that line. */
function linesOf({ start, end }: vscode.Selection): Lines {
    return { first: start.line, last: end.character === 0 && end.line > start.line ? end.line - 1 : end.line };
}

/** Turns the lines of each selection into comments, or back. */
export async function toggleComment(server: Server): Promise<void> {
    const editor = vscode.window.activeTextEditor;
    if (editor) {
        const lines = editor.selections.map(linesOf);
        await make(editor, server.execute('ladder.comment', { uri: editor.document.uri.toString(), lines }));
    }
}

/** Makes the edits of an answer, unless the text has changed meanwhile; shows why there are none. */
async function make(editor: vscode.TextEditor, answer: Promise<EditedDrawing>): Promise<void> {
    const { document } = editor;
    const { version } = document;
    try {
        const { edits, cursor } = await answer;
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
        void vscode.window.showWarningMessage(`Ladder: ${reasonOf(error)}`);
    }
}
