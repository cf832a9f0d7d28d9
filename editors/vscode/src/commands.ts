// The commands of package.json.
import * as vscode from 'vscode';

import { CLICK, type Click } from './click.ts';
import { convert, exportAs } from './conversion.ts';
import { showReferences } from './lenses.ts';
import { askValue, pickTag } from './prompts.ts';
import type { Tag } from './protocol.ts';
import { runScenarios } from './scenarios.ts';
import type { Server } from './server.ts';
import { tagHere } from './tagHere.ts';
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

async function breakOnChange(simulation: Simulation, given: Tag | undefined): Promise<void> {
    const state = simulation.current?.state;
    const tag = given ?? (state && (await pickTag(state, 'Break on Change', () => true)));
    if (tag) {
        await simulation.toggleBreakOnChange(tag.name);
    }
}

/** Tells why the tag of a row, or the one at the cursor, holds what it holds. */
async function why(simulation: Simulation, given: Tag | undefined): Promise<void> {
    const session = simulation.current;
    if (!session) {
        return;
    }
    const editor = vscode.window.activeTextEditor;
    const here = editor?.document === session.document ? editor.selection.active : undefined;
    const word = here && tagHere(session.document.lineAt(here.line).text, here.character, session.state.tags);
    const name = given?.name ?? word ?? (await pickTag(session.state, 'Why', () => true))?.name;
    const told = name === undefined ? undefined : await simulation.why(name);
    if (!told) {
        return;
    }
    const [first, ...deeper] = told.text.split('\n');
    const showAll = 'Show All';
    const chosen = await vscode.window.showInformationMessage(`Ladder: ${first}`, ...(deeper.length > 0 ? [showAll] : []));
    if (chosen === showAll) {
        const document = await vscode.workspace.openTextDocument({ content: `${told.text}\n`, language: 'plaintext' });
        await vscode.window.showTextDocument(document, vscode.ViewColumn.Beside, true);
    }
}

/** Starts a simulation; of a Click program that of its diagram, which shows the power. */
async function start(click: Click, simulation: Simulation): Promise<void> {
    const document = vscode.window.activeTextEditor?.document;
    if (document?.languageId !== CLICK) {
        await simulation.start();
        return;
    }
    const drawing = await click.show(document);
    if (drawing) {
        await simulation.start(drawing);
    }
}

export function registerCommands(server: Server, simulation: Simulation, click: Click): vscode.Disposable {
    // A command comes with the tag of a row, a lens with the address of its file, the palette with nothing.
    const commands: Record<string, (given?: any) => unknown> = {
        'ladder.simulation.start': () => start(click, simulation),
        'ladder.simulation.step': () => simulation.command('step', { scans: 1 }),
        'ladder.simulation.stepBlock': () => simulation.command('stepBlock', {}),
        'ladder.simulation.stepRung': () => simulation.command('stepRung', {}),
        'ladder.simulation.back': () => simulation.command('back', { scans: 1 }),
        'ladder.simulation.run': () => simulation.command('run', {}),
        'ladder.simulation.pause': () => simulation.pause(),
        'ladder.simulation.reset': () => simulation.command('reset', {}),
        'ladder.simulation.warmRestart': () => simulation.command('warmRestart', {}),
        'ladder.simulation.stop': () => simulation.stop(),
        'ladder.simulation.set': (tag) => assign(simulation, 'set', tag),
        'ladder.simulation.force': (tag) => assign(simulation, 'force', tag),
        'ladder.simulation.unforce': (tag) => release(simulation, tag),
        'ladder.simulation.toggle': (tag) => toggle(simulation, tag),
        'ladder.test': (uri?: unknown) => runScenarios(server.program(), typeof uri === 'string' ? uri : undefined),
        'ladder.simulation.breakOnChange': (tag) => breakOnChange(simulation, tag),
        'ladder.simulation.why': (tag) => why(simulation, tag),
        // Not `ladder.convert`: the client registers the server's commands under their own names.
        'ladder.convertFile': (uri) => convert(server, uri),
        'ladder.exportAs': (uri) => exportAs(server, uri),
        'ladder.click.open': () => click.open(),
        'ladder.click.preview': () => click.preview(),
        'ladder.toggleComment': () => toggleCommentInEditor(),
        'ladder.restartServer': () => server.restart(),
        'ladder.showLog': () => server.log.show(),
    };
    return vscode.Disposable.from(
        vscode.commands.registerCommand('ladder.showReferences', showReferences),
        ...Object.entries(commands).map(([name, run]) => vscode.commands.registerCommand(name, run)),
    );
}
