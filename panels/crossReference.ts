// What the server says of a program's tags, as rows of a tree: a tag, and the places that read, write, set and reset it.
import type { Range } from './protocol.ts';

/** What `ladder.crossReference` answers. */
export interface CrossReferenced {
    readonly uri: string;
    readonly version: number;
    readonly tags: readonly ReferencedTag[];
}

export interface ReferencedTag {
    readonly name: string;
    readonly block?: string;
    readonly type: string;
    readonly kind: 'input' | 'output' | 'internal' | 'constant';
    readonly address?: string;
    readonly comment?: string;
    readonly declared: boolean;
    readonly range: Range;
    readonly places: readonly ReferencedPlace[];
}

export interface ReferencedPlace {
    readonly does: string;
    readonly network: number;
    readonly range: Range;
}

export interface ReferenceRow {
    readonly label: string;
    readonly description: string;
    readonly icon: string;
    readonly range: Range;
    readonly children: readonly ReferenceRow[];
}

const icons: Readonly<Record<string, string>> = { read: 'eye', write: 'edit', set: 'arrow-circle-up', reset: 'arrow-circle-down' };

/** The rows of the tags whose name, address or comment holds what is looked for, in any case. */
export function referenceRows({ tags }: CrossReferenced, wanted: string): ReferenceRow[] {
    const sought = wanted.trim().toLowerCase();
    const matches = ({ name, block, address, comment }: ReferencedTag) =>
        [name, block, address, comment].some((text) => text?.toLowerCase().includes(sought));
    return tags.filter((tag) => sought === '' || matches(tag)).map(tagRow);
}

function tagRow({ name, block, type, kind, address, comment, range, places }: ReferencedTag): ReferenceRow {
    const counts = new Map<string, number>();
    for (const { does } of places) {
        counts.set(does, (counts.get(does) ?? 0) + 1);
    }
    const used = places.length === 0 ? 'used nowhere' : [...counts].map(([does, count]) => `${does} ${count}`).join(', ');
    const words = [type, kind, address === name ? undefined : address, used, comment];
    return {
        label: block === undefined ? name : `${block}.${name}`,
        description: words.filter((word) => word !== undefined && word !== '').join(' · '),
        icon: kind === 'input' ? 'arrow-right' : kind === 'output' ? 'arrow-left' : kind === 'constant' ? 'symbol-constant' : 'symbol-variable',
        range,
        children: places.map((place) => ({
            label: place.does,
            description: `line ${place.range.start.line + 1}, network ${place.network}`,
            icon: icons[place.does] ?? 'arrow-both',
            range: place.range,
            children: [],
        })),
    };
}
