// What to paint: ranges by how they look, neighbours joined so that the editor has few to draw.
import type { Power } from './protocol.ts';

type Range = Power['range'];

/**
 * How an element looks: with power, without, a contact that lets it through with and without power, one that stops it, and
 * what changes faster than anybody can follow; and that of which nothing is known.
 */
export type Look = 'on' | 'off' | 'closedOn' | 'closed' | 'blocks' | 'flickers' | 'unknown';

export type PowerRanges = Readonly<Record<Look, readonly Range[]>>;

function look({ on, unknown, contact }: Power): Look {
    if (unknown) {
        return 'unknown';
    }
    if (contact === 'closed') {
        return on ? 'closedOn' : 'closed';
    }
    return contact === 'blocks' ? 'blocks' : on ? 'on' : 'off';
}

function touches(left: Range, right: Range): boolean {
    return left.end.line === right.start.line && left.end.character === right.start.character;
}

function inTextOrder(a: Power, b: Power): number {
    return a.range.start.line - b.range.start.line || a.range.start.character - b.range.start.character;
}

export function powerRanges(power: readonly Power[], flickering: ReadonlySet<Power> = new Set()): PowerRanges {
    const ranges: Record<Look, Range[]> = { on: [], off: [], closedOn: [], closed: [], blocks: [], flickers: [], unknown: [] };
    for (const element of power.toSorted(inTextOrder)) {
        const list = ranges[flickering.has(element) ? 'flickers' : look(element)];
        const last = list.at(-1);
        // Two contacts side by side stay two.
        if (last && !element.contact && touches(last, element.range)) {
            list[list.length - 1] = { start: last.start, end: element.range.end };
        } else {
            list.push(element.range);
        }
    }
    return ranges;
}
