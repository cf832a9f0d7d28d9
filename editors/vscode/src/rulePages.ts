// Shows the page of a rule when the link of a finding is followed.
import * as vscode from 'vscode';
import type { ClientCapabilities, StaticFeature } from 'vscode-languageclient/node';

import { ruleOf, SCHEME } from './rulePage.ts';
import type { Server } from './server.ts';

/** Tells the server that findings may link the pages of their rules. */
export const rulePageLinks: StaticFeature = {
    fillClientCapabilities(capabilities: ClientCapabilities): void {
        capabilities.experimental = { ...(capabilities.experimental as object | undefined), rulePages: true };
    },
    initialize(): void {},
    getState() {
        return { kind: 'static' };
    },
    clear(): void {},
};

/** Has the editor open the addresses that findings link. */
export function showRulePages(server: Server): vscode.Disposable {
    return vscode.workspace.registerTextDocumentContentProvider(SCHEME, {
        provideTextDocumentContent: async ({ path }) =>
            (await server.execute('ladder.rulePage', { rule: ruleOf(path) })).markdown,
    });
}
