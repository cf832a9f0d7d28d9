// What was done in a simulation, as a test next to the program.
import * as vscode from 'vscode';

import type { Recorded } from '../../../panels/protocol.ts';
import { freshName } from './freshName.ts';
import type { Simulation } from './simulation.ts';
import type { TestExplorer } from './testExplorer.ts';

/** The tags of which the test is to expect something. */
async function chosenOutputs({ offered, outputs }: Recorded): Promise<readonly string[] | undefined> {
    const rows = offered.map(({ name, type, output }) => ({
        label: name,
        description: output ? `${type}, output` : type,
        picked: outputs.includes(name),
    }));
    // What is chosen already is what is most likely wanted.
    rows.sort((a, b) => Number(b.picked) - Number(a.picked));
    const picked = await vscode.window.showQuickPick(rows, {
        canPickMany: true,
        title: 'Record as Test',
        placeHolder: 'Tags of which the test expects values',
        matchOnDescription: true,
    });
    return picked?.map(({ label }) => label);
}

/** Saves what was done so far as a file of scenarios next to the program, opens it and runs it once. */
export async function record(simulation: Simulation, tests: TestExplorer): Promise<void> {
    const program = simulation.current?.document;
    const first = await simulation.record();
    const outputs = first && (await chosenOutputs(first));
    const recorded = outputs && (await simulation.record(outputs));
    if (!program || !recorded) {
        return;
    }
    const notes = (recorded.notes ?? []).map((note) => `; ${note}`).join('');
    if (program.uri.scheme !== 'file') {
        const document = await vscode.workspace.openTextDocument({ language: 'ladder-test', content: recorded.text });
        await vscode.window.showTextDocument(document, vscode.ViewColumn.Beside);
        void vscode.window.showInformationMessage(`Ladder: the program is in no folder yet: save it, then the test as ${recorded.file}${notes}.`);
        return;
    }
    const folder = vscode.Uri.joinPath(program.uri, '..');
    const names = (await vscode.workspace.fs.readDirectory(folder)).map(([name]) => name);
    const file = vscode.Uri.joinPath(folder, freshName(recorded.file, names));
    await vscode.workspace.fs.writeFile(file, new TextEncoder().encode(recorded.text));
    await vscode.window.showTextDocument(file, { viewColumn: vscode.ViewColumn.Beside });
    void vscode.window.showInformationMessage(`Ladder: saved as ${vscode.workspace.asRelativePath(file)}${notes}.`);
    await tests.runFile(file.toString());
}
