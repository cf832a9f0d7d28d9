// The scrolling part of the page: asks for what comes into sight, and keeps only that on the page.
import type { Drawn, Finding, FromPage, LineChange, Place } from './messages.ts';
import { isField } from './draw/field.ts';
import type { Called } from './called.ts';
import { Drawing, type Part } from './drawing.ts';
import { Layout, moved } from './layout.ts';
import { SAME_RUNG, type Spot } from './neighbours.ts';
import type { Changed, Live } from './live.ts';

/** Pieces are kept ready so far above and below what is seen, in pixels. */
const MARGIN = 400;
/** So many lines more are asked for than seem to be in sight. */
const AHEAD = 20;
/** So many drawings are remembered. */
const REMEMBERED = 2000;
/** While a program runs, elements are not put into words more often. In milliseconds. */
const WORDS_EVERY = 500;
/** The width of a letter of a drawing, and what a drawing has next to its rails, in pixels. */
const LETTER = 8;
const NEXT_TO = 80;
/** Where line numbers are, to the left of each drawing: `--gutter` of the style. In pixels. */
const GUTTER = 44;
/** How far from there a field for a network is, and how high it is, in pixels. */
const [INDENT, FIELD] = [16, 26];
/** The right rail is where the page ends, but no further left or right than this, in letters. */
const RAILS = [44, 110] as const;

/** Nobody waits longer for the drawing of a new text, in milliseconds. */
const PATIENCE = 2000;
/** So long what is new is shown as that, in milliseconds. */
const SHOWN_AS_NEW = 600;

/** An element, and the drawing that it is in. */
export interface Found {
    readonly drawing: Drawing;
    readonly part: Part;
}

/** What is to get the focus when it is drawn. */
interface Soon {
    readonly places: readonly Place[];
    /** Of the text that has it. */
    readonly version: number;
    readonly isPoint?: boolean;
    /** Something else was chosen meanwhile: it keeps the focus. */
    readonly isLeft?: boolean;
}

export class Page {
    readonly layout = new Layout();
    readonly called: Called;
    /** What the arrow keys and the strip below are about. */
    selected: { line: number; character: number; isPoint?: boolean } | undefined;
    /** Somebody draws: the places in the wires are there. */
    isDrawing = false;

    readonly #view: HTMLElement;
    readonly #canvas: HTMLElement;
    readonly #live: Live;
    readonly #send: (message: FromPage) => void;
    readonly #drawings = new Map<number, Drawing>();
    readonly #svgs = new Map<string, string>();
    #rail = 0;
    /** When elements were last put into words. */
    #spoken = 0;
    /** The widest piece that was in sight since the text was opened, in pixels at its own size. */
    #widest = 0;
    /** A question is on its way. */
    #isAsking = false;
    /** The version of a text of which there is no drawing. */
    #failed: number | undefined;
    #sees = '';
    #cursor: Place | undefined;
    #findings: readonly Finding[] = [];
    /** What is to get the focus, and is shown as new. */
    #soon: (Soon & { done(): void }) | undefined;
    /** What gets the focus now does so by itself. */
    #isGiven = false;

    constructor(view: HTMLElement, canvas: HTMLElement, live: Live, called: Called, send: (message: FromPage) => void) {
        this.#view = view;
        this.#canvas = canvas;
        this.#live = live;
        this.called = called;
        this.#send = send;
        view.addEventListener('scroll', () => this.update(), { passive: true });
        new ResizeObserver(() => this.#fit()).observe(view);
    }

    get scale(): number {
        return this.layout.scale;
    }

    zoom(scale: number): void {
        const anchor = this.#anchor();
        this.layout.scale = scale;
        this.layout.place();
        for (const drawing of this.#drawings.values()) {
            drawing.resize(scale);
        }
        this.#fit();
        this.#stay(anchor);
        this.update();
    }

    /** The scale, 1 at most, at which nothing that was in sight is cut off at the right. */
    get fitting(): number {
        const room = this.#view.clientWidth - GUTTER;
        return room > 0 && this.#widest > room ? room / this.#widest : 1;
    }

    open(version: number, lineCount: number, line: number): void {
        this.#clear();
        this.#widest = 0;
        this.layout.open(version, lineCount);
        this.#isAsking = false;
        this.#failed = undefined;
        this.update();
        if (line > 0) {
            this.#view.scrollTop = this.layout.topOf(line);
        }
        this.update();
    }

    edit(version: number, lineCount: number, changes: readonly LineChange[]): void {
        const anchor = this.#anchor();
        this.layout.edit(version, lineCount, changes);
        anchor.line = moved(anchor.line, changes);
        if (this.selected) {
            this.selected.line = moved(this.selected.line, changes);
        }
        const move = (place: Place) => ({ ...place, line: moved(place.line, changes) });
        this.#findings = this.#findings.map((finding) => ({ ...finding, from: move(finding.from), to: move(finding.to) }));
        this.#stay(anchor);
        this.update();
    }

    take(drawn: Drawn): void {
        for (const { key, svg } of drawn.pieces) {
            if (svg !== undefined) {
                this.#svgs.delete(key);
                this.#svgs.set(key, svg);
            }
        }
        const anchor = this.#anchor();
        this.#isAsking = false;
        if (this.layout.take(drawn)) {
            // Whoever drives the page from outside sees what is drawn.
            this.#canvas.dataset['version'] = String(drawn.version);
            this.#stay(anchor);
            this.#forget();
        }
        this.update();
        this.#markCursor(false);
        this.#focusNew();
    }

    /** What lies here gets the focus as soon as it is drawn: it is new in the text that comes. */
    async focusSoon(soon: Soon): Promise<void> {
        this.#soon?.done();
        await new Promise<void>((done) => {
            this.#soon = { ...soon, done };
            this.#focusNew();
            // Of a text that cannot be drawn nothing comes.
            setTimeout(done, PATIENCE);
        });
    }

    #focusNew(): void {
        const soon = this.#soon;
        const [first] = soon?.places ?? [];
        if (!soon || !first || this.layout.version < soon.version || this.layout.at(first.line)?.version !== this.layout.version) {
            return;
        }
        const { places, isPoint, isLeft } = soon;
        this.#soon = undefined;
        soon.done();
        const { activeElement } = document;
        if (!(isLeft === true && this.find(activeElement))) {
            this.selected = { ...first, isPoint: isPoint === true };
            const found = this.#selectedPart();
            if (found && (isLeft === true || isField(activeElement))) {
                // Who types already goes on typing.
                this.hasFocus(found);
            } else if (found) {
                this.select(found);
            }
        }
        for (const { line, character } of places) {
            const isAt = ({ drawing, part }: Found) => drawing.first + part.at[0] === line && part.at[1] === character;
            const node = this.spots().find(({ found }) => !found.drawing.points.includes(found.part) && isAt(found))?.found.part.node;
            node?.classList.add('new');
            setTimeout(() => node?.classList.remove('new'), SHOWN_AS_NEW);
        }
    }

    /** The first lines of the networks that are known, from top to bottom. */
    networks(): number[] {
        return this.layout.segments.flatMap(({ first, piece }) => (piece?.kind === 'network' ? [first] : []));
    }

    /** Where a part is, from the upper left corner of the diagram. */
    boxOf({ drawing, part: { box } }: Found): { left: number; top: number; width: number; height: number } {
        const scale = this.layout.scale;
        const top = Number(drawing.node.dataset['top'] ?? 0) + box.y * scale;
        return { left: GUTTER + box.x * scale, top, width: box.width * scale, height: box.height * scale };
    }

    /** Where what is written above or below a network is. */
    beside({ drawing: { node, piece } }: Found, place: 'above' | 'below'): { x: number; y: number } {
        const top = Number(node.dataset['top'] ?? 0);
        return { x: GUTTER + INDENT, y: place === 'above' ? top - FIELD : top + piece.height * this.layout.scale };
    }

    /** What is reported about the text, from top to bottom. */
    get findings(): readonly Finding[] {
        return this.#findings;
    }

    report(findings: readonly Finding[]): void {
        this.#findings = [...findings].sort((a, b) => a.from.line - b.from.line || a.from.character - b.from.character);
        for (const drawing of this.#drawings.values()) {
            this.#reportTo(drawing);
        }
    }

    #reportTo(drawing: Drawing): void {
        const last = this.layout.at(drawing.first)?.last ?? drawing.first;
        drawing.report(this.#findings.filter(({ from, to }) => from.line <= last && to.line >= drawing.first));
    }

    /** There is no drawing of this text: it is asked for again with the next one. */
    fail(version: number): void {
        this.#isAsking = false;
        this.#failed = version;
        this.update();
    }

    get isEmpty(): boolean {
        return this.#drawings.size === 0;
    }

    /** What is in sight is put on the page, and asked for if it is not known. */
    update(): void {
        const { layout } = this;
        const [top, bottom] = [this.#view.scrollTop, this.#view.scrollTop + this.#view.clientHeight];
        this.#canvas.style.height = `${layout.height}px`;
        const segments = layout.between(top - MARGIN, bottom + MARGIN);
        const seen = new Map<number, Drawing>();
        let width = 0;
        for (const { piece, first, last, top: at } of segments) {
            const svg = piece && this.#svgs.get(piece.key);
            if (!piece || svg === undefined) {
                continue;
            }
            width = Math.max(width, piece.width * layout.scale);
            this.#widest = Math.max(this.#widest, piece.width);
            let drawing = this.#drawings.get(piece.id);
            if (!drawing) {
                drawing = new Drawing(piece, svg, first, last, this.called);
                drawing.resize(layout.scale);
                this.#drawings.set(piece.id, drawing);
                drawing.show(this.#live);
                this.#reportTo(drawing);
            } else if (drawing.first !== first) {
                drawing.move(first);
                drawing.show(this.#live);
            }
            drawing.node.style.transform = `translateY(${at}px)`;
            drawing.node.dataset['top'] = String(at);
            seen.set(piece.id, drawing);
        }
        const hadFocus = this.#drop(seen);
        this.#order([...seen.values()]);
        const focused = hadFocus ? (this.#selectedPart() ?? this.#nearestPart()) : undefined;
        if (focused) {
            this.#give(() => this.select(focused, false));
        } else if (hadFocus) {
            this.#view.focus({ preventScroll: true });
        }
        this.#canvas.style.minWidth = `${width + GUTTER}px`;
        this.#ask(top, bottom);
    }

    /** The state of the program is another one. */
    show(changed: Changed): void {
        const isHurried = this.#live.state?.status === 'running' && Date.now() - this.#spoken < WORDS_EVERY;
        if (!isHurried) {
            this.#spoken = Date.now();
        }
        for (const drawing of this.#drawings.values()) {
            if (drawing.isAbout(changed) || (drawing.owesWords && !isHurried)) {
                drawing.show(this.#live, isHurried);
            }
        }
    }

    /** Instructions are called in another way. */
    rename(): void {
        for (const drawing of this.#drawings.values()) {
            drawing.show(this.#live);
        }
    }

    /** In the order of the text, which is that of the tabulator and of screen readers. */
    #order(drawings: readonly Drawing[]): void {
        const focused = document.activeElement;
        let following: Element | null = null;
        for (const { node } of [...drawings].reverse()) {
            let next = node.nextElementSibling;
            while (next && !next.classList.contains('piece')) {
                next = next.nextElementSibling;
            }
            if (node.parentNode !== this.#canvas || next !== following) {
                this.#canvas.insertBefore(node, following);
            }
            following = node;
        }
        if (document.activeElement !== focused && focused instanceof SVGElement && focused.isConnected) {
            this.#give(() => focused.focus({ preventScroll: true }));
        }
    }

    /** Takes off the page what is not seen. @returns whether that had the focus, which goes to what takes its place */
    #drop(seen: ReadonlyMap<number, Drawing>): boolean {
        let hadFocus = false;
        for (const [id, { node }] of this.#drawings) {
            if (!seen.has(id)) {
                hadFocus ||= node.contains(document.activeElement);
                node.remove();
                this.#drawings.delete(id);
            }
        }
        return hadFocus;
    }

    #ask(top: number, bottom: number): void {
        const sees = { first: this.layout.lineAt(top), last: this.layout.lineAt(bottom) };
        const last = this.layout.at(sees.last)?.last ?? sees.last;
        if (JSON.stringify([sees.first, last]) !== this.#sees) {
            this.#sees = JSON.stringify([sees.first, last]);
            this.#send({ type: 'sees', lines: { first: sees.first, last } });
        }
        const lines = this.layout.wanted(top - MARGIN, bottom + MARGIN);
        // One question at a time: what is asked while a user scrolls is about the place where he has arrived.
        if (!lines || this.#rail === 0 || this.#isAsking || this.#failed === this.layout.version) {
            return;
        }
        this.#isAsking = true;
        const known = this.layout.segments.filter(({ first, last }) => first <= lines.last + 200 && last >= lines.first - 200);
        const keys = known.flatMap(({ piece }) => (piece && this.#svgs.has(piece.key) ? [piece.key] : []));
        // Declarations take no room: what comes after them may be in sight, too.
        const ahead = { first: lines.first, last: lines.last + AHEAD };
        this.#send({ type: 'ask', lines: ahead, rail: this.#rail, known: [...new Set(keys)] });
    }

    /** The rail goes to the right end of the page. */
    #fit(): void {
        const letters = Math.floor((this.#view.clientWidth / this.layout.scale - NEXT_TO) / LETTER);
        const rail = Math.min(Math.max(letters - (letters % 2), RAILS[0]), RAILS[1]);
        if (rail !== this.#rail && this.#view.clientWidth > 0) {
            this.#rail = rail;
            this.layout.outdate();
        }
        this.update();
    }

    #forget(): void {
        for (const key of this.#svgs.keys()) {
            if (this.#svgs.size <= REMEMBERED) {
                break;
            }
            if (![...this.#drawings.values()].some(({ piece }) => piece.key === key)) {
                this.#svgs.delete(key);
            }
        }
    }

    #clear(): void {
        this.#canvas.replaceChildren();
        this.#drawings.clear();
        this.selected = undefined;
    }

    #anchor() {
        return this.layout.anchorAt(this.#view.scrollTop);
    }

    #stay(anchor: ReturnType<Layout['anchorAt']>): void {
        this.#canvas.style.height = `${this.layout.height}px`;
        const top = this.layout.heightOfAnchor(anchor);
        if (Math.abs(top - this.#view.scrollTop) >= 1) {
            this.#view.scrollTop = top;
        }
    }

    /** All elements that are on the page, with their places there. */
    spots(): (Spot & { readonly found: Found })[] {
        const drawings = [...this.#drawings.values()].sort((a, b) => a.first - b.first);
        return drawings.flatMap((drawing) =>
            [...drawing.parts, ...(this.isDrawing ? drawing.points : [])].map((part) => {
                const top = Number(drawing.node.dataset['top'] ?? 0);
                return { found: { drawing, part }, ...drawing.spotOf(part, top, this.layout.scale) };
            }),
        );
    }

    /** The first or the last element on the line of a drawing that something is on. */
    endOfLine({ drawing, part }: Found, sign: -1 | 1): Found {
        const yOf = (part: Part) => drawing.spotOf(part, 0, 1).y;
        const beside = drawing.parts.filter((other) => Math.abs(yOf(other) - yOf(part)) <= SAME_RUNG);
        const last = beside.reduce((a, b) => ((b.box.x - a.box.x) * sign > 0 ? b : a), beside[0] ?? part);
        return { drawing, part: last };
    }

    /** Goes to a network, so many further down; to the first or the last with infinity. */
    async goToNetwork(by: number): Promise<void> {
        const networks = this.networks();
        const here = networks.findLastIndex((first) => first <= (this.selected?.line ?? -1));
        const next = networks[Math.min(Math.max(here + by, 0), networks.length - 1)];
        if (next !== undefined) {
            this.#scrollTo(next);
            await this.focusSoon({ places: [{ line: next, character: 0 }], version: this.layout.version });
        }
    }

    /** The element that a node of the page belongs to. */
    find(node: EventTarget | null): Found | undefined {
        const group = node instanceof Element ? node.closest('g.element') : null;
        for (const drawing of group ? this.#drawings.values() : []) {
            const part = [...drawing.parts, ...drawing.points].find((part) => part.node === group);
            if (part) {
                return { drawing, part };
            }
        }
        return undefined;
    }

    /** The drawing that a node of the page is in. */
    drawingOf(node: EventTarget | null): Drawing | undefined {
        return node instanceof Node ? [...this.#drawings.values()].find((drawing) => drawing.node.contains(node)) : undefined;
    }

    #selectedPart(): Found | undefined {
        const place = this.selected;
        const drawing = place && [...this.#drawings.values()].find(({ first, node }) => {
            const segment = this.layout.at(place.line);
            return segment?.first === first && node.isConnected;
        });
        const isAt = ({ at: [line, character] }: Part) => drawing && place && drawing.first + line === place.line && character === place.character;
        const point = place?.isPoint === true ? drawing?.points.find(isAt) : undefined;
        // A comment has no elements: it is one of its own places.
        const part = point ?? (place && (drawing?.partAt(place.line, place.character) ?? drawing?.points[0]));
        return drawing && part && { drawing, part };
    }

    /** The element next to the one that was selected, if that is gone, and not only out of sight. */
    #nearestPart(): Found | undefined {
        const line = this.selected?.line ?? 0;
        if (this.layout.at(line)?.piece) {
            return undefined;
        }
        const far = ({ first }: Drawing) => Math.abs(first - line);
        const [drawing] = [...this.#drawings.values()].filter(({ parts }) => parts.length > 0).sort((a, b) => far(a) - far(b));
        const part = drawing && (drawing.first < line ? drawing.parts.at(-1) : drawing.parts[0]);
        return drawing && part && { drawing, part };
    }

    /** The element that has the focus, or had it last. */
    get selection(): Found | undefined {
        return this.#selectedPart();
    }

    /** The tabulator comes back to this element. Where a person chose it, it keeps the focus, whatever else was to get it. */
    hasFocus({ drawing, part }: Found): void {
        if (!this.#isGiven) {
            this.#soon &&= { ...this.#soon, isLeft: true };
        }
        for (const node of this.#canvas.querySelectorAll('g.element[tabindex="0"]')) {
            node.setAttribute('tabindex', '-1');
        }
        part.node.setAttribute('tabindex', '0');
        this.selected = { line: drawing.first + part.at[0], character: part.at[1], isPoint: drawing.points.includes(part) };
    }

    /** Gives an element the focus: a person chose it. */
    select(found: Found, scrolls = true): void {
        this.hasFocus(found);
        found.part.node.focus({ preventScroll: true });
        if (scrolls) {
            this.#bringIntoView(found);
        }
    }

    /** Gives it the focus by itself, since something is drawn. */
    #give(act: () => void): void {
        this.#isGiven = true;
        act();
        this.#isGiven = false;
    }

    /** So that the tabulator comes to some element, and to the page itself only while there is none. */
    makeReachable(): void {
        this.#view.tabIndex = this.isEmpty ? 0 : -1;
        if (!this.#canvas.querySelector('g.element[tabindex="0"]')) {
            const { part } = this.selection ?? this.spots()[0]?.found ?? {};
            part?.node.setAttribute('tabindex', '0');
        }
    }

    #bringIntoView({ drawing, part }: Found): void {
        const { box } = part;
        const scale = this.layout.scale;
        const top = Number(drawing.node.dataset['top'] ?? 0) + box.y * scale;
        const view = this.#view;
        const [height, width] = [box.height * scale, box.width * scale];
        if (top < view.scrollTop) {
            view.scrollTop = top - 24;
        } else if (top + height > view.scrollTop + view.clientHeight) {
            view.scrollTop = top + height + 24 - view.clientHeight;
        }
        const left = box.x * scale;
        if (left < view.scrollLeft || left + width > view.scrollLeft + view.clientWidth) {
            view.scrollLeft = Math.max(left - 48, 0);
        }
    }

    /** The cursor of the text is here: its element is marked, and comes into sight. */
    cursorAt(place: Place): void {
        this.#cursor = place;
        this.#scrollTo(place.line);
        this.#markCursor(true);
    }

    /** A line that is not on the page comes into sight. */
    #scrollTo(line: number): void {
        const segment = this.layout.at(line);
        if (!segment?.piece || !this.#drawings.has(segment.piece.id)) {
            const top = this.layout.topOf(line);
            const isSeen = top >= this.#view.scrollTop && top < this.#view.scrollTop + this.#view.clientHeight - 40;
            if (!isSeen) {
                this.#view.scrollTop = Math.max(top - this.#view.clientHeight / 3, 0);
                this.update();
            }
        }
    }

    #markCursor(scrolls: boolean): void {
        const place = this.#cursor;
        const piece = place && this.layout.at(place.line)?.piece;
        const drawing = piece && this.#drawings.get(piece.id);
        const part = place && drawing?.partAt(place.line, place.character);
        for (const node of this.#canvas.querySelectorAll('g.element.cursor')) {
            if (node !== part?.node) {
                node.classList.remove('cursor');
            }
        }
        for (const node of this.#canvas.querySelectorAll('.piece.here')) {
            node.classList.toggle('here', node === drawing?.node);
        }
        drawing?.node.classList.add('here');
        if (drawing && part) {
            part.node.classList.add('cursor');
            if (scrolls) {
                this.#bringIntoView({ drawing, part });
            }
        }
    }
}
