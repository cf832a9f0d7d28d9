// Tasks that check, test and align the workspace, with their findings under *Problems*.
import { homedir } from 'node:os';

import * as vscode from 'vscode';

import type { Server } from './server.ts';
import { taskArguments, type Work } from './taskArguments.ts';

const TYPE = 'ladder';

const TITLES: Record<Work, string> = { check: 'check', test: 'test', format: 'format' };

interface Definition extends vscode.TaskDefinition {
    readonly command: Work;
    readonly path?: string;
}

class Tasks implements vscode.TaskProvider {
    readonly #server: Server;

    constructor(server: Server) {
        this.#server = server;
    }

    provideTasks(): vscode.Task[] {
        const folders = vscode.workspace.workspaceFolders ?? [];
        return folders.flatMap((folder) => (['check', 'test', 'format'] as const).flatMap((command) => this.#task({ type: TYPE, command }, folder) ?? []));
    }

    resolveTask(task: vscode.Task): vscode.Task | undefined {
        const definition = task.definition as Definition;
        const folder = typeof task.scope === 'object' ? task.scope : vscode.workspace.workspaceFolders?.[0];
        return folder && definition.command in TITLES ? this.#task(definition, folder) : undefined;
    }

    #task(definition: Definition, folder: vscode.WorkspaceFolder): vscode.Task | undefined {
        const program = this.#server.program();
        if (program === undefined) {
            return undefined;
        }
        const args = taskArguments(definition.command, folder.uri.fsPath, definition.path);
        // The shell is passed by, and the program is not started where others may have put libraries.
        const execution = new vscode.ProcessExecution(program, args, { cwd: homedir() });
        // What the check finds the server has found before, in closed files, too: under Problems each would be twice.
        const ofCheck = this.#server.isRunning() ? [] : ['$ladder'];
        const matchers = { check: ofCheck, test: ['$ladder-test', '$ladder-scenario-error'], format: [] }[definition.command];
        const task = new vscode.Task(definition, folder, TITLES[definition.command], TYPE, execution, matchers);
        if (definition.command === 'test') {
            task.group = vscode.TaskGroup.Test;
        } else if (definition.command === 'check') {
            task.group = vscode.TaskGroup.Build;
        }
        task.presentationOptions = { clear: true, showReuseMessage: false };
        return task;
    }
}

export function registerTasks(server: Server): vscode.Disposable {
    return vscode.tasks.registerTaskProvider(TYPE, new Tasks(server));
}
