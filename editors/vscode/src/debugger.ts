// The debugger: the adapter is the language server, and works on the simulation that is shown.
import { isAbsolute, join } from 'node:path';

import * as vscode from 'vscode';

import { reasonOf } from '../../../panels/reason.ts';
import { completed, expressionAt, type ActiveFile } from './debugConfiguration.ts';
import { RefusedBreakpoints } from './refusedBreakpoints.ts';
import type { Server } from './server.ts';
import type { Simulation } from './simulation.ts';
import { withLinesOnly } from './stackFrames.ts';

const TYPE = 'ladder';

/** A row of the variables view, as the editor hands it to a command of its menu. */
interface VariableRow {
    readonly sessionId?: string;
    readonly container?: { readonly variablesReference?: number };
    readonly variable?: { readonly name: string; readonly evaluateName?: string; readonly value: string };
}

function activeFile(): ActiveFile | undefined {
    const editor = vscode.window.activeTextEditor;
    const document = editor?.document;
    return editor && document?.uri.scheme === 'file'
        ? { languageId: document.languageId, path: document.uri.fsPath, line: editor.selection.active.line + 1 }
        : undefined;
}

class Configurations implements vscode.DebugConfigurationProvider {
    resolveDebugConfiguration(
        _folder: vscode.WorkspaceFolder | undefined,
        given: vscode.DebugConfiguration,
    ): vscode.ProviderResult<vscode.DebugConfiguration> {
        const configuration = completed(given, activeFile());
        if (!configuration) {
            void vscode.window.showErrorMessage('Ladder: open a program (.clad) or its scenarios (.ladder-test), and start again.');
            return undefined;
        }
        return configuration as vscode.DebugConfiguration;
    }

    async resolveDebugConfigurationWithSubstitutedVariables(
        folder: vscode.WorkspaceFolder | undefined,
        given: vscode.DebugConfiguration,
    ): Promise<vscode.DebugConfiguration> {
        const configuration = { ...given };
        for (const name of ['program', 'scenarioFile', 'retain']) {
            const path: unknown = configuration[name];
            if (folder && typeof path === 'string' && path !== '' && !isAbsolute(path)) {
                configuration[name] = join(folder.uri.fsPath, path);
            }
        }
        // Scenarios are read as they are on disk; of a program the text of its editor counts.
        const names = [configuration['program'], configuration['scenarioFile']];
        for (const document of vscode.workspace.textDocuments) {
            if (document.isDirty && names.includes(document.uri.fsPath)) {
                await document.save();
            }
        }
        return configuration;
    }
}

/** The programs of the workspace, for the list under "Show all automatic debug configurations". */
const programs: vscode.DebugConfigurationProvider = {
    async provideDebugConfigurations() {
        const files = await vscode.workspace.findFiles('**/*.clad', undefined, 100);
        return files.map((file) => ({
            type: TYPE,
            request: 'launch',
            name: vscode.workspace.asRelativePath(file),
            program: file.fsPath,
            stopOnEntry: true,
        }));
    },
};

/** Passes the messages of the editor's debugger to the session that the live view shows, and back. */
class Bridge implements vscode.DebugAdapter {
    readonly #said = new vscode.EventEmitter<vscode.DebugProtocolMessage>();
    readonly #refused = new RefusedBreakpoints();
    readonly #subscriptions: vscode.Disposable;
    readonly #server: Server;
    readonly #session: string;
    readonly #gone: () => void;

    readonly onDidSendMessage = this.#said.event;

    /** @param gone called when the editor is done with it */
    constructor(server: Server, session: string, gone: () => void) {
        this.#server = server;
        this.#session = session;
        this.#gone = gone;
        this.#subscriptions = vscode.Disposable.from(
            this.#refused,
            server.onDebuggerSays((said) => {
                if (said.session === session) {
                    this.#refused.hears(said.message);
                    this.#said.fire(withLinesOnly(said.message));
                }
            }),
            server.onDidStop(() => this.#said.fire({ seq: 0, type: 'event', event: 'terminated' } as vscode.DebugProtocolMessage)),
        );
    }

    handleMessage(message: vscode.DebugProtocolMessage): void {
        this.#refused.asks(message);
        this.#server.tellDebugger({ session: this.#session, message });
    }

    dispose(): void {
        this.#subscriptions.dispose();
        this.#said.dispose();
        this.#gone();
    }
}

class Adapters implements vscode.DebugAdapterDescriptorFactory {
    readonly #server: Server;
    readonly #simulation: Simulation;

    constructor(server: Server, simulation: Simulation) {
        this.#server = server;
        this.#simulation = simulation;
    }

    async createDebugAdapterDescriptor({ configuration }: vscode.DebugSession): Promise<vscode.DebugAdapterDescriptor> {
        if (this.#server.program() === undefined) {
            throw new Error(
                vscode.workspace.isTrusted
                    ? 'there is no program "ladder"; the log says more ("Ladder: Show Log").'
                    : 'nothing is run in a workspace that is not trusted.',
            );
        }
        const { session, isJoined } = await this.#simulation.debug(configuration);
        const gone = () => void this.#simulation.undebug(session, isJoined);
        return new vscode.DebugAdapterInlineImplementation(new Bridge(this.#server, session.id, gone));
    }
}

const values: vscode.EvaluatableExpressionProvider = {
    provideEvaluatableExpression(document, { line, character }) {
        const found = expressionAt(document.lineAt(line).text, character);
        return found && new vscode.EvaluatableExpression(new vscode.Range(line, found.start, line, found.end));
    },
};

function sessionOf(row: VariableRow | undefined): vscode.DebugSession | undefined {
    const session = vscode.debug.activeDebugSession;
    return session?.type === TYPE && (row?.sessionId === undefined || row.sessionId === session.id) ? session : undefined;
}

/** Holds a variable at a value that is asked for. */
export async function forceVariable(row: VariableRow | undefined): Promise<void> {
    const session = sessionOf(row);
    if (!session || !row?.variable) {
        return;
    }
    const { evaluateName, value } = row.variable;
    const name = evaluateName ?? row.variable.name;
    const wanted = await vscode.window.showInputBox({
        title: `Force ${name}`,
        prompt: `${name} is held at this value until it is released`,
        value: value.replace(/ \(forced\)$/, ''),
    });
    if (wanted !== undefined) {
        await tell(session.customRequest('ladder/force', { name, value: wanted }));
    }
}

/** Lets a variable go. */
export async function releaseVariable(row: VariableRow | undefined): Promise<void> {
    const session = sessionOf(row);
    const name = row?.variable?.evaluateName ?? row?.variable?.name;
    if (session && name !== undefined) {
        await tell(session.customRequest('ladder/unforce', { name }));
    }
}

/** Goes back to the start of the scan, or to that of the one before. */
export async function stepBackScan(): Promise<void> {
    const session = sessionOf(undefined);
    if (session) {
        await tell(session.customRequest('ladder/stepBackScan', {}));
    }
}

async function tell(asked: Thenable<unknown>): Promise<void> {
    try {
        await asked;
    } catch (error) {
        void vscode.window.showErrorMessage(`Ladder: ${reasonOf(error)}`);
    }
}

/** Starts the program of the active editor, or the scenario at its cursor. */
export async function startDebugging(): Promise<void> {
    const file = activeFile();
    const folder = file && vscode.workspace.getWorkspaceFolder(vscode.Uri.file(file.path));
    const configuration = completed({}, file);
    if (configuration) {
        await vscode.debug.startDebugging(folder, configuration as vscode.DebugConfiguration);
    }
}

export function registerDebugger(server: Server, simulation: Simulation): vscode.Disposable {
    const { Dynamic } = vscode.DebugConfigurationProviderTriggerKind;
    return vscode.Disposable.from(
        vscode.debug.registerDebugConfigurationProvider(TYPE, new Configurations()),
        vscode.debug.registerDebugConfigurationProvider(TYPE, programs, Dynamic),
        vscode.debug.registerDebugAdapterDescriptorFactory(TYPE, new Adapters(server, simulation)),
        vscode.languages.registerEvaluatableExpressionProvider({ language: 'clad' }, values),
    );
}
