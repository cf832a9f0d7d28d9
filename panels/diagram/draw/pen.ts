// Drawing: what keys and the mouse change in the text by way of the diagram. Each change is one edit of the server; what a
// person writes is asked for first, so that nothing half written is ever in the text.
import type { DrawableRow, Range } from '../../protocol.ts';
import { reasonOf } from '../../reason.ts';
import type { FromPage, Place } from '../messages.ts';
import type { Found, Page } from '../page.ts';
import type { Ask } from './asker.ts';
import type { Choice, Field, Written } from './field.ts';
import type { Asked, Edit, Offered, Requests } from './requests.ts';
import { CLOSED_CONTACT, COIL, CONTACT } from './palette.ts';

/** What is said of a change, and of one that cannot be made. */
export interface Voice {
    said(text: string): void;
    refused(text: string): void;
}

/** The heads that one key makes of each other. */
const OPPOSITE: Readonly<Record<string, string>> = { '[ ]': '[/]', '[/]': '[ ]', '( )': '(/)', '(/)': '( )' };

/** The kinds that one key goes through. */
const KINDS: readonly (readonly string[])[] = [['[ ]', '[/]', '[P]', '[N]'], ['( )', '(/)', '(S)', '(R)', '(P)', '(N)']];

/** How many letters the head of a contact or coil has. */
const HEAD = 3;

function order(a: Place, b: Place): number {
    return a.line - b.line || a.character - b.character;
}

/** Where an element is in the text. */
export function rangeOf({ drawing, part: { at, end } }: Found): Range {
    return { start: { line: drawing.first + at[0], character: at[1] }, end: { line: drawing.first + end[0], character: end[1] } };
}

/** Where something is put in, and how: into the wire there, or as a branch around what is between two places. */
export type Target = { readonly at: Place } | { readonly from: Place; readonly to: Place; readonly side: 'below' | 'above' };

export class Pen {
    readonly #page: Page;
    readonly #field: Field;
    readonly #ask: Ask;
    readonly #voice: Voice;
    readonly #send: (message: FromPage) => void;
    readonly #palette: () => void;
    /** What is selected besides what has the focus. */
    #also: Found[] = [];
    /** The elements that are to be moved, and the text that is copied. */
    #held: readonly Range[] = [];
    #copied = '';
    /** The tags that there were when the field was opened. */
    #known: Promise<Requests['tags']['answer']> | undefined;

    constructor(page: Page, field: Field, ask: Ask, voice: Voice, send: (message: FromPage) => void, palette: () => void) {
        this.#page = page;
        this.#field = field;
        this.#ask = ask;
        this.#voice = voice;
        this.#send = send;
        this.#palette = palette;
    }

    /** The element or place that has the focus. */
    get #here(): Found | undefined {
        return this.#page.find(document.activeElement) ?? this.#page.selection;
    }

    /** The selected elements, from left to right. */
    get selected(): readonly Found[] {
        const here = this.#here;
        const all = [...this.#also, ...(here ? [here] : [])].filter(({ part }) => part.kind !== 'point' && part.node.isConnected);
        return [...new Map(all.map((found) => [found.part.node, found])).values()].sort((a, b) => order(rangeOf(a).start, rangeOf(b).start));
    }

    get #what(): Range[] {
        return this.selected.map(rangeOf);
    }

    /** Selects more: a click with Shift, or an arrow. */
    extend(found: Found): void {
        const here = this.#here;
        this.#also = [...this.#also, ...(here ? [here] : [])].filter(({ drawing }) => drawing === found.drawing);
        this.#mark();
    }

    /** Nothing but what has the focus is selected. */
    forget(): void {
        if (this.#also.length > 0) {
            this.#also = [];
            this.#mark();
        }
    }

    #mark(): void {
        const selected = new Set(this.#also.map(({ part }) => part.node as Element));
        for (const node of document.querySelectorAll('g.element.chosen')) {
            if (!selected.has(node)) {
                node.classList.remove('chosen');
            }
        }
        selected.forEach((node) => node.classList.add('chosen'));
    }

    /** Makes a change. */
    async edit(edit: Edit): Promise<void> {
        const { version } = this.#page.layout;
        try {
            const { select, focus, said, version: becomes } = await this.#ask('edit', { version, edit });
            this.forget();
            this.#voice.said(said);
            const places = select.length > 0 ? select.map(({ start }) => start) : focus ? [focus] : [];
            await this.#page.focusSoon(places, becomes, select.length === 0);
        } catch (error) {
            this.#voice.refused(reasonOf(error));
        }
    }

    async #offer(asked: Asked): Promise<Offered | undefined> {
        try {
            return await this.#ask('offer', { version: this.#page.layout.version, ...asked });
        } catch (error) {
            this.#voice.refused(reasonOf(error));
            return undefined;
        }
    }

    /** Where something goes that is put in here: into this wire, or behind this element. */
    async #placeOf(found: Found): Promise<Place | undefined> {
        if (found.part.kind === 'point') {
            return rangeOf(found).start;
        }
        const offer = await this.#offer({ what: [rangeOf(found)] });
        return offer?.points?.behind ?? rangeOf(found).end;
    }

    #spot(found: Found): { x: number; y: number } {
        const { left, top, height } = this.#page.boxOf(found);
        return { x: left, y: top + height + 2 };
    }

    /** The tags that may be meant, those that begin so first. */
    async #tags(text: string, isBool: boolean): Promise<Choice[]> {
        const word = /[\w.]*$/.exec(text)?.[0].toLowerCase() ?? '';
        const before = text.slice(0, text.length - word.length);
        // Each letter narrows the same tags.
        this.#known ??= this.#ask('tags', {}).catch((error: unknown) => {
            this.#known = undefined;
            throw error;
        });
        const { tags } = await this.#known;
        const fitting = tags.filter(({ name, type }) => name.toLowerCase().includes(word) && (!isBool || type === 'BOOL'));
        const rank = (name: string) => (name.toLowerCase().startsWith(word) ? 0 : 1);
        return fitting
            .sort((a, b) => rank(a.name) - rank(b.name) || a.name.localeCompare(b.name))
            .map(({ name, type, kind, comment }) => ({ text: before + name, about: [`${type}, ${kind}`, comment].filter(Boolean).join('  ') }));
    }

    /** Which names of a text are new, and what they would be. */
    async #news(text: string, head: string, asked: Asked): Promise<string> {
        if (!text) {
            return '';
        }
        const { declares = [] } = await this.#ask('offer', { version: this.#page.layout.version, ...asked, text: `${head}( ${text} )` });
        return declares.map(({ name, type, section }) => `${name} is new: ${type} in ${section}`).join(', ');
    }

    /** Asks for what is in the parentheses of a block. */
    async #operands(found: Found, label: string, head: string, text: string, asked: Asked): Promise<Written | undefined> {
        const isBool = head.length === HEAD;
        this.#known = undefined;
        const written = await this.#field.ask({
            label,
            text,
            placeholder: isBool ? 'tag' : '',
            spot: this.#spot(found),
            choices: (text) => this.#tags(text, isBool),
            note: (text) => this.#news(text, head, asked),
        });
        if (written?.text === '') {
            const { names } = (await this.#offer(asked)) ?? {};
            return names === undefined ? undefined : { ...written, text: names };
        }
        return written;
    }

    /** Draws a block, whose operands are asked for first. */
    async draw({ block, title, operands }: Pick<DrawableRow, 'block' | 'title' | 'operands'>, found: Found, target?: Target): Promise<void> {
        const at = target ?? (await this.#placeOf(found).then((at) => at && { at }));
        if (!at) {
            return;
        }
        const asked = { at: 'at' in at ? at.at : at.from };
        const written = operands === undefined ? { text: '' } : await this.#operands(found, title, block, operands, asked);
        found.part.node.focus({ preventScroll: true });
        if (written) {
            const text = operands === undefined ? block : `${block}( ${written.text} )`;
            await this.edit('at' in at ? { op: 'insert', at: at.at, text } : { op: 'parallel', ...at, text });
        }
    }

    /** A coil goes to the end of the line; where something acts there already, below that. */
    async coil(found: Found): Promise<void> {
        const asked: Asked = found.part.kind === 'point' ? { at: rangeOf(found).start } : { what: [rangeOf(found)] };
        const offer = await this.#offer(asked);
        const acting = offer?.acting;
        await this.draw(COIL, found, acting && { ...acting, side: 'below' });
    }

    /** A contact in parallel to what is selected. */
    async branch(side: 'below' | 'above'): Promise<void> {
        const selected = this.selected;
        const [first, last] = [selected[0], selected.at(-1)];
        if (first && last) {
            const target = { from: rangeOf(first).start, to: rangeOf(last).end, side };
            await this.draw({ block: '[ ]', title: `Contact in parallel, ${side}`, operands: '' }, last, target);
        } else {
            this.#voice.refused('Select what the branch goes around: an element, or several with Shift');
        }
    }

    /** Writes another operand in the place of this one, or of the first; the tabulator goes on to the next. */
    async operand(found: Found, index = 0): Promise<void> {
        const { drawing, part } = found;
        const operand = part.operands[index];
        if (!operand) {
            this.#voice.refused(`${part.name} has nothing in parentheses`);
            return;
        }
        const [line, character] = operand.place;
        const start = { line: drawing.first + line, character };
        const what = { start, end: { ...start, character: character + operand.text.length } };
        const isBool = part.kind !== 'block';
        this.#known = undefined;
        const written = await this.#field.ask({
            label: part.name,
            text: operand.text,
            spot: this.#spot(found),
            choices: (text) => this.#tags(text === operand.text ? '' : text, isBool),
            note: (text) => this.#news(isBool && text !== operand.text ? text : '', '[ ]', { what: [rangeOf(found)] }),
        });
        part.node.focus({ preventScroll: true });
        if (written && written.text !== operand.text) {
            await this.edit({ op: 'operand', what, text: written.text });
        }
        const next = written?.next ? this.#page.selection : undefined;
        if (next && index + 1 < next.part.operands.length) {
            await this.operand(next, index + 1);
        }
    }

    /** Gives a contact or coil another head. */
    async head(found: Found, choose: (head: string) => string | undefined): Promise<void> {
        const { start } = rangeOf(found);
        const offer = await this.#offer({ what: [rangeOf(found)] });
        const head = offer?.text?.slice(0, HEAD);
        const text = head && choose(head);
        if (text) {
            await this.edit({ op: 'head', what: { start, end: { ...start, character: start.character + HEAD } }, text });
        } else if (offer) {
            this.#voice.refused(`${found.part.name} has no such kind`);
        }
    }

    /** Asks for a whole network, or for a piece of one. */
    async entry(found: Found | undefined, place: 'below' | 'above' | 'here'): Promise<void> {
        const spot = found ? this.#spot(found) : { x: 8, y: this.#page.layout.height };
        const label = place === 'here' ? 'Quick entry' : `Network ${place}`;
        const written = await this.#field.ask({ label, placeholder: 'XIC start XIO stop OTE run', spot, choices: () => [] });
        found?.part.node.focus({ preventScroll: true });
        if (!written?.text) {
            return;
        }
        if (place === 'here' && found) {
            const at = await this.#placeOf(found);
            await (at && this.edit({ op: 'insert', at, text: written.text }));
            return;
        }
        const network = found && { network: found.drawing.first };
        await this.edit({ op: 'network', ...network, place: place === 'above' ? 'above' : 'below', entry: written.text });
    }

    /** Asks for one line about a network, or for a new name. */
    async #line(found: Found, label: string, text: string, edit: (text: string) => Edit): Promise<void> {
        const { left, top } = this.#page.boxOf(found);
        const written = await this.#field.ask({ label, text, spot: { x: left, y: top }, choices: () => [] });
        found.part.node.focus({ preventScroll: true });
        if (written?.text) {
            await this.edit(edit(written.text));
        }
    }

    async remove(): Promise<void> {
        const what = this.#what;
        if (what.length > 0) {
            await this.edit({ op: 'delete', what });
        }
    }

    async #moveNetwork(found: Found, by: 1 | -1): Promise<void> {
        const networks = this.#page.networks();
        const index = networks.indexOf(found.drawing.first);
        const before = by < 0 ? networks[index - 1] : (networks[index + 2] ?? null);
        if (index >= 0 && before !== undefined && (by < 0 || index + 1 < networks.length)) {
            await this.edit({ op: 'moveNetwork', network: found.drawing.first, before });
        }
    }

    async #larger(found: Found): Promise<void> {
        const { larger } = (await this.#offer({ what: this.#what })) ?? {};
        if (larger) {
            const { start, end } = larger;
            const isInside = (part: Range) =>
                part.start.line >= start.line && part.end.line <= end.line && part.start.character >= start.character && part.end.character <= end.character;
            this.#also = found.drawing.parts.map((part) => ({ drawing: found.drawing, part })).filter((other) => isInside(rangeOf(other)));
            this.#mark();
        }
    }

    /** Takes the selection up, to be put down elsewhere; its text goes to the clipboard. */
    copied(isCut: boolean, clipboard: DataTransfer | null): void {
        const what = this.#what;
        // The clipboard takes what is there at once: the text is asked for when something is selected.
        clipboard?.setData('text/plain', this.#copied);
        this.#held = isCut ? what : [];
        if (isCut) {
            this.#voice.said(`${what.length === 1 ? 'One element is' : `${what.length} elements are`} taken up: paste where it goes`);
        }
    }

    /** Puts down what was taken up, or draws what the clipboard has. */
    async paste(text: string): Promise<void> {
        const here = this.#here;
        if (/^\s*\+/m.test(text)) {
            await this.edit({ op: 'network', ...(here && { network: here.drawing.first }), place: 'below', text, copied: true });
            return;
        }
        const at = here && (await this.#placeOf(here));
        if (!at) {
            return;
        }
        const held = this.#held;
        this.#held = [];
        await this.edit(held.length > 0 ? { op: 'move', what: held, to: { at } } : { op: 'insert', at, text, copied: true });
    }

    /** Something has the focus now: what it is as text is known when it is copied. */
    async focused(): Promise<void> {
        const what = this.#what;
        this.#copied = '';
        if (what.length > 0) {
            const offer = await this.#ask('offer', { version: this.#page.layout.version, what }).catch(() => undefined);
            this.#copied = offer?.text ?? '';
        }
    }

    /** Moves elements, or draws a copy of them. */
    async drop(what: readonly Range[], target: Target, isCopy: boolean): Promise<void> {
        if ('at' in target && !isCopy) {
            await this.edit({ op: 'move', what, to: target });
            return;
        }
        const offer = await this.#offer({ what });
        const text = offer?.text;
        if (text) {
            await this.edit('at' in target ? { op: 'insert', at: target.at, text, copied: true } : { op: 'parallel', ...target, text, copied: true });
        }
    }

    /** @returns whether the key means something; what it does goes on */
    key({ key, shiftKey, altKey, ctrlKey, metaKey }: KeyboardEvent): boolean {
        const found = this.#here;
        const does = this.#meaning(key, shiftKey, altKey, ctrlKey || metaKey, found);
        void does?.();
        return does !== undefined;
    }

    #meaning(key: string, isShifted: boolean, isAlt: boolean, isControl: boolean, found: Found | undefined): (() => Promise<void> | void) | undefined {
        const letter = key.toLowerCase();
        if (isControl) {
            const step = letter === 'z' ? (isShifted ? 'redo' : 'undo') : letter === 'y' ? 'redo' : undefined;
            return step && (() => this.#send({ type: step }));
        }
        if (isAlt) {
            const by = key === 'ArrowUp' ? -1 : key === 'ArrowDown' ? 1 : undefined;
            return found && isShifted && by ? () => this.#moveNetwork(found, by) : undefined;
        }
        if (letter === 'n') {
            return () => this.entry(found, isShifted ? 'above' : 'below');
        }
        if (!found) {
            return undefined;
        }
        const isPoint = found.part.kind === 'point';
        const network = found.drawing.first;
        switch (letter) {
            case 'c':
                return () => this.draw(isShifted ? CLOSED_CONTACT : CONTACT, found);
            case 'q':
                return () => this.coil(found);
            case 'f':
                return this.#palette;
            case 'i':
            case 'insert':
                return () => this.entry(found, 'here');
            case 'k':
                return () => (isPoint ? this.edit({ op: 'split', at: rangeOf(found).start }) : this.#placeOf(found).then((at) => at && this.edit({ op: 'split', at })));
            case 'j': {
                const networks = this.#page.networks();
                const next = networks[networks.indexOf(network) + 1];
                return () => (next === undefined ? this.#voice.refused('There is no network below this one') : this.edit({ op: 'merge', networks: [network, next] }));
            }
            case 'y':
                return () => this.edit({ op: 'duplicate', network });
            case '#':
                return () => this.#line(found, 'Comment above the network', '', (text) => ({ op: 'comment', network, text }));
            case 'delete':
            case 'backspace':
                if (isShifted) {
                    const what = found.drawing.parts.map((part) => rangeOf({ drawing: found.drawing, part }));
                    return () => this.edit({ op: 'delete', what });
                }
                return () => this.remove();
            case 'escape':
                this.#held = [];
                return () => this.forget();
        }
        if (isPoint) {
            return undefined;
        }
        switch (letter) {
            case 'b':
                return () => this.branch(isShifted ? 'above' : 'below');
            case 'enter':
                return () => this.operand(found);
            case '/':
                return () => this.head(found, (head) => OPPOSITE[head]);
            case 'e':
                return () => this.head(found, (head) => (isShifted ? OPPOSITE[head] : nextKind(head)));
            case 's':
            case 'r':
                return () => this.head(found, (head) => (head.startsWith('(') ? `(${letter.toUpperCase()})` : undefined));
            case 'a':
                return () => this.#larger(found);
            case 'f2': {
                const [operand] = found.part.operands;
                const start = operand && { line: network + operand.place[0], character: operand.place[1] };
                return start && (() => this.#line(found, 'New name of the tag', operand.text, (text) => ({ op: 'rename', what: { start, end: start }, text })));
            }
            default:
                return undefined;
        }
    }
}

function nextKind(head: string): string | undefined {
    const kinds = KINDS.find((kinds) => kinds.includes(head));
    return kinds?.[(kinds.indexOf(head) + 1) % kinds.length];
}
