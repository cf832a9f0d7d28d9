// Which lines of a program are marked after a comparison, and as what.
import type { Changed, Compared } from './messages.ts';

/** What a mark says of a rung: it does the same, another thing, or that is not decided; it is new, one is gone, or it is only drawn or placed differently. */
export type Mark = 'same' | 'other' | 'unknown' | 'new' | 'gone' | 'drawn';

/** A line has one mark, however many changes are there: the first of these. */
const ranks: readonly Mark[] = ['other', 'unknown', 'new', 'gone', 'same', 'drawn'];

export interface MarkedLine {
    readonly line: number;
    readonly mark: Mark;
    /** What happened there, in words. */
    readonly titles: readonly string[];
}

/** @returns none for a change that is marked nowhere: comments */
export function markOf({ change, meaning }: Changed): Mark | undefined {
    switch (change) {
        case 'edited':
            return meaning === 'same' || meaning === 'other' ? meaning : 'unknown';
        case 'new':
        case 'gone':
            return change;
        case 'redrawn':
        case 'same':
            return 'drawn';
        case 'commented':
            return undefined;
    }
}

/** The marks of the networks: of what else is different the editor's own signs say enough. */
export function markedLines({ changes }: Compared): MarkedLine[] {
    const lines = new Map<number, MarkedLine>();
    for (const change of changes) {
        const mark = markOf(change);
        if (change.kind !== 'network' || !mark) {
            continue;
        }
        const title = change.reason === undefined ? change.title : `${change.title}: ${change.reason}`;
        const there = lines.get(change.line);
        const marks = [mark, ...(there ? [there.mark] : [])];
        const first = ranks.find((rank) => marks.includes(rank)) ?? mark;
        lines.set(change.line, { line: change.line, mark: first, titles: [...(there?.titles ?? []), title] });
    }
    return [...lines.values()];
}
