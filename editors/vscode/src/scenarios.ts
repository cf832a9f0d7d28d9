// The scenarios of a file, run in a terminal.
import * as vscode from 'vscode';

const NAME = 'Ladder Scenarios';

/**
 * Saves a file of scenarios, that of the active editor if none is named, and runs `ladder test` on it. The shell is
 * passed by: nothing needs quotes.
 */
export async function runScenarios(program: string | undefined, uri?: string): Promise<void> {
    if (program === undefined) {
        void vscode.window.showWarningMessage(
            vscode.workspace.isTrusted
                ? 'Ladder: there is no program "ladder"; the log says more ("Ladder: Show Log").'
                : 'Ladder: nothing is run in a workspace that is not trusted.',
        );
        return;
    }
    const document =
        uri === undefined
            ? vscode.window.activeTextEditor?.document
            : await vscode.workspace.openTextDocument(vscode.Uri.parse(uri));
    if (!document || document.languageId !== 'ladder-test') {
        return;
    }
    await document.save();
    const folder = vscode.workspace.getWorkspaceFolder(document.uri);
    const execution = new vscode.ProcessExecution(program, ['test', '--', document.uri.fsPath]);
    const task = new vscode.Task(
        { type: 'process' },
        folder ?? vscode.TaskScope.Workspace,
        NAME,
        'ladder',
        execution,
    );
    task.presentationOptions = { clear: true, reveal: vscode.TaskRevealKind.Always, showReuseMessage: false };
    await vscode.tasks.executeTask(task);
}
