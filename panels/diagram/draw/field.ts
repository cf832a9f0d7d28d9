// A field in the drawing: what is typed there becomes part of the text when it is finished, and nothing before that.
import { type Segment, segmentsInBlocks, segmentsOf } from './segments.ts';

/** A line of the list below the field. */
export interface Choice {
    readonly text: string;
    /** What is shown of it, if that is less. */
    readonly shown?: string;
    /** What it is, in grey. */
    readonly about: string;
    /** Its names are made up: others are written in their places before it is finished. */
    readonly isBegun?: true;
}

/** What was written before, and why it could not be done. */
export interface Again {
    readonly text: string;
    readonly why: string;
}

/** What is asked for. */
export interface Wanted {
    /** What the field is about: "Open contact". */
    readonly label: string;
    readonly text?: string;
    readonly placeholder?: string;
    /** Where it is, from the upper left corner of the diagram. */
    readonly spot: { readonly x: number; readonly y: number };
    /** One line, operands that follow one another on one, a piece of a drawing, or several lines. */
    readonly kind?: 'line' | 'operands' | 'drawing' | 'lines';
    readonly again?: Again | undefined;
    /** What may be meant by what is typed: all of it, up to the cursor. */
    choices?(before: string): readonly Choice[] | Promise<readonly Choice[]>;
    /** What is to be known of it, such as that a name is new. */
    note?(text: string): Promise<string>;
}

/** What a person has written. */
export interface Written {
    readonly text: string;
    /** The next field is to follow. */
    readonly next: boolean;
    /** Something else was pressed meanwhile: it has the focus. */
    readonly isLeft: boolean;
}

/** What is typed last is asked for, this long after the last key. In milliseconds. */
const PAUSE = 120;
const MOST = 12;
/** How wide the field is, in letters, and how high at most, in lines. */
const [NARROWEST, DRAWN, WIDEST] = [24, 48, 64];
const HIGHEST = 12;
/** What is left free beside it, and how wide and high it is with the longest list, in pixels. */
const BESIDE = 4;
const [WIDEST_LIST, ROOM] = [360, 240];

let fields = 0;

/** Whether somebody types there: letters are letters then. */
export function isField(node: EventTarget | null): node is HTMLInputElement | HTMLTextAreaElement {
    return node instanceof HTMLInputElement || node instanceof HTMLTextAreaElement;
}

export class Field {
    readonly #parent: HTMLElement;
    #end: ((written: Written | undefined) => void) | undefined;

    constructor(parent: HTMLElement) {
        this.#parent = parent;
    }

    get isOpen(): boolean {
        return this.#end !== undefined;
    }

    /** Asks for a text. @returns nothing if it was given up */
    async ask(wanted: Wanted): Promise<Written | undefined> {
        this.#end?.(undefined);
        const node = document.createElement('div');
        node.className = 'field';
        const list = document.createElement('ul');
        list.id = `choices-${++fields}`;
        list.setAttribute('role', 'listbox');
        list.setAttribute('aria-label', wanted.label);
        list.hidden = true;
        const input = inputOf(wanted, list.id);
        const shown = document.createElement('p');
        shown.className = 'note-of-field';
        shown.setAttribute('aria-live', 'polite');
        const take = button('take', '✓', wanted.kind === 'lines' ? 'Take it (Enter; Shift+Enter begins another line)' : 'Take it (Enter)');
        const giveUp = button('give-up', '✕', 'Give up (Escape)');
        const row = document.createElement('div');
        row.className = 'row';
        row.append(input, take, giveUp);
        node.append(row, shown, list);
        this.#parent.append(node);
        const room = this.#parent.clientWidth - Math.max(node.offsetWidth, WIDEST_LIST) - BESIDE;
        node.style.left = `${Math.max(Math.min(wanted.spot.x, room), BESIDE)}px`;
        node.style.top = `${Math.max(wanted.spot.y, 0)}px`;
        // Once, with room for a list: nothing moves under the pointer later.
        node.style.minHeight = `${ROOM}px`;
        node.scrollIntoView({ block: 'nearest', inline: 'nearest' });
        node.style.minHeight = '';
        const choices = new Choices(input, list);
        const { again } = wanted;
        const before = again?.text ?? wanted.text ?? '';
        let asked = 0;
        let later: ReturnType<typeof setTimeout> | undefined;
        const look = async () => {
            const number = ++asked;
            // Half a name may be nothing that can be drawn.
            const told = wanted.note?.(input.value).catch(() => '') ?? '';
            const may = wanted.choices?.(input.value.slice(0, input.selectionStart ?? 0)) ?? [];
            const [found, note] = await Promise.all([may, told]).catch(() => [[], ''] as const);
            if (number === asked && this.isOpen) {
                const isRefused = again !== undefined && input.value === again.text;
                choices.show(found.slice(0, MOST));
                shown.textContent = isRefused ? again.why : note;
                shown.classList.toggle('why', isRefused);
                input.setAttribute('aria-invalid', String(isRefused));
            }
        };
        let segments = (text: string): Segment[] => (wanted.kind === 'operands' ? segmentsOf(text) : []);
        const select = (segment: Segment | undefined): boolean => {
            if (segment) {
                input.setSelectionRange(...segment);
                void look();
            }
            return segment !== undefined;
        };
        /** The operands after the cursor, if each is written on its own. */
        const following = () => segments(input.value).filter(([start]) => start > (input.selectionEnd ?? 0));
        input.addEventListener('input', () => {
            clearTimeout(later);
            later = setTimeout(() => void look(), PAUSE);
        });
        const written = await new Promise<Written | undefined>((resolve) => {
            const stop = new AbortController();
            const end = (written: Written | undefined) => {
                if (this.#end === end) {
                    this.#end = undefined;
                    stop.abort();
                    resolve(written);
                }
            };
            const done = (next: boolean) => end({ text: input.value.trim(), next, isLeft: false });
            this.#end = end;
            /** The comma before the cursor was typed over. */
            let isOver = false;
            /** Takes what is chosen in the list, and goes on. @returns whether there is more to write */
            const goOn = () => {
                const choice = choices.takeChosen();
                if (choice?.isBegun) {
                    segments = segmentsInBlocks;
                    return select(segments(input.value)[0]);
                }
                return select(following()[0]);
            };
            take.addEventListener('click', () => goOn() || done(false));
            giveUp.addEventListener('click', () => end(undefined));
            node.addEventListener('pointerdown', (event) => {
                if (event.target !== input) {
                    // The field keeps the focus.
                    event.preventDefault();
                }
            });
            list.addEventListener('click', (event) => {
                if (choices.choose(event.target) && !goOn()) {
                    done(false);
                }
            });
            node.addEventListener('keydown', (event) => {
                event.stopPropagation();
                if ((event.key === 'ArrowDown' || event.key === 'ArrowUp') && choices.move(event.key === 'ArrowDown' ? 1 : -1)) {
                    event.preventDefault();
                } else if (event.key === ',' && typedOver(input, following()[0])) {
                    event.preventDefault();
                    isOver = select(following()[0]);
                    return;
                } else if (event.key === ' ' && isOver) {
                    // The blank is there as well.
                    event.preventDefault();
                } else if (event.key === 'Tab' || (event.key === 'Enter' && !(wanted.kind === 'lines' && event.shiftKey))) {
                    event.preventDefault();
                    const isFinished = event.key === 'Enter' && !choices.isBegun;
                    if (isFinished) {
                        choices.takeChosen();
                    }
                    if (isFinished || !goOn()) {
                        done(event.key === 'Tab');
                    }
                } else if (event.key === 'Escape') {
                    event.preventDefault();
                    end(undefined);
                }
                isOver = false;
            });
            // Who presses elsewhere has finished; the page itself may lose the focus for a moment.
            let isLeft = false;
            const press = ({ target }: PointerEvent) => {
                isLeft = !(target instanceof Node && node.contains(target));
            };
            window.addEventListener('pointerdown', press, { capture: true, signal: stop.signal });
            input.addEventListener('blur', () => {
                if (document.hasFocus()) {
                    const written = isLeft && input.value.trim() !== before ? { text: input.value.trim(), next: false, isLeft } : undefined;
                    // What is pressed has the focus only after that.
                    setTimeout(() => end(written));
                }
            });
            input.focus({ preventScroll: true });
            const first = again ? undefined : segmentsOf(input.value)[0];
            if (wanted.kind === 'operands' && first) {
                input.setSelectionRange(...first);
            } else if (wanted.kind === 'lines' || again) {
                input.setSelectionRange(input.value.length, input.value.length);
            } else {
                input.select();
            }
            void look();
        });
        clearTimeout(later);
        node.remove();
        return written;
    }
}

function button(name: string, sign: string, title: string): HTMLButtonElement {
    const button = document.createElement('button');
    button.type = 'button';
    button.className = name;
    button.tabIndex = -1;
    button.textContent = sign;
    button.title = title;
    button.setAttribute('aria-label', title);
    return button;
}

/** What is typed into: several lines have a box that grows with them, and no list. */
function inputOf({ label, text, placeholder, kind, again }: Wanted, list: string): HTMLInputElement | HTMLTextAreaElement {
    const value = again?.text ?? text ?? '';
    const input = document.createElement(kind === 'lines' ? 'textarea' : 'input');
    input.spellcheck = kind === 'lines';
    input.value = value;
    input.placeholder = placeholder ?? '';
    input.setAttribute('aria-label', label);
    if (input instanceof HTMLTextAreaElement) {
        const fit = () => {
            input.rows = Math.min(input.value.split('\n').length, HIGHEST);
        };
        input.cols = WIDEST;
        input.addEventListener('input', fit);
        fit();
        return input;
    }
    input.type = 'text';
    input.autocomplete = 'off';
    // Wide enough for what is there: the parameters of a block are many.
    input.size = Math.min(Math.max(value.length + 2, kind === 'drawing' ? DRAWN : NARROWEST), WIDEST);
    input.setAttribute('role', 'combobox');
    input.setAttribute('aria-autocomplete', 'list');
    input.setAttribute('aria-expanded', 'false');
    input.setAttribute('aria-controls', list);
    return input;
}

/** A comma was typed where one is already, before the next operand: whoever writes all of them goes on there. */
function typedOver({ value, selectionStart, selectionEnd }: HTMLInputElement | HTMLTextAreaElement, next: Segment | undefined): boolean {
    const between = next && selectionStart === selectionEnd ? value.slice(selectionEnd ?? 0, next[0]) : '';
    return between.trim() === ',';
}

/** The list below the field: the arrows choose, and never make a name of their own. */
class Choices {
    readonly #input: HTMLInputElement | HTMLTextAreaElement;
    readonly #list: HTMLElement;
    #shown: readonly Choice[] = [];
    #chosen = -1;

    constructor(input: HTMLInputElement | HTMLTextAreaElement, list: HTMLElement) {
        this.#input = input;
        this.#list = list;
    }

    show(choices: readonly Choice[]): void {
        this.#shown = choices;
        this.#chosen = -1;
        const nodes = choices.map(({ text, shown, about }, index) => {
            const node = document.createElement('li');
            node.id = `${this.#list.id}-${index}`;
            node.setAttribute('role', 'option');
            const name = document.createElement('b');
            name.textContent = shown ?? text;
            const told = document.createElement('span');
            told.textContent = about;
            node.append(name, told);
            return node;
        });
        this.#list.replaceChildren(...nodes);
        this.#list.hidden = choices.length === 0;
        if (this.#input instanceof HTMLInputElement) {
            this.#input.setAttribute('aria-expanded', String(choices.length > 0));
        }
        this.#mark();
    }

    /** @returns whether there is a list to move in */
    move(by: number): boolean {
        const count = this.#shown.length;
        if (count > 0) {
            this.#chosen = (this.#chosen + by + count + (this.#chosen < 0 && by < 0 ? 1 : 0)) % count;
            this.#mark();
        }
        return count > 0;
    }

    /** What is chosen is only begun. */
    get isBegun(): boolean {
        return this.#shown[this.#chosen]?.isBegun === true;
    }

    takeChosen(): Choice | undefined {
        const choice = this.#shown[this.#chosen];
        if (choice) {
            // What is after the cursor, or was selected, stays: the operands that follow.
            const rest = this.#input.value.slice(this.#input.selectionEnd ?? 0);
            this.#input.value = choice.text + rest;
            this.#input.setSelectionRange(choice.text.length, choice.text.length);
        }
        return choice;
    }

    /** Chooses the one that a node is of. @returns whether there is one */
    choose(node: EventTarget | null): boolean {
        const item = node instanceof Element ? node.closest('li') : null;
        this.#chosen = item ? [...this.#list.children].indexOf(item) : -1;
        return this.#chosen >= 0;
    }

    #mark(): void {
        [...this.#list.children].forEach((node, index) => node.setAttribute('aria-selected', String(index === this.#chosen)));
        const chosen = this.#list.children[this.#chosen];
        if (chosen) {
            this.#input.setAttribute('aria-activedescendant', chosen.id);
            chosen.scrollIntoView({ block: 'nearest' });
        } else {
            this.#input.removeAttribute('aria-activedescendant');
        }
    }
}
