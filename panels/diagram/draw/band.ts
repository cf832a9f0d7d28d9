// A rubber band: what it reaches of one network is selected.
import type { Found, Page } from '../page.ts';
import { follow } from './follow.ts';
import { aboutOf, type Selection } from './selection.ts';

/** Who moves less only presses, in pixels. */
const LEAST = 5;

export class Band {
    readonly #page: Page;
    readonly #canvas: HTMLElement;
    readonly #selection: Selection;

    constructor(page: Page, canvas: HTMLElement, selection: Selection) {
        this.#page = page;
        this.#canvas = canvas;
        this.#selection = selection;
    }

    begin(event: PointerEvent): void {
        const from = this.#placeOf(event);
        const node = document.createElement('div');
        node.className = 'band';
        node.setAttribute('aria-hidden', 'true');
        const move = (moved: PointerEvent) => {
            const to = this.#placeOf(moved);
            const box = { left: Math.min(from.x, to.x), top: Math.min(from.y, to.y), width: Math.abs(to.x - from.x), height: Math.abs(to.y - from.y) };
            if (!node.isConnected && Math.hypot(box.width, box.height) > LEAST) {
                this.#canvas.append(node);
            }
            if (node.isConnected) {
                moved.preventDefault();
                Object.assign(node.style, { left: `${box.left}px`, top: `${box.top}px`, width: `${box.width}px`, height: `${box.height}px` });
                this.#select(box);
            }
        };
        follow({ move, end: () => node.remove() });
    }

    #placeOf({ clientX, clientY }: PointerEvent): { x: number; y: number } {
        const { left, top } = this.#canvas.getBoundingClientRect();
        return { x: clientX - left, y: clientY - top };
    }

    /** The elements of the first network that is reached; the last of them has the focus. */
    #select(band: { left: number; top: number; width: number; height: number }): void {
        const isReached = (found: Found) => {
            const box = this.#page.boxOf(found);
            return box.left < band.left + band.width && band.left < box.left + box.width && box.top < band.top + band.height && band.top < box.top + box.height;
        };
        const reached = this.#page.spots().map(({ found }) => found).filter((found) => ['element', 'note'].includes(aboutOf(found)) && isReached(found));
        const own = reached.filter(({ drawing }) => drawing === reached[0]?.drawing);
        const last = own.at(-1);
        if (last) {
            this.#page.select(last, false);
        }
        this.#selection.set(own);
    }
}
