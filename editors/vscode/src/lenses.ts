// The commands of code lenses: which there are, and the one that shows places.
import * as vscode from 'vscode';
import type { ClientCapabilities, Location, Position, StaticFeature } from 'vscode-languageclient/node';

/** Tells the server which commands its lenses may have here. */
export const lensCommands: StaticFeature = {
    fillClientCapabilities(capabilities: ClientCapabilities): void {
        const commands = ['ladder.simulation.start', 'ladder.test', 'ladder.showReferences'];
        capabilities.experimental = { ...(capabilities.experimental as object | undefined), commands };
    },
    initialize(): void {},
    getState() {
        return { kind: 'static' };
    },
    clear(): void {},
};

const toPosition = ({ line, character }: Position) => new vscode.Position(line, character);

const toLocation = ({ uri, range }: Location) =>
    new vscode.Location(vscode.Uri.parse(uri), new vscode.Range(toPosition(range.start), toPosition(range.end)));

/** Shows places beside a position, as the editor shows references. */
export async function showReferences(uri: string, position: Position, places: Location[]): Promise<void> {
    await vscode.commands.executeCommand(
        'editor.action.showReferences',
        vscode.Uri.parse(uri),
        toPosition(position),
        places.map(toLocation),
    );
}
