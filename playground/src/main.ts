// The playground: puts its parts together.
import type { Range } from '../../panels/protocol.ts';
import { reasonOf } from '../../panels/reason.ts';
import { setUp } from './editors.ts';
import { byId, setText } from './element.ts';
import { type Example, examples } from './examples.ts';
import { save, saveIn, stemOf, toCsv, toPng, toSvg } from './exports.ts';
import { read, takeFiles } from './foreign.ts';
import { fromFragment, type Linked, toFragment } from './link.ts';
import { type Item, menu } from './menu.ts';
import { Programs } from './programs.ts';
import { withoutNetwork } from './withoutNetwork.ts';
import { theme } from './appearance.ts';
import { simulationKeys, Toolbar } from './toolbar.ts';
import { formatDocument } from '@codemirror/lsp-client';

const spoken = byId('status');
const shown = byId('message');
let later: ReturnType<typeof setTimeout> | undefined;

/** Says something aloud only: what is seen elsewhere. */
function announce(text: string): void {
    setText(spoken, text);
}

/** Says something in the page, and aloud. */
function say(text: string): void {
    const sentence = text.charAt(0).toUpperCase() + text.slice(1);
    announce(sentence);
    setText(shown, sentence);
    shown.hidden = false;
    clearTimeout(later);
    later = setTimeout(() => (shown.hidden = true), Math.max(4000, text.length * 90));
}

async function orSay(work: () => Promise<void>): Promise<void> {
    try {
        await work();
    } catch (error) {
        say(reasonOf(error));
    }
}

/** Says in the page what a person has to wait for. */
function busy(text?: string): void {
    if (text === undefined) {
        shown.hidden = true;
    } else {
        say(text);
        clearTimeout(later);
    }
}

const { server, complete, program, scenarios, simulation, panels, documents } = setUp(say, busy);
const { trace } = panels;
theme((chosen) => panels.frames.forEach((frame) => (frame.theme = chosen)));
panels.onReady(() => panels.frames.forEach((frame) => (frame.theme = document.documentElement.dataset['theme'] ?? '')));

const back = byId('back') as HTMLButtonElement;
const programs = new Programs(program, scenarios, {
    message: say,
    opened() {
        void simulation.stop();
        panels.forget(programs.files);
        documents.title('program', program.name);
        documents.title('scenarios', scenarios.name);
        document.title = `${program.name} – Ladder playground`;
        step.hidden = true;
        const { before } = programs;
        back.disabled = !before;
        back.title = before ? `Brings back what was open before: ${before.name}` : 'Nothing was open before';
    },
});

/** Another program is opened next to the one that is there. */
async function open(linked: Linked): Promise<void> {
    await simulation.stop();
    programs.open(linked);
    documents.choose('program');
}

const step = byId('step');
let all: readonly Example[] = [];

async function openExample({ name, text, scenarios: tests, files, ...example }: Example): Promise<void> {
    await open({ name, text, ...(tests === undefined ? {} : { scenarios: tests }), ...(files === undefined ? {} : { files }) });
    const group = all.filter(({ group }) => group === example.group);
    const at = group.findIndex(({ title }) => title === example.title);
    const link = (title: string, to: Example | undefined) => {
        const button = document.createElement('button');
        button.type = 'button';
        button.textContent = title;
        button.disabled = !to;
        button.addEventListener('click', () => to && void openExample(to));
        return button;
    };
    const chapter = document.createElement('a');
    chapter.href = `../${example.chapter ?? ''}`;
    chapter.target = '_blank';
    chapter.textContent = 'Read about it';
    step.hidden = example.chapter === undefined;
    step.replaceChildren(`${example.group}: ${example.title} `, chapter, link('Previous', group[at - 1]), link('Next', group[at + 1]));
    say(`${example.title} is open.`);
}

async function openFiles(files: readonly File[]): Promise<void> {
    for (const { program: one, summary, report } of await read(complete, files, programs.current)) {
        await open(one);
        if (one.scenarios !== undefined) {
            documents.choose('scenarios');
        }
        say(summary);
        if (report !== undefined) {
            panels.report(report);
        }
    }
}

async function share(): Promise<void> {
    const address = new URL(location.href);
    address.hash = await toFragment(programs.current);
    history.replaceState(null, '', address);
    programs.isLinked();
    try {
        await navigator.clipboard.writeText(address.href);
        say('The link is copied: it holds the program itself, and nothing was sent anywhere.');
    } catch {
        say('The link is in the address bar: it holds the program itself, and nothing was sent anywhere.');
    }
}

async function exportItems(): Promise<readonly Item[]> {
    const stem = stemOf(program.name);
    const own: Item[] = [
        { title: `Program (${program.name})`, act: () => save(program.name, program.text) },
        { title: `Scenarios (${scenarios.name})`, act: () => save(scenarios.name, scenarios.text) },
        { title: 'Picture (SVG)', act: () => void orSay(async () => save(`${stem}.svg`, await toSvg(server, program), 'image/svg+xml')) },
        { title: 'Picture (PNG)', act: () => void orSay(async () => save(`${stem}.png`, await toPng(await toSvg(server, program)))) },
        { title: 'Trace of the simulation (CSV)', act: () => void orSay(async () => save(`${stem}.csv`, await toCsv(simulation), 'text/csv')) },
    ];
    try {
        const { notations } = await complete.execute('ladder.notations', {}, {});
        return [...own, ...notations.map(({ name: to, title }): Item => ({
            title: `As ${title}`,
            act: () => void orSay(async () => say(await saveIn(to, complete, program))),
        }))];
    } catch (error) {
        say(reasonOf(error));
        return own;
    }
}

back.addEventListener('click', () => void orSay(async () => {
    await simulation.stop();
    await programs.back();
}));
byId('share').addEventListener('click', () => void orSay(share));
byId('format').addEventListener('click', () => formatDocument((documents.chosen === 'scenarios' ? scenarios : program).view));
menu(byId('export') as HTMLButtonElement, exportItems);
takeFiles(byId('open') as HTMLButtonElement, byId('file') as HTMLInputElement, (files) => void orSay(() => openFiles(files)));

const why = async (): Promise<void> => {
    const range: Range['start'] = program.place(program.view.state.selection.main.head);
    const tag = simulation.operandAt(range)?.tags[0];
    await (tag === undefined ? say('There is no tag at the cursor.') : panels.why(tag));
};
/** What a click does is said once. */
let hasHint = false;
const toolbar = new Toolbar(byId('simulation'), simulation, announce);
simulationKeys(simulation, {
    toggle: async () => {
        const tag = simulation.operandAt(program.place(program.view.state.selection.main.head))?.tags[0];
        await (tag === undefined ? say('There is no tag at the cursor.') : simulation.toggle(tag));
    },
    why,
});
simulation.onChange(() => {
    toolbar.show();
    if (simulation.isRunning && !hasHint && document.querySelector('.switch')) {
        hasHint = true;
        say('Click a contact of an input, in the text or in the diagram, to switch it.');
    }
});

async function begin(): Promise<void> {
    const loading = examples((example) => void openExample(example)).then((loaded) => (all = loaded));
    const [navigation] = performance.getEntriesByType('navigation') as PerformanceNavigationTiming[];
    const isAgain = location.hash === '' || navigation?.type !== 'navigate';
    if (isAgain && (await programs.restore(true))) {
        return;
    }
    try {
        const linked = await fromFragment(location.hash);
        if (linked) {
            programs.openLinked(linked);
            return;
        }
    } catch (error) {
        say(`This link cannot be read: ${reasonOf(error)}`);
    }
    if (!(await programs.restore(false))) {
        await loading;
        const first = all[0];
        if (first) {
            await open(first);
            // Who comes for the first time sees at once what this is.
            await simulation.start();
            say('The program runs, and its machine with it: press the buttons of the picture, and see what lights up in the text.');
        }
    }
}

window.addEventListener('hashchange', () => void orSay(async () => {
    const linked = await fromFragment(location.hash);
    if (linked) {
        await simulation.stop();
        programs.openLinked(linked);
    }
}));
void withoutNetwork(byId('offline'), say);
void orSay(begin).then(() => void trace.tell());
