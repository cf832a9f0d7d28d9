// What is selected while somebody draws: what has the focus, and what was selected with it.
import type { Range } from '../../protocol.ts';
import type { Place } from '../messages.ts';
import type { Found, Page } from '../page.ts';

function order(a: Place, b: Place): number {
    return a.line - b.line || a.character - b.character;
}

/** Where something is in the text. */
export function rangeOf({ drawing, part: { at, end } }: Found): Range {
    return { start: { line: drawing.first + at[0], character: at[1] }, end: { line: drawing.first + end[0], character: end[1] } };
}

/** What can be done with it: elements and comments can be deleted and moved, places have room, ends of branches are moved. */
export type About = 'element' | 'note' | 'point' | 'join';

/** What can be deleted and moved. */
const THINGS: readonly About[] = ['element', 'note'];

export function aboutOf({ part: { kind } }: Found): About {
    return kind === 'point' || kind === 'join' || kind === 'note' ? kind : 'element';
}

export class Selection {
    readonly #page: Page;
    #also: readonly Found[] = [];

    constructor(page: Page) {
        this.#page = page;
    }

    /** What has the focus, or had it last. */
    get here(): Found | undefined {
        return this.#page.find(document.activeElement) ?? this.#page.selection;
    }

    /** The selected elements and comments, from left to right. */
    get all(): readonly Found[] {
        const here = this.here;
        const all = [...this.#also, ...(here ? [here] : [])].filter((found) => THINGS.includes(aboutOf(found)) && found.part.node.isConnected);
        return [...new Map(all.map((found) => [found.part.node, found])).values()].sort((a, b) => order(rangeOf(a).start, rangeOf(b).start));
    }

    get ranges(): Range[] {
        return this.all.map(rangeOf);
    }

    has({ part }: Found): boolean {
        return this.all.some((found) => found.part === part);
    }

    /** Selects more of the same drawing: a click with Shift, or an arrow. */
    extend(found: Found): void {
        const here = this.here;
        this.set([...this.#also, ...(here ? [here] : [])].filter(({ drawing }) => drawing === found.drawing));
    }

    /** Selects some elements besides what has the focus. */
    set(also: readonly Found[]): void {
        this.#also = also;
        const selected = new Set(also.map(({ part }) => part.node as Element));
        for (const node of document.querySelectorAll('g.element.chosen')) {
            if (!selected.has(node)) {
                node.classList.remove('chosen');
            }
        }
        selected.forEach((node) => node.classList.add('chosen'));
    }

    /** Selects the things of a drawing that begin where some ranges of the text do. */
    these({ drawing }: Found, ranges: readonly Range[]): void {
        const all = [...drawing.parts, ...drawing.points].map((part) => ({ drawing, part }));
        this.set(all.filter((found) => THINGS.includes(aboutOf(found)) && ranges.some(({ start }) => order(start, rangeOf(found).start) === 0)));
    }

    /** Nothing but what has the focus is selected. */
    forget(): void {
        if (this.#also.length > 0) {
            this.set([]);
        }
    }
}
