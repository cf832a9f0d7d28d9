// Files as the program names them and as the editor has them.
import { homedir } from 'node:os';
import { isAbsolute, join } from 'node:path';

import * as vscode from 'vscode';

/** The text of a file as the editor has it, else as it is on disk. */
export async function textOf(uri: vscode.Uri): Promise<string> {
    const open = vscode.workspace.textDocuments.find((document) => document.uri.toString() === uri.toString());
    return open?.getText() ?? new TextDecoder().decode(await vscode.workspace.fs.readFile(uri));
}

/** A path as the program says it: it runs in the home folder, and names what lies below that from there on. */
export function whole(path: string): string {
    return isAbsolute(path) ? path : join(homedir(), path);
}
