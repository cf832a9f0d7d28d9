// The tag view's content: tags in groups by their role, and what each row shows.
import type { Tag } from './protocol.ts';

/** A tag in the list: once among those of its role, and once more if it is watched. */
export interface Row extends Tag {
    readonly watched?: boolean;
}

/** What tells a row from all others. */
export function rowId({ name, watched }: Row): string {
    return watched ? `watched ${name}` : name;
}

/** Tags of one role; of a long list a part of them. */
export interface TagGroup {
    readonly id: string;
    readonly title: string;
    readonly tags: readonly Row[];
    /** It begins unfolded. */
    readonly open: boolean;
}

/** A longer list is shown in parts. */
const LONG = 200;
const PART = 100;

const titles: readonly (readonly [Tag['role'], string])[] = [
    ['input', 'Inputs'],
    ['output', 'Outputs'],
    ['internal', 'Internal'],
];

/** The tags that a person watches, as rows of their own, in the order of the list. */
export function watchedRows(tags: readonly Tag[]): Row[] {
    return tags.map((tag) => ({ ...tag, watched: true }));
}

/** Those rows, above all other groups; none if nothing is watched. */
export function watchedGroup(rows: readonly Row[]): TagGroup[] {
    return rows.length > 0 ? [{ id: 'watched', title: 'Watched', tags: rows, open: true }] : [];
}

/** Groups without a tag are left out. */
export function tagGroups(tags: readonly Tag[]): TagGroup[] {
    return titles
        .map(([role, title]) => ({ id: role, title, tags: tags.filter((tag) => tag.role === role), open: true }))
        .filter((group) => group.tags.length > 0);
}

/** The tags whose name or type holds what a person looks for, in any case, and what a member of theirs is looked for in. */
export function filtered(tags: readonly Tag[], wanted: string): readonly Tag[] {
    const sought = wanted.trim().toLowerCase();
    const fits = ({ name, type, parts }: Tag) =>
        `${name} : ${type}`.toLowerCase().includes(sought) || (parts !== undefined && /^[.[]/.test(sought.slice(name.length)) && sought.startsWith(name.toLowerCase()));
    return sought === '' ? tags : tags.filter(fits);
}

/** The parts of a group that is too long to be looked through. */
export function partsOf({ id, tags }: TagGroup): TagGroup[] {
    if (tags.length <= LONG) {
        return [];
    }
    return Array.from({ length: Math.ceil(tags.length / PART) }, (_, part) => {
        const these = tags.slice(part * PART, (part + 1) * PART);
        return { id: `${id} ${part}`, title: `${these[0]?.name} – ${these.at(-1)?.name}`, tags: these, open: false };
    });
}

/** What is unfolded of tags: they themselves, and of those that open what they open into. */
export function unfolded(tags: readonly Row[], isOpen: (id: string) => boolean, parts: ReadonlyMap<string, readonly Row[]>): Row[] {
    return tags.flatMap((tag) => {
        if (tag.parts === undefined) {
            return [tag];
        }
        const group = opened(tag, parts.get(rowId(tag)) ?? []);
        return isOpen(group.id) ? [tag, ...unfoldedGroup(group, isOpen, parts)] : [tag];
    });
}

/** The same of a group that is unfolded itself. */
export function unfoldedGroup(group: TagGroup, isOpen: (id: string) => boolean, parts: ReadonlyMap<string, readonly Row[]>): Row[] {
    const inner = partsOf(group);
    const groups = inner.length === 0 ? [group] : inner.filter(({ id }) => isOpen(id));
    return groups.flatMap(({ tags }) => unfolded(tags, isOpen, parts));
}

/** A tag that opens, as a group of what it opens into. */
export function opened(tag: Row, tags: readonly Row[]): TagGroup {
    return { id: `tag ${rowId(tag)}`, title: tag.name, tags, open: false };
}

export interface TagRow {
    readonly label: string;
    readonly description: string;
    readonly tooltip: string;
    readonly icon: string;
    /** Words that package.json's menus match: `tag`, `settable`, and `free` or `forced`, or `constant`; `watched` or `unwatched`. */
    readonly context: string;
    /** A click inverts it. */
    readonly toggles: boolean;
}

export function tagRow(tag: Row): TagRow {
    const watched = tag.watched ? 'watched' : 'unwatched';
    const isBool = typeof tag.value === 'boolean';
    const settable = tag.readOnly !== true;
    const role = tag.readOnly ? 'constant' : tag.role;
    if (tag.parts !== undefined) {
        return {
            label: tag.name,
            description: (tag.text === '' ? tag.type : tag.text) + (tag.forced ? '  forced' : ''),
            tooltip: `${tag.name} : ${tag.type}, ${role}`,
            icon: 'symbol-array',
            context: `group ${watched}`,
            toggles: false,
        };
    }
    const icon = tag.forced ? 'lock' : !isBool ? 'symbol-number' : tag.value ? 'circle-filled' : 'circle-large-outline';
    return {
        label: tag.name,
        description: tag.text + (tag.forced ? '  forced' : ''),
        tooltip: `${tag.name} : ${tag.type}, ${role}${tag.forced ? ', forced' : ''}`,
        icon,
        context: `tag ${settable ? `settable ${tag.forced ? 'forced' : 'free'}` : 'constant'} ${watched}`,
        toggles: settable && isBool && (tag.role !== 'output' || tag.forced),
    };
}
