// Drawing: what keys, menus and the mouse change in the text by way of the diagram. Each change is one edit of the server; what
// a person writes is asked for first, so that nothing half written is ever in the text.
import type { DrawableRow } from '../../protocol.ts';
import { reasonOf } from '../../reason.ts';
import type { FromPage, Place } from '../messages.ts';
import type { Found, Page } from '../page.ts';
import type { Aim, Target } from './aim.ts';
import { type Step, stepped } from './along.ts';
import type { Ask } from './asker.ts';
import type { Again, Choice, Field, Wanted, Written } from './field.ts';
import { HEAD, Operands } from './operands.ts';
import { COIL } from './palette.ts';
import type { Asked, Edit, Offered } from './requests.ts';
import { aboutOf, rangeOf, Selection } from './selection.ts';

/** What is said of a change, and of one that cannot be made. */
export interface Voice {
    said(text: string): void;
    refused(text: string): void;
}

/** The change that something written means; nothing if it means none. */
type EditOf = (text: string) => Edit | undefined | Promise<Edit | undefined>;

/** How far left of a ring its field begins, in pixels. */
const BESIDE_RING = 12;

export class Pen {
    readonly voice: Voice;
    readonly page: Page;
    readonly selection: Selection;
    readonly #field: Field;
    readonly #operands: Operands;
    readonly #aim: Aim;
    readonly #ask: Ask;
    readonly #send: (message: FromPage) => void;
    /** Where a branch begins that has no end yet. */
    #begun: Found | undefined;
    /** The end of what was begun last: then what is selected is in the text as it is. */
    settled: Promise<unknown> = Promise.resolve();
    /** What had the focus before each change, and after those that were taken back. */
    #past: Page['selected'][] = [];
    #future: Page['selected'][] = [];

    constructor(page: Page, field: Field, aim: Aim, ask: Ask, voice: Voice, send: (message: FromPage) => void) {
        this.page = page;
        this.voice = voice;
        this.selection = new Selection(page);
        this.#field = field;
        this.#operands = new Operands(page, field, ask);
        this.#aim = aim;
        this.#ask = ask;
        this.#send = send;
    }

    /** Makes a change. */
    async edit(edit: Edit): Promise<void> {
        await this.#make(edit);
    }

    /** The same. @param isLeft something else has the focus by now, and keeps it. @returns why it was not made */
    #make(edit: Edit, isLeft = false): Promise<string | undefined> {
        const made = this.#made(edit, isLeft);
        this.settled = made;
        return made;
    }

    async #made(edit: Edit, isLeft: boolean): Promise<string | undefined> {
        const { version } = this.page.layout;
        const before = this.page.selected && { ...this.page.selected };
        try {
            const { select, focus, said, version: becomes } = await this.#ask('edit', { version, edit });
            this.selection.forget();
            this.#past.push(before);
            this.#future = [];
            this.voice.said(said);
            const places = select.length > 0 ? select.map(({ start }) => start) : focus ? [focus] : [];
            await (places.length > 0 && this.page.focusSoon({ places, version: becomes, isPoint: select.length === 0, isLeft }));
            return undefined;
        } catch (error) {
            const why = reasonOf(error);
            this.voice.refused(why);
            return why;
        }
    }

    /** Asks for a text and makes its change. What cannot be done is asked for again, with the reason. @returns what was done */
    #written(found: Found | undefined, ask: (again?: Again) => Promise<Written | undefined>, editOf: EditOf): Promise<Written | undefined> {
        const written = this.#writing(found, ask, editOf);
        this.settled = written;
        return written;
    }

    async #writing(found: Found | undefined, ask: (again?: Again) => Promise<Written | undefined>, editOf: EditOf): Promise<Written | undefined> {
        let again: Again | undefined;
        for (;;) {
            const written = await ask(again);
            if (document.activeElement === document.body) {
                found?.part.node.focus({ preventScroll: true });
            }
            const edit = written && (await editOf(written.text));
            const why = edit && (await this.#make(edit, written.isLeft));
            if (!written || why === undefined || written.isLeft) {
                return why === undefined ? written : undefined;
            }
            again = { text: written.text, why };
        }
    }

    /** Goes back or forward in the text's history, with what was selected. @param isKey a key asks for it */
    async history(step: 'undo' | 'redo', isKey: boolean): Promise<void> {
        const [from, to] = step === 'undo' ? [this.#past, this.#future] : [this.#future, this.#past];
        const { selected } = this.page;
        const place = from.pop();
        to.push(selected && { ...selected });
        this.#send({ type: step, isKey });
        if (place) {
            await this.page.focusSoon({ places: [place], version: this.page.layout.version + 1, isPoint: place.isPoint === true });
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

    /** Where a field about something is: below it, and below the middle of a wire. */
    #spot(found: Found): { x: number; y: number } {
        const { left, top, width, height } = this.page.boxOf(found);
        return { x: aboutOf(found) === 'point' ? left + width / 2 - BESIDE_RING : left, y: top + height + 2 };
    }

    /** Draws a block, whose operands are asked for first. @param around what a branch goes around, if it is one */
    async draw({ block, title, operands }: Pick<DrawableRow, 'block' | 'title' | 'operands'>, found: Found, target?: Target, around: readonly Found[] = [found]): Promise<void> {
        const at = target ?? (await this.placeOf(found).then((at) => at && { at }));
        if (!at) {
            return;
        }
        const editOf = (text: string): Edit => ('at' in at ? { op: 'insert', at: at.at, text } : { op: 'parallel', ...at, text });
        if (operands === undefined) {
            await this.edit(editOf(block));
            return;
        }
        const asked = { at: 'at' in at ? at.at : at.from };
        this.#aim.show(at, around);
        const spot = this.#spot(found);
        await this.#written(
            found,
            (again) => this.#operands.ofNew(block, asked, { label: this.page.called.sentence(title), text: operands, spot, again }),
            async (text) => {
                this.#aim.hide();
                const name = text || (await this.offer(asked))?.name;
                return name === undefined ? undefined : editOf(`${block}( ${name} )`);
            },
        );
        this.#aim.hide();
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
            await this.draw({ ...row, title: `${row.title} in parallel, ${side}` }, last, target, selected);
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
        const spot = this.#spot(found);
        const written = await this.#written(
            found,
            (again) => this.#operands.another(operand.text, part.kind !== 'block', asked, { label: part.name, spot, again }),
            (text) => (text === operand.text ? undefined : { op: 'operand', what, text }),
        );
        const here = written?.next ? this.page.selection : undefined;
        if (here && index + 1 < here.part.operands.length) {
            await this.operand(here, index + 1);
        } else if (here) {
            await this.#operandAfter(here);
        }
    }

    /** The tabulator goes on to the next element of the network that has something in parentheses. */
    async #operandAfter({ drawing, part }: Found): Promise<void> {
        const next = drawing.parts.slice(drawing.parts.indexOf(part) + 1).find(({ operands }) => operands.length > 0);
        if (next) {
            this.page.select({ drawing, part: next });
            await this.operand({ drawing, part: next });
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
        const spot = !found ? { x: 8, y: this.page.layout.height } : place === 'here' ? this.#spot(found) : this.page.beside(found, place);
        const label = place === 'here' ? 'Quick entry' : `Network ${place}`;
        const begins = await this.#begins(place === 'here');
        const choices = (before: string) => (before === '' ? begins : this.#operands.within(before));
        const at = place === 'here' && found ? await this.placeOf(found) : undefined;
        const network = found && { network: found.drawing.first };
        await this.#written(
            found,
            (again) => this.#field.ask({ label, kind: 'drawing', placeholder: 'XIC start XIO stop OTE run', spot, choices, again }),
            (text) => {
                if (text === '') {
                    return undefined;
                }
                return at ? { op: 'insert', at, text } : { op: 'network', ...network, place: place === 'above' ? 'above' : 'below', entry: text };
            },
        );
    }

    /** What a network may begin with, for who does not type more than names. */
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
            ? [{ text: contact, about: 'A contact', isBegun: true }]
            : [
                  { text: `${contact}--( )( ${free('coil')} )`, about: 'A contact and a coil', isBegun: true },
                  { text: `${contact}--[TON]( ${free('timer')}, 5s )`, about: 'A contact and a timer', isBegun: true },
              ];
    }

    /** Asks for a text, such as a comment or a new name. */
    async line(found: Found, { label, text = '', kind = 'line' }: Pick<Wanted, 'label' | 'text' | 'kind'>, edit: (text: string) => Edit): Promise<void> {
        const { left, top } = this.page.boxOf(found);
        const spot = { x: left, y: top };
        await this.#written(
            found,
            (again) => this.#field.ask({ label, text, spot, kind, again }),
            (written) => (written === '' || written === text ? undefined : edit(written)),
        );
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
        if (!found.every(({ part }) => part.node.isConnected)) {
            this.voice.refused('The drawing has changed meanwhile: try again');
            return;
        }
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
