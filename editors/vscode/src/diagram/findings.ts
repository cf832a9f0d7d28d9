// What is reported about a program, for its diagram, and what puts it right.
import * as vscode from 'vscode';

import type { Finding } from '../../../../panels/diagram/messages.ts';
import type { Range } from '../../../../panels/protocol.ts';

const SEVERITIES = {
    [vscode.DiagnosticSeverity.Error]: 'error',
    [vscode.DiagnosticSeverity.Warning]: 'warning',
    [vscode.DiagnosticSeverity.Information]: 'info',
    [vscode.DiagnosticSeverity.Hint]: 'info',
} as const;

const placeOf = ({ line, character }: vscode.Position) => ({ line, character });

export function findingsOf({ uri }: vscode.TextDocument): Finding[] {
    return vscode.languages.getDiagnostics(uri).map(({ range, severity, message }) => ({ from: placeOf(range.start), to: placeOf(range.end), severity: SEVERITIES[severity], message }));
}

/** The fixes of what is reported in a range. */
export async function fixesAt({ uri }: vscode.TextDocument, { start, end }: Range): Promise<readonly vscode.CodeAction[]> {
    const range = new vscode.Range(start.line, start.character, end.line, end.character);
    const { value } = vscode.CodeActionKind.QuickFix;
    return (await vscode.commands.executeCommand<readonly vscode.CodeAction[] | undefined>('vscode.executeCodeActionProvider', uri, range, value, 20)) ?? [];
}

/** Makes the fix of this title. */
export async function fix(document: vscode.TextDocument, range: Range, title: string): Promise<void> {
    const action = (await fixesAt(document, range)).find((action) => action.title === title);
    if (action?.edit) {
        await vscode.workspace.applyEdit(action.edit);
    }
    const { command } = action ?? {};
    if (command) {
        await vscode.commands.executeCommand(command.command, ...(command.arguments ?? []));
    }
}
