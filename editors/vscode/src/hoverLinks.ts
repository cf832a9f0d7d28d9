// What can be done with the tags under the pointer, as links below what the server says of them.
import type { Tag } from '../../../panels/protocol.ts';
import { escaped } from './markdown.ts';

/** The commands that the links may run. */
export const LINKED = [
    'ladder.simulation.toggle',
    'ladder.simulation.set',
    'ladder.simulation.force',
    'ladder.simulation.unforce',
    'ladder.simulation.why',
    'ladder.trace.add',
] as const;

/** Shows all that is known of what is under the pointer. */
export const MORE = 'ladder.hover.more';

function link(title: string, command: (typeof LINKED)[number], { name }: Tag): string {
    return `[${title}](command:${command}?${encodeURIComponent(JSON.stringify([{ name }]))})`;
}

/** A line for each tag, in Markdown. */
export function hoverLinks(tags: readonly Tag[]): string {
    const lines = tags.map((tag) => {
        const links = [];
        if (tag.readOnly !== true) {
            if (typeof tag.value === 'boolean') {
                links.push(link('Toggle', 'ladder.simulation.toggle', tag));
            } else {
                links.push(link('Set', 'ladder.simulation.set', tag));
            }
            links.push(tag.forced ? link('Release', 'ladder.simulation.unforce', tag) : link('Force', 'ladder.simulation.force', tag));
        }
        links.push(link('Why?', 'ladder.simulation.why', tag), link('Trace', 'ladder.trace.add', tag));
        return `\`${tag.name}\` = ${escaped(tag.text)}: ${links.join(' · ')}`;
    });
    return lines.join('\n\n');
}

/** The line below them: why the value is what it is, and the way to the rest, for which its command is given what is in `more`. */
export function reasonLine(reason: string | undefined, more: readonly object[] | undefined): string {
    const rest = more && `[More](command:${MORE}?${encodeURIComponent(JSON.stringify(more))})`;
    return [reason === undefined ? '' : escaped(reason), rest ?? ''].filter(Boolean).join(' · ');
}
