// Where a place in a drawing is, in words.
/** A thing on a rung, from its left end to its right one. */
export interface OnRung {
    readonly left: number;
    readonly right: number;
    readonly y: number;
    /** What is said of it. */
    readonly text: string;
}

/** Things on one rung are at the same height, but for a few pixels. */
const SAME_RUNG = 4;

/** Where a place is: "between start and stop, line 1 of 2". */
export function wordsOf(point: Omit<OnRung, 'text'>, things: readonly OnRung[], heights: readonly number[]): string {
    const beside = things.filter(({ y }) => Math.abs(y - point.y) < SAME_RUNG);
    // A short wire is a target that reaches over what is next to it.
    const middle = (point.left + point.right) / 2;
    const before = beside.filter(({ right }) => right <= middle).sort((a, b) => b.right - a.right)[0];
    const after = beside.filter(({ left }) => left >= middle).sort((a, b) => a.left - b.left)[0];
    const where = `between ${before?.text ?? 'the left'} and ${after?.text ?? 'the right'}`;
    const lines = [...new Set(heights.map(Math.round))].sort((a, b) => a - b);
    const line = lines.findIndex((y) => Math.abs(y - point.y) < SAME_RUNG);
    return lines.length > 1 ? `${where}, line ${line + 1} of ${lines.length}` : where;
}
