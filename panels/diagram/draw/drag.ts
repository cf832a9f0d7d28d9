// What is dragged: an element of the drawing, or a row of the palette. While it moves the place is shown where it would go:
// a ring in a wire, a bar below an element, which a new branch would go around.
import type { Found, Page } from '../page.ts';
import type { Aim, Target } from './aim.ts';
import { follow } from './follow.ts';
import { aboutOf, rangeOf } from './selection.ts';

/** Who moves less only presses, in pixels. */
const LEAST = 5;
/** A finger that moves sooner scrolls, in milliseconds. */
const HOLD = 300;
/** No place is further away than this, in pixels. */
const REACH = 60;

/** What is let go, where, and whether as another kind or a copy. */
export interface Drop {
    readonly found: Found;
    readonly target: Target;
    readonly isShifted: boolean;
    readonly isCopy: boolean;
}

export class Drag {
    readonly #page: Page;
    readonly #canvas: HTMLElement;
    readonly #mark: Aim;
    readonly #ghost = document.createElement('div');
    #aim: { readonly found: Found; readonly target: Target } | undefined;

    constructor(page: Page, canvas: HTMLElement, mark: Aim) {
        this.#page = page;
        this.#canvas = canvas;
        this.#mark = mark;
        this.#ghost.className = 'ghost';
        this.#ghost.setAttribute('aria-hidden', 'true');
    }

    /**
     * Follows what was pressed. `pressed` is called if it did not move, `dropped` if it was let go at a place.
     * @param onlyWires an end of a branch goes to no place below an element
     */
    begin(event: PointerEvent, shown: string, dropped: (drop: Drop) => void, pressed: () => void, onlyWires = false): void {
        const from = { x: event.clientX, y: event.clientY };
        const since = Date.now();
        let isDragging = false;
        const move = (moved: PointerEvent) => {
            const far = Math.hypot(moved.clientX - from.x, moved.clientY - from.y);
            if (!isDragging && far > LEAST) {
                if (moved.pointerType === 'touch' && Date.now() - since < HOLD) {
                    giveUp();
                    return;
                }
                isDragging = true;
                this.#ghost.textContent = shown;
                document.body.append(this.#ghost);
                document.body.classList.add('dragging');
            }
            if (isDragging) {
                moved.preventDefault();
                this.#ghost.style.transform = `translate(${moved.clientX + 12}px, ${moved.clientY + 8}px)`;
                this.#show(moved, onlyWires);
            }
        };
        const end = (released?: PointerEvent) => {
            const aim = this.#aim;
            document.body.classList.remove('dragging');
            this.#ghost.remove();
            this.#hide();
            if (released && !isDragging) {
                pressed();
            } else if (released && aim?.found.part.node.isConnected === true) {
                dropped({ ...aim, isShifted: released.shiftKey, isCopy: released.ctrlKey || released.metaKey });
            }
        };
        const giveUp = follow({ move, end });
    }

    #hide(): void {
        this.#mark.hide();
        this.#aim = undefined;
    }

    /** Shows the nearest place. */
    #show({ clientX, clientY }: PointerEvent, onlyWires: boolean): void {
        const { left, top } = this.#canvas.getBoundingClientRect();
        const [x, y] = [clientX - left, clientY - top];
        let best: { found: Found; isLane: boolean; far: number } | undefined;
        for (const { found } of this.#page.spots()) {
            const box = this.#page.boxOf(found);
            const about = aboutOf(found);
            const isLane = about === 'element';
            if (about === 'join' || about === 'note' || (isLane && onlyWires)) {
                continue;
            }
            const across = Math.max(box.left - x, 0, x - box.left - box.width);
            const [upper, lower] = isLane ? [box.top + box.height - 6, box.top + box.height + 10] : [box.top, box.top + box.height];
            const far = Math.hypot(across, Math.max(upper - y, 0, y - lower));
            if (far < (best?.far ?? REACH)) {
                best = { found, isLane, far };
            }
        }
        if (best?.found.part.node === this.#aim?.found.part.node) {
            return;
        }
        this.#hide();
        if (!best) {
            return;
        }
        const { found, isLane } = best;
        const range = rangeOf(found);
        this.#aim = { found, target: isLane ? { from: range.start, to: range.end, side: 'below' } : { at: range.start } };
        this.#mark.show(this.#aim.target, [found]);
    }
}
