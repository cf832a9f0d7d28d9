// Where ranges stand after an edit. An editor moves what it has drawn by itself, but it does not tell where to.
import type { Power } from './protocol.ts';

type Range = Power['range'];
type Position = Range['start'];

export interface Change {
    readonly range: Range;
    readonly text: string;
}

function before(a: Position, b: Position): boolean {
    return a.line < b.line || (a.line === b.line && a.character < b.character);
}

function moved(position: Position, { range, text }: Change): Position {
    const lines = text.split('\n');
    const last = lines.at(-1)?.length ?? 0;
    const line = position.line + lines.length - 1 - (range.end.line - range.start.line);
    if (position.line !== range.end.line) {
        return { line, character: position.character };
    }
    const kept = position.character - range.end.character;
    return { line, character: kept + last + (lines.length === 1 ? range.start.character : 0) };
}

/** Ranges that a change cuts into are dropped. Changes are as an editor reports them: all about the text before them. */
export function rangesAfterEdit(ranges: readonly Range[], changes: readonly Change[]): Range[] {
    // From the last to the first in the text, so that none moves the place of one still to come.
    const backwards = changes.toSorted((a, b) => (before(a.range.start, b.range.start) ? 1 : -1));
    return backwards.reduce<Range[]>(
        (kept, change) =>
            kept.flatMap((range) => {
                if (!before(change.range.start, range.end)) {
                    return [range];
                }
                return before(range.start, change.range.end)
                    ? []
                    : [{ start: moved(range.start, change), end: moved(range.end, change) }];
            }),
        [...ranges],
    );
}
