// The page of the trace: what it shows, and what keys and the pointer do. What is drawn comes from the server.
import type { FromPage, Situation, ToPage, Traced, TraceAsked } from './messages.ts';
import { Columns, edge } from './columns.ts';
import { across, letters, Row, type Sheet, toX } from './rows.ts';
import { draw as drawShapes, put, setText, shape } from './shapes.ts';
import { BEGINNING, EVERYTHING, follows, panned, type ScanWindow, showing, zoomed } from './scanWindow.ts';

interface Kept {
    readonly window: ScanWindow;
    /** What is kept as JSON has null where a cursor is not set. */
    readonly cursors: readonly (number | null | undefined)[];
}

declare function acquireVsCodeApi(): {
    postMessage(message: FromPage): void;
    getState(): Kept | undefined;
    setState(state: Kept): void;
};

const AXIS = 24;
/** From tick to tick, in pixels, at least. */
const TICK = 90;
/** A pointer that moves less far has clicked. */
const STILL = 4;
/** A cursor can be taken so far next to its line. */
const NEAR = 5;

const vscode = acquireVsCodeApi();
const find = <Kind extends HTMLElement>(id: string) => document.getElementById(id) as Kind;
const [trace, table, rowsElement, axisCell] = [find('trace'), find('table'), find('rows'), find('axis')];
const [place, measure, said, notice] = [find('place'), find('measure'), find('said'), find('notice')];
const axis = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
axis.setAttribute('aria-hidden', 'true');
axis.setAttribute('height', String(AXIS));
axisCell.append(axis);

const columns = new Columns();
const rows = new Map<string, Row>();
let situation: Situation = { running: false, tags: [] };
let traced: Traced | undefined;
const kept: Kept = vscode.getState() ?? { window: BEGINNING, cursors: [undefined, undefined] };
let shown = kept.window;
let cursors = kept.cursors.map((scan) => scan ?? undefined);
/** The cursor that keys move. */
let active = 0;
let selected: string | undefined;
let isAsking = false;
let isStale = true;

const send = (message: FromPage) => vscode.postMessage(message);
const cursorsSet = () => cursors.filter((scan): scan is number => scan !== undefined);
const width = () => Math.max(axisCell.clientWidth, 50);

/** Asks for what is to be drawn, unless an answer is awaited: then it is asked for again after that. */
function ask(): void {
    if (isAsking || !situation.session) {
        isStale = true;
        return;
    }
    isStale = false;
    isAsking = true;
    const asked: TraceAsked = {
        ...shown,
        columns: Math.min(width(), 4000),
        ticks: Math.max(Math.floor(width() / TICK), 1),
        cursors: cursorsSet(),
    };
    const span = shown.span ?? 0;
    const first = shown.last === undefined ? (traced?.first ?? 0) : Math.max(shown.last - span + 1, 1);
    const since = columns.since(asked, first, situation.tags);
    send({ kind: 'ask', session: situation.session, asked: since === undefined ? asked : { ...asked, since } });
}

function show(window: ScanWindow): void {
    shown = window;
    keep();
    ask();
}

function keep(): void {
    vscode.setState({ window: shown, cursors });
}

function take(message: ToPage): void {
    switch (message.kind) {
        case 'situation': {
            const isOther = message.situation.session !== situation.session;
            const isArranged = !isOther && message.situation.tags.join('\n') === situation.tags.join('\n');
            situation = message.situation;
            if (isOther) {
                columns.forget();
                traced = undefined;
                isAsking = false;
            }
            if (!isArranged) {
                arrange();
            }
            ask();
            return;
        }
        case 'refused':
            isAsking = false;
            return;
        case 'traced':
            if (message.session !== situation.session) {
                return;
            }
            isAsking = false;
            traced = message.traced;
            if (columns.take(message.asked, traced)) {
                requestAnimationFrame(draw);
            } else {
                isStale = true;
            }
            if (isStale) {
                ask();
            }
    }
}

/** A row for each tag, in their order. */
function arrange(): void {
    const names = new Set(situation.tags);
    for (const [name, row] of rows) {
        if (!names.has(name)) {
            row.element.remove();
            rows.delete(name);
        }
    }
    situation.tags.forEach((name, index) => {
        const row = rows.get(name) ?? new Row(name, { select, remove: (tag) => send({ kind: 'remove', tag }) });
        rows.set(name, row);
        if (rowsElement.children[index] !== row.element) {
            rowsElement.insertBefore(row.element, rowsElement.children[index] ?? null);
        }
    });
    if (selected === undefined || !names.has(selected)) {
        select(situation.tags[0]);
    }
    document.body.classList.toggle('idle', !situation.session);
    setText(notice, situation.session ? 'No tags are chosen: press Tags…' : 'Nothing is simulated.');
    notice.hidden = situation.session !== undefined && situation.tags.length > 0;
    table.hidden = !notice.hidden;
}

function select(tag: string | undefined): void {
    selected = tag;
    for (const [name, row] of rows) {
        row.select(name === tag);
    }
}

function draw(): void {
    if (!traced || !situation.session) {
        return;
    }
    const sheet: Sheet = { width: width(), traced, cursors };
    for (const tag of traced.tags) {
        rows.get(tag.name)?.draw(tag, columns.of(tag.name), sheet);
    }
    table.classList.toggle('with-A', cursors[0] !== undefined);
    table.classList.toggle('with-B', cursors[1] !== undefined);
    drawAxis(sheet);
    const time = (scan: number) => milliseconds(scan * (traced?.intervalMs ?? 0));
    setText(place, `scan ${traced.here}${traced.here < traced.newest ? ` of ${traced.newest}` : ''}, ${time(traced.here)}`);
    const times = traced.cursors?.times ?? [];
    const set = cursors.flatMap((scan, index) => (scan === undefined ? [] : [letters[index] ?? '']));
    const difference = traced.cursors?.difference === undefined ? [] : [`B − A ${traced.cursors.difference}`];
    setText(measure, [...set.map((letter, index) => `${letter} ${times[index] ?? ''}`), ...difference].join('   '));
    put(find('follow'), 'aria-pressed', String(follows(shown)));
    const clear = find<HTMLButtonElement>('clear');
    if (clear.disabled !== (cursorsSet().length === 0)) {
        clear.disabled = !clear.disabled;
    }
}

function milliseconds(time: number): string {
    return time < 1000 ? `${Math.round(time * 1000) / 1000} ms` : `${(time / 1000).toFixed(time < 60_000 ? 2 : 1)} s`;
}

function drawAxis(sheet: Sheet): void {
    const { traced, width } = sheet;
    put(axis, 'width', width);
    const ticks = traced.ticks.flatMap(({ at, text }) => {
        const x = toX(sheet, at);
        const anchor = x < 24 ? 'start' : x > width - 24 ? 'end' : 'middle';
        return [
            shape('line', { class: 'grid', x1: x, x2: x, y1: AXIS - 6, y2: AXIS }),
            shape('text', { class: 'tick', x, y: 11, 'text-anchor': anchor }, text),
        ];
    });
    // A click leads only to what is kept.
    const from = Math.max(toX(sheet, Math.max(traced.reach.first, 1)), 0);
    const to = Math.min(toX(sheet, traced.reach.last + 1), width);
    const kept = shape('line', { class: 'kept', x1: from, x2: Math.max(from, to), y1: AXIS - 1, y2: AXIS - 1 });
    const flags = cursors.flatMap((scan, index) => {
        const x = scan === undefined ? -1 : toX(sheet, scan + 0.5);
        if (x < 0 || x > width) {
            return [];
        }
        return [
            shape('rect', { class: `flag ${letters[index]}`, x: x - 7, y: 0, width: 14, height: 15, rx: 2 }),
            shape('text', { class: 'letter', x, y: 12, 'text-anchor': 'middle' }, letters[index]),
        ];
    });
    drawShapes(axis, [...ticks, ...across(sheet, AXIS), kept, ...flags]);
}

/** The scan at a place on the page. */
function scanAt(clientX: number): number {
    const { first, last } = traced ?? { first: 1, last: 1 };
    const x = clientX - axisCell.getBoundingClientRect().left;
    return first + (x / width()) * (last - first + 1);
}

const recorded = (scan: number) => Math.min(Math.max(Math.floor(scan), traced?.oldest ?? 1), traced?.newest ?? 1);

function setCursor(index: number, scan: number | undefined): void {
    cursors = cursors.map((before, at) => (at === index ? scan : before));
    active = index;
    keep();
    draw();
    ask();
}

function goTo(scan: number): void {
    if (!traced || situation.running) {
        return;
    }
    const { first, last } = traced.reach;
    if (scan < first || scan > last) {
        say(`Scan ${scan} is not kept any more; one can go to the scans from ${first} to ${last}.`);
        return;
    }
    send({ kind: 'goTo', scan });
}

function say(text: string): void {
    said.textContent = text;
}

/** Moves a cursor, and the window with it. */
function moveCursor(to: number): void {
    if (!traced) {
        return;
    }
    const scan = recorded(to);
    shown = showing(shown, traced, scan);
    setCursor(active, scan);
    const name = selected;
    const letter = letters[active] ?? '';
    afterAnswer = () => {
        const tag = traced?.tags.find((it) => it.name === name);
        const which = active === 1 && cursors[0] !== undefined ? 1 : 0;
        const value = tag ? `, ${tag.name} ${tag.readings?.[which] ?? 'not known'}` : '';
        say(`${letter} at ${traced?.cursors?.times[which] ?? ''}${value}`);
    };
}

let afterAnswer: (() => void) | undefined;

function key(event: KeyboardEvent): void {
    if (!traced || event.target instanceof HTMLButtonElement) {
        return;
    }
    const { first, last, per, oldest, newest, here } = traced;
    const span = last - first + 1;
    const cursor = cursors[active] ?? Math.min(here, newest);
    const step = event.shiftKey ? Math.max(Math.round(span / 20), per) : per;
    const jump = (way: 1 | -1) => {
        const to = selected && edge(columns.of(selected), Math.floor(cursor / per), way);
        if (to !== undefined && to !== '') {
            moveCursor(to * per);
        }
    };
    const pick = (by: number) => {
        const index = selected === undefined ? 0 : situation.tags.indexOf(selected) + by;
        select(situation.tags[Math.min(Math.max(index, 0), situation.tags.length - 1)]);
    };
    const actions: Record<string, () => void> = {
        ArrowLeft: () => (event.ctrlKey || event.metaKey ? jump(-1) : moveCursor(cursor - step)),
        ArrowRight: () => (event.ctrlKey || event.metaKey ? jump(1) : moveCursor(cursor + step)),
        ArrowUp: () => (event.altKey && selected ? send({ kind: 'move', tag: selected, by: -1 }) : pick(-1)),
        ArrowDown: () => (event.altKey && selected ? send({ kind: 'move', tag: selected, by: 1 }) : pick(1)),
        PageUp: () => traced && show(panned(traced, -span / 2)),
        PageDown: () => traced && show(panned(traced, span / 2)),
        Home: () => moveCursor(oldest),
        End: () => show({ span }),
        '+': () => zoom(0.5, cursors[active]),
        '=': () => zoom(0.5, cursors[active]),
        '-': () => zoom(2, cursors[active]),
        0: () => show(EVERYTHING),
        a: () => setCursor(0, cursors[0] ?? recorded(cursor)),
        b: () => setCursor(1, cursors[1] ?? recorded(cursor)),
        Enter: () => goTo(cursor),
        Escape: clear,
        Delete: () => selected && send({ kind: 'remove', tag: selected }),
        ' ': () => send({ kind: 'runOrPause' }),
    };
    const action = actions[event.key];
    if (action) {
        event.preventDefault();
        action();
    }
}

/** About a scan; about the middle if that is not in sight. While it runs the newest is followed. */
function zoom(factor: number, at?: number): void {
    if (traced) {
        const isInSight = at !== undefined && traced.first <= at && at <= traced.last;
        const isLive = situation.running && follows(shown);
        show(zoomed(shown, traced, factor, isInSight && !isLive ? at : undefined));
    }
}

function clear(): void {
    cursors = [undefined, undefined];
    active = 0;
    keep();
    draw();
    ask();
}

/** What a pointer that is held down does when it moves. */
let drag: { readonly from: number; readonly window: Traced; readonly cursor: number | undefined; moved: boolean } | undefined;

function isOverPicture(event: MouseEvent): boolean {
    const { left, right } = axisCell.getBoundingClientRect();
    return event.clientX >= left && event.clientX < right && event.target instanceof SVGElement;
}

function pointerDown(event: PointerEvent): void {
    if (!traced || event.button !== 0 || !isOverPicture(event)) {
        return;
    }
    trace.focus({ preventScroll: true });
    const sheet: Sheet = { width: width(), traced, cursors };
    const x = event.clientX - axisCell.getBoundingClientRect().left;
    const near = cursors.findIndex((scan) => scan !== undefined && Math.abs(toX(sheet, scan + 0.5) - x) <= NEAR);
    drag = { from: event.clientX, window: traced, cursor: near < 0 ? undefined : near, moved: false };
    trace.setPointerCapture(event.pointerId);
    event.preventDefault();
}

function pointerMove(event: PointerEvent): void {
    if (!drag || !traced) {
        return;
    }
    drag.moved ||= Math.abs(event.clientX - drag.from) > STILL;
    if (!drag.moved) {
        return;
    }
    if (drag.cursor !== undefined) {
        setCursor(drag.cursor, recorded(scanAt(event.clientX)));
        return;
    }
    const { first, last } = drag.window;
    show(panned({ ...drag.window, newest: traced.newest }, ((drag.from - event.clientX) / width()) * (last - first + 1)));
}

function pointerUp(event: PointerEvent): void {
    const held = drag;
    drag = undefined;
    if (!held || held.moved || !traced) {
        return;
    }
    const scan = recorded(scanAt(event.clientX));
    if (event.shiftKey) {
        setCursor(1, scan);
        return;
    }
    setCursor(0, scan);
    goTo(scan);
}

function wheel(event: WheelEvent): void {
    if (!traced) {
        return;
    }
    const { first, last } = traced;
    if (event.ctrlKey || event.metaKey) {
        event.preventDefault();
        zoom(event.deltaY < 0 ? 0.8 : 1.25, scanAt(event.clientX));
    } else if (event.shiftKey || event.deltaX !== 0) {
        event.preventDefault();
        show(panned(traced, ((event.deltaX || event.deltaY) / width()) * (last - first + 1)));
    }
}

const buttons: Record<string, () => void> = {
    choose: () => send({ kind: 'choose' }),
    in: () => zoom(0.5, cursors[active]),
    out: () => zoom(2, cursors[active]),
    fit: () => show(EVERYTHING),
    follow: () => traced && show({ span: traced.last - traced.first + 1 }),
    clear,
};
for (const [id, press] of Object.entries(buttons)) {
    document.getElementById(id)?.addEventListener('click', press);
}
trace.addEventListener('keydown', key);
trace.addEventListener('pointerdown', pointerDown);
trace.addEventListener('pointermove', pointerMove);
trace.addEventListener('pointerup', pointerUp);
trace.addEventListener('pointercancel', () => (drag = undefined));
trace.addEventListener('wheel', wheel, { passive: false });
new ResizeObserver(() => {
    columns.forget();
    ask();
}).observe(axisCell);
window.addEventListener('message', ({ data }: MessageEvent<ToPage>) => {
    take(data);
    if (data.kind === 'traced' && !isAsking && afterAnswer) {
        afterAnswer();
        afterAnswer = undefined;
    }
});
arrange();
send({ kind: 'ready' });
