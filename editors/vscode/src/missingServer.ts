// What is offered where the language server is missing, and the wait until it is there.
import { existsSync, readFileSync, statSync } from 'node:fs';
import { homedir } from 'node:os';
import { join } from 'node:path';

import * as vscode from 'vscode';

const INSTALL = 'Install...';
const CHOOSE = 'Choose File...';
const SETTING = 'Open Setting';
const LOG = 'Show Log';

/** How often a missing program is looked for, in milliseconds: some files are asked whether they exist. */
const LOOK_AGAIN = 2000;

/** Whether a folder holds the project's source text, from which the server is built. */
export function isProject(folder: string): boolean {
    const manifest = join(folder, 'cli', 'Cargo.toml');
    return existsSync(manifest) && /^name = "ladder-cli"$/m.test(readFileSync(manifest, 'utf8'));
}

/** Builds and installs the server from the project's folder, in a terminal that can be seen. */
async function install(cargo: string | undefined): Promise<void> {
    if (cargo === undefined) {
        const rust = 'Get Rust';
        const text = 'The language server is built with Rust, and there is no program "cargo" here. Install Rust, then choose "Install..." again.';
        if ((await vscode.window.showWarningMessage(text, rust)) === rust) {
            await vscode.env.openExternal(vscode.Uri.parse('https://rustup.rs'));
        }
        return;
    }
    const [folder] =
        (await vscode.window.showOpenDialog({
            canSelectFiles: false,
            canSelectFolders: true,
            openLabel: 'Build and Install',
            title: 'The folder of the Ladder project, as it was cloned',
        })) ?? [];
    if (!folder) {
        return;
    }
    if (!isProject(folder.fsPath)) {
        void vscode.window.showErrorMessage(`"${folder.fsPath}" is not the folder of the Ladder project: it has no cli/Cargo.toml of that program.`);
        return;
    }
    // The shell is passed by: no name of a folder can be a command.
    const execution = new vscode.ProcessExecution(cargo, ['install', '--locked', '--path', join(folder.fsPath, 'cli')], { cwd: homedir() });
    const task = new vscode.Task({ type: 'ladder-install' }, vscode.TaskScope.Workspace, 'install the language server', 'Ladder', execution, []);
    task.presentationOptions = { reveal: vscode.TaskRevealKind.Always, clear: true };
    await vscode.tasks.executeTask(task);
}

/** Lets the user pick the program, and keeps it in the user's own settings. */
async function choose(): Promise<void> {
    const [file] = (await vscode.window.showOpenDialog({ openLabel: 'Use This Program', title: 'The program "ladder"' })) ?? [];
    if (file) {
        await vscode.workspace.getConfiguration('ladder.server').update('path', file.fsPath, vscode.ConfigurationTarget.Global);
    }
}

/** Says that the server is missing, and does what the user picks. */
export async function offer(message: string, log: vscode.LogOutputChannel, cargo: () => string | undefined): Promise<void> {
    switch (await vscode.window.showErrorMessage(message, INSTALL, CHOOSE, SETTING, LOG)) {
        case INSTALL:
            return install(cargo());
        case CHOOSE:
            return choose();
        case SETTING:
            await vscode.commands.executeCommand('workbench.action.openSettings', 'ladder.server.path');
            return;
        case LOG:
            log.show();
    }
}

/** A file as it is now: another program in its place has another mark. */
function mark(path: string | undefined): string {
    const file = path === undefined ? undefined : statSync(path, { throwIfNoEntry: false });
    return file ? `${path} ${file.size} ${file.mtimeMs}` : '';
}

/**
 * Waits until there is a program, or another one than now.
 *
 * @param find the place where it would be started from
 * @returns what ends the wait
 */
export function whenThere(find: () => string | undefined, act: () => void): vscode.Disposable {
    const before = mark(find());
    const timer = setInterval(() => {
        const now = mark(find());
        if (now !== '' && now !== before) {
            clearInterval(timer);
            act();
        }
    }, LOOK_AGAIN);
    return new vscode.Disposable(() => clearInterval(timer));
}
