// The status bar item: how the current simulation is, in the server's words.
import * as vscode from 'vscode';

import { Pace } from '../../../panels/pace.ts';
import type { Controller, State } from '../../../panels/protocol.ts';
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

const ONLINE = '$(radio-tower)';

/** What a controller that is watched has otherwise, and what is to be known of any. */
function onlineHelp({ name, differences = [] }: Controller): string {
    const about = `Values of the controller ${name}. Nothing is written to it. The values of one reading are not from one scan.`;
    return [about, ...differences].join('\n');
}

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
        const { status, text, stale, faults, forced, controller } = session.state;
        const isInDoubt = controller !== undefined && (!controller.answers || controller.differences !== undefined);
        const warning = stale || faults.length > 0 || forced > 0 || isInDoubt;
        session.isDrawing = true;
        item.text = `${controller ? ONLINE : icons[status]} Ladder: ${text}`;
        const about = controller ? onlineHelp(controller) : 'Simulation of the ladder program. Click to show its tags.';
        item.tooltip = stale ? STALE : (faults.at(-1)?.message ?? about);
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
