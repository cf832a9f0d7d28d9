// A piece of the diagram on the page: the server's SVG, with the state of the running program on it. Text of the program
// comes as text and stays text: the drawing is read as XML, and what is added is added as text.
import type { Tag } from '../protocol.ts';
import type { Called } from './called.ts';
import { type Changed, isSwitch, type Live, type Power, toggles } from './live.ts';
import type { Piece } from './layout.ts';
import type { Finding } from './messages.ts';
import type { Spot } from './neighbours.ts';
import { addComment, addPoints, BESIDE_JOIN } from './draw/points.ts';
import { addWave } from './draw/wave.ts';
import { wordsOf } from './draw/words.ts';
import { describe } from './speech.ts';

const SVG = 'http://www.w3.org/2000/svg';

/** A place in the text, its line counted from the first of the piece. */
type Within = readonly [line: number, character: number];

interface Powered {
    readonly shape: Element;
    readonly parts: readonly Within[];
    state: string;
}

interface ValueAt {
    readonly text: SVGTextElement;
    readonly operand: Within;
    readonly room: number;
}

/** What a drawing has besides its elements, while somebody draws. */
const PLACES = ['point', 'join', 'note'] as readonly string[];

/** A contact, coil or block on the page, or what else can be selected while somebody draws. */
export interface Part {
    readonly node: SVGGElement;
    readonly kind: string;
    readonly name: string;
    readonly at: Within;
    readonly end: Within;
    readonly operands: readonly { readonly place: Within; readonly text: string; readonly node: Element }[];
    readonly box: { readonly x: number; readonly y: number; readonly width: number; readonly height: number };
    /** Right of the symbol: where a forced one is marked. */
    readonly mark: Spot | undefined;
    readonly values: readonly ValueAt[];
    /** What is reported about it. */
    findings: readonly Finding[];
    state: string;
    words: string;
    context: string;
}

function within(place: string | null): Within {
    const [line = 0, character = 0] = (place ?? '').split(':').map(Number);
    return [line, character];
}

function isUpTo([a, b]: Within, [c, d]: Within): boolean {
    return a < c || (a === c && b <= d);
}

function number(node: Element, name: string): number {
    return Number(node.getAttribute(name) ?? 0);
}

/** How a wire looks that these elements give power to. */
function lookOf(powers: readonly Power[]): 'on' | 'off' | 'flickers' | 'unknown' | '' {
    if (powers.some(({ on, does }) => on && does !== 'flickers')) {
        return 'on';
    }
    const doubtful = (['flickers', 'unknown'] as const).find((look) => powers.some(({ does }) => does === look));
    return doubtful ?? (powers.length > 0 ? 'off' : '');
}

/** What fits into so many letters. */
function fitted(text: string, room: number): string {
    return text.length <= room ? text : `${text.slice(0, Math.max(room - 1, 1))}…`;
}

function setText(node: Element, text: string): void {
    if (node.textContent !== text) {
        node.textContent = text;
    }
}

function partOf(node: SVGGElement, called: Called): Part {
    const hit = node.querySelector('.hit');
    const box = hit
        ? { x: number(hit, 'x'), y: number(hit, 'y'), width: number(hit, 'width'), height: number(hit, 'height') }
        : { x: 0, y: 0, width: 0, height: 0 };
    const gate = node.querySelector('.gate')?.getAttribute('d')?.match(/-?\d+/g)?.map(Number);
    const mark = gate && {
        x: Math.max(...gate.filter((_, index) => index % 2 === 0)) + 9,
        y: Math.min(...gate.filter((_, index) => index % 2 === 1)) + 2,
    };
    const names = [...node.querySelectorAll('[data-operand]:not(.value)')];
    const values = [...node.querySelectorAll<SVGTextElement>('.value[data-operand]')];
    return {
        node,
        kind: ['contact', 'coil', ...PLACES].find((kind) => node.classList.contains(kind)) ?? 'block',
        get name() {
            return called.name(node.getAttribute('data-name') ?? '');
        },
        at: within(node.getAttribute('data-at')),
        end: within(node.getAttribute('data-end')),
        operands: names.map((text) => ({
            place: within(text.getAttribute('data-operand')),
            text: text.textContent ?? '',
            node: text,
        })),
        box,
        mark,
        values: values.map((text) => ({
            text,
            operand: within(text.getAttribute('data-operand')),
            room: number(text, 'data-room'),
        })),
        findings: [],
        state: '',
        words: '',
        context: '',
    };
}

/** What the menu of an element or operand may offer, as the editor's own menus ask for it. */
function menuOf(tag: Tag | undefined, place: string): string {
    const can = !tag
        ? []
        : [
              ...(toggles(tag) ? ['toggle', ...(tag.forced ? [] : ['pulse', 'bool'])] : []),
              ...(tag.readOnly === true ? [] : ['set', tag.forced ? 'unforce' : 'force']),
              'why',
          ];
    return JSON.stringify({
        webviewSection: 'element',
        preventDefaultContextMenuItems: true,
        ladderCan: can.join(' '),
        place,
        ...(tag ? { name: tag.name } : {}),
    });
}

export class Drawing {
    readonly node: HTMLElement;
    readonly piece: Piece;
    readonly parts: readonly Part[];
    /** The places in its wires, ends of branches and comments, while somebody draws. */
    readonly points: readonly Part[];
    first: number;
    /** What is said of its elements is older than what is seen. */
    owesWords = false;
    readonly #powered: readonly Powered[];
    readonly #gutter: HTMLElement;
    /** The tags that it shows, in lower case. */
    readonly #tags = new Set<string>();
    /** The last line that has something live, from the first one. */
    readonly #lastLine: number;

    constructor(piece: Piece, svg: string, first: number, last: number, called: Called) {
        this.piece = piece;
        this.first = first;
        this.node = document.createElement('section');
        this.node.className = `piece ${piece.kind}${piece.isHeld ? ' held' : ''}`;
        this.#gutter = document.createElement('span');
        this.#gutter.className = 'gutter';
        this.#gutter.setAttribute('aria-hidden', 'true');
        const parsed = new DOMParser().parseFromString(svg, 'image/svg+xml').documentElement;
        const drawing = document.importNode(parsed, true);
        this.node.append(this.#gutter, drawing);
        if (piece.isHeld) {
            const note = document.createElement('span');
            note.className = 'note';
            note.textContent = 'being edited';
            this.node.append(note);
        }
        const isDrawable = piece.kind === 'network' && !piece.isHeld && !piece.why;
        if (isDrawable) {
            const add = document.createElement('button');
            add.type = 'button';
            add.className = 'add';
            add.tabIndex = -1;
            add.textContent = '+';
            add.title = 'New network below (N)';
            this.node.append(add);
        }
        this.#powered = [...drawing.querySelectorAll('[data-power]')].map((shape) => ({
            shape,
            parts: (shape.getAttribute('data-power') ?? '').split(' ').map(within),
            state: '',
        }));
        this.parts = [...drawing.querySelectorAll<SVGGElement>('g.element')].map((node) => partOf(node, called));
        const places = isDrawable ? addPoints(drawing) : piece.kind === 'comment' ? addComment(drawing, last - first) : [];
        this.points = places.map((node) => partOf(node, called));
        this.#lastLine = Math.max(0, ...this.#powered.flatMap(({ parts }) => parts.map(([line]) => line)));
        for (const { node } of [...this.parts, ...this.points]) {
            node.setAttribute('tabindex', '-1');
            node.setAttribute('role', 'button');
        }
        this.#namePoints();
        this.move(first);
    }

    /** The piece begins at this line now. */
    move(first: number): void {
        this.first = first;
        setText(this.#gutter, String(first + 1));
        if (this.piece.kind === 'network') {
            this.node.setAttribute('role', 'group');
            this.node.setAttribute('aria-label', `Network in line ${first + 1}`);
        }
    }

    /** Its size on the page. */
    resize(scale: number): void {
        const svg = this.node.querySelector('svg');
        svg?.setAttribute('width', String(this.piece.width * scale));
        svg?.setAttribute('height', String(this.piece.height * scale));
    }

    /** Whether a change is about something in it. */
    isAbout({ whole, lines, tags }: Changed): boolean {
        if (whole || [...this.#tags].some((name) => tags.has(name))) {
            return true;
        }
        for (let line = this.first; line <= this.first + this.#lastLine; line += 1) {
            if (lines.has(line)) {
                return true;
            }
        }
        return false;
    }

    /** Shows the state of the program; what is only heard, or asked for, may wait. */
    show(live: Live, isHurried = false): void {
        this.owesWords = isHurried;
        const isLive = live.state !== undefined;
        for (const powered of this.#powered) {
            const powers = powered.parts.map(([line, character]) => live.power(this.first + line, character));
            const state = isLive ? lookOf(powers.filter((power) => power !== undefined)) : '';
            if (state !== powered.state) {
                powered.state = state;
                for (const look of ['on', 'off', 'flickers', 'unknown']) {
                    powered.shape.classList.toggle(look, look === state);
                }
            }
        }
        this.#tags.clear();
        for (const part of this.parts) {
            this.#showPart(part, live, isHurried);
        }
    }

    /** The tags of a part: those of its first operand first. */
    tagsOf(part: Part, live: Live): Tag[] {
        return live.tagsOf(part.operands.map(({ place: [line, character] }) => [this.first + line, character]));
    }

    #showPart(part: Part, live: Live, isHurried: boolean): void {
        const power = live.power(this.first + part.at[0], part.at[1]);
        const tags = this.tagsOf(part, live);
        const [main] = tags;
        tags.forEach(({ name }) => this.#tags.add(name.toLowerCase()));
        const isForced = tags.some((tag) => tag.forced);
        const state = [
            'element',
            part.kind,
            ...(live.state && power ? [...new Set([lookOf([power]), power.does ?? ''])] : []),
            isForced ? 'forced' : '',
            isSwitch(part.kind, main) ? 'switch' : '',
            part.node.classList.contains('cursor') ? 'cursor' : '',
        ].filter(Boolean).join(' ');
        if (state !== part.state) {
            part.state = state;
            part.node.setAttribute('class', state);
            this.#markForced(part, isForced);
        }
        for (const { text, operand, room } of part.values) {
            const tag = live.tagsOf([[this.first + operand[0], operand[1]]])[0];
            setText(text, tag ? fitted(`${tag.forced ? 'F ' : ''}${tag.text}`, room) : '');
            text.classList.toggle('forced', tag?.forced === true);
        }
        if (isHurried && part.node !== document.activeElement) {
            return;
        }
        const words = describe({ ...part, operands: part.operands.map(({ text }) => text) }, power, tags);
        if (words !== part.words) {
            part.words = words;
            part.node.setAttribute('aria-label', words);
            if (isSwitch(part.kind, main)) {
                part.node.setAttribute('aria-pressed', String(main?.value === true));
            } else {
                part.node.removeAttribute('aria-pressed');
            }
        }
        this.#offer(part, live);
    }

    /** The menus of a part and of its operands. */
    #offer(part: Part, live: Live): void {
        const place = `${this.first + part.at[0]}:${part.at[1]}`;
        const menus = [undefined, ...part.operands].map((operand) => {
            const [line, character] = (operand ?? part.operands[0])?.place ?? part.at;
            return menuOf(live.tagsOf([[this.first + line, character]])[0], place);
        });
        const context = menus.join('\n');
        if (context !== part.context) {
            part.context = context;
            part.node.dataset['vscodeContext'] = menus[0];
            part.operands.forEach(({ node }, index) => node.setAttribute('data-vscode-context', menus[index + 1] ?? ''));
        }
    }

    /** A letter in a frame, for those who do not see colours. */
    #markForced({ node, mark }: Part, isForced: boolean): void {
        const badge = node.querySelector('.badge');
        if (!isForced || !mark) {
            badge?.remove();
        } else if (!badge) {
            const group = document.createElementNS(SVG, 'g');
            group.setAttribute('class', 'badge');
            const frame = document.createElementNS(SVG, 'rect');
            const size = { x: mark.x - 6, y: mark.y - 6, width: 12, height: 12, rx: 2 };
            for (const [name, value] of Object.entries(size)) {
                frame.setAttribute(name, String(value));
            }
            const letter = document.createElementNS(SVG, 'text');
            letter.setAttribute('x', String(mark.x));
            letter.setAttribute('y', String(mark.y + 3.5));
            letter.setAttribute('text-anchor', 'middle');
            letter.textContent = 'F';
            group.append(frame, letter);
            node.append(group);
        }
    }

    #namePoints(): void {
        const on = ({ box, mark }: Part) => ({ left: box.x, right: box.x + box.width, y: mark ? mark.y + 8 : box.y + 29 });
        const elements = this.parts.map((part) => ({ ...on(part), text: part.operands[0]?.text ?? part.name }));
        const ends = this.points.filter(({ kind }) => kind === 'join').flatMap(({ box: { x, y, width, height } }) => {
            const middle = { left: x + width / 2, right: x + width / 2, text: 'a branch' };
            return [{ ...middle, y: y - BESIDE_JOIN }, { ...middle, y: y + height + BESIDE_JOIN }];
        });
        const heights = this.points.filter(({ kind }) => kind === 'point').map(({ box }) => box.y + box.height / 2);
        for (const { node, name, kind, box } of this.points) {
            const y = kind === 'join' ? box.y - BESIDE_JOIN : box.y + box.height / 2;
            node.setAttribute('aria-label', kind === 'note' ? name : `${name} ${wordsOf({ left: box.x, right: box.x + box.width, y }, kind === 'join' ? elements : [...elements, ...ends], heights)}`);
        }
    }

    /** Marks the elements that something is reported about; what is about no element is at the nearest. */
    report(findings: readonly Finding[]): void {
        const of = new Map<Part, Finding[]>();
        for (const finding of findings) {
            const from: Within = [finding.from.line - this.first, finding.from.character];
            const to: Within = [finding.to.line - this.first, finding.to.character];
            const about = this.parts.filter(({ at, end }) => isUpTo(at, to) && isUpTo(from, end));
            const nearest = this.partAt(finding.from.line, finding.from.character);
            for (const part of about.length > 0 ? about : nearest ? [nearest] : []) {
                of.set(part, [...(of.get(part) ?? []), finding]);
            }
        }
        for (const part of this.parts) {
            part.findings = of.get(part) ?? [];
            addWave(part.node, part.box, part.findings);
        }
    }

    /** The part around a place of the text, else the one that begins last before it. */
    partAt(line: number, character: number): Part | undefined {
        const here: Within = [line - this.first, character];
        const around = this.parts.find(({ at, end }) => isUpTo(at, here) && isUpTo(here, end));
        const before = this.parts.filter(({ at }) => at[0] === here[0] && at[1] <= here[1]);
        // On a line below all of them the last one is the nearest.
        const last = this.parts.every(({ at }) => at[0] < here[0]) ? this.parts.at(-1) : undefined;
        return around ?? before.at(-1) ?? this.parts.find(({ at }) => at[0] === here[0]) ?? last ?? this.parts[0];
    }

    /** The middle of a part, from the upper left corner of the diagram. */
    spotOf({ kind, box, mark }: Part, top: number, scale: number): Spot {
        const y = mark ? mark.y + 8 : PLACES.includes(kind) ? box.y + box.height / 2 : box.y + 29;
        return { x: (box.x + box.width / 2) * scale, y: top + y * scale, isBetween: kind === 'join' };
    }
}
