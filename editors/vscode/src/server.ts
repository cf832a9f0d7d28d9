// The language server's life: found, started, restarted, and asked.
import { execFile } from 'node:child_process';
import { statSync } from 'node:fs';
import { homedir } from 'node:os';
import { promisify } from 'node:util';

import * as vscode from 'vscode';
import { LanguageClient, State as ClientState } from 'vscode-languageclient/node';

import { lensCommands } from './lenses.ts';
import { previewNotification, shownNotification, stateNotification, type OtherCommands, type Previewed, type State } from './protocol.ts';
import { cannotStart, findServer, type Place } from './serverPath.ts';
import type { Send } from './session.ts';

const execute = promisify(execFile);

function isFile(path: string): boolean {
    return statSync(path, { throwIfNoEntry: false })?.isFile() ?? false;
}

/** @returns why the program does not run, or undefined if it does */
async function whyNot(path: string): Promise<string | undefined> {
    try {
        await execute(path, ['--version'], { timeout: 5000, cwd: homedir() });
        return undefined;
    } catch (error) {
        return error instanceof Error ? error.message : String(error);
    }
}

export class Server implements vscode.Disposable {
    readonly log = vscode.window.createOutputChannel('Ladder', { log: true });

    readonly #extensionPath: string;
    readonly #stateReceived = new vscode.EventEmitter<State>();
    readonly #previewReceived = new vscode.EventEmitter<Previewed>();
    readonly #started = new vscode.EventEmitter<void>();
    readonly #stopped = new vscode.EventEmitter<void>();
    #client: LanguageClient | undefined;

    readonly onDidReceiveState = this.#stateReceived.event;
    readonly onDidReceivePreview = this.#previewReceived.event;
    /** The server runs, for the first time or again. */
    readonly onDidStart = this.#started.event;
    /** The server has ended, wanted or not: its sessions are gone. */
    readonly onDidStop = this.#stopped.event;

    constructor(extensionPath: string) {
        this.#extensionPath = extensionPath;
    }

    #place(): Place {
        return findServer({
            setting: vscode.workspace.getConfiguration('ladder.server').get('path', ''),
            extensionPath: this.#extensionPath,
            home: homedir(),
            platform: process.platform,
            searchPath: process.env['PATH'] ?? '',
            folders: (vscode.workspace.workspaceFolders ?? []).map(({ uri }) => uri.fsPath),
            isFile,
        });
    }

    /** The program `ladder`; none if there is none, or if nothing may be run here. */
    program(): string | undefined {
        return vscode.workspace.isTrusted ? this.#place().path : undefined;
    }

    /** Starts the server. In a workspace that the user does not trust nothing is started, until that changes. */
    async start(): Promise<void> {
        if (!vscode.workspace.isTrusted) {
            this.log.info('This workspace is not trusted: no program is started, and nothing is written.');
            return;
        }
        const place = this.#place();
        const path = place.path;
        const reason = path === undefined ? 'there is no such program' : await whyNot(path);
        if (path === undefined || reason !== undefined) {
            this.log.error(`${path ?? 'ladder'}: ${reason}`);
            void this.#tellMissing(place, reason ?? '');
            return;
        }
        this.log.info(`Starting ${path} (from the ${place.from})`);
        const client = new LanguageClient(
            'ladder',
            'Ladder',
            // Not in the folder that is open, where Windows would look for libraries.
            { command: path, args: ['lsp'], options: { cwd: homedir() } },
            {
                // Settings and files on disk the server asks for by itself.
                documentSelector: [
                    { language: 'clad' },
                    { language: 'ladder-click' },
                    { language: 'ladder-test' },
                    { pattern: '**/ladder.toml' },
                ],
                outputChannel: this.log,
            },
        );
        client.registerFeature(lensCommands);
        client.onNotification(stateNotification, (state: State) => this.#stateReceived.fire(state));
        client.onNotification(previewNotification, (previewed: Previewed) => this.#previewReceived.fire(previewed));
        client.onDidChangeState(({ newState }) => {
            if (newState === ClientState.Stopped) {
                this.#stopped.fire();
            } else if (newState === ClientState.Running) {
                // The documents are told to it first.
                setTimeout(() => this.#started.fire());
            }
        });
        this.#client = client;
        // The client itself tells the user if this fails; the extension's commands stay, "Restart" among them.
        await client.start().catch((error: unknown) => this.log.error(String(error)));
    }

    async restart(): Promise<void> {
        await this.stop();
        await this.start();
    }

    async stop(): Promise<void> {
        const client = this.#client;
        this.#client = undefined;
        await client?.dispose();
    }

    readonly simulate: Send = (name, argument) => this.#request(`ladder.simulate.${name}`, argument);

    /** A session's state is shown: the next may come. */
    hasShown(session: string): void {
        void this.#client?.sendNotification(shownNotification, { session });
    }

    /** Asks for one of the commands beside those of the simulator. */
    execute<Name extends keyof OtherCommands>(
        name: Name,
        argument: OtherCommands[Name]['argument'],
    ): Promise<OtherCommands[Name]['answer']> {
        return this.#request(name, argument);
    }

    async #request<Answer>(command: string, argument: object): Promise<Answer> {
        if (!this.#client) {
            if (!vscode.workspace.isTrusted) {
                throw new Error('nothing is run in a workspace that is not trusted.');
            }
            throw new Error('the language server does not run; the log says why ("Ladder: Show Log").');
        }
        return this.#client.sendRequest('workspace/executeCommand', { command, arguments: [argument] });
    }

    dispose(): void {
        this.#stateReceived.dispose();
        this.#previewReceived.dispose();
        this.#started.dispose();
        this.#stopped.dispose();
        this.log.dispose();
    }

    async #tellMissing(place: Place, reason: string): Promise<void> {
        const settings = 'Open Settings';
        const showLog = 'Show Log';
        const chosen = await vscode.window.showErrorMessage(cannotStart(place, reason), settings, showLog);
        if (chosen === settings) {
            await vscode.commands.executeCommand('workbench.action.openSettings', 'ladder.server.path');
        } else if (chosen === showLog) {
            this.log.show();
        }
    }
}
