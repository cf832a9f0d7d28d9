// The status bar item: status, scan and simulated time of the current simulation.
import * as vscode from 'vscode';

import { Pace } from './pace.ts';
import type { Simulation } from './simulation.ts';
import { statusText } from './statusText.ts';

/** Nobody reads it more often, and the editor lays its bar out anew each time. In milliseconds. */
const UPDATE_EVERY = 200;

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
        session.isDrawing = true;
        item.text = text;
        item.tooltip = tooltip;
        item.backgroundColor = warning ? new vscode.ThemeColor('statusBarItem.warningBackground') : undefined;
        item.show();
    };
    const pace = new Pace(UPDATE_EVERY, update);
    return vscode.Disposable.from(
        item,
        pace,
        simulation.onDidChange(() => pace.news(simulation.current?.state.status === 'running')),
    );
}
