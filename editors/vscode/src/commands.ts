// The commands of package.json.
import * as vscode from 'vscode';

import { askValue, pickTag } from './prompts.ts';
import type { Tag } from './protocol.ts';
import { runScenarios } from './scenarios.ts';
import type { Server } from './server.ts';
import type { Simulation } from './simulation.ts';
import { toggleCommentInEditor } from './toggleComment.ts';

/** Sets or forces the tag of a row of the view, or one that is asked for. */
async function assign(simulation: Simulation, name: 'set' | 'force', given: Tag | undefined): Promise<void> {
    const state = simulation.current?.state;
    if (!state) {
        return;
    }
    const verb = name === 'set' ? 'Set' : 'Force';
    const settable = (tag: Tag) => name === 'force' || tag.role !== 'output';
    const tag = given ?? (await pickTag(state, `${verb} Tag`, settable));
    const value = tag && (await askValue(tag, `${verb} ${tag.name}`));
    if (tag && value !== undefined) {
        await simulation.command(name, { tag: tag.name, value });
    }
}

async function release(simulation: Simulation, given: Tag | undefined): Promise<void> {
    const state = simulation.current?.state;
    const tag = given ?? (state && (await pickTag(state, 'Release Force', ({ forced }) => forced)));
    if (tag) {
        await simulation.command('unforce', { tag: tag.name });
    }
}

async function toggle(simulation: Simulation, given: Tag | undefined): Promise<void> {
    const state = simulation.current?.state;
    const isBoolInput = ({ role, value }: Tag) => role === 'input' && typeof value === 'boolean';
    const tag = given ?? (state && (await pickTag(state, 'Toggle Tag', isBoolInput)));
    if (tag) {
        await simulation.toggle(tag.name);
    }
}

export function registerCommands(server: Server, simulation: Simulation): vscode.Disposable {
    const commands: Record<string, (tag?: Tag) => unknown> = {
        'ladder.simulation.start': () => simulation.start(),
        'ladder.simulation.step': () => simulation.command('step', { scans: 1 }),
        'ladder.simulation.run': () => simulation.command('run', {}),
        'ladder.simulation.pause': () => simulation.pause(),
        'ladder.simulation.reset': () => simulation.command('reset', {}),
        'ladder.simulation.stop': () => simulation.stop(),
        'ladder.simulation.set': (tag) => assign(simulation, 'set', tag),
        'ladder.simulation.force': (tag) => assign(simulation, 'force', tag),
        'ladder.simulation.unforce': (tag) => release(simulation, tag),
        'ladder.simulation.toggle': (tag) => toggle(simulation, tag),
        'ladder.test': () => runScenarios(server.program()),
        'ladder.toggleComment': () => toggleCommentInEditor(),
        'ladder.restartServer': () => server.restart(),
        'ladder.showLog': () => server.log.show(),
    };
    return vscode.Disposable.from(
        ...Object.entries(commands).map(([name, run]) => vscode.commands.registerCommand(name, run)),
    );
}
