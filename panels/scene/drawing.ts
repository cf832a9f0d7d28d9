// The picture: elements made one by one from what the server has let through, and changed at most once in a frame.
import type { Changed, SceneShown } from './messages.ts';

const SVG = 'http://www.w3.org/2000/svg';

export class Drawing {
    readonly nodes: readonly Node[];
    /** The value of each place, as it is now. */
    readonly values: string[];
    readonly #shown: SceneShown;
    /** What attributes were before there were values. */
    readonly #atRest: readonly (string | null)[];
    readonly #onRow: (row: number, value: string) => void;
    readonly #onAlarm: (text: string, isShown: boolean) => void;
    readonly #animations: Animation[] = [];
    #waiting = new Map<number, string>();
    #isAsked = false;

    constructor(parent: HTMLElement, shown: SceneShown, onRow: (row: number, value: string) => void, onAlarm: (text: string, isShown: boolean) => void) {
        this.#shown = shown;
        this.#onRow = onRow;
        this.#onAlarm = onAlarm;
        const nodes: Node[] = [];
        for (const { parent: above, name, attributes, text } of shown.nodes) {
            const node = name === undefined ? document.createTextNode(text ?? '') : document.createElementNS(SVG, name);
            if (node instanceof Element) {
                Object.entries(attributes ?? {}).forEach(([attribute, value]) => node.setAttribute(attribute, value));
            }
            if (above !== undefined) {
                nodes[above]?.appendChild(node);
            }
            nodes.push(node);
        }
        this.nodes = nodes;
        this.values = shown.slots.map(() => '');
        this.#atRest = shown.slots.map(({ node, use }) => {
            const element = nodes[node];
            return use === 'text' ? (element?.textContent ?? '') : element instanceof Element ? element.getAttribute(use) : null;
        });
        parent.replaceChildren(...nodes.slice(0, 1));
        this.#blink();
        this.#apply(shown.values.map((value, slot) => [slot, value] as const));
    }

    element(node: number): SVGElement | undefined {
        const found = this.nodes[node];
        return found instanceof SVGElement ? found : undefined;
    }

    /** The value of a place of an element. */
    valueOf(node: number, use: string): string {
        const slot = this.#shown.slots.findIndex((slot) => slot.node === node && slot.use === use);
        return this.#waiting.get(slot) ?? this.values[slot] ?? '';
    }

    /** The values come with the next frame; of several for one place the last. */
    change(values: readonly Changed[]): void {
        values.forEach(([slot, value]) => this.#waiting.set(slot, value));
        if (!this.#isAsked) {
            this.#isAsked = true;
            requestAnimationFrame(() => {
                this.#isAsked = false;
                const waiting = this.#waiting;
                this.#waiting = new Map();
                this.#apply(waiting);
            });
        }
    }

    /** Nothing of it is shown any more. */
    end(): void {
        this.#waiting = new Map();
        this.#animations.forEach((animation) => animation.cancel());
    }

    #apply(values: Iterable<Changed>): void {
        for (const [slot, value] of values) {
            const { node, use } = this.#shown.slots[slot] ?? { node: 0, use: '' };
            if (use === '') {
                continue;
            }
            this.values[slot] = value;
            if (use === 'row') {
                this.#onRow(node, value);
            } else if (use !== 'given') {
                this.#put(this.element(node), use, value, this.#atRest[slot] ?? null);
            }
        }
    }

    #put(element: SVGElement | undefined, use: string, value: string, atRest: string | null): void {
        if (use === 'text') {
            if (element && element.textContent !== value) {
                element.textContent = value;
            }
            return;
        }
        const wanted = value === '' ? atRest : value;
        if (wanted === null) {
            element?.removeAttribute(use);
        } else if (element?.getAttribute(use) !== wanted) {
            element?.setAttribute(use, wanted);
        }
        if (use === 'display' && element?.getAttribute('role') === 'alert') {
            this.#onAlarm(element.getAttribute('aria-label') ?? element.textContent ?? '', value === '');
        }
    }

    /** Who asks for less motion sees it all the time. */
    #blink(): void {
        if (matchMedia('(prefers-reduced-motion: reduce)').matches) {
            return;
        }
        this.#shown.nodes.forEach(({ blink }, at) => {
            if (blink !== undefined) {
                const frames = [{ opacity: 1 }, { opacity: 0.15 }];
                const animation = this.element(at)?.animate(frames, { duration: blink, iterations: Infinity, easing: 'steps(2, jump-none)' });
                this.#animations.push(...(animation ? [animation] : []));
            }
        });
    }
}
