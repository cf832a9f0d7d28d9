// The two texts, what is around them, and how all of it hangs together.
import { closeBrackets, closeBracketsKeymap, completionKeymap } from '@codemirror/autocomplete';
import { defaultKeymap, historyKeymap } from '@codemirror/commands';
import { bracketMatching } from '@codemirror/language';
import { lintGutter, lintKeymap } from '@codemirror/lint';
import {
    findReferencesKeymap, formatKeymap, jumpToDefinitionKeymap, renameKeymap, signatureHelp,
} from '@codemirror/lsp-client';
import { highlightSelectionMatches, search, searchKeymap } from '@codemirror/search';
import { EditorState, type Extension } from '@codemirror/state';
import {
    drawSelection, dropCursor, EditorView, highlightActiveLine, highlightActiveLineGutter, highlightSpecialChars, keymap, lineNumbers, placeholder,
} from '@codemirror/view';

import { look } from './appearance.ts';
import { actionKeymap } from './actions.ts';
import { breakpoints } from './breakpoints.ts';
import { Complete } from './complete.ts';
import { completion } from './completion.ts';
import { DiagramPanel } from './diagramPanel.ts';
import { byId, element } from './element.ts';
import { findings } from './findings.ts';
import { hover } from './hover.ts';
import { clad, colours, ladderTest } from './language.ts';
import { followLinks } from './links.ts';
import { OpenText } from './openText.ts';
import { powerIn, showPower } from './power.ts';
import { ProblemsPanel } from './problemsPanel.ts';
import { marksOfRuns, ScenariosPanel } from './scenariosPanel.ts';
import { ScenePanel } from './scenePanel.ts';
import { Server } from './server.ts';
import { Simulation } from './simulation.ts';
import { Tabs } from './tabs.ts';
import { TagsPanel } from './tagsPanel.ts';
import { TracePanel } from './tracePanel.ts';
import { typing } from './typing.ts';
import { WhyPanel } from './whyPanel.ts';

/** What is in the place of scenarios where there are none. */
const EXAMPLE = `program motor.clad
step 100ms

scenario "it runs on after start is let go"
start  _-_
run => _--

(Write your own, for the tags of your program.)`;

const common: Extension = [
    lineNumbers(),
    drawSelection(),
    dropCursor(),
    highlightSpecialChars(),
    highlightActiveLine(),
    highlightActiveLineGutter(),
    highlightSelectionMatches(),
    bracketMatching(),
    closeBrackets(),
    search({ top: true }),
    lintGutter(),
    EditorState.tabSize.of(4),
    keymap.of([...closeBracketsKeymap, ...completionKeymap, ...lintKeymap, ...searchKeymap, ...historyKeymap, ...defaultKeymap]),
    look,
    colours,
    marksOfRuns,
];

const languageServer = [
    completion,
    signatureHelp(),
    keymap.of([...formatKeymap, ...renameKeymap, ...jumpToDefinitionKeymap, ...findReferencesKeymap]),
    actionKeymap,
];

const LOADING = 'What translates programs and proves is being loaded.';

/** @param busy says what a person has to wait for, until it is called with nothing */
export function setUp(say: (text: string) => void, busy: (text?: string) => void) {
    const server = new Server([...languageServer, findings((uri, found) => {
            problems.take(uri, found);
            diagram?.report(uri, found);
        })], {
        state: (state) => simulation.receive(state),
        debugger: (message) => simulation.receiveOfDebugger(message),
        message: say,
        failed(reason) {
            simulation.drop();
            const again = element('button', { type: 'button', onclick: () => { failure.hidden = true; server.restart(); diagram?.open(); } }, 'Start it again');
            failure.replaceChildren(`${reason} `, again);
            failure.hidden = false;
        },
    });
    const failure = byId('failure');
    const programPanel = byId('program');
    const scenariosText = byId('scenarios');
    const label = (text: string) => EditorView.contentAttributes.of({ 'aria-label': text, tabindex: '0' });
    const follow: Extension = EditorView.updateListener.of((update) => diagram?.followed(update));
    const program: OpenText = new OpenText(programPanel, server, 'program.clad', [
        breakpoints((lines) => simulation.setBreakpoints(lines)),
        common,
        clad,
        typing(server),
        powerIn(() => simulation, (offset) => program.place(offset)),
        follow,
        hover(() => simulation),
        label('Program'),
    ]);
    const scenarios: OpenText = new OpenText(scenariosText, server, 'program.ladder-test', [common, ladderTest, placeholder(EXAMPLE), typing(server), hover(() => undefined), label('Scenarios')]);
    const simulation: Simulation = new Simulation(server, program, { message: say, stopped: (range) => program.reveal(range.start) });
    const documents = new Tabs(byId('documents'), 'Texts', () => undefined);
    documents.add('program', program.name, programPanel);
    documents.add('scenarios', scenarios.name, scenariosText);
    const show = (text: OpenText) => documents.choose(text === program ? 'program' : 'scenarios');
    followLinks([program, scenarios], show);

    const tabs = new Tabs(byId('views'), 'Views', (id) => appear(id));
    const why = new WhyPanel(byId('why'), program, simulation);
    const ask = async (tag: string): Promise<void> => {
        tabs.choose('why');
        await why.ask(tag);
    };
    const problems: ProblemsPanel = new ProblemsPanel(byId('problems'), [program, scenarios], show, (count) => tabs.title('problems', count > 0 ? `Problems ${count}` : 'Problems'));
    const complete = new Complete((isLoading) => busy(isLoading ? LOADING : undefined));
    const runs = new ScenariosPanel(byId('runs'), server, complete, program, scenarios, simulation, say, show);
    const trace = new TracePanel(byId('traces'), simulation);
    const tags = new TagsPanel(byId('tags'), simulation, {
        why: (tag) => void ask(tag),
        trace: (tag) => void trace.add(tag).then(() => tabs.choose('traces')),
    });
    const moves = { start: () => simulation.start(), run: () => simulation.run(), pause: () => simulation.pause(), step: () => simulation.move('step'), back: () => simulation.move('back'), stop: () => simulation.stop() };
    const diagram: DiagramPanel | undefined = new DiagramPanel(byId('diagram'), program, server, simulation, { why: (tag) => void ask(tag), command: (name) => void moves[name]() });
    const scene = new ScenePanel(byId('scene'), server, simulation);
    const appear = (id: string) => {
        const views: Readonly<Record<string, () => void>> = { scene: () => scene.tell(), diagram: () => diagram.appear(), tags: () => tags.appear(), traces: () => void trace.tell() };
        views[id]?.();
    };
    for (const [id, title] of [['scene', 'Scene'], ['diagram', 'Diagram'], ['tags', 'Tags'], ['traces', 'Traces'], ['why', 'Why'], ['runs', 'Scenarios'], ['problems', 'Problems']] as const) {
        tabs.add(id, title, byId(id));
    }
    showPower(program, simulation, { ranges: () => why.stopping() });
    tabs.offer('scene', false, 'diagram');
    const frames = [scene.frame, diagram.frame, trace.frame];
    return {
        server,
        complete,
        program,
        scenarios,
        simulation,
        documents,
        panels: {
            trace,
            frames,
            why: ask,
            onReady: (ready: () => void) => byId('views').ownerDocument.querySelectorAll('iframe').forEach((frame) => frame.addEventListener('load', ready)),
            /** Another program is in the editor. */
            forget(files: Readonly<Record<string, string>>) {
                server.beside(files);
                const isThere = scene.open(files);
                tabs.offer('scene', isThere, 'diagram');
                if (isThere) {
                    tabs.choose('scene');
                }
                diagram.open();
                trace.forget();
                runs.forget();
            },
            /** What became of a program of another system. */
            report(text: string) {
                const dialog = byId('choice') as HTMLDialogElement;
                const close = element('button', { value: 'done' }, 'Close');
                dialog.replaceChildren(element('form', { method: 'dialog', class: 'report' }, element('h2', {}, 'What became of the program'), element('pre', { tabindex: '0', autofocus: true }, text), close));
                dialog.showModal();
            },
        },
    };
}
