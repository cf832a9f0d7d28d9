// Drawing: what keys, menus and the mouse change in the text by way of the diagram. Each change is one edit of the server; what
// a person writes is asked for first, so that nothing half written is ever in the text.
import type { DrawableRow } from '../../protocol.ts';
import { reasonOf } from '../../reason.ts';
import type { FromPage, Place } from '../messages.ts';
import type { Found, Page } from '../page.ts';
import { type Step, stepped } from './along.ts';
import type { Ask } from './asker.ts';
import type { Choice, Field } from './field.ts';
import { HEAD, Operands } from './operands.ts';
import { COIL } from './palette.ts';
import type { Asked, Edit, Offered } from './requests.ts';
import { aboutOf, rangeOf, Selection } from './selection.ts';

/** What is said of a change, and of one that cannot be made. */
export interface Voice {
    said(text: string): void;
    refused(text: string): void;
}

/** Where something is put in, and how: into the wire there, or as a branch around what is between two places. */
export type Target = { readonly at: Place } | { readonly from: Place; readonly to: Place; readonly side: 'below' | 'above' };

export class Pen {
    readonly voice: Voice;
    readonly page: Page;
    readonly selection: Selection;
    readonly #field: Field;
    readonly #operands: Operands;
    readonly #ask: Ask;
    readonly #send: (message: FromPage) => void;
    /** Where a branch begins that has no end yet. */
    #begun: Found | undefined;
    /** What had the focus before each change, and after those that were taken back. */
    #past: Page['selected'][] = [];
    #future: Page['selected'][] = [];

    constructor(page: Page, field: Field, ask: Ask, voice: Voice, send: (message: FromPage) => void) {
        this.page = page;
        this.voice = voice;
        this.selection = new Selection(page);
        this.#field = field;
        this.#operands = new Operands(page, field, ask);
        this.#ask = ask;
        this.#send = send;
    }

    /** Makes a change. */
    async edit(edit: Edit): Promise<void> {
        const { version } = this.page.layout;
        const before = this.page.selected && { ...this.page.selected };
        try {
            const { select, focus, said, version: becomes } = await this.#ask('edit', { version, edit });
            this.selection.forget();
            this.#past.push(before);
            this.#future = [];
            this.voice.said(said);
            const places = select.length > 0 ? select.map(({ start }) => start) : focus ? [focus] : [];
            await (places.length > 0 && this.page.focusSoon(places, becomes, select.length === 0));
        } catch (error) {
            this.voice.refused(reasonOf(error));
        }
    }

    /** Goes back or forward in the text's history, with what was selected. */
    async history(step: 'undo' | 'redo'): Promise<void> {
        const [from, to] = step === 'undo' ? [this.#past, this.#future] : [this.#future, this.#past];
        const { selected } = this.page;
        const place = from.pop();
        to.push(selected && { ...selected });
        this.#send({ type: step });
        if (place) {
            await this.page.focusSoon([place], this.page.layout.version + 1, place.isPoint === true);
        }
    }

    /** What can be done. */
    async offer(asked: Asked): Promise<Offered | undefined> {
        try {
            return await this.#ask('offer', { version: this.page.layout.version, ...asked });
        } catch (error) {
            this.voice.refused(reasonOf(error));
            return undefined;
        }
    }

    /** The same, where nobody has asked for anything. */
    async look(asked: Asked): Promise<Offered | undefined> {
        return this.#ask('offer', { version: this.page.layout.version, ...asked }).catch(() => undefined);
    }

    /** Where something goes that is put in here: into this wire, or behind this element. */
    async placeOf(found: Found): Promise<Place | undefined> {
        if (aboutOf(found) !== 'element') {
            return aboutOf(found) === 'note' ? rangeOf(found).end : rangeOf(found).start;
        }
        const offer = await this.offer({ what: [rangeOf(found)] });
        return offer && (offer.points?.behind ?? rangeOf(found).end);
    }

    #spot(found: Found): { x: number; y: number } {
        const { left, top, height } = this.page.boxOf(found);
        return { x: left, y: top + height + 2 };
    }

    /** Draws a block, whose operands are asked for first. */
    async draw({ block, title, operands }: Pick<DrawableRow, 'block' | 'title' | 'operands'>, found: Found, target?: Target): Promise<void> {
        const at = target ?? (await this.placeOf(found).then((at) => at && { at }));
        if (!at) {
            return;
        }
        let text = block;
        if (operands !== undefined) {
            const asked = { at: 'at' in at ? at.at : at.from };
            const written = await this.#operands.ofNew(block, asked, { label: title, text: operands, spot: this.#spot(found) });
            found.part.node.focus({ preventScroll: true });
            const name = written?.text === '' ? (await this.offer(asked))?.name : written?.text;
            if (name === undefined) {
                return;
            }
            text = `${block}( ${name} )`;
        }
        await this.edit('at' in at ? { op: 'insert', at: at.at, text } : { op: 'parallel', ...at, text });
    }

    /** A coil goes to the end of the line; where something acts there already, below that. */
    async coil(found: Found): Promise<void> {
        const offer = await this.offer(aboutOf(found) === 'element' ? { what: [rangeOf(found)] } : { at: rangeOf(found).start });
        const acting = offer?.acting;
        await (offer && this.draw(COIL, found, acting && { ...acting, side: 'below' }));
    }

    /** A contact in parallel to what is selected. */
    async branch(row: Pick<DrawableRow, 'block' | 'title' | 'operands'>, side: 'below' | 'above'): Promise<void> {
        const selected = this.selection.all;
        const [first, last] = [selected[0], selected.at(-1)];
        if (first && last) {
            const target = { from: rangeOf(first).start, to: rangeOf(last).end, side };
            await this.draw({ ...row, title: `${row.title} in parallel, ${side}` }, last, target);
        } else {
            this.voice.refused('Select what the branch goes around: an element, or several with Shift');
        }
    }

    /** A branch begins here, and ends where the next key says so. */
    beginBranch(found: Found): void {
        this.endBranch();
        this.#begun = found;
        found.part.node.classList.add('begun');
        this.voice.said('A branch begins here: go to where it ends, and press /');
    }

    /** @returns whether a branch has begun */
    endBranch(): Found | undefined {
        const begun = this.#begun;
        begun?.part.node.classList.remove('begun');
        this.#begun = undefined;
        return begun?.part.node.isConnected === true ? begun : undefined;
    }

    get isBranchBegun(): boolean {
        return this.#begun !== undefined;
    }

    /** The branch that has begun ends here: with a first element on one line, else a loose end is joined to the line above. */
    async closeBranch(found: Found, row: DrawableRow): Promise<void> {
        const begun = this.endBranch();
        if (!begun) {
            return;
        }
        const [from, to] = [rangeOf(begun).start, rangeOf(found).start];
        if (from.line === to.line) {
            await this.draw({ ...row, title: `${row.title} in the branch` }, found, { from, to, side: 'below' });
        } else {
            const [upper, lower] = from.line < to.line ? [from, to] : [to, from];
            await this.edit({ op: 'close', what: lower, to: upper });
        }
    }

    /** Moves what is selected a step, or the end of a branch along its line. */
    async step(found: Found, step: Step): Promise<void> {
        const to = stepped(found, step);
        if (!to) {
            this.voice.refused('There is no wire in that direction');
        } else if (aboutOf(found) === 'join') {
            await this.edit({ op: 'branchEnd', what: rangeOf(found).start, to });
        } else if (aboutOf(found) !== 'point') {
            await this.edit({ op: 'move', what: this.selection.ranges, to: { at: to } });
        }
    }

    /** Writes another operand in the place of this one, or of the first; the tabulator goes on to the next. */
    async operand(found: Found, index = 0): Promise<void> {
        const { drawing, part } = found;
        const operand = part.operands[index];
        if (!operand) {
            this.voice.refused(`${part.name} has nothing in parentheses`);
            return;
        }
        const [line, character] = operand.place;
        const start = { line: drawing.first + line, character };
        const what = { start, end: { ...start, character: character + operand.text.length } };
        const asked = { what: [rangeOf(found)] };
        const written = await this.#operands.another(operand.text, part.kind !== 'block', asked, { label: part.name, spot: this.#spot(found) });
        part.node.focus({ preventScroll: true });
        if (written && written.text !== operand.text) {
            await this.edit({ op: 'operand', what, text: written.text });
        }
        const next = written?.next ? this.page.selection : undefined;
        if (next && index + 1 < next.part.operands.length) {
            await this.operand(next, index + 1);
        }
    }

    /** Gives a contact or coil another head. */
    async head(found: Found, choose: (head: string) => string | undefined): Promise<void> {
        const { start } = rangeOf(found);
        const offer = await this.offer({ what: [rangeOf(found)] });
        const head = offer?.text?.slice(0, HEAD);
        const text = head && choose(head);
        if (text) {
            await this.edit({ op: 'head', what: { start, end: { ...start, character: start.character + HEAD } }, text });
        } else if (offer) {
            this.voice.refused(`${found.part.name} has no such kind`);
        }
    }

    /** Asks for a whole network, or for a piece of one. */
    async entry(found: Found | undefined, place: 'below' | 'above' | 'here'): Promise<void> {
        const spot = found ? this.#spot(found) : { x: 8, y: this.page.layout.height };
        const label = place === 'here' ? 'Quick entry' : `Network ${place}`;
        const choices = async (text: string) => (text === '' ? this.#begins(place === 'here') : []);
        const written = await this.#field.ask({ label, placeholder: 'XIC start XIO stop OTE run', spot, choices });
        found?.part.node.focus({ preventScroll: true });
        if (!written?.text) {
            return;
        }
        if (place === 'here' && found) {
            const at = await this.placeOf(found);
            await (at && this.edit({ op: 'insert', at, text: written.text }));
            return;
        }
        const network = found && { network: found.drawing.first };
        await this.edit({ op: 'network', ...network, place: place === 'above' ? 'above' : 'below', entry: written.text });
    }

    /** What a network may begin with, for who does not type: its tags get other names later. */
    async #begins(isPiece: boolean): Promise<Choice[]> {
        const { tags } = await this.#ask('tags', {}).catch(() => ({ tags: [] }));
        const names = new Set(tags.map(({ name }) => name.toLowerCase()));
        const free = (word: string) => {
            let number = 1;
            while (names.has(`${word}_${number}`)) {
                number += 1;
            }
            return `${word}_${number}`;
        };
        const contact = `[ ]( ${free('contact')} )`;
        return isPiece
            ? [{ text: contact, about: 'A contact, to be renamed' }]
            : [
                  { text: `${contact}--( )( ${free('coil')} )`, about: 'A contact and a coil, to be renamed' },
                  { text: `${contact}--[TON]( ${free('timer')}, 5s )`, about: 'A contact and a timer' },
              ];
    }

    /** Asks for one line, such as a comment or a new name. */
    async line(found: Found, label: string, text: string, edit: (text: string) => Edit): Promise<void> {
        const { left, top } = this.page.boxOf(found);
        const written = await this.#field.ask({ label, text, spot: { x: left, y: top }, choices: () => [] });
        found.part.node.focus({ preventScroll: true });
        if (written?.text) {
            await this.edit(edit(written.text));
        }
    }

    /** Deletes what is selected. */
    async remove(): Promise<void> {
        const note = this.selection.all.find((found) => found.drawing.piece.kind === 'comment');
        const what = this.selection.ranges;
        if (note) {
            await this.edit({ op: 'comment', what: rangeOf(note), text: '' });
        } else if (what.length > 0) {
            await this.edit({ op: 'delete', what });
        }
    }

    async moveNetwork(found: Found, by: 1 | -1): Promise<void> {
        const networks = this.page.networks();
        const index = networks.indexOf(found.drawing.first);
        const before = by < 0 ? networks[index - 1] : (networks[index + 2] ?? null);
        if (index >= 0 && before !== undefined && (by < 0 || index + 1 < networks.length)) {
            await this.edit({ op: 'moveNetwork', network: found.drawing.first, before });
        } else {
            this.voice.refused(`There is no network ${by < 0 ? 'above' : 'below'} this one`);
        }
    }

    async larger(found: Found): Promise<void> {
        const { largerThings = [] } = (await this.offer({ what: this.selection.ranges })) ?? {};
        if (largerThings.length > 0) {
            this.selection.these(found, largerThings);
        }
    }

    /** Moves elements, or draws a copy of them. */
    async drop(found: readonly Found[], target: Target, isCopy: boolean): Promise<void> {
        const what = found.map(rangeOf);
        const [first] = found;
        if (first && aboutOf(first) === 'join') {
            await ('at' in target && this.edit({ op: 'branchEnd', what: rangeOf(first).start, to: target.at }));
            return;
        }
        if ('at' in target && !isCopy) {
            await this.edit({ op: 'move', what, to: target });
            return;
        }
        const text = (await this.offer({ what }))?.text;
        if (text) {
            await this.edit('at' in target ? { op: 'insert', at: target.at, text, copied: true } : { op: 'parallel', ...target, text, copied: true });
        }
    }
}
