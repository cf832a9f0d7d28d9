// The language server's life: found, started, restarted, and asked.
import { execFile } from 'node:child_process';
import { statSync } from 'node:fs';
import { homedir } from 'node:os';
import { promisify } from 'node:util';

import * as vscode from 'vscode';
import { CloseAction, CodeLensRequest, ErrorAction, LanguageClient, State as ClientState } from 'vscode-languageclient/node';

import {
    fromDebuggerNotification,
    previewNotification,
    shownNotification,
    stateNotification,
    toDebuggerNotification,
    type DebuggerMessage,
    type OtherCommands,
    type Previewed,
    type State,
} from '../../../panels/protocol.ts';
import { reasonOf } from '../../../panels/reason.ts';
import type { Send } from '../../../panels/session.ts';
import { followed } from './filledSnippet.ts';
import { FOREIGN_FILES } from './foreignProgram.ts';
import { lensCommands, lensesOf } from './lenses.ts';
import { offer, whenThere } from './missingServer.ts';
import { libraryAddresses } from './libraryBlocks.ts';
import { rulePageLinks } from './rulePages.ts';
import { cannotStart, findCargo, findServer, type Place, type Surroundings } from './serverPath.ts';
import { fit, misfit } from './serverVersion.ts';
import { TypedAhead } from './typedAhead.ts';

const execute = promisify(execFile);

function isFile(path: string): boolean {
    return statSync(path, { throwIfNoEntry: false })?.isFile() ?? false;
}

/** A server that ends so often in so short a time, in milliseconds, is not started again by itself. */
const MOST_DEATHS = 5;
const IN_TIME = 180_000;

type Answer = { readonly version: string } | { readonly failed: string };

/** What a program answers when it is asked for its version. */
async function askVersion(path: string): Promise<Answer> {
    try {
        const { stdout } = await execute(path, ['--version'], { timeout: 5000, cwd: homedir() });
        return { version: stdout };
    } catch (error) {
        return { failed: reasonOf(error) };
    }
}

export class Server implements vscode.Disposable {
    readonly log = vscode.window.createOutputChannel('Ladder', { log: true });

    readonly #extensionPath: string;
    readonly #version: string;
    readonly #stateReceived = new vscode.EventEmitter<State>();
    readonly #previewReceived = new vscode.EventEmitter<Previewed>();
    readonly #debuggerSaid = new vscode.EventEmitter<DebuggerMessage>();
    readonly #started = new vscode.EventEmitter<void>();
    readonly #stopped = new vscode.EventEmitter<void>();
    /** When it ended without being asked to. */
    #deaths: readonly number[] = [];
    readonly #typedAhead = new TypedAhead();
    #client: LanguageClient | undefined;
    #waiting: vscode.Disposable | undefined;
    #turn = 0;

    readonly onDidReceiveState = this.#stateReceived.event;
    readonly onDidReceivePreview = this.#previewReceived.event;
    readonly onDebuggerSays = this.#debuggerSaid.event;
    /** Whether a simulation of a document is open. */
    isSimulated: (document: vscode.TextDocument) => boolean = () => false;
    /** Whether a hover has a value of a running program alone. */
    isBrief: (document: vscode.TextDocument, position: vscode.Position) => boolean = () => false;
    /** The server runs, for the first time or again. */
    readonly onDidStart = this.#started.event;
    /** The server has ended, wanted or not: its sessions are gone. */
    readonly onDidStop = this.#stopped.event;

    /**
     * @param extensionPath the extension's folder
     * @param version the extension's version, which the server's is held against
     */
    constructor(extensionPath: string, version: string) {
        this.#extensionPath = extensionPath;
        this.#version = version;
    }

    #surroundings(): Surroundings {
        return {
            setting: vscode.workspace.getConfiguration('ladder.server').get('path', ''),
            extensionPath: this.#extensionPath,
            home: homedir(),
            platform: process.platform,
            searchPath: process.env['PATH'] ?? '',
            cargoHome: process.env['CARGO_HOME'],
            folders: (vscode.workspace.workspaceFolders ?? []).map(({ uri }) => uri.fsPath),
            isFile,
        };
    }

    #place(): Place {
        return findServer(this.#surroundings());
    }

    /** The program `ladder`; none if there is none, or if nothing may be run here. */
    program(): string | undefined {
        return vscode.workspace.isTrusted ? this.#place().path : undefined;
    }

    /** Whether the server runs, and with it what it finds in all files of the workspace is shown. */
    isRunning(): boolean {
        return this.#client?.isRunning() ?? false;
    }

    /** Starts the server. In a workspace that the user does not trust nothing is started, until that changes. */
    async start(): Promise<void> {
        if (!vscode.workspace.isTrusted) {
            this.log.info('This workspace is not trusted: no program is started, and nothing is written.');
            return;
        }
        this.#waiting?.dispose();
        this.#turn += 1;
        const turn = this.#turn;
        const place = this.#place();
        const path = place.path;
        const answer = path === undefined ? { failed: 'there is no such program' } : await askVersion(path);
        if (turn !== this.#turn) {
            // Another start or a stop has come meanwhile: there is never more than one server.
            return;
        }
        if (path === undefined || 'failed' in answer) {
            this.#isMissing(cannotStart(place, 'failed' in answer ? answer.failed : ''));
            return;
        }
        const found = fit(answer.version, this.#version);
        if (!found.fits) {
            const message = misfit(found, path);
            if (found.why === 'other-program') {
                this.#isMissing(message);
                return;
            }
            this.log.warn(message);
            void vscode.window.showWarningMessage(message);
        }
        this.log.info(`Starting ${path} (${answer.version.trim()}, from: ${place.from})`);
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
                    { pattern: '**/*.scene.svg' },
                    ...FOREIGN_FILES.map((pattern) => ({ pattern })),
                ],
                outputChannel: this.log,
                errorHandler: {
                    error: () => ({ action: ErrorAction.Continue }),
                    closed: () => ({ action: this.#died() ? CloseAction.DoNotRestart : CloseAction.Restart, handled: true }),
                },
                middleware: {
                    provideCompletionItem: async (document, position, context, token, next) =>
                        followed(await next(document, position, context, token)),
                    provideHover: (document, position, token, next) =>
                        this.isBrief(document, position) ? undefined : next(document, position, token),
                    provideCodeLenses: (document, token, next) => lensesOf(document, token, next, this.isSimulated(document)),
                    provideOnTypeFormattingEdits: async (document, position, character, options, token, next) => {
                        await this.#typedAhead.typed(
                            document,
                            position,
                            character,
                            token,
                            async (at, typed, until) => (await next(document, at, typed, options, until)) ?? [],
                        );
                        return undefined;
                    },
                },
            },
        );
        client.registerFeature(lensCommands);
        client.registerFeature(rulePageLinks);
        client.registerFeature(libraryAddresses);
        client.onNotification(stateNotification, (state: State) => this.#stateReceived.fire(state));
        client.onNotification(fromDebuggerNotification, (said: DebuggerMessage) => this.#debuggerSaid.fire(said));
        client.onNotification(previewNotification, (previewed: Previewed) => this.#previewReceived.fire(previewed));
        client.onDidChangeState(({ newState }) => {
            if (newState === ClientState.Stopped) {
                this.#stopped.fire();
            } else if (newState === ClientState.Running) {
                // It gets the documents first.
                setTimeout(() => this.#started.fire());
            }
        });
        this.#client = client;
        // The client itself tells the user if this fails; the extension's commands stay, "Restart" among them.
        await client.start().catch((error: unknown) => this.log.error(String(error)));
    }

    /** It ended without being asked to. @returns whether it did so too often */
    #died(): boolean {
        const now = Date.now();
        this.#deaths = [...this.#deaths.filter((then) => now - then < IN_TIME), now];
        if (this.#deaths.length < MOST_DEATHS) {
            return false;
        }
        this.#deaths = [];
        const [again, log] = ['Restart', 'Show Log'];
        const message = `Ladder: the language server has ended ${MOST_DEATHS} times in three minutes, and is not started again by itself.`;
        void vscode.window.showErrorMessage(message, again, log).then((chosen) => {
            if (chosen === again) {
                void this.restart();
            } else if (chosen === log) {
                this.log.show();
            }
        });
        return true;
    }

    /** Settles when the server runs. */
    whenRunning(): Promise<void> {
        if (this.isRunning()) {
            return Promise.resolve();
        }
        return new Promise((resolve) => {
            const waiting = this.onDidStart(() => {
                waiting.dispose();
                resolve();
            });
        });
    }

    async restart(): Promise<void> {
        await this.stop();
        await this.start();
    }

    async stop(): Promise<void> {
        this.#waiting?.dispose();
        this.#turn += 1;
        const client = this.#client;
        this.#client = undefined;
        await client?.dispose();
    }

    readonly simulate: Send = (name, argument) => this.#request(`ladder.simulate.${name}`, argument);

    /** Asks for the lenses of a document again. */
    refreshLenses(document: vscode.TextDocument): void {
        this.#client?.getFeature(CodeLensRequest.method).getProvider(document)?.onDidChangeCodeLensEmitter.fire();
    }

    /** A session's state is shown: the next may come. */
    hasShown(session: string): void {
        void this.#client?.sendNotification(shownNotification, { session });
    }

    /** Tells the debugger of a session something. */
    tellDebugger(message: DebuggerMessage): void {
        void this.#client?.sendNotification(toDebuggerNotification, message);
    }

    /** Asks for one of the commands besides those of the simulator. */
    execute<Name extends keyof OtherCommands>(
        name: Name,
        argument: OtherCommands[Name]['argument'],
        token?: vscode.CancellationToken,
    ): Promise<OtherCommands[Name]['answer']> {
        return this.#request(name, argument, token);
    }

    async #request<Answer>(command: string, argument: object, token?: vscode.CancellationToken): Promise<Answer> {
        if (!this.#client) {
            if (!vscode.workspace.isTrusted) {
                throw new Error('nothing is run in a workspace that is not trusted.');
            }
            throw new Error('the language server does not run; the log says why ("Ladder: Show Log").');
        }
        // None is no argument: it would be sent along.
        const cancellation = token ? [token] : [];
        return this.#client.sendRequest('workspace/executeCommand', { command, arguments: [argument] }, ...cancellation);
    }

    dispose(): void {
        this.#waiting?.dispose();
        this.#typedAhead.dispose();
        this.#stateReceived.dispose();
        this.#previewReceived.dispose();
        this.#started.dispose();
        this.#stopped.dispose();
        this.log.dispose();
    }

    /** Offers what helps, and starts the server once there is one. */
    #isMissing(message: string): void {
        this.log.error(message);
        this.#waiting = whenThere(
            () => this.#place().path,
            () => void this.start(),
        );
        void offer(message, this.log, () => findCargo(this.#surroundings()));
    }
}
