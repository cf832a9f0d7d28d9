// The programs that come with the page: the examples, and what is written in each step of the first chapters of the book.
import { byId, element } from './element.ts';

export interface Example {
    readonly group: string;
    readonly title: string;
    readonly name: string;
    readonly text: string;
    readonly scenarios?: string;
    /** What is next to it: its machine, and a scene of that. */
    readonly files?: Readonly<Record<string, string>>;
    /** Where the book tells of it, from the site's first page. */
    readonly chapter?: string;
}

/** @param open called with the one that was chosen, and whether there is one before and after it in its group */
export async function examples(open: (example: Example) => void): Promise<readonly Example[]> {
    const select = byId('examples') as HTMLSelectElement;
    const all = (await (await fetch('examples.json')).json()) as readonly Example[];
    const groups = [...new Set(all.map(({ group }) => group))];
    select.append(
        ...groups.map((group) => {
            const options = all.flatMap((example, at) => (example.group === group ? [element('option', { value: String(at) }, example.title)] : []));
            return element('optgroup', { label: group }, ...options);
        }),
    );
    select.addEventListener('change', () => {
        const chosen = all[Number(select.value)];
        select.value = '';
        if (chosen) {
            open(chosen);
        }
    });
    return all;
}
