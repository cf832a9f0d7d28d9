// The page of the diagram: puts its parts together and talks with the extension.
import type { FromPage, ToPage } from './messages.ts';
import type { Tools } from './draw/actions.ts';
import { Called } from './called.ts';
import { Aim } from './draw/aim.ts';
import { Asker } from './draw/asker.ts';
import { Band } from './draw/band.ts';
import { Clipboard } from './draw/clipboard.ts';
import { DeclarationsTable } from './draw/declarations.ts';
import { Drag } from './draw/drag.ts';
import { Field } from './draw/field.ts';
import { Findings } from './draw/findings.ts';
import { showKeys } from './draw/help.ts';
import { Menu } from './draw/menu.ts';
import { ModeSwitch } from './draw/mode.ts';
import { CONTACT, Palette } from './draw/palette.ts';
import { Pen } from './draw/pen.ts';
import { beginReorder } from './draw/reorder.ts';
import { rangeOf } from './draw/selection.ts';
import { openMenu } from './draw/selectionMenu.ts';
import { Hands } from './hands.ts';
import type { DrawableRow } from '../protocol.ts';
import { Inspector } from './inspector.ts';
import { Live } from './live.ts';
import { Page } from './page.ts';
import { describe } from './speech.ts';
import { Toolbar } from './toolbar.ts';

interface Saved {
    readonly scale?: number;
}

declare function acquireVsCodeApi(): {
    postMessage(message: FromPage): void;
    getState(): Saved | undefined;
    setState(state: Saved): void;
};

const SCALES = [0.5, 3] as const;

const editor = acquireVsCodeApi();
const send = (message: FromPage) => editor.postMessage(message);

function part(tag: string, className: string): HTMLElement {
    const node = document.createElement(tag);
    node.className = className;
    return node;
}

const bar = part('div', 'toolbar');
const view = part('div', 'view');
const canvas = part('div', 'canvas');
const empty = part('p', 'empty');
const strip = part('footer', 'inspector');
const spoken = part('div', 'spoken');
view.tabIndex = 0;
view.setAttribute('role', 'application');
spoken.setAttribute('role', 'status');
spoken.setAttribute('aria-live', 'polite');
/** Why something cannot be done: seen until something else is. */
const refusal = part('p', 'refusal');
refusal.setAttribute('role', 'alert');
refusal.hidden = true;
strip.setAttribute('aria-label', 'Tags of the element');
/** The first network of an empty program. */
const first = document.createElement('button');
first.type = 'button';
first.className = 'first';
first.textContent = 'New network';
first.title = 'The first network of the program (N)';
first.hidden = true;
view.append(canvas, empty, first);
// The strip of buttons is above, and the tabulator comes to the drawing first.
document.body.append(view, bar, strip, refusal, spoken);

const live = new Live();
const called = new Called();
const page = new Page(view, canvas, live, called, send);
const inspector = new Inspector(strip, send);
const toolbar = new Toolbar(bar, send, zoom);

const asker = new Asker(send);
const aim = new Aim(page, canvas);
const drag = new Drag(page, canvas, aim);
const voice = {
    said(text: string): void {
        refusal.hidden = true;
        say(called.sentence(text));
    },
    refused(text: string): void {
        refusal.textContent = text;
        refusal.hidden = false;
    },
};
const pen = new Pen(page, new Field(canvas), aim, asker.ask, voice, send);
const menu = new Menu(document.body, voice.refused);
const declarations = new DeclarationsTable(asker.ask, pen, (by) => void findings.go(by));
const findings: Findings = new Findings(page, asker.ask, menu, voice, (finding) => declarations.focusOn(finding));
strip.before(findings.node);
view.before(declarations.node);

/** Draws something where the focus is. */
async function drawHere(row: DrawableRow): Promise<void> {
    await pen.settled;
    const found = page.selection;
    if (!found) {
        voice.refused('Choose a place first: a wire, or an element');
        return;
    }
    palette.used(row);
    await (row.block === '( )' ? pen.coil(found) : pen.draw(row, found));
}

const palette = new Palette(asker.ask, called, {
    chosen: (row) => void drawHere(row),
    pressed: (row, event) =>
        drag.begin(
            event,
            row.block,
            ({ found, target, isShifted }) => {
                palette.used(row);
                const other = isShifted ? { '[ ]': '[/]', '( )': '(/)' }[row.block] : undefined;
                void pen.draw(other === undefined ? row : { ...row, block: other }, found, target);
            },
            () => void drawHere(row),
        ),
    branch: () => void pen.settled.then(() => pen.branch(CONTACT, 'below')),
});

const tools: Tools = {
    pen,
    clipboard: new Clipboard(pen),
    palette,
    findings,
    reveal: (found) => {
        const { start, end } = rangeOf(found);
        send({ type: 'reveal', from: start, to: end, focus: true });
    },
    menu: (found) => void openMenu(found, tools, menu),
    help: showKeys,
};

const mode = new ModeSwitch((mode) => {
    const isDraw = mode === 'draw';
    page.isDrawing = isDraw;
    document.body.classList.toggle('drawing-mode', isDraw);
    palette.node.hidden = !isDraw;
    declarations.node.hidden = !isDraw;
    declarations.outdate();
    refusal.hidden = true;
    pen.selection.forget();
    inspect();
    say(isDraw ? 'Draw: keys and the mouse change the program' : 'Operate: keys and the mouse switch its inputs');
});
first.addEventListener('click', () => {
    mode.set('draw');
    void pen.entry(undefined, 'below');
});
bar.prepend(mode.node);
bar.after(palette.node);
palette.node.hidden = true;
new Hands(view, page, live, send, inspect, {
    tools,
    drag,
    band: new Band(page, canvas, pen.selection),
    reorder: (event, drawing) => beginReorder(event, { drawing }, page, canvas, pen),
    mode,
    favourite: (number) => palette.favourite(number),
});

/** The size that a person has chosen; without one the diagram fits to the width of the page. */
let { scale: chosen } = editor.getState() ?? {};

function limited(scale: number): number {
    return Math.min(Math.max(scale, SCALES[0]), SCALES[1]);
}

function zoom(factor: number | undefined): void {
    chosen = factor === undefined ? undefined : limited(page.scale * factor);
    editor.setState(chosen === undefined ? {} : { scale: chosen });
    resize();
}

function resize(): void {
    const scale = limited(chosen ?? page.fitting);
    if (Math.abs(scale - page.scale) > 0.005) {
        page.zoom(scale);
    }
    toolbar.scale(page.scale);
}

/** The strip below is about the element that has the focus. */
function inspect(): void {
    const found = live.state && page.selection;
    const tags = found ? found.drawing.tagsOf(found.part, live) : [];
    const name = found ? [found.part.name, ...found.part.operands.map(({ text }) => text)].join(' ') : '';
    inspector.show(tags.length > 0 ? name : '', tags);
    findings.show(page.selection);
}

/** Said aloud when a person has done something, or the simulation is differently. */
function say(text: string): void {
    if (spoken.textContent !== text) {
        spoken.textContent = text;
    }
}

let status: string | undefined;
let elementSaid = '';

function speak(): void {
    const state = live.state;
    if (state?.status !== status) {
        status = state?.status;
        say(`Simulation ${state?.text ?? 'at rest'}`);
    }
    const found = page.selection;
    if (!found || !document.activeElement?.closest('g.element') || state?.status === 'running') {
        return;
    }
    const { drawing, part } = found;
    const power = live.power(drawing.first + part.at[0], part.at[1]);
    const words = describe({ ...part, operands: part.operands.map(({ text }) => text) }, power, drawing.tagsOf(part, live));
    const key = `${drawing.first}:${part.at.join(':')}`;
    // The reader itself says what gets the focus; what changes under it is said here.
    if (elementSaid.startsWith(`${key} `) && elementSaid !== `${key} ${words}`) {
        say(words);
    }
    elementSaid = `${key} ${words}`;
}

function receive(message: ToPage): void {
    switch (message.type) {
        case 'open':
            document.title = message.name;
            view.setAttribute('aria-label', `Ladder diagram of ${message.name}`);
            empty.textContent = '';
            called.named(message.names ?? 'iec');
            void palette.load().then(() => page.rename());
            page.open(message.version, message.lineCount, message.line);
            declarations.open();
            break;
        case 'edited':
            live.edit(message.changes);
            page.edit(message.version, message.lineCount, message.changes);
            declarations.outdate();
            break;
        case 'drawn':
            page.take(message.drawn);
            resize();
            page.makeReachable();
            empty.textContent = page.isEmpty && message.drawn.lineCount < 50 ? 'There is no network in this program yet.' : '';
            first.hidden = empty.textContent === '';
            inspect();
            break;
        case 'failed':
            page.fail(message.version);
            empty.textContent = page.isEmpty ? message.message : '';
            break;
        case 'live': {
            const isSimulated = live.state !== undefined;
            const changed = live.take(message.update);
            if (isSimulated !== (message.update !== undefined)) {
                mode.set(isSimulated ? 'draw' : 'operate');
            }
            document.body.classList.toggle('simulating', message.update !== undefined);
            page.show(changed);
            toolbar.show(message.update);
            inspect();
            speak();
            // When the frame is on the screen the next state may come.
            requestAnimationFrame(() => setTimeout(() => send({ type: 'painted' })));
            break;
        }
        case 'cursor':
            page.cursorAt(message.place);
            break;
        case 'findings':
            page.report(message.findings);
            declarations.report(message.findings);
            inspect();
            break;
        case 'reply':
            asker.take(message);
            break;
    }
}

window.addEventListener('message', ({ data }: MessageEvent<ToPage>) => receive(data));
view.addEventListener(
    'wheel',
    (event) => {
        if (event.ctrlKey) {
            event.preventDefault();
            zoom(event.deltaY < 0 ? 1.1 : 1 / 1.1);
        }
    },
    { passive: false },
);
new ResizeObserver(resize).observe(view);
resize();
mode.set('draw');
send({ type: 'ready' });
