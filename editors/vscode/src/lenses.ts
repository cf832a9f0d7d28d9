// The commands of code lenses: which there are, and the one that shows places.
import * as vscode from 'vscode';
import type { ClientCapabilities, Location, Position, ProvideCodeLensesSignature, StaticFeature } from 'vscode-languageclient/node';

import { placeOfName } from './placeOfName.ts';
import type { Server } from './server.ts';
import type { Simulation } from './simulation.ts';

const START = 'ladder.simulation.start';

/** Tells the server which commands its lenses and code actions may have here. */
export const lensCommands: StaticFeature = {
    fillClientCapabilities(capabilities: ClientCapabilities): void {
        const commands = [START, 'ladder.test', 'ladder.prove', 'ladder.showReferences', 'ladder.rename'];
        capabilities.experimental = { ...(capabilities.experimental as object | undefined), commands };
    },
    initialize(): void {},
    getState() {
        return { kind: 'static' };
    },
    clear(): void {},
};

const STOP = { title: 'Stop simulation', command: 'ladder.simulation.stop' };

/** Lenses of a document: where its simulation runs, the one that starts it ends it. */
export async function lensesOf(
    document: vscode.TextDocument,
    token: vscode.CancellationToken,
    next: ProvideCodeLensesSignature,
    isSimulated: boolean,
): Promise<vscode.CodeLens[] | null | undefined> {
    const lenses = await next(document, token);
    const shown = (lens: vscode.CodeLens) => (lens.command?.command === START ? new vscode.CodeLens(lens.range, STOP) : lens);
    return isSimulated ? lenses?.map(shown) : lenses;
}

/** Has the lenses follow the simulations that begin and end. */
export function lensesFollow(server: Server, simulation: Simulation): vscode.Disposable {
    const simulated = new WeakSet<vscode.TextDocument>();
    server.isSimulated = (document) => simulation.of(document) !== undefined;
    return simulation.onDidChange((document) => {
        const isSimulated = server.isSimulated(document);
        if (isSimulated === simulated.has(document)) {
            return;
        }
        if (isSimulated) {
            simulated.add(document);
        } else {
            simulated.delete(document);
        }
        server.refreshLenses(document);
    });
}

const toPosition = ({ line, character }: Position) => new vscode.Position(line, character);

const toLocation = ({ uri, range }: Location) =>
    new vscode.Location(vscode.Uri.parse(uri), new vscode.Range(toPosition(range.start), toPosition(range.end)));

/** Asks for another name in the place of one that a code action has made up. */
export async function renameMadeUp(uri: string, name: string): Promise<void> {
    const editor = vscode.window.visibleTextEditors.find(({ document }) => document.uri.toString() === vscode.Uri.parse(uri).toString());
    const at = editor ? placeOfName(editor.document.getText(), name) : -1;
    if (editor && at >= 0) {
        const place = editor.document.positionAt(at);
        editor.selection = new vscode.Selection(place, place);
        editor.revealRange(editor.selection);
        await vscode.commands.executeCommand('editor.action.rename');
    }
}

/** Shows places next to a position, as the editor shows references. */
export async function showReferences(uri: string, position: Position, places: Location[]): Promise<void> {
    await vscode.commands.executeCommand(
        'editor.action.showReferences',
        vscode.Uri.parse(uri),
        toPosition(position),
        places.map(toLocation),
    );
}
