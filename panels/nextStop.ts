// Where Tab leads on a rung: blanks in a wire would cut it.

/** Whether a line of text is drawn: rails, connectors, wires or blocks. */
export function isDrawn(line: string): boolean {
    return /^\s*[+|\\/]/.test(line) || /[\])>]-|-[[(<\\/+]/.test(line);
}

/** The places on a drawn line where a person goes on: at operands, in front of blocks, and after the last wire. */
function stops(line: string): number[] {
    const found = new Set<number>();
    for (const { index, 0: text } of line.matchAll(/\(\s*(?=[^)\s])|,\s*/g)) {
        // The first part of a coil is not an operand, and neither is what is in a comment.
        if (!/^\(\s*\w*\s*\)\s*\(/.test(line.slice(index)) && (line.slice(0, index).split('#').length - 1) % 2 === 0) {
            found.add(index + text.length);
        }
    }
    const end = line.trimEnd().replace(/\s+\|$|-*\+$/, '').length;
    found.add(end);
    return [...found].filter((stop) => stop > 0).sort((a, b) => a - b);
}

/** The next stop after (or, backwards, in front of) a column; the end of the line or its column where there is none. */
export function nextStop(line: string, column: number, backwards: boolean): number {
    const all = stops(line);
    return backwards
        ? (all.findLast((stop) => stop < column) ?? column)
        : (all.find((stop) => stop > column) ?? Math.max(column, line.trimEnd().length));
}
