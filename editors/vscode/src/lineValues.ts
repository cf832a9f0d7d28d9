// Values at the ends of lines: which tags each line shows, and the text of them.
import { indexTags, tagPlaces } from './operands.ts';
import type { Power, State } from './protocol.ts';
import { showValue } from './value.ts';

/** The places in the state's list of tags that a line shows, by line. */
export type LineTags = ReadonlyMap<number, readonly number[]>;

/** Found once a session: they depend on its text and its list of tags alone. */
export function findLineTags(state: Pick<State, 'power' | 'tags'>, textIn: (range: Power['range']) => string): LineTags {
    const blocks = new Map<number, string[]>();
    for (const { range } of state.power) {
        if (range.start.line === range.end.line) {
            const line = blocks.get(range.start.line) ?? [];
            line.push(textIn(range));
            blocks.set(range.start.line, line);
        }
    }
    const index = indexTags(state.tags);
    const lines = new Map<number, readonly number[]>();
    for (const [line, texts] of blocks) {
        const places = tagPlaces(texts, index);
        if (places.length > 0) {
            lines.set(line, places);
        }
    }
    return lines;
}

/** `start=1  stop=0!`; the `!` marks a forced tag. */
export function lineText(tags: State['tags'], places: readonly number[]): string {
    return places
        .flatMap((place) => tags[place] ?? [])
        .map((tag) => `${tag.name}=${showValue(tag)}${tag.forced ? '!' : ''}`)
        .join('  ');
}
