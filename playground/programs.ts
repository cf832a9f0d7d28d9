// The programs that come with the page: those with a machine of their own, those of `examples/`, and those of the chapters that begin with nothing.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

import type { Example } from './src/examples.ts';

/** Chapters whose programs follow one another, with the title of their group. */
const CHAPTERS: readonly (readonly [chapter: string, group: string])[] = [
    ['guide/first-program', 'A first program'],
    ['guide/drawing-rungs', 'Drawing rungs'],
    ['guide/for-electricians', 'For electricians'],
    ['guide/data', "Data of one's own"],
];

const title = (stem: string) => stem.charAt(0).toUpperCase() + stem.slice(1).replaceAll('_', ' ');

function ofFolder(folder: string): Example[] {
    const names = readdirSync(folder).filter((name) => name.endsWith('.clad')).sort();
    // The one that the book and the README begin with comes first.
    names.sort((a, b) => Number(b === 'motor.clad') - Number(a === 'motor.clad'));
    return names.map((name) => {
        const stem = name.replace(/\.clad$/, '');
        const tests = join(folder, `${stem}.ladder-test`);
        return {
            group: 'Examples',
            title: title(stem),
            name,
            text: readFileSync(join(folder, name), 'utf8'),
            ...(existsSync(tests) ? { scenarios: readFileSync(tests, 'utf8') } : {}),
        };
    });
}

/** Each in a folder of its own: the program has the folder's name, and all next to it is of its machine. */
function ofMachines(folder: string): Example[] {
    return readdirSync(folder).sort().map((stem) => {
        const read = (name: string) => readFileSync(join(folder, stem, name), 'utf8');
        const own = [`${stem}.clad`, `${stem}.ladder-test`];
        const beside = readdirSync(join(folder, stem)).filter((name) => !own.includes(name)).sort();
        return {
            group: 'Machines',
            title: title(stem),
            name: `${stem}.clad`,
            text: read(`${stem}.clad`),
            scenarios: read(`${stem}.ladder-test`),
            files: Object.fromEntries(beside.map((name) => [name, read(name)])),
        };
    });
}

/** As mdBook makes them. */
const anchor = (heading: string) => heading.toLowerCase().replaceAll(/[^\w\s-]/g, '').trim().replaceAll(/\s+/g, '-');

function ofChapter(root: string, [chapter, group]: readonly [string, string]): Example[] {
    const lines = readFileSync(join(root, 'docs/src', `${chapter}.md`), 'utf8').split('\n');
    const found: (Omit<Example, 'title'> & { readonly heading: string })[] = [];
    let heading = '';
    for (let at = 0; at < lines.length; at += 1) {
        const line = lines[at] ?? '';
        heading = /^#+ (.*)$/.exec(line)?.[1] ?? heading;
        if (!line.startsWith('```')) {
            continue;
        }
        const end = lines.indexOf('```', at + 1);
        const words = line.slice('```'.length).split(/[\s,]+/);
        if (words[0] === 'clad') {
            const name = words.find((word) => word.startsWith('file='))?.slice('file='.length) ?? 'program.clad';
            found.push({ group, heading, name, text: `${lines.slice(at + 1, end).join('\n')}\n`, chapter: `${chapter}.html#${anchor(heading)}` });
        }
        at = end;
    }
    return found.map((step, at) => {
        const { heading, ...rest } = step;
        const same = found.filter((other) => other.heading === heading);
        const number = same.length > 1 ? ` (${same.indexOf(step) + 1})` : '';
        return { ...rest, title: `${at + 1}. ${heading.replaceAll('`', '')}${number}` };
    });
}

export function programs(root: string): Example[] {
    return [...ofMachines(join(root, 'playground/machines')), ...ofFolder(join(root, 'examples')), ...CHAPTERS.flatMap((chapter) => ofChapter(root, chapter))];
}
