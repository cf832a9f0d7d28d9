// The status bar item: how the current simulation is, in the server's words.
import * as vscode from 'vscode';

import { Pace } from '../../../panels/pace.ts';
import type { State } from '../../../panels/protocol.ts';
import type { Simulation } from './simulation.ts';

/** Nobody reads it more often, and the editor lays its bar out again each time. In milliseconds. */
const UPDATE_EVERY = 200;

const STALE = 'The text has errors; the last program without any runs on, and is shown in the lines that are still the same.';

const icons: Readonly<Record<State['status'], string>> = {
    running: '$(play)',
    paused: '$(debug-pause)',
    ended: '$(debug-stop)',
    faulted: '$(error)',
};

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
        const { status, text, stale, faults, forced } = session.state;
        const warning = stale || faults.length > 0 || forced > 0;
        session.isDrawing = true;
        item.text = `${icons[status]} Ladder: ${text}`;
        item.tooltip = stale ? STALE : (faults.at(-1)?.message ?? 'Simulation of the ladder program. Click to show its tags.');
        item.backgroundColor = warning ? new vscode.ThemeColor('statusBarItem.warningBackground') : undefined;
        item.show();
    };
    const pace = new Pace(UPDATE_EVERY, update);
    return vscode.Disposable.from(
        item,
        pace,
        simulation.onDidChange(() => pace.changed(simulation.current?.state.status === 'running')),
    );
}
