// What a place in a wire is called.
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

/** What a place is called: "Wire between start and stop, line 1 of 2". */
export function wordsOf(point: Omit<OnRung, 'text'>, things: readonly OnRung[], heights: readonly number[]): string {
    const beside = things.filter(({ y }) => Math.abs(y - point.y) < SAME_RUNG);
    const before = beside.filter(({ right }) => right <= point.left + 1).sort((a, b) => b.right - a.right)[0];
    const after = beside.filter(({ left }) => left >= point.right - 1).sort((a, b) => a.left - b.left)[0];
    const where = `Wire between ${before?.text ?? 'the left'} and ${after?.text ?? 'the right'}`;
    const lines = [...new Set(heights.map(Math.round))].sort((a, b) => a - b);
    const line = lines.findIndex((y) => Math.abs(y - point.y) < SAME_RUNG);
    return lines.length > 1 ? `${where}, line ${line + 1} of ${lines.length}` : where;
}
