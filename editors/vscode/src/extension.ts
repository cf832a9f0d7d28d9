// The extension's beginning and end: what there is, and what is wired to what.
import * as vscode from 'vscode';

import { Click } from './click.ts';
import { registerCommands } from './commands.ts';
import { showPower } from './decorations.ts';
import { showFaults } from './faults.ts';
import type { State } from './protocol.ts';
import { Server } from './server.ts';
import { Simulation } from './simulation.ts';
import { showStatus } from './statusBar.ts';
import { showTags } from './tagsView.ts';

let server: Server | undefined;

/** What other extensions, and the end-to-end tests, may ask. */
export interface Api {
    /** The last state of the current simulation. */
    state(): State | undefined;
}

export async function activate(context: vscode.ExtensionContext): Promise<Api> {
    server = new Server(context.extensionPath);
    const simulation = new Simulation(server);
    const click = new Click(server);
    context.subscriptions.push(
        server,
        simulation,
        click,
        registerCommands(server, simulation, click),
        showPower(simulation),
        showFaults(simulation),
        showStatus(simulation),
        showTags(simulation),
        vscode.workspace.onDidGrantWorkspaceTrust(() => server?.start()),
        vscode.workspace.onDidChangeConfiguration((event) => {
            if (event.affectsConfiguration('ladder.server.path')) {
                void server?.restart();
            }
        }),
    );
    await server.start();
    return { state: () => simulation.current?.state };
}

export async function deactivate(): Promise<void> {
    await server?.stop();
}
