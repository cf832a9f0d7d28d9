// What the pointer rests on. While the program runs that is what the tag there holds and why, in two lines, and more when it is asked
// for; else what the server says of it.
import { LSPPlugin } from '@codemirror/lsp-client';
import type { Extension } from '@codemirror/state';
import { closeHoverTooltips, type EditorView, hoverTooltip, type Tooltip, ViewPlugin } from '@codemirror/view';

import type { Place, Range } from '../../panels/protocol.ts';
import { element } from './element.ts';
import type { Simulation } from './simulation.ts';

/** So long it is read after a touch. In milliseconds. */
const TOUCHED = 6000;

interface Hover {
    readonly contents: { readonly kind: string; readonly value: string };
    readonly range?: Range;
}

function ask(plugin: LSPPlugin, position: Place): Promise<Hover | null> {
    plugin.client.sync();
    const asked = { textDocument: { uri: plugin.uri }, position };
    return plugin.client.request<typeof asked, Hover | null>('textDocument/hover', asked);
}

function put(node: HTMLElement, plugin: LSPPlugin, { contents }: Hover): void {
    node.innerHTML = plugin.docToHTML(contents as Parameters<LSPPlugin['docToHTML']>[0]);
}

const tooltip = (pos: number, end: number, dom: HTMLElement): Tooltip => ({ pos, end, above: true, create: () => ({ dom }) });

/** What is said of the tag at a place while the program runs. */
async function live(plugin: LSPPlugin, simulation: Simulation, place: Place): Promise<Tooltip | undefined> {
    const operand = simulation.operandAt(place);
    const name = operand?.tags[0];
    const { session } = simulation;
    const [why, found] = name === undefined || !session ? [] : await Promise.all([
        session.urgent('why', { tag: name }).catch(() => undefined),
        session.urgent('tags', { names: [name] }).catch(() => undefined),
    ]);
    const tag = found?.tags[0];
    if (!operand || !why || !tag) {
        return undefined;
    }
    const dom = element('div', { class: 'cm-lsp-hover-tooltip cm-lsp-documentation live' });
    const unfold = async () => {
        const hover = await ask(plugin, place);
        if (hover) {
            // The pointer, which is on the button, stays in what is shown.
            dom.style.minWidth = `${dom.offsetWidth}px`;
            put(dom, plugin, hover);
        }
    };
    const more = element('button', { type: 'button', onclick: () => void unfold() }, 'More');
    dom.append(element('p', {}, `${tag.name} = ${tag.text}`), element('p', {}, element('span', {}, why.reason.text), ' ', more));
    return tooltip(plugin.fromPosition(operand.range.start), plugin.fromPosition(operand.range.end), dom);
}

async function explained(plugin: LSPPlugin, place: Place, pos: number): Promise<Tooltip | null> {
    const hover = await ask(plugin, place);
    if (!hover) {
        return null;
    }
    const dom = element('div', { class: 'cm-lsp-hover-tooltip cm-lsp-documentation' });
    put(dom, plugin, hover);
    const { start, end } = hover.range ?? { start: place, end: place };
    return tooltip(hover.range ? plugin.fromPosition(start) : pos, hover.range ? plugin.fromPosition(end) : pos, dom);
}

/** The last press was that of a finger on a switch, which says nothing but by what it does. */
let isSwitched = false;

/** A finger leaves no pointer behind that could go: what is shown goes with the next touch elsewhere, with scrolling, and after a while. */
const goes = ViewPlugin.fromClass(
    class {
        readonly #view: EditorView;
        #later: ReturnType<typeof setTimeout> | undefined;

        constructor(view: EditorView) {
            this.#view = view;
            document.addEventListener('pointerdown', this.#pressed, true);
            view.scrollDOM.addEventListener('scroll', this.#close, { passive: true });
        }

        destroy(): void {
            clearTimeout(this.#later);
            document.removeEventListener('pointerdown', this.#pressed, true);
        }

        readonly #close = (): void => {
            if (this.#view.dom.querySelector('.cm-tooltip-hover')) {
                this.#view.dispatch({ effects: closeHoverTooltips });
            }
        };

        readonly #pressed = ({ target, pointerType }: PointerEvent): void => {
            const on = (selector: string) => target instanceof Element && target.closest(selector) !== null;
            isSwitched = pointerType === 'touch' && on('.switch');
            clearTimeout(this.#later);
            if (!on('.cm-tooltip')) {
                this.#close();
                if (pointerType === 'touch') {
                    this.#later = setTimeout(this.#close, TOUCHED);
                }
            }
        };
    },
);

/** @param simulation of the text, if it is a program */
export function hover(simulation: () => Simulation | undefined): Extension {
    const source = async (view: EditorView, pos: number): Promise<Tooltip | null> => {
        const plugin = LSPPlugin.get(view);
        if (!plugin || isSwitched) {
            return null;
        }
        const [place, running] = [plugin.toPosition(pos), simulation()];
        return (running && (await live(plugin, running, place))) ?? explained(plugin, place, pos);
    };
    return [hoverTooltip(source, { hideOn: ({ docChanged }) => docChanged }), goes];
}
