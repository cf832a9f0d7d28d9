// Why a tag holds what it holds: the reasons as a tree, each of which leads to its place in the text.
import type { Range } from '../../panels/protocol.ts';
import { stillStopping, stoppingBlocks, type WhyRow, whyRow } from '../../panels/whyTree.ts';
import { element } from './element.ts';
import type { OpenText } from './openText.ts';
import type { Simulation } from './simulation.ts';

const HINT = 'While the program runs, ask why a tag holds what it holds: Shift+F4 at its place in the text or the diagram, or "Why" in the list of tags.';

const signs: Readonly<Record<WhyRow['icon'], string>> = {
    'symbol-variable': '=',
    'circle-slash': '⊘',
    pass: '✓',
    edit: '✎',
    'arrow-right': '→',
    lock: '!',
};

export class WhyPanel {
    readonly #simulation: Simulation;
    readonly #program: OpenText;
    readonly #tree = element('div', { class: 'why' });
    #session: Simulation['session'];
    #stopping: readonly Range[] = [];
    #tag: string | undefined;

    constructor(panel: HTMLElement, program: OpenText, simulation: Simulation) {
        this.#program = program;
        this.#simulation = simulation;
        const again = element('button', { type: 'button', onclick: () => void (this.#tag && this.ask(this.#tag)) }, 'Ask again');
        panel.append(element('div', { class: 'bar' }, again), this.#tree);
        this.#show(undefined);
        // Reasons are those of the session, at the places of its text.
        simulation.onChange(() => {
            if (this.#session && (simulation.session !== this.#session || this.#session.stale)) {
                this.#show(undefined);
            }
        });
    }

    /** Asks why a tag holds what it holds, and shows it. */
    async ask(tag: string): Promise<void> {
        const { session } = this.#simulation;
        const why = await this.#simulation.why(tag);
        if (session && why) {
            this.#tag = tag;
            this.#session = session;
            this.#show(whyRow(why.reason));
        }
    }

    /** The blocks that keep power from the tag, and do so still. */
    stopping(): readonly Range[] {
        const { session } = this.#simulation;
        return session ? stillStopping(this.#stopping, ({ start }) => session.power.get(start.line)?.get(start.character)) : [];
    }

    #show(root: WhyRow | undefined): void {
        this.#stopping = root ? stoppingBlocks(root) : [];
        if (!root) {
            this.#session = undefined;
        }
        this.#tree.previousElementSibling?.toggleAttribute('hidden', !root);
        this.#tree.replaceChildren(root ? element('ul', {}, this.#row(root)) : element('p', { class: 'hint' }, HINT));
    }

    #row({ label, tooltip, icon, range, uri, children }: WhyRow): HTMLElement {
        const sign = element('span', { class: 'sign', 'aria-hidden': 'true' }, signs[icon]);
        const isHere = range && (uri === undefined || uri === this.#program.uri);
        const text = isHere
            ? element('button', { type: 'button', class: 'link', title: tooltip, onclick: () => this.#program.select(range, false) }, label)
            : element('span', { title: tooltip }, label);
        const said = icon === 'circle-slash' || icon === 'pass' ? element('span', { class: 'quiet' }, ` ${tooltip.toLowerCase()}`) : '';
        const below = children.length > 0 ? [element('ul', {}, ...children.map((child) => this.#row(child)))] : [];
        return element('li', {}, sign, text, said, ...below);
    }
}
