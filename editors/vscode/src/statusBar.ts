// The status bar item: status, scan and simulated time of the current simulation.
import * as vscode from 'vscode';

import type { Simulation } from './simulation.ts';
import { statusText } from './statusText.ts';

export function showStatus(simulation: Simulation): vscode.Disposable {
    const item = vscode.window.createStatusBarItem('ladder.simulation', vscode.StatusBarAlignment.Left, 0);
    item.name = 'Ladder Simulation';
    item.command = 'ladder.tags.focus';
    const update = () => {
        const session = simulation.current;
        if (!session) {
            item.hide();
            return;
        }
        const { text, tooltip, warning } = statusText(session.state, session.speed);
        item.text = text;
        item.tooltip = tooltip;
        item.backgroundColor = warning ? new vscode.ThemeColor('statusBarItem.warningBackground') : undefined;
        item.show();
    };
    return vscode.Disposable.from(item, simulation.onDidChange(update));
}
