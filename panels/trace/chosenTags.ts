// The tags of a trace and their order.
import type { Tag } from '../protocol.ts';

/** The server records no more. */
export const MOST = 64;

/** So many are shown of a program for which none were chosen. */
const AT_FIRST = 8;

const same = (one: string, other: string) => one.toLowerCase() === other.toLowerCase();

export function added(tags: readonly string[], tag: string): readonly string[] {
    return tags.some((it) => same(it, tag)) ? tags : [...tags, tag];
}

export function removed(tags: readonly string[], tag: string): readonly string[] {
    return tags.filter((it) => !same(it, tag));
}

/** One place up or down. */
export function moved(tags: readonly string[], tag: string, by: 1 | -1): readonly string[] {
    const from = tags.findIndex((it) => same(it, tag));
    const to = from + by;
    const other = tags[to];
    if (from < 0 || other === undefined) {
        return tags;
    }
    return tags.map((it, at) => (at === from ? other : at === to ? tag : it));
}

/** Those that were picked: the ones that were there before keep their order. */
export function picked(tags: readonly string[], names: readonly string[]): readonly string[] {
    const kept = tags.filter((tag) => names.some((name) => same(name, tag)));
    return names.reduce(added, kept);
}

/** Those that were asked for, by the names that the program has for them now: some may have been renamed while it runs. */
export function renamed(asked: readonly string[], found: readonly { readonly name: string }[]): readonly string[] {
    const names = asked.map((tag, at) => found[at]?.name ?? tag);
    return names.every((name, at) => same(name, asked[at] ?? '')) ? asked : names.reduce<readonly string[]>(added, []);
}

/** What the world gives and takes, as long as nobody has chosen. */
export function atFirst(tags: readonly Tag[]): readonly string[] {
    const ofRole = (role: Tag['role']) => tags.filter((tag) => tag.role === role && tag.readOnly !== true);
    return [...ofRole('input'), ...ofRole('output')].slice(0, AT_FIRST).map(({ name }) => name);
}
