// The strip below the diagram: the tags of the element that has the focus, to be set and forced.
import type { FromPage } from './messages.ts';
import type { Tag } from '../protocol.ts';
import { toggles } from './live.ts';
import { type Span, sliderSpan } from './slider.ts';

/** More tags than this nobody looks at together. */
const MOST = 6;

interface Row {
    readonly node: HTMLElement;
    readonly update: (tag: Tag) => void;
}

function button(label: string, title: string, act: () => void): HTMLButtonElement {
    const node = document.createElement('button');
    node.type = 'button';
    node.textContent = label;
    node.title = title;
    node.addEventListener('click', act);
    return node;
}

function span(className: string, text: string): HTMLSpanElement {
    const node = document.createElement('span');
    node.className = className;
    node.textContent = text;
    return node;
}

/** A state that comes later than this after a slider was moved is no older one. In milliseconds. */
const SETTLED = 500;

export class Inspector {
    readonly #node: HTMLElement;
    readonly #send: (message: FromPage) => void;
    readonly #rows = new Map<string, Row>();
    readonly #title = span('title', '');
    readonly #list = document.createElement('div');

    constructor(node: HTMLElement, send: (message: FromPage) => void) {
        this.#node = node;
        this.#send = send;
        this.#list.className = 'tags';
        node.append(this.#title, this.#list);
        this.show('', []);
    }

    /** Shows these tags; rows that are there already stay, with whatever a user types into them. */
    show(title: string, all: readonly Tag[]): void {
        const tags = all.slice(0, MOST);
        if (this.#title.textContent !== title) {
            this.#title.textContent = title;
        }
        if (this.#node.hidden !== (title === '')) {
            this.#node.hidden = title === '';
        }
        const names = new Set(tags.map(({ name, type, readOnly }) => `${name} ${type} ${readOnly}`));
        for (const [name, { node }] of this.#rows) {
            if (!names.has(name)) {
                node.remove();
                this.#rows.delete(name);
            }
        }
        for (const tag of tags) {
            const key = `${tag.name} ${tag.type} ${tag.readOnly}`;
            const row = this.#rows.get(key) ?? this.#row(tag);
            this.#rows.set(key, row);
            this.#list.append(...(row.node.parentNode ? [] : [row.node]));
            row.update(tag);
        }
    }

    #row(first: Tag): Row {
        let now = first;
        const node = document.createElement('div');
        node.className = 'tag';
        node.setAttribute('role', 'group');
        node.setAttribute('aria-label', first.name);
        const value = span('is', '');
        node.append(span('name', first.name), span('type', first.type), value);
        const updates: (() => void)[] = [];
        if (first.readOnly !== true) {
            updates.push(...(toggles(first) ? this.#switch(node, () => now) : this.#number(node, () => now)));
            const force = button('Force', '', () => {
                this.#send(now.forced ? { type: 'unforce', tag: now.name } : { type: 'force', tag: now.name, value: now.value });
            });
            node.append(force);
            updates.push(() => {
                force.textContent = now.forced ? 'Release' : 'Force';
                force.title = now.forced ? 'Let the program write it again (F)' : 'Hold it at its value, whatever the program writes (F)';
                force.setAttribute('aria-pressed', String(now.forced));
            });
        }
        return {
            node,
            update: (tag) => {
                now = tag;
                value.textContent = `${tag.text}${tag.forced ? ' forced' : ''}`;
                node.classList.toggle('forced', tag.forced);
                updates.forEach((update) => update());
            },
        };
    }

    /** Buttons of a tag of BOOL. */
    #switch(node: HTMLElement, now: () => Tag): (() => void)[] {
        const toggle = button('Toggle', 'Invert it (Enter)', () => this.#send({ type: 'toggle', tag: now().name }));
        const pulse = button('Pulse', 'Invert it for one scan (P)', () => this.#send({ type: 'pulse', tag: now().name }));
        node.append(toggle, pulse);
        return [() => (pulse.disabled = now().forced)];
    }

    /** A field for the value, and a slider for a number. What is forced is forced to the new value. */
    #number(node: HTMLElement, now: () => Tag): (() => void)[] {
        const write = (text: string) => {
            const { name, forced } = now();
            this.#send({ type: forced ? 'force' : 'set', tag: name, text });
        };
        const field = document.createElement('input');
        field.type = 'text';
        field.size = 10;
        field.spellcheck = false;
        field.setAttribute('aria-label', `New value of ${now().name}`);
        field.addEventListener('keydown', (event) => {
            if (event.key === 'Enter') {
                write(field.value);
                field.select();
            }
        });
        const slider = document.createElement('input');
        slider.type = 'range';
        slider.setAttribute('aria-label', `Value of ${now().name}`);
        let span: Span | undefined;
        let isDragged = false;
        /** What was sent last: until it comes back states are of the time before, and would move the slider back. */
        let sent: { readonly value: number; readonly at: number } | undefined;
        slider.addEventListener('input', () => {
            isDragged = true;
            const { name, type, forced } = now();
            const value = type === 'REAL' || type === 'LREAL' ? Number(slider.value) : Math.round(Number(slider.value));
            sent = { value, at: Date.now() };
            this.#send({ type: forced ? 'force' : 'set', tag: name, value });
        });
        slider.addEventListener('change', () => (isDragged = false));
        node.append(slider, field);
        return [
            () => {
                const tag = now();
                if (document.activeElement !== field) {
                    field.value = tag.text;
                }
                const next = sliderSpan(tag, span);
                slider.hidden = next === undefined;
                if (next && next !== span) {
                    [slider.min, slider.max, slider.step] = [String(next.min), String(next.max), String(next.step)];
                }
                span = next;
                slider.setAttribute('aria-valuetext', tag.text);
                if (sent && (tag.value === sent.value || Date.now() - sent.at > SETTLED)) {
                    sent = undefined;
                }
                if (!isDragged && !sent && typeof tag.value === 'number') {
                    slider.value = String(tag.value);
                }
            },
        ];
    }
}
