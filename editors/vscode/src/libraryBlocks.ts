// Shows the source of a block of the library when its definition is asked for.
import * as vscode from 'vscode';
import type { ClientCapabilities, StaticFeature } from 'vscode-languageclient/node';

import { blockOf, SCHEME } from './libraryBlock.ts';
import type { Server } from './server.ts';

/** Tells the server that definitions may lead into the library. */
export const libraryAddresses: StaticFeature = {
    fillClientCapabilities(capabilities: ClientCapabilities): void {
        capabilities.experimental = { ...(capabilities.experimental as object | undefined), libraryBlocks: true };
    },
    initialize(): void {},
    getState() {
        return { kind: 'static' };
    },
    clear(): void {},
};

/** Has the editor open the addresses of the library. */
export function showLibraryBlocks(server: Server): vscode.Disposable {
    return vscode.workspace.registerTextDocumentContentProvider(SCHEME, {
        provideTextDocumentContent: async ({ path }) =>
            (await server.execute('ladder.libraryBlock', { block: blockOf(path) })).text,
    });
}
