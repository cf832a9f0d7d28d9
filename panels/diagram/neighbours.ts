// Which element the arrow keys go to.

/** An element on the page: its middle, and the height of its wire. */
export interface Spot {
    readonly x: number;
    readonly y: number;
    /** It is between the rungs: up and down come to it only from what is right above or below. */
    readonly isBetween?: boolean;
}

export type Direction = 'left' | 'right' | 'up' | 'down';

/** Elements on one rung are at the same height, but for a pixel. */
export const SAME_RUNG = 4;

/** Going up and down prefers what is near to what is straight ahead by this much. */
const SLANT = 0.3;
const SLANT_BETWEEN = 2;

function along(spots: readonly Spot[], from: Spot, sign: number): number {
    const order = (a: Spot, b: Spot) => (Math.abs(a.y - b.y) > SAME_RUNG ? a.y - b.y : a.x - b.x);
    let best = -1;
    spots.forEach((spot, index) => {
        const known = spots[best];
        if (sign * order(spot, from) > 0 && (!known || sign * order(spot, known) < 0)) {
            best = index;
        }
    });
    return best;
}

function across(spots: readonly Spot[], from: Spot, sign: number): number {
    let best = -1;
    let least = Infinity;
    spots.forEach((spot, index) => {
        const far = sign * (spot.y - from.y);
        const cost = far + (spot.isBetween ? SLANT_BETWEEN : SLANT) * Math.abs(spot.x - from.x);
        if (far > SAME_RUNG && cost < least) {
            best = index;
            least = cost;
        }
    });
    return best;
}

/** @returns the index of the neighbour; left and right go on to the rung above or below. -1 if there is none */
export function neighbour(spots: readonly Spot[], from: Spot, direction: Direction): number {
    switch (direction) {
        case 'left':
            return along(spots, from, -1);
        case 'right':
            return along(spots, from, 1);
        case 'up':
            return across(spots, from, -1);
        case 'down':
            return across(spots, from, 1);
    }
}
