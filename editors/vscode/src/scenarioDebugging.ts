// A scenario in the debugger.
import * as vscode from 'vscode';

/**
 * Debugs one scenario. @returns its exit status; none if it was ended before
 *
 * @param text of a file of scenarios, in the place of what is on disk: then it stops before its first scan
 */
export async function debugOne(
    file: vscode.Uri,
    scenario: string,
    token: vscode.CancellationToken,
    text?: string,
): Promise<number | undefined> {
    let status: number | undefined;
    let session: vscode.DebugSession | undefined;
    const name = `Scenario "${scenario}"`;
    const tracker = vscode.debug.registerDebugAdapterTrackerFactory('ladder', {
        createDebugAdapterTracker(started) {
            if (started.name !== name) {
                return undefined;
            }
            session = started;
            return {
                onDidSendMessage(message: { event?: string; body?: { exitCode?: number } }) {
                    if (message.event === 'exited') {
                        status = message.body?.exitCode;
                    }
                },
            };
        },
    });
    try {
        const ended = new Promise<void>((resolve) => {
            const listener = vscode.debug.onDidTerminateDebugSession((over) => {
                if (over === session) {
                    listener.dispose();
                    resolve();
                }
            });
        });
        const folder = vscode.workspace.getWorkspaceFolder(file);
        const given = text === undefined ? {} : { scenarioText: text, stopOnEntry: true };
        const configuration = { type: 'ladder', request: 'launch', name, scenarioFile: file.fsPath, scenario, ...given };
        if (!(await vscode.debug.startDebugging(folder, configuration))) {
            return undefined;
        }
        token.onCancellationRequested(() => void vscode.debug.stopDebugging(session));
        await ended;
        return status;
    } finally {
        tracker.dispose();
    }
}
