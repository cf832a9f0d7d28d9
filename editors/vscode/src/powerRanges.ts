// What to paint: the ranges with and without power, neighbours joined so that the editor has few to draw.
import type { Power } from './protocol.ts';

type Range = Power['range'];

export interface PowerRanges {
    readonly on: readonly Range[];
    readonly off: readonly Range[];
}

function touches(left: Range, right: Range): boolean {
    return left.end.line === right.start.line && left.end.character === right.start.character;
}

/** Joins ranges that touch; they are joined only as they follow one another in the list. */
function joined(ranges: readonly Range[]): Range[] {
    const result: Range[] = [];
    for (const range of ranges) {
        const last = result.at(-1);
        if (last && touches(last, range)) {
            result[result.length - 1] = { start: last.start, end: range.end };
        } else {
            result.push(range);
        }
    }
    return result;
}

function inTextOrder(a: Power, b: Power): number {
    return a.range.start.line - b.range.start.line || a.range.start.character - b.range.start.character;
}

export function powerRanges(power: readonly Power[]): PowerRanges {
    const sorted = power.toSorted(inTextOrder);
    return {
        on: joined(sorted.filter(({ on }) => on).map(({ range }) => range)),
        off: joined(sorted.filter(({ on }) => !on).map(({ range }) => range)),
    };
}
