// The extension's beginning and end: what there is, and what is wired to what.
import * as vscode from 'vscode';

import type { MarkedLine } from '../../../panels/compare/marks.ts';
import type { State } from '../../../panels/protocol.ts';
import { offerTools } from './assistants.ts';
import { Click } from './click.ts';
import { registerCommands } from './commands.ts';
import { Comparisons } from './compare/comparisons.ts';
import { ReviewMarks } from './compare/marks.ts';
import { ComparePanels } from './compare/panel.ts';
import { CrossReferenceView } from './crossReferenceView.ts';
import { registerDebugger } from './debugger.ts';
import { showPower } from './decorations.ts';
import { DiagramEditors } from './diagram/editor.ts';
import { showFaults } from './faults.ts';
import { FilledSnippet } from './filledSnippet.ts';
import { liveHovers } from './hover.ts';
import { lensesFollow } from './lenses.ts';
import { Fences } from './markdown/fences.ts';
import { showLibraryBlocks } from './libraryBlocks.ts';
import { showRulePages } from './rulePages.ts';
import { ScenePanels } from './scene/panels.ts';
import { Server } from './server.ts';
import { Simulation } from './simulation.ts';
import { showStatus } from './statusBar.ts';
import { showTags } from './tagsView.ts';
import { registerTasks } from './tasks.ts';
import { TestExplorer } from './testExplorer.ts';
import { TraceView } from './trace/traceView.ts';
import { sayTypedLine } from './typedLine.ts';
import { WatchList } from './watchList.ts';
import { WhyView } from './whyView.ts';

let server: Server | undefined;

/** What other extensions, and the end-to-end tests, may ask. */
export interface Api {
    /** The last state of the current simulation, with all that is known of what is shown. */
    state(): State | undefined;
    /** The marks next to what is not as HEAD has it. */
    marks(document: vscode.TextDocument): readonly MarkedLine[];
    /** What the preview of Markdown documents asks for. */
    extendMarkdownIt: Fences['plugin'];
}

export async function activate(context: vscode.ExtensionContext): Promise<Api> {
    server = new Server(context.extensionPath, String(context.extension.packageJSON.version));
    const simulation = new Simulation(server);
    const click = new Click(server);
    const tests = new TestExplorer(server);
    const fences = new Fences(
        (text) => server?.execute('ladder.fence', { text }) ?? Promise.reject(new Error('no server')),
        () => void vscode.commands.executeCommand('markdown.preview.refresh'),
    );
    const comparisons = new Comparisons(server);
    const marks = new ReviewMarks(comparisons);
    const views = {
        references: new CrossReferenceView(server),
        why: new WhyView(simulation),
        trace: new TraceView(simulation, context),
        diagrams: new DiagramEditors(context.extensionUri, server, simulation),
        compare: new ComparePanels(context.extensionUri, comparisons),
        scenes: new ScenePanels(context.extensionUri, server, simulation),
    };
    context.subscriptions.push(
        server,
        simulation,
        click,
        fences,
        server.onDidStart(() => fences.begin()),
        views.references,
        views.why,
        views.trace,
        views.diagrams,
        views.compare,
        views.scenes,
        marks,
        comparisons,
        registerCommands(server, simulation, click, tests, views),
        registerDebugger(server, simulation),
        registerTasks(server),
        tests,
        lensesFollow(server, simulation),
        liveHovers(server, simulation),
        showPower(simulation),
        showFaults(simulation),
        showStatus(simulation),
        showTags(simulation, new WatchList(context.workspaceState)),
        sayTypedLine(server),
        new FilledSnippet(),
        showRulePages(server),
        showLibraryBlocks(server),
        offerTools(server),
        vscode.workspace.onDidGrantWorkspaceTrust(() => server?.start()),
        vscode.workspace.onDidChangeConfiguration((event) => {
            if (event.affectsConfiguration('ladder.server.path')) {
                void server?.restart();
            }
        }),
    );
    await server.start();
    return {
        extendMarkdownIt: fences.plugin,
        marks: (document) => marks.lines(document),
        state: () => {
            const session = simulation.current;
            const power = [...(session?.power.values() ?? [])].flatMap((line) => [...line.values()]);
            return session && { ...session.state, commands: session.seen, tags: [...session.tags.values()], power };
        },
    };
}

export async function deactivate(): Promise<void> {
    await server?.stop();
}
