// The operands in a text such as `t, T#1s`: each is written on its own.

/** Where a part of a text begins and ends. */
export type Segment = readonly [start: number, end: number];

/** The operands in all parentheses of a text such as `[ ]( a )--[TON]( t, 5s )`. */
export function segmentsInBlocks(text: string): Segment[] {
    return [...text.matchAll(/\( ([^()]*) \)/g)].flatMap(({ index, 1: list = '' }) => segmentsOf(list).map(([start, end]): Segment => [index + 2 + start, index + 2 + end]));
}

/** The operands of a list, without the blanks around them. Commas in strings and in brackets part nothing. */
export function segmentsOf(text: string): Segment[] {
    const segments: Segment[] = [];
    let from = 0;
    let depth = 0;
    let quote = '';
    const take = (to: number) => {
        const part = text.slice(from, to);
        const start = from + part.length - part.trimStart().length;
        segments.push([start, Math.max(start, from + part.trimEnd().length)]);
        from = to + 1;
    };
    for (let index = 0; index < text.length; index += 1) {
        const letter = text.charAt(index);
        if (quote) {
            quote = letter === quote ? '' : quote;
        } else if (letter === "'" || letter === '"') {
            quote = letter;
        } else if ('([{'.includes(letter)) {
            depth += 1;
        } else if (')]}'.includes(letter)) {
            depth -= 1;
        } else if (letter === ',' && depth === 0) {
            take(index);
        }
    }
    take(text.length);
    return segments;
}
