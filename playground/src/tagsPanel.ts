// The tags of the program that runs, with what they hold: switches, fields, and a menu of what else can be done.
import { filtered, tagGroups } from '../../panels/tagTree.ts';
import { toggles } from '../../panels/diagram/live.ts';
import type { Tag } from '../../panels/protocol.ts';
import { element, setText } from './element.ts';
import type { Simulation } from './simulation.ts';

/** More rows than this nobody looks through: a filter finds them. */
const MOST = 300;

export interface TagEvents {
    why(tag: string): void;
    trace(tag: string): void;
}

interface Row {
    readonly name: string;
    readonly update: (tag: Tag) => void;
}

export class TagsPanel {
    readonly #panel: HTMLElement;
    readonly #simulation: Simulation;
    readonly #events: TagEvents;
    readonly #list = element('div', { class: 'tags' });
    readonly #filter = element('input', { type: 'search', placeholder: 'Filter by name or type', 'aria-label': 'Filter the tags', oninput: () => this.#put() });
    readonly #hint = element('p', { class: 'hint' }, 'Run the program to see its tags, switch its inputs and set values.');
    #tags: readonly Tag[] = [];
    /** What a tag opens into, by its name, of those that are open. */
    readonly #open = new Map<string, readonly Tag[]>();
    #rows: readonly Row[] = [];
    /** The program whose tags are listed. */
    #known = '';

    constructor(panel: HTMLElement, simulation: Simulation, events: TagEvents) {
        this.#panel = panel;
        this.#simulation = simulation;
        this.#events = events;
        const form = element('div', { class: 'bar' }, this.#filter);
        panel.append(form, this.#hint, this.#list);
        simulation.onChange(() => void this.#refresh());
        simulation.showsTags(() => (this.#isSeen ? this.#rows.map(({ name }) => name) : []));
    }

    get #isSeen(): boolean {
        return !this.#panel.hidden;
    }

    appear(): void {
        this.#simulation.look();
        void this.#refresh();
    }

    async #refresh(): Promise<void> {
        if (!this.#isSeen) {
            return;
        }
        const { session } = this.#simulation;
        const known = session ? `${session.id} ${session.state.program ?? 0}` : '';
        if (known !== this.#known) {
            this.#known = known;
            this.#open.clear();
            const tags = session ? await this.#simulation.tags() : [];
            if (known !== this.#known) {
                return;
            }
            this.#tags = tags;
            this.#put();
            this.#simulation.look();
        }
        for (const { name, update } of this.#rows) {
            const tag = session?.tag(name);
            if (tag) {
                update(tag);
            }
        }
    }

    #put(): void {
        const rows: Row[] = [];
        const groups = tagGroups(filtered(this.#tags, this.#filter.value)).map(({ title, tags }) => {
            const body = element('tbody');
            this.#add(body, rows, tags, 0);
            const heads = ['Tag', 'Type', 'Value', 'More'].map((name) => element('th', { scope: 'col' }, name));
            return element('table', {}, element('caption', {}, title), element('thead', {}, element('tr', {}, ...heads)), body);
        });
        this.#rows = rows;
        this.#list.replaceChildren(...groups, ...(rows.length >= MOST ? [element('p', { class: 'hint' }, `Only ${MOST} tags are listed; a filter finds the others.`)] : []));
        this.#hint.hidden = this.#simulation.session !== undefined;
        this.#filter.parentElement?.toggleAttribute('hidden', this.#tags.length === 0);
        for (const { name, update } of rows) {
            const tag = this.#simulation.session?.tag(name);
            if (tag) {
                update(tag);
            }
        }
    }

    #add(body: HTMLElement, rows: Row[], tags: readonly Tag[], depth: number): void {
        for (const tag of tags) {
            if (rows.length >= MOST) {
                return;
            }
            const head = element('th', { scope: 'row', class: `deep-${Math.min(depth, 4)}` }, tag.name);
            const cells = [element('td', { class: 'quiet' }, tag.type)];
            if (tag.parts === undefined) {
                const [value, update] = this.#value(tag);
                const [more, updateMore] = this.#more(tag);
                cells.push(element('td', { class: 'is' }, value), element('td', { class: 'more' }, ...more));
                rows.push({
                    name: tag.name,
                    update: (now) => {
                        update(now);
                        updateMore(now);
                    },
                });
            } else {
                const isOpen = this.#open.has(tag.name);
                const shown = ({ text }: Tag) => text || `${tag.parts} parts`;
                const opener = element('button', { type: 'button', 'aria-expanded': String(isOpen), onclick: () => void this.#fold(tag.name) }, shown(tag));
                cells.push(element('td', {}, opener), element('td'));
                rows.push({ name: tag.name, update: (now) => setText(opener, shown(now)) });
            }
            body.append(element('tr', {}, head, ...cells));
            this.#add(body, rows, this.#open.get(tag.name) ?? [], depth + 1);
        }
    }

    async #fold(name: string): Promise<void> {
        if (!this.#open.delete(name)) {
            this.#open.set(name, await this.#simulation.tags(name));
        }
        this.#put();
        this.#simulation.look();
    }

    /** What shows a value and sets it. */
    #value(tag: Tag): readonly [HTMLElement, (now: Tag) => void] {
        if (toggles(tag)) {
            const node = element('button', { type: 'button', role: 'switch', class: 'bool', 'aria-label': tag.name, onclick: () => void this.#simulation.toggle(tag.name) });
            return [
                node,
                (now) => {
                    setText(node, now.text);
                    node.setAttribute('aria-checked', String(now.value === true));
                },
            ];
        }
        if (tag.readOnly) {
            const node = element('span');
            return [node, (now) => setText(node, now.text)];
        }
        const node = element('input', { type: 'text', 'aria-label': tag.name, autocomplete: 'off', spellcheck: 'false' });
        node.addEventListener('change', () => void this.#simulation.give(tag.name, { text: node.value }));
        node.addEventListener('keydown', ({ key }) => key === 'Escape' && node.blur());
        return [
            node,
            ({ text }) => {
                if (document.activeElement !== node && node.value !== text) {
                    node.value = text;
                }
            },
        ];
    }

    #more(tag: Tag): readonly [readonly HTMLElement[], (now: Tag) => void] {
        const why = element('button', { type: 'button', title: `Why ${tag.name} holds what it holds`, 'aria-label': `Why ${tag.name}`, onclick: () => this.#events.why(tag.name) }, 'Why');
        const trace = element(
            'button',
            { type: 'button', title: `Show ${tag.name} in the traces`, 'aria-label': `Trace ${tag.name}`, onclick: () => this.#events.trace(tag.name) },
            'Trace',
        );
        if (tag.readOnly) {
            return [[why], () => undefined];
        }
        const force = element('button', {
            type: 'button',
            title: `${tag.name} is held at its value until it is released`,
            'aria-label': `Force ${tag.name}`,
            'aria-pressed': 'false',
            onclick: () => {
                const now = this.#simulation.session?.tag(tag.name);
                if (now) {
                    void (now.forced ? this.#simulation.command('unforce', { tag: now.name }) : this.#simulation.command('force', { tag: now.name, value: now.value }));
                }
            },
        }, 'Force');
        return [
            [force, why, trace],
            ({ forced }) => {
                force.setAttribute('aria-pressed', String(forced));
            },
        ];
    }
}
