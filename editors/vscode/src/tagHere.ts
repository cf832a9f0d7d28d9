// The tag that a person means by a place in a line.
import type { Tag } from './protocol.ts';

/** `run`, `t1.ET`, `a[3]`, `%IX0.1` around a column; of a timer or counter the first of its members. */
export function tagHere(line: string, column: number, tags: readonly Tag[]): string | undefined {
    const words = line.matchAll(/[\p{L}\p{N}_.%]+(\[-?\d+\])?/gu);
    const found = [...words].find(({ index, 0: word }) => index <= column && column <= index + word.length)?.[0];
    if (found === undefined) {
        return undefined;
    }
    const wanted = found.toLowerCase();
    const named = tags.find(({ name }) => name.toLowerCase() === wanted);
    return (named ?? tags.find(({ name }) => name.toLowerCase().startsWith(`${wanted}.`)))?.name ?? found;
}
