// The places along a line of a drawing, from left to right, and those next to something.
import type { Place } from '../messages.ts';
import type { Found } from '../page.ts';
import { BESIDE_JOIN } from './points.ts';
import { rangeOf } from './selection.ts';

/** Places on one line are at the same height, but for a few pixels. */
const SAME_LINE = 6;

export type Step = 'left' | 'right' | 'up' | 'down';

function middle({ box }: Found['part']): { x: number; y: number } {
    return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

/**
 * Where something goes that moves a step: past what is next to it on its line, or to the nearest place of a line above or
 * below. What is an end of a branch moves on the line that its upper end is at.
 */
export function stepped(found: Found, step: Step): Place | undefined {
    const { drawing, part } = found;
    const isJoin = part.kind === 'join';
    const { x } = middle(part);
    const y = isJoin ? part.box.y - BESIDE_JOIN : part.kind === 'note' ? middle(part).y : part.box.y + 27;
    const points = drawing.points.filter(({ kind }) => kind === 'point').map((point) => ({ point, ...middle(point) }));
    const placeOf = (point: Found['part'] | undefined) => point && rangeOf({ drawing, part: point }).start;
    if (step === 'left' || step === 'right') {
        const sign = step === 'left' ? -1 : 1;
        const along = points.filter((other) => Math.abs(other.y - y) < SAME_LINE && (other.x - x) * sign > 0);
        along.sort((a, b) => (a.x - b.x) * sign);
        // The nearest is right next to it: what is put in there has not moved.
        return placeOf(along[1]?.point);
    }
    const sign = step === 'up' ? -1 : 1;
    const across = points.filter((other) => (other.y - y) * sign > SAME_LINE);
    const far = (other: { x: number; y: number }) => Math.abs(other.y - y) * 4 + Math.abs(other.x - x);
    across.sort((a, b) => far(a) - far(b));
    return placeOf(across[0]?.point);
}
