// A field in the drawing: what is typed there becomes part of the text when it is finished, and nothing before that.

/** A line of the list below the field. */
export interface Choice {
    readonly text: string;
    /** What it is, in grey. */
    readonly about: string;
}

/** What is asked for. */
export interface Wanted {
    /** What the field is about: "Open contact". */
    readonly label: string;
    readonly text?: string;
    readonly placeholder?: string;
    /** Where it is, from the upper left corner of the diagram. */
    readonly spot: { readonly x: number; readonly y: number };
    /** What may be meant by what is typed. */
    choices(text: string): readonly Choice[] | Promise<readonly Choice[]>;
    /** What is to be known of it, such as that a name is new. */
    note?(text: string): Promise<string>;
}

/** What a person has written, and whether the next field is to follow. */
export interface Written {
    readonly text: string;
    readonly next: boolean;
}

/** What is typed last is asked for, this long after the last key. In milliseconds. */
const PAUSE = 120;
const MOST = 12;
/** How wide the field is, in letters. */
const [NARROWEST, WIDEST] = [24, 64];

let fields = 0;

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
        node.style.left = `${Math.max(wanted.spot.x, 4)}px`;
        node.style.top = `${wanted.spot.y}px`;
        const list = document.createElement('ul');
        list.id = `choices-${++fields}`;
        list.setAttribute('role', 'listbox');
        list.setAttribute('aria-label', wanted.label);
        list.hidden = true;
        const input = document.createElement('input');
        input.type = 'text';
        input.spellcheck = false;
        input.autocomplete = 'off';
        input.value = wanted.text ?? '';
        // Wide enough for what is there: the parameters of a block are many.
        input.size = Math.min(Math.max(input.value.length + 2, NARROWEST), WIDEST);
        input.placeholder = wanted.placeholder ?? '';
        input.setAttribute('role', 'combobox');
        input.setAttribute('aria-label', wanted.label);
        input.setAttribute('aria-autocomplete', 'list');
        input.setAttribute('aria-expanded', 'false');
        input.setAttribute('aria-controls', list.id);
        const shown = document.createElement('p');
        shown.className = 'note-of-field';
        shown.setAttribute('aria-live', 'polite');
        node.append(input, shown, list);
        this.#parent.append(node);
        const choices = new Choices(input, list);
        let asked = 0;
        let later: ReturnType<typeof setTimeout> | undefined;
        const look = async () => {
            const number = ++asked;
            // Half a name may be nothing that can be drawn.
            const told = wanted.note?.(input.value).catch(() => '') ?? '';
            const [found, note] = await Promise.all([wanted.choices(input.value), told]).catch(() => [[], ''] as const);
            if (number === asked && this.isOpen) {
                choices.show(found.slice(0, MOST));
                shown.textContent = note;
            }
        };
        input.addEventListener('input', () => {
            clearTimeout(later);
            later = setTimeout(() => void look(), PAUSE);
        });
        const written = await new Promise<Written | undefined>((resolve) => {
            const end = (written: Written | undefined) => {
                this.#end = undefined;
                resolve(written);
            };
            this.#end = end;
            list.addEventListener('pointerdown', (event) => {
                event.preventDefault();
                if (choices.take(event.target)) {
                    end({ text: input.value, next: false });
                }
            });
            input.addEventListener('keydown', (event) => {
                event.stopPropagation();
                if (event.key === 'ArrowDown' || event.key === 'ArrowUp') {
                    event.preventDefault();
                    choices.move(event.key === 'ArrowDown' ? 1 : -1);
                } else if (event.key === 'Enter' || event.key === 'Tab') {
                    event.preventDefault();
                    choices.takeChosen();
                    end({ text: input.value.trim(), next: event.key === 'Tab' });
                } else if (event.key === 'Escape') {
                    event.preventDefault();
                    end(undefined);
                }
            });
            // Who goes elsewhere has given up; the page itself may lose the focus for a moment.
            input.addEventListener('blur', () => {
                if (document.hasFocus()) {
                    end(undefined);
                }
            });
            input.focus({ preventScroll: true });
            input.select();
            void look();
        });
        clearTimeout(later);
        node.remove();
        return written;
    }
}

/** The list below the field: the arrows choose, and never make a name of their own. */
class Choices {
    readonly #input: HTMLInputElement;
    readonly #list: HTMLElement;
    #shown: readonly Choice[] = [];
    #chosen = -1;

    constructor(input: HTMLInputElement, list: HTMLElement) {
        this.#input = input;
        this.#list = list;
    }

    show(choices: readonly Choice[]): void {
        this.#shown = choices;
        this.#chosen = -1;
        const nodes = choices.map(({ text, about }, index) => {
            const node = document.createElement('li');
            node.id = `${this.#list.id}-${index}`;
            node.setAttribute('role', 'option');
            const name = document.createElement('b');
            name.textContent = text;
            const told = document.createElement('span');
            told.textContent = about;
            node.append(name, told);
            return node;
        });
        this.#list.replaceChildren(...nodes);
        this.#list.hidden = choices.length === 0;
        this.#input.setAttribute('aria-expanded', String(choices.length > 0));
        this.#mark();
    }

    move(by: number): void {
        const count = this.#shown.length;
        if (count > 0) {
            this.#chosen = (this.#chosen + by + count + (this.#chosen < 0 && by < 0 ? 1 : 0)) % count;
            this.#mark();
        }
    }

    takeChosen(): void {
        const choice = this.#shown[this.#chosen];
        if (choice) {
            this.#input.value = choice.text;
        }
    }

    /** Takes the one that a node is of. @returns whether there is one */
    take(node: EventTarget | null): boolean {
        const item = node instanceof Element ? node.closest('li') : null;
        this.#chosen = item ? [...this.#list.children].indexOf(item) : -1;
        this.takeChosen();
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
