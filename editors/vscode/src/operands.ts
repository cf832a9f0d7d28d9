// The tags that the blocks of a line name, for the values at its end.
import type { Tag } from './protocol.ts';

/** The members worth a place at the end of a line, most telling first. */
const shownMembers = ['et', 'cv', 'q', 'q1', 'qu', 'qd'];

const name = /(?<![\p{L}\p{N}_.])[%\p{L}_][\p{L}\p{N}_]*(?:[.[\]]*[\p{L}\p{N}_]+)*\]?/gu;

/**
 * The names in a block's operand list, in order, with indices and members: `a[3]`, `t.ET`, `%IX0.3`.
 *
 * @param block the block as it stands in the text
 */
export function operandNames(block: string): string[] {
    const list = /^(?:\[[^\]]*\]|\([^)]*\)|<[^>]*>)\s*\((.*)\)$/s.exec(block)?.[1];
    if (list === undefined) {
        return [];
    }
    // Strings first: they may hold a `#`. Then literals with a prefix (16#FF, T#5s), and comments last.
    const bare = list
        .replaceAll(/'(?:\$.|[^'])*'/gs, ' ')
        .replaceAll(/[\p{L}\p{N}_]+#[\p{L}\p{N}_.:-]*/gu, ' ')
        .replaceAll(/#[^#]*#/g, ' ');
    return [...bare.matchAll(name)].map(([found]) => found);
}

/** Names of tags, in lower case, to their places in the state's list. */
export function indexTags(tags: readonly Tag[]): Map<string, number> {
    return new Map(tags.map((tag, place) => [tag.name.toLowerCase(), place]));
}

/** More than one for a timer or counter, none for a name that is no tag. */
function placesOf(index: ReadonlyMap<string, number>, wanted: string): number[] {
    const own = index.get(wanted);
    if (own !== undefined) {
        return [own];
    }
    return shownMembers.flatMap((member) => index.get(`${wanted}.${member}`) ?? []);
}

/** The places in the state's list of every tag that these blocks name, each once. */
export function tagPlaces(blocks: readonly string[], index: ReadonlyMap<string, number>): number[] {
    const places = new Set<number>();
    for (const operand of blocks.flatMap(operandNames)) {
        const wanted = operand.toLowerCase();
        const found = placesOf(index, wanted);
        // `word.3`, `a[i]`: the tag itself is what has a value.
        const shown = found.length > 0 ? found : placesOf(index, /^[^.[]+/.exec(wanted)?.[0] ?? wanted);
        for (const place of shown) {
            places.add(place);
        }
    }
    return [...places];
}
