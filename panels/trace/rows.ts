// The rows of the trace: for each tag its name, its value, its picture, and its values at the cursors.
import type { Column, Traced, TraceTag } from './messages.ts';
import { bitPaths, numberPath, scaleOf, words } from './paths.ts';
import { draw, put, setText, type Shape, shape } from './shapes.ts';

/** In pixels. */
const HEIGHTS = { bit: 30, number: 64, text: 30, unknown: 30 } as const;
const MARGIN = 6;
/** What a letter of a band is wide, more or less. */
const LETTER = 7.5;

export interface RowEvents {
    select(tag: string): void;
    remove(tag: string): void;
}

/** From scans to pixels, and where lines are across all rows. */
export interface Sheet {
    readonly width: number;
    readonly traced: Traced;
    readonly cursors: readonly (number | undefined)[];
}

export const letters = ['A', 'B'] as const;

export function toX({ traced: { first, last }, width }: Sheet, scan: number): number {
    return ((scan - first) / (last - first + 1)) * width;
}

/** The lines that go through all rows: what was stepped back from, where the simulation is, and the cursors. */
export function across(sheet: Sheet, height: number): Shape[] {
    const { traced, cursors, width } = sheet;
    const marks: Shape[] = [];
    const from = Math.max(toX(sheet, traced.here + 1), 0);
    const to = Math.min(toX(sheet, traced.newest + 1), width);
    if (traced.here < traced.newest && to > from) {
        marks.push(shape('rect', { class: 'ahead', x: from, y: 0, width: to - from, height }));
    }
    const line = (name: string, scan: number) => {
        // In the middle of the scan, where there is room for one.
        const x = toX(sheet, scan + 0.5);
        if (x >= 0 && x <= width) {
            marks.push(shape('line', { class: name, x1: x, x2: x, y1: 0, y2: height }));
        }
    };
    line('here', traced.here);
    cursors.forEach((scan, index) => scan !== undefined && line(`cursor ${letters[index]}`, scan));
    return marks;
}

export class Row {
    readonly element = document.createElement('tr');
    readonly name: string;
    readonly #now = document.createElement('td');
    readonly #picture = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
    readonly #readings = letters.map(() => document.createElement('td'));
    readonly #difference = document.createElement('td');

    constructor(name: string, events: RowEvents) {
        this.name = name;
        const head = document.createElement('th');
        head.scope = 'row';
        const label = document.createElement('span');
        label.textContent = name;
        label.title = name;
        const remove = document.createElement('button');
        remove.className = 'remove';
        remove.textContent = '×';
        remove.title = `Remove ${name} from the trace (Delete)`;
        remove.setAttribute('aria-label', remove.title);
        remove.addEventListener('click', () => events.remove(name));
        head.append(label, remove);
        head.addEventListener('mousedown', () => events.select(name));
        const wave = document.createElement('td');
        wave.className = 'wave';
        this.#picture.setAttribute('role', 'img');
        wave.append(this.#picture);
        this.#now.className = 'now';
        this.#readings.forEach((cell, index) => (cell.className = `reading ${letters[index]}`));
        this.#difference.className = 'reading difference';
        this.element.append(head, this.#now, wave, ...this.#readings, this.#difference);
    }

    select(isSelected: boolean): void {
        this.element.classList.toggle('selected', isSelected);
        if (isSelected) {
            this.element.setAttribute('aria-current', 'true');
            this.element.scrollIntoView({ block: 'nearest' });
        } else {
            this.element.removeAttribute('aria-current');
        }
    }

    draw(tag: TraceTag, columns: readonly Column[], sheet: Sheet): void {
        put(this.element, 'class', this.element.classList.contains('selected') ? `selected ${tag.kind}` : tag.kind);
        setText(this.#now, tag.kind === 'unknown' ? 'no such tag' : (tag.now ?? ''));
        this.#readings.forEach((cell, index) => setText(cell, this.#reading(tag, sheet, index)));
        setText(this.#difference, tag.difference ?? '');
        const height = HEIGHTS[tag.kind];
        put(this.#picture, 'width', sheet.width);
        put(this.#picture, 'height', height);
        put(this.#picture, 'aria-label', `Waveform of ${tag.name}${tag.type ? `, ${tag.type}` : ''}`);
        draw(this.#picture, [...wave(tag, columns, sheet, height), ...across(sheet, height)]);
    }

    #reading(tag: TraceTag, { cursors }: Sheet, index: number): string {
        // The readings are those of the cursors that are set, in their order.
        const which = cursors.slice(0, index).filter((scan) => scan !== undefined).length;
        return cursors[index] === undefined ? '' : (tag.readings?.[which] ?? '–');
    }
}

function wave(tag: TraceTag, columns: readonly Column[], sheet: Sheet, height: number): Shape[] {
    const { traced, width } = sheet;
    const [top, bottom] = [MARGIN, height - MARGIN];
    const columnToX = (column: number) => toX(sheet, Math.max(column * traced.per, tag.oldest ?? 0));
    const end = Math.min(toX(sheet, traced.newest + 1), width);
    switch (tag.kind) {
        case 'bit': {
            const paths = bitPaths(columns, columnToX, end, top, bottom);
            return [
                shape('path', { class: 'high', d: paths.high }),
                shape('path', { class: 'busy', d: paths.busy }),
                shape('path', { class: 'line', d: paths.line }),
            ];
        }
        case 'number': {
            const toY = scaleOf(tag.range ?? [0, 0], top + 2, bottom - 2);
            const scale = (tag.ticks ?? []).flatMap(({ at, text }) => {
                const y = toY(at);
                return [
                    shape('line', { class: 'grid', x1: 0, x2: width, y1: y, y2: y }),
                    shape('text', { class: 'tick', x: 3, y: Math.max(y - 2, 10) }, text),
                ];
            });
            return [...scale, shape('path', { class: 'line', d: numberPath(columns, columnToX, end, toY) })];
        }
        case 'text':
            return words(columns, columnToX, end).flatMap(({ from, to, text }) => {
                const room = Math.floor((to - from - 8) / LETTER);
                const place = { class: 'band', x: from, y: top, width: to - from, height: bottom - top };
                const box: Shape = { name: 'rect', attributes: place, title: text };
                const shown = text.length <= room ? text : room > 2 ? `${text.slice(0, room - 1)}…` : '';
                return [box, shape('text', { class: 'word', x: from + 4, y: bottom - 4 }, shown)];
            });
        default:
            return [];
    }
}
