// The playground: puts its parts together.
import type { Range } from '../../panels/protocol.ts';
import { reasonOf } from '../../panels/reason.ts';
import { setUp } from './editors.ts';
import { byId, setText } from './element.ts';
import { type Example, examples } from './examples.ts';
import { save, stemOf, toCsv, toPng, toSvg } from './exports.ts';
import { read, takeFiles } from './foreign.ts';
import { fromFragment, type Linked, nameOf, toFragment } from './link.ts';
import { type Item, menu } from './menu.ts';
import { theme } from './appearance.ts';
import { simulationKeys, Toolbar } from './toolbar.ts';
import { formatDocument } from '@codemirror/lsp-client';

const KEPT = 'ladder.program';

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

const { server, program, scenarios, simulation, panels, documents } = setUp(say);
const { trace } = panels;
theme((chosen) => panels.frames.forEach((frame) => (frame.theme = chosen)));
panels.onReady(() => panels.frames.forEach((frame) => (frame.theme = document.documentElement.dataset['theme'] ?? '')));

/** Another program takes the place of the one that is there. */
async function open({ name, text, scenarios: tests }: Linked): Promise<void> {
    await simulation.stop();
    program.open(name, text);
    scenarios.open(`${stemOf(name)}.ladder-test`, tests ?? '');
    panels.forget();
    documents.title('program', name);
    documents.title('scenarios', scenarios.name);
    documents.choose('program');
    document.title = `${name} – Ladder playground`;
    keep();
}

const here = (): Linked => ({ name: program.name, text: program.text, scenarios: scenarios.text });

/** What was typed is there again when the page is. */
function keep(): void {
    localStorage.setItem(KEPT, JSON.stringify(here()));
}

window.addEventListener('pagehide', keep);
document.addEventListener('visibilitychange', () => document.hidden && keep());

function kept(): Linked | undefined {
    try {
        const read = JSON.parse(localStorage.getItem(KEPT) ?? 'null') as Partial<Linked> | null;
        return typeof read?.text === 'string' ? { name: nameOf(read.name), text: read.text, ...(typeof read.scenarios === 'string' ? { scenarios: read.scenarios } : {}) } : undefined;
    } catch {
        return undefined;
    }
}

const step = byId('step');
let all: readonly Example[] = [];

function openExample(example: Example): void {
    void open(example);
    const group = all.filter(({ group }) => group === example.group);
    const at = group.indexOf(example);
    const link = (title: string, to: Example | undefined) => {
        const button = document.createElement('button');
        button.type = 'button';
        button.textContent = title;
        button.disabled = !to;
        button.addEventListener('click', () => to && openExample(to));
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
    for (const file of files) {
        const opened = await read(server, file);
        if (opened.name.endsWith('.ladder-test')) {
            scenarios.open(`${stemOf(program.name)}.ladder-test`, opened.text);
            documents.choose('scenarios');
        } else {
            await open({ name: nameOf(opened.name), text: opened.text });
        }
        say(opened.summary ?? `${file.name} is open.`);
        if (opened.report !== undefined) {
            panels.report(opened.report);
        }
    }
}

async function share(): Promise<void> {
    const address = new URL(location.href);
    address.hash = await toFragment(here());
    history.replaceState(null, '', address);
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
    const { notations } = await server.execute('ladder.notations', {});
    const others = notations.map(({ name: to, title }): Item => ({
        title: `As ${title}`,
        act: () =>
            void orSay(async () => {
                const converted = await server.execute('ladder.convert', { uri: program.uri, to });
                save(`${stem}.${converted.extension || 'txt'}`, converted.text);
                say(`${converted.translated} translated, ${converted.approximated} approximated, ${converted.refused} refused.`);
            }),
    }));
    return [...own, ...others];
}

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
    const loading = examples(openExample).then((loaded) => (all = loaded));
    let linked: Linked | undefined;
    try {
        linked = await fromFragment(location.hash);
    } catch (error) {
        say(`This link cannot be read: ${reasonOf(error)}`);
    }
    const known = linked ?? kept();
    if (known) {
        await open(known);
    } else {
        await loading;
        const first = all[0];
        if (first) {
            await open(first);
        }
    }
}

window.addEventListener('hashchange', () => void orSay(async () => {
    const linked = await fromFragment(location.hash);
    if (linked) {
        await open(linked);
    }
}));
void orSay(begin).then(() => void trace.tell());
