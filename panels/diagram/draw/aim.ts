// Where something would go: a ring in a wire, a bar below what a new branch would go around.
import type { Found, Page } from '../page.ts';
import { rangeOf } from './selection.ts';
import type { Place } from '../messages.ts';

/** Where something is put in, and how: into the wire there, or as a branch around what is between two places. */
export type Target = { readonly at: Place } | { readonly from: Place; readonly to: Place; readonly side: 'below' | 'above' };

/** How high the bar is, in pixels. */
const BAR = 5;

export class Aim {
    readonly #page: Page;
    readonly #canvas: HTMLElement;
    readonly #bar = document.createElement('div');
    #ring: Element | undefined;

    constructor(page: Page, canvas: HTMLElement) {
        this.#page = page;
        this.#canvas = canvas;
        this.#bar.className = 'lane';
        this.#bar.setAttribute('aria-hidden', 'true');
    }

    /** Marks a place. @param around what a branch would go around */
    show(target: Target, around: readonly Found[]): void {
        this.hide();
        if ('at' in target) {
            const { line, character } = target.at;
            const isThere = (found: Found) => found.part.kind === 'point' && rangeOf(found).start.line === line && rangeOf(found).start.character === character;
            this.#ring = this.#page.spots().find(({ found }) => isThere(found))?.found.part.node;
            this.#ring?.classList.add('aim');
            return;
        }
        const boxes = around.map((found) => this.#page.boxOf(found));
        const [left, right] = [Math.min(...boxes.map((box) => box.left)), Math.max(...boxes.map((box) => box.left + box.width))];
        const top = target.side === 'above' ? Math.min(...boxes.map((box) => box.top)) - BAR + 2 : Math.max(...boxes.map((box) => box.top + box.height)) - 2;
        Object.assign(this.#bar.style, { left: `${left}px`, top: `${top}px`, width: `${right - left}px` });
        this.#canvas.append(this.#bar);
    }

    hide(): void {
        this.#ring?.classList.remove('aim');
        this.#ring = undefined;
        this.#bar.remove();
    }
}
