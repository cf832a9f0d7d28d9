// Where values are: above their operands where nothing else does, else below them, else between the lines. Never between
// the characters of a line, which would push the drawing apart.

export interface Label {
    /** The operand's line and column, from 0. */
    readonly row: number;
    readonly column: number;
    readonly text: string;
    /** Cells that are kept free for it at least. */
    readonly room: number;
}

export interface Placed {
    readonly side: 'above' | 'below' | 'between';
    readonly column: number;
}

/** How many cells a value of a type mostly takes, so that it can grow without moving. */
export function roomFor(type: string): number {
    if (type === 'BOOL') {
        return 1;
    }
    return type === 'TIME' || type.endsWith('REAL') ? 7 : 5;
}

/** Whether cells are blank, and one on each side, so that two things do not look like one. */
function isFree(line: string | undefined, taken: ReadonlySet<number> | undefined, from: number, to: number): boolean {
    if (line === undefined) {
        return false;
    }
    for (let cell = Math.max(from - 1, 0); cell <= to; cell += 1) {
        if (taken?.has(cell) || (line[cell] ?? ' ') !== ' ') {
            return false;
        }
    }
    return true;
}

/**
 * @param labels in the order of the text
 * @param lineAt undefined past the ends of the text
 */
export function placeLabels(labels: readonly Label[], lineAt: (row: number) => string | undefined): Placed[] {
    const taken = new Map<number, Set<number>>();
    const freeBetween = new Map<number, number>();
    return labels.map(({ row, column, text, room }) => {
        const width = Math.max(text.length, room);
        for (const [side, other] of [['above', row - 1], ['below', row + 1]] as const) {
            const cells = taken.get(other) ?? new Set();
            if (isFree(lineAt(other), cells, column, column + width)) {
                taken.set(other, cells);
                for (let cell = column; cell < column + width; cell += 1) {
                    cells.add(cell);
                }
                return { side, column };
            }
        }
        const free = Math.max(column, freeBetween.get(row) ?? 0);
        freeBetween.set(row, free + width + 1);
        return { side: 'between', column: free };
    });
}
