// The commands of package.json.
import * as vscode from 'vscode';

import type { Speed, Tag } from '../../../panels/protocol.ts';
import type { WhyRow } from '../../../panels/whyTree.ts';
import type { Click } from './click.ts';
import { convert, exportAs } from './conversion.ts';
import { isForeign, isProject } from './foreignProgram.ts';
import type { ComparePanels } from './compare/panel.ts';
import type { CrossReferenceView } from './crossReferenceView.ts';
import type { DiagramEditors } from './diagram/editor.ts';
import { editDrawing, toggleComment } from './edit.ts';
import { openExample } from './example.ts';
import { renameMadeUp, showReferences } from './lenses.ts';
import { askValue, pickTag } from './prompts.ts';
import { forceVariable, releaseVariable, startDebugging, stepBackScan } from './debugger.ts';
import { record } from './record.ts';
import type { ScenePanels } from './scene/panels.ts';
import type { Server } from './server.ts';
import type { Simulation } from './simulation.ts';
import { goToStop } from './tabStops.ts';
import type { TestExplorer } from './testExplorer.ts';
import type { TraceView } from './trace/traceView.ts';
import type { WhyView } from './whyView.ts';

/** The tag of a row, or the one at the cursor if it is wanted, or one that is asked for. */
async function chosen(
    simulation: Simulation,
    given: Tag | undefined,
    title: string,
    wanted: (tag: Tag) => boolean,
): Promise<Tag | undefined> {
    const session = simulation.current;
    if (!session || given) {
        return session && given && (session.tag(given.name) ?? given);
    }
    const here = simulation.operandHere()?.tags.flatMap((name) => session.tag(name) ?? []);
    return here?.find(wanted) ?? pickTag(await simulation.allTags(), title, wanted);
}

const isWritable = ({ readOnly }: Tag) => readOnly !== true;

/** Sets or forces a tag. */
async function assign(simulation: Simulation, name: 'set' | 'force', row: Tag | undefined): Promise<void> {
    const verb = name === 'set' ? 'Set' : 'Force';
    const tag = await chosen(simulation, row, `${verb} Tag`, isWritable);
    const given = tag && (await askValue(tag, `${verb} ${tag.name}`));
    if (tag && given) {
        await simulation.command(name, { tag: tag.name, ...given });
    }
}

async function release(simulation: Simulation, given: Tag | undefined): Promise<void> {
    const tag = await chosen(simulation, given, 'Release Force', ({ forced }) => forced);
    if (tag) {
        await simulation.command('unforce', { tag: tag.name });
    }
}

async function toggle(simulation: Simulation, given: Tag | undefined): Promise<void> {
    const isBool = (tag: Tag) => typeof tag.value === 'boolean' && isWritable(tag);
    const tag = await chosen(simulation, given, 'Toggle Tag', isBool);
    if (tag) {
        await simulation.toggle(tag);
    }
}

const isFreeBool = (tag: Tag) => typeof tag.value === 'boolean' && isWritable(tag) && !tag.forced;

/** A tag of BOOL has its other value for one scan. */
async function pulse(simulation: Simulation, given: Tag | undefined): Promise<void> {
    const tag = await chosen(simulation, given, 'Pulse Tag', isFreeBool);
    if (tag) {
        await simulation.command('pulse', { tag: tag.name });
    }
}

async function forceTo(simulation: Simulation, given: Tag | undefined, value: boolean): Promise<void> {
    const tag = await chosen(simulation, given, value ? 'Force On' : 'Force Off', isFreeBool);
    if (tag) {
        await simulation.command('force', { tag: tag.name, value });
    }
}

async function breakOnChange(simulation: Simulation, given: Tag | undefined): Promise<void> {
    const tag = await chosen(simulation, given, 'Break on Change', () => true);
    if (tag) {
        await simulation.toggleBreakOnChange(tag.name);
    }
}

/** Shows why a tag holds what it holds. */
async function why(simulation: Simulation, view: WhyView, given: Tag | undefined): Promise<void> {
    const tag = await chosen(simulation, given, 'Why', () => true);
    if (tag) {
        await view.ask(tag.name);
    }
}

/** Shows a tag in the trace. */
async function trace(simulation: Simulation, view: TraceView, given: Tag | undefined): Promise<void> {
    const tag = await chosen(simulation, given, 'Add to Trace', () => true);
    if (tag) {
        await view.add(tag.name);
    }
}

const speeds: readonly { readonly label: string; readonly description: string; readonly speed: Speed }[] = [
    { label: '0.01x', description: 'very slow motion', speed: { speed: 0.01 } },
    { label: '0.1x', description: 'slow motion', speed: { speed: 0.1 } },
    { label: '0.5x', description: 'half as fast as real time', speed: { speed: 0.5 } },
    { label: '1x', description: 'real time', speed: { speed: 1 } },
    { label: '2x', description: 'twice as fast', speed: { speed: 2 } },
    { label: '10x', description: 'ten times as fast', speed: { speed: 10 } },
    { label: '100x', description: 'a hundred times as fast', speed: { speed: 100 } },
    { label: 'max', description: 'as fast as it goes', speed: { realTime: false } },
];

async function setSpeed(simulation: Simulation): Promise<void> {
    const placeHolder = 'How fast a run goes';
    const picked = await vscode.window.showQuickPick(speeds, { title: 'Speed of the Simulation', placeHolder, matchOnDescription: true });
    if (picked) {
        await simulation.command('speed', picked.speed);
    }
}

/** Starts a simulation; of a program of another system that of its ladder text, which shows the power. */
async function start(click: Click, simulation: Simulation): Promise<void> {
    const document = vscode.window.activeTextEditor?.document;
    if (document && isProject(document)) {
        await simulation.start(document);
        return;
    }
    if (!document || !isForeign(document)) {
        await simulation.start();
        return;
    }
    const drawing = await click.show(document);
    if (drawing) {
        await simulation.start(drawing);
    }
}

/** Opens a diagram; of a program of another system that of its ladder text. */
async function openDiagram(click: Click, diagrams: DiagramEditors, given?: unknown): Promise<void> {
    const asked = given instanceof vscode.Uri ? given : vscode.window.activeTextEditor?.document.uri;
    const document = vscode.workspace.textDocuments.find(({ uri }) => uri.toString() === asked?.toString());
    if (!document || !isForeign(document)) {
        await diagrams.open(given);
        return;
    }
    const drawing = await click.drawing(document);
    if (drawing) {
        await diagrams.open(drawing.uri);
    }
}

export interface Views {
    readonly references: CrossReferenceView;
    readonly why: WhyView;
    readonly trace: TraceView;
    readonly diagrams: DiagramEditors;
    readonly compare: ComparePanels;
    readonly scenes: ScenePanels;
}

export function registerCommands(server: Server, simulation: Simulation, click: Click, tests: TestExplorer, views: Views): vscode.Disposable {
    // A command comes with the tag of a row, a lens with the address of its file, the palette with nothing.
    const commands: Record<string, (given?: any) => unknown> = {
        'ladder.simulation.start': () => start(click, simulation),
        'ladder.simulation.step': () => simulation.command('step', { scans: 1 }),
        'ladder.simulation.stepBlock': () => simulation.command('stepBlock', {}),
        'ladder.simulation.stepRung': () => simulation.command('stepRung', {}),
        'ladder.simulation.back': () => simulation.command('back', { scans: 1 }),
        'ladder.simulation.run': () => simulation.run(),
        'ladder.simulation.speed': () => setSpeed(simulation),
        'ladder.simulation.pause': () => simulation.pause(),
        'ladder.simulation.reset': () => simulation.command('reset', {}),
        'ladder.openExample': openExample,
        'ladder.crossReference.show': () => views.references.show(),
        'ladder.crossReference.filter': () => views.references.filter(),
        'ladder.simulation.record': () => record(simulation, tests),
        'ladder.simulation.warmRestart': () => simulation.command('warmRestart', {}),
        'ladder.simulation.stop': () => simulation.stop(),
        'ladder.simulation.serve': () => simulation.toggleServing(),
        'ladder.goOnline': () => simulation.goOnline(),
        'ladder.goOffline': () => simulation.stop(),
        'ladder.simulation.set': (tag) => assign(simulation, 'set', tag),
        'ladder.simulation.force': (tag) => assign(simulation, 'force', tag),
        'ladder.simulation.unforce': (tag) => release(simulation, tag),
        'ladder.simulation.toggle': (tag) => toggle(simulation, tag),
        'ladder.simulation.pulse': (tag) => pulse(simulation, tag),
        'ladder.simulation.forceOn': (tag) => forceTo(simulation, tag, true),
        'ladder.simulation.forceOff': (tag) => forceTo(simulation, tag, false),
        'ladder.openDiagram': (uri) => openDiagram(click, views.diagrams, uri),
        'ladder.openScene': (uri) => views.scenes.open(uri),
        'ladder.compareWithHead': (given) => views.compare.open(given),
        'ladder.diagram.reveal': (context) => views.diagrams.reveal(context),
        'ladder.diagram.breakpoint': (context) => views.diagrams.toggleBreakpoint(context),
        'ladder.diagram.check': () => views.diagrams.check(),
        'ladder.diagram.text': () => views.diagrams.showText(),
        'ladder.test': (uri?: unknown) => tests.runFile(typeof uri === 'string' ? uri : undefined),
        'ladder.test.whatMatters': () => tests.whatMatters(),
        'ladder.prove': (uri?: unknown, name?: unknown) =>
            tests.prove(typeof uri === 'string' ? uri : undefined, typeof name === 'string' ? name : undefined),
        'ladder.simulation.breakOnChange': (tag) => breakOnChange(simulation, tag),
        'ladder.simulation.why': (tag) => why(simulation, views.why, tag),
        'ladder.trace.add': (tag) => trace(simulation, views.trace, tag),
        'ladder.trace.choose': () => views.trace.pick(),
        'ladder.trace.show': () => views.trace.show(),
        // Not `ladder.convert`: the client registers the server's commands under their own names.
        'ladder.convertFile': (uri) => convert(server, uri),
        'ladder.exportAs': (uri) => exportAs(server, uri),
        'ladder.click.open': () => click.open(),
        'ladder.click.preview': () => click.preview(),
        'ladder.debug.start': () => startDebugging(),
        'ladder.debug.force': (row) => forceVariable(row),
        'ladder.debug.unforce': (row) => releaseVariable(row),
        'ladder.debug.stepBackScan': () => stepBackScan(),
        'ladder.toggleComment': () => toggleComment(server),
        'ladder.draw.contact': () => editDrawing(server, 'contact'),
        'ladder.draw.closedContact': () => editDrawing(server, 'closedContact'),
        'ladder.draw.coil': () => editDrawing(server, 'coil'),
        'ladder.draw.block': () => editDrawing(server, 'block'),
        'ladder.draw.branch': () => editDrawing(server, 'branch'),
        'ladder.draw.invert': () => editDrawing(server, 'invert'),
        'ladder.draw.delete': () => editDrawing(server, 'delete'),
        'ladder.draw.left': () => editDrawing(server, 'left'),
        'ladder.draw.right': () => editDrawing(server, 'right'),
        'ladder.draw.up': () => editDrawing(server, 'up'),
        'ladder.draw.down': () => editDrawing(server, 'down'),
        'ladder.nextStop': () => goToStop(false),
        'ladder.previousStop': () => goToStop(true),
        'ladder.restartServer': () => server.restart(),
        'ladder.showLog': () => server.log.show(),
    };
    return vscode.Disposable.from(
        vscode.commands.registerCommand('ladder.showReferences', showReferences),
        vscode.commands.registerCommand('ladder.rename', renameMadeUp),
        vscode.commands.registerCommand('ladder.simulation.why.open', (row: WhyRow) => views.why.open(row)),
        ...Object.entries(commands).map(([name, run]) => vscode.commands.registerCommand(name, run)),
    );
}
