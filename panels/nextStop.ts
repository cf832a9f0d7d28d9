// Where Tab leads on a rung: blanks in a wire would cut it.

/** What Tab selects: an operand, or a place to write at. */
export interface Stop {
    readonly start: number;
    readonly end: number;
}

/** The words before a `#` that belongs to a literal: `T#5s`, `16#FF`. Any other `#` opens a comment. */
const LITERAL =
    /(?:^|[^\p{L}\p{N}_.#])(?:\d+|L?TIME|T|DATE|D|TIME_OF_DAY|TOD|DATE_AND_TIME|DT|BOOL|BYTE|[DL]?WORD|[SDL]?INT|U[SDL]?INT|L?REAL|STRING)$/iu;

/** Whether a line of text is drawn: rails, connectors, wires or blocks. */
export function isDrawn(line: string): boolean {
    return /^\s*[+|\\/]/.test(line) || /[\])>]-|-[[(<\\/+]/.test(line);
}

/** After the comment or the text that begins at a place; where nothing ends it, after the line. */
function after(line: string, at: number): number {
    const end = line.indexOf(line.charAt(at), at + 1);
    return end < 0 ? line.length : end + 1;
}

/** The operand between two places; of one that is given by name the value. An operand that is still to be written is a place. */
function operand(line: string, from: number, to: number): Stop {
    const text = line.slice(from, to);
    const name = /^\s*[\p{L}_][\p{L}\p{N}_]*\s*(?::=|=>)/u.exec(text)?.[0].length ?? 0;
    const value = text.slice(name);
    const start = from + name + (value.length - value.trimStart().length);
    return { start, end: Math.max(from + text.trimEnd().length, start) };
}

/** Adds the operands of the list that opens at a place; returns where the list ends. */
function addOperands(line: string, open: number, found: Stop[]): number {
    let depth = 0;
    let from = open + 1;
    let at = from;
    for (; at < line.length; at += 1) {
        const letter = line.charAt(at);
        if (letter === "'" || (letter === '#' && !LITERAL.test(line.slice(from, at)))) {
            at = after(line, at) - 1;
        } else if (letter === '(' || letter === '[') {
            depth += 1;
        } else if (letter === ',' && depth === 0) {
            found.push(operand(line, from, at));
            from = at + 1;
        } else if (letter === ')' && depth === 0) {
            break;
        } else if (letter === ')' || letter === ']') {
            depth -= 1;
        }
    }
    if (from > open + 1 || line.slice(from, at).trim() !== '') {
        found.push(operand(line, from, at));
    }
    return at;
}

/** The places on a drawn line where a person goes on: the operands, and after the last wire. */
function stops(line: string): Stop[] {
    const found: Stop[] = [];
    for (let at = 0; at < line.length; at += 1) {
        if (line.charAt(at) === '#') {
            at = after(line, at) - 1;
        } else if (line.charAt(at) === '(' && /[\])>]\s*$/.test(line.slice(0, at))) {
            // What follows a block's first part is its list.
            at = addOperands(line, at, found);
        }
    }
    const end = line.trimEnd().replace(/\s+\|$|-*\+$/, '').length;
    return end > 0 ? [...found, { start: end, end }] : found;
}

/** The next stop after (or, backwards, in front of) what is selected; the end of the line or its place where there is none. */
export function nextStop(line: string, { start, end }: Stop, backwards: boolean): Stop {
    const all = stops(line);
    if (backwards) {
        return all.findLast((stop) => stop.end < start || (stop.start < start && stop.end <= start)) ?? { start, end: start };
    }
    const last = Math.max(end, line.trimEnd().length);
    return all.find((stop) => stop.start > end || (stop.start === end && start === end && stop.end > end)) ?? { start: last, end: last };
}
