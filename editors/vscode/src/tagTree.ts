// The tag view's content: tags in groups by their role, and what each row shows.
import type { State, Tag } from './protocol.ts';
import { showValue } from './value.ts';

export interface TagGroup {
    readonly role: Tag['role'];
    readonly title: string;
    readonly tags: readonly Tag[];
}

const titles: readonly (readonly [Tag['role'], string])[] = [
    ['input', 'Inputs'],
    ['output', 'Outputs'],
    ['internal', 'Internal'],
];

/** Groups without a tag are left out. */
export function tagGroups(state: Pick<State, 'tags'>): TagGroup[] {
    return titles
        .map(([role, title]) => ({ role, title, tags: state.tags.filter((tag) => tag.role === role) }))
        .filter(({ tags }) => tags.length > 0);
}

export interface TagRow {
    readonly label: string;
    readonly description: string;
    readonly tooltip: string;
    readonly icon: string;
    /** Words that package.json's menus match: `settable`, and `free` or `forced`. */
    readonly context: string;
    /** A click inverts it. */
    readonly toggles: boolean;
}

export function tagRow(tag: Tag): TagRow {
    const isBool = typeof tag.value === 'boolean';
    const settable = tag.role === 'input';
    const icon = tag.forced ? 'lock' : !isBool ? 'symbol-number' : tag.value ? 'circle-filled' : 'circle-large-outline';
    return {
        label: tag.name,
        description: showValue(tag) + (tag.forced ? '  forced' : ''),
        tooltip: `${tag.name} : ${tag.type}, ${tag.role}${tag.forced ? ', forced' : ''}`,
        icon,
        context: `${settable ? 'settable ' : ''}${tag.forced ? 'forced' : 'free'}`,
        toggles: settable && isBool,
    };
}

/** The rows whose text differs between two states, so that only they are drawn again; undefined if the lists differ. */
export function changedTags(before: readonly Tag[], after: readonly Tag[]): Tag[] | undefined {
    if (before.length !== after.length || before.some((tag, place) => tag.name !== after[place]?.name)) {
        return undefined;
    }
    return after.filter((tag, place) => tag.value !== before[place]?.value || tag.forced !== before[place]?.forced);
}
