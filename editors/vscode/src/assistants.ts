// The tools of `ladder mcp` for the assistants of this editor, where it has such.
import * as vscode from 'vscode';

import type { Server } from './server.ts';

/** What editors newer than the oldest that is supported have besides. */
interface Newer {
    readonly lm?: { registerMcpServerDefinitionProvider?(id: string, provider: { provideMcpServerDefinitions(): unknown[] }): vscode.Disposable };
    readonly McpStdioServerDefinition?: new (label: string, command: string, args: string[]) => unknown;
}

/** Offers the program that the editor itself runs: in a workspace that is not trusted nothing. The editor names its folders. */
export function offerTools(server: Server): vscode.Disposable {
    const { lm, McpStdioServerDefinition: Definition } = vscode as unknown as Newer;
    if (!lm?.registerMcpServerDefinitionProvider || !Definition) {
        return new vscode.Disposable(() => undefined);
    }
    return lm.registerMcpServerDefinitionProvider('ladder', {
        provideMcpServerDefinitions: () => {
            const program = server.program();
            const folders = (vscode.workspace.workspaceFolders ?? []).map(({ uri }) => uri.fsPath);
            return program === undefined || folders.length === 0 ? [] : [new Definition('Ladder', program, ['mcp', ...folders])];
        },
    });
}
