// What can be drawn, above the diagram: what is used most as buttons, all else by a search.
import type { DrawableRow } from '../../protocol.ts';
import type { Called } from '../called.ts';
import type { Ask } from './asker.ts';

export const CONTACT: DrawableRow = { section: '', block: '[ ]', title: 'Open contact', us: 'XIC', operands: '' };
export const CLOSED_CONTACT: DrawableRow = { section: '', block: '[/]', title: 'Closed contact', us: 'XIO', operands: '' };
export const COIL: DrawableRow = { section: '', block: '( )', title: 'Coil', us: 'OTE', operands: '' };

/** Always there, in this order: before the branch, and after it as far as the program may have them. */
const [FIRST, SECOND] = [[CONTACT, CLOSED_CONTACT, COIL], ['[TON]', '[CTU]']] as const;

/** So many of those that were used last are buttons, too. */
const MOST_USED = 5;
/** There are so many keys with numbers. */
const NUMBERS = 9;

/** What a person does with a row. */
export interface Takes {
    /** It is to be drawn where the focus is. */
    chosen(row: DrawableRow): void;
    /** It may be dragged: the pointer is down on it. */
    pressed(row: DrawableRow, event: PointerEvent): void;
    branch(): void;
}

export class Palette {
    readonly node = document.createElement('div');
    readonly #buttons = document.createElement('span');
    readonly #search = document.createElement('input');
    readonly #list = document.createElement('div');
    readonly #ask: Ask;
    readonly #takes: Takes;
    readonly #names: Called;
    /** All that the program may have. */
    #rows: readonly DrawableRow[] = [CONTACT, CLOSED_CONTACT, COIL];
    #used: DrawableRow[] = [];
    #shown: readonly DrawableRow[] = [];
    #chosen = -1;
    #asked = 0;

    constructor(ask: Ask, names: Called, takes: Takes) {
        this.#ask = ask;
        this.#names = names;
        this.#takes = takes;
        this.node.className = 'palette';
        this.node.setAttribute('role', 'toolbar');
        this.node.setAttribute('aria-label', 'What can be drawn');
        this.#buttons.className = 'favourites';
        this.#search.type = 'text';
        this.#search.placeholder = 'Search: timer, XIC, counter up';
        this.#search.spellcheck = false;
        this.#list.className = 'found';
        this.#list.id = 'palette-found';
        this.#list.setAttribute('role', 'listbox');
        this.#list.setAttribute('aria-label', 'Instructions and blocks');
        this.#list.hidden = true;
        for (const [name, value] of Object.entries({
            role: 'combobox',
            'aria-label': 'Search what can be drawn',
            'aria-expanded': 'false',
            'aria-controls': this.#list.id,
            'aria-autocomplete': 'list',
        })) {
            this.#search.setAttribute(name, value);
        }
        this.node.append(this.#buttons, this.#search, this.#list);
        this.#search.addEventListener('focus', () => void this.#look());
        this.#search.addEventListener('input', () => void this.#look());
        this.#search.addEventListener('blur', () => this.#close());
        this.#search.addEventListener('keydown', (event) => this.#key(event));
        this.#list.addEventListener('pointerdown', (event) => this.#press(event));
        this.#showButtons();
    }

    /** What a row is called, and what else. */
    #called({ title, elsewhere = [] }: DrawableRow): [string, string] {
        const called = this.#names.name(title);
        return [called, [title, ...elsewhere].filter((name) => name !== called).join(', ')];
    }

    /** The search has the focus. */
    open(): void {
        this.#search.focus();
        this.#search.select();
    }

    /** A program is opened: what can be drawn in it is asked for. */
    async load(): Promise<void> {
        const { rows } = await this.#ask('palette', { search: '' }).catch(() => ({ rows: this.#rows }));
        this.#rows = rows;
        this.#names.know(rows);
        this.#showButtons();
    }

    /** What a block is called: `Rising-edge contact`. */
    titleOf(block: string): string {
        const row = this.#rows.find((row) => row.block === block);
        return row ? this.#called(row)[0] : block;
    }

    /** The favourites that have operands. */
    get #always(): readonly DrawableRow[] {
        return SECOND.flatMap((block) => this.#rows.find((row) => row.block === block) ?? []);
    }

    /** The buttons from left to right. */
    get #favourites(): readonly (DrawableRow | 'branch')[] {
        return [...FIRST, 'branch', ...this.#always, ...this.#used];
    }

    /** Takes the favourite with this number, from 1. @returns whether there is one */
    favourite(number: number): boolean {
        const favourite = this.#favourites[number - 1];
        if (favourite === 'branch') {
            this.#takes.branch();
        } else if (favourite) {
            this.#takes.chosen(favourite);
        }
        return favourite !== undefined;
    }

    /** It is one of those that were used last. */
    used(row: DrawableRow): void {
        this.#search.value = '';
        if (![...FIRST, ...this.#always, ...this.#used].some(({ block }) => block === row.block)) {
            // A button stays where it is as long as it is there.
            this.#used = [...this.#used, row].slice(-MOST_USED);
            this.#showButtons();
        }
    }

    #showButtons(): void {
        this.#buttons.replaceChildren(...this.#favourites.map((favourite, index) => (favourite === 'branch' ? this.#branchButton(index) : this.#buttonOf(favourite, index))));
    }

    #branchButton(index: number): HTMLButtonElement {
        const button = document.createElement('button');
        button.type = 'button';
        button.textContent = 'Branch';
        button.title = `A contact in parallel to what is selected (B, ${index + 1})`;
        button.addEventListener('click', () => this.#takes.branch());
        return button;
    }

    #buttonOf(row: DrawableRow, index: number): HTMLButtonElement {
        const button = document.createElement('button');
        button.type = 'button';
        button.textContent = row.block;
        const [called] = this.#called(row);
        button.title = index < NUMBERS ? `${called} (${index + 1})` : called;
        button.setAttribute('aria-label', called);
        button.addEventListener('pointerdown', (event) => this.#takes.pressed(row, event));
        // By keys: the pointer has its own way, which may be a drag.
        button.addEventListener('click', ({ detail }) => {
            if (detail === 0) {
                this.#takes.chosen(row);
            }
        });
        return button;
    }

    async #look(): Promise<void> {
        const number = ++this.#asked;
        const { rows } = await this.#ask('palette', { search: this.#search.value }).catch(() => ({ rows: [] }));
        if (number !== this.#asked || document.activeElement !== this.#search) {
            return;
        }
        this.#shown = rows;
        this.#chosen = this.#search.value && rows.length > 0 ? 0 : -1;
        const nodes: HTMLElement[] = [];
        let group: HTMLElement | undefined;
        rows.forEach((row, index) => {
            if (group?.getAttribute('aria-label') !== row.section) {
                group = document.createElement('div');
                group.setAttribute('role', 'group');
                group.setAttribute('aria-label', row.section);
                const heading = document.createElement('span');
                heading.className = 'section';
                heading.setAttribute('aria-hidden', 'true');
                heading.textContent = row.section;
                group.append(heading);
                nodes.push(group);
            }
            const node = document.createElement('div');
            node.id = `palette-row-${index}`;
            node.className = 'row';
            node.dataset['row'] = String(index);
            node.setAttribute('role', 'option');
            const block = document.createElement('b');
            block.textContent = row.block;
            const title = document.createElement('span');
            const [called, otherwise] = this.#called(row);
            title.textContent = called;
            const elsewhere = document.createElement('span');
            elsewhere.className = 'elsewhere';
            elsewhere.textContent = otherwise;
            node.append(block, title, elsewhere);
            group.append(node);
        });
        this.#list.replaceChildren(...nodes);
        this.#list.hidden = rows.length === 0;
        this.#search.setAttribute('aria-expanded', String(rows.length > 0));
        this.#mark();
    }

    #close(): void {
        this.#asked += 1;
        this.#list.hidden = true;
        this.#search.setAttribute('aria-expanded', 'false');
    }

    #mark(): void {
        for (const node of this.#list.querySelectorAll<HTMLElement>('.row')) {
            const isChosen = Number(node.dataset['row']) === this.#chosen;
            node.setAttribute('aria-selected', String(isChosen));
            if (isChosen) {
                this.#search.setAttribute('aria-activedescendant', node.id);
                node.scrollIntoView({ block: 'nearest' });
            }
        }
        if (this.#chosen < 0) {
            this.#search.removeAttribute('aria-activedescendant');
        }
    }

    #key(event: KeyboardEvent): void {
        event.stopPropagation();
        const row = this.#shown[this.#chosen];
        if (event.key === 'ArrowDown' || event.key === 'ArrowUp') {
            event.preventDefault();
            const count = this.#shown.length;
            this.#chosen = count > 0 ? (this.#chosen + (event.key === 'ArrowDown' ? 1 : count - 1)) % count : -1;
            this.#mark();
        } else if (event.key === 'Enter' && row) {
            event.preventDefault();
            this.#take(row);
        } else if (event.key === 'Escape') {
            this.#search.blur();
        }
    }

    #take(row: DrawableRow): void {
        this.#search.value = '';
        this.#close();
        this.#takes.chosen(row);
    }

    #press(event: PointerEvent): void {
        const node = event.target instanceof Element ? event.target.closest<HTMLElement>('.row') : null;
        const row = this.#shown[Number(node?.dataset['row'] ?? -1)];
        // The list stays open as long as the search has the focus.
        event.preventDefault();
        if (row) {
            this.#takes.pressed(row, event);
        }
    }
}
