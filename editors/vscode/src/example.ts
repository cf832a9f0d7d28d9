// A program to begin with, opened without a file: nothing is written until it is saved.
import * as vscode from 'vscode';

import { EXAMPLE } from './exampleText.ts';

export async function openExample(): Promise<void> {
    const document = await vscode.workspace.openTextDocument({ language: 'clad', content: EXAMPLE });
    await vscode.window.showTextDocument(document);
}
