// Programs of other systems: one becomes ladder text, ladder text becomes one of theirs. What comes back is a new
// document, which is nowhere until the person saves it.
import { posix } from 'node:path';

import * as vscode from 'vscode';

import { hasReport, report, summary } from '../../../panels/conversionReport.ts';
import type { Converted } from '../../../panels/protocol.ts';
import { reasonOf } from '../../../panels/reason.ts';
import { freshName } from './freshName.ts';
import type { Server } from './server.ts';

/** The file of a menu, else that of the active editor. */
function target(given: unknown): vscode.Uri | undefined {
    return given instanceof vscode.Uri ? given : vscode.window.activeTextEditor?.document.uri;
}

/** Shows what became of a program, as a file next to it that is called as the program and not written yet. */
async function show(program: vscode.Uri, { text, to, extension }: Converted): Promise<void> {
    const folder = vscode.Uri.joinPath(program, '..');
    const { name: stem } = posix.parse(program.path);
    const files = await vscode.workspace.fs.readDirectory(folder).then(
        (entries) => entries.map(([name]) => name),
        () => [],
    );
    const open = vscode.workspace.textDocuments.map((document) => posix.basename(document.uri.path));
    const name = freshName(`${stem}.${extension}`, [...files, ...open]);
    // A path of a folder, so that it is saved there; a program that is no file has none.
    const path = program.scheme === 'file' ? vscode.Uri.joinPath(folder, name).path : name;
    const shown = await vscode.workspace.openTextDocument(vscode.Uri.from({ scheme: 'untitled', path }));
    const edit = new vscode.WorkspaceEdit();
    edit.insert(shown.uri, new vscode.Position(0, 0), text);
    await vscode.workspace.applyEdit(edit);
    await vscode.languages.setTextDocumentLanguage(shown, to === 'clad' ? 'clad' : 'plaintext');
    await vscode.window.showTextDocument(shown, { preview: false });
}

/** Writes a program in another notation and shows it. */
async function translate(server: Server, uri: vscode.Uri, to: string): Promise<void> {
    const document = vscode.workspace.textDocuments.find((open) => open.uri.toString() === uri.toString());
    // Ladder text that is open the server has already, with what it knows of it.
    const changed = document && document.languageId !== 'clad' && (document.isDirty || document.isUntitled);
    const argument = { uri: uri.toString(), to, ...(changed ? { text: document.getText() } : {}) };
    const converted = await server.execute('ladder.convert', argument);
    await show(uri, converted);
    const file = posix.basename(uri.path);
    const showReport = 'Show Report';
    const tell = converted.refused > 0 ? vscode.window.showWarningMessage : vscode.window.showInformationMessage;
    const chosen = await tell(`Ladder: ${summary(file, converted)}.`, ...(hasReport(converted) ? [showReport] : []));
    if (chosen === showReport) {
        const shown = await vscode.workspace.openTextDocument({ content: report(file, converted), language: 'plaintext' });
        await vscode.window.showTextDocument(shown, vscode.ViewColumn.Beside, true);
    }
}

async function orTell(work: () => Promise<void>): Promise<void> {
    try {
        await work();
    } catch (error) {
        void vscode.window.showErrorMessage(`Ladder: ${reasonOf(error)}`);
    }
}

/** Shows a program of another system as ladder text. */
export function convert(server: Server, given: unknown): Promise<void> {
    return orTell(async () => {
        const uri = target(given);
        if (!uri) {
            throw new Error('there is no file to convert; open one, or choose it in the explorer.');
        }
        await translate(server, uri, 'clad');
    });
}

/** Shows a program in a notation that the person picks. */
export function exportAs(server: Server, given: unknown): Promise<void> {
    return orTell(async () => {
        const uri = target(given);
        if (!uri) {
            throw new Error('there is no program to export; open one, or choose it in the explorer.');
        }
        const { notations } = await server.execute('ladder.notations', {});
        const items = notations.map(({ name, title, extensions }) => ({
            label: title,
            description: [name, ...extensions.map((extension) => `.${extension}`)].join('  '),
            name,
        }));
        const title = `Export ${posix.basename(uri.path)} As`;
        const picked = await vscode.window.showQuickPick(items, { title, placeHolder: 'Notation', matchOnDescription: true });
        if (picked) {
            await translate(server, uri, picked.name);
        }
    });
}
