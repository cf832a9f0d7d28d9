// Every link in a built site leads to a file that is there, and to an element that is in it; none leaves the folder.
//
//   node check-links.mjs FOLDER
import { existsSync, readdirSync, readFileSync, statSync } from 'node:fs';
import { dirname, join, relative, resolve } from 'node:path';

const root = resolve(process.argv[2] ?? '.');
const decoded = (text) => text.replaceAll('&amp;', '&').replaceAll('&quot;', '"').replaceAll('&#39;', "'").replaceAll('&#x27;', "'").replaceAll('&lt;', '<').replaceAll('&gt;', '>');
/** What is written by a page's script, or shown as text, is no link of the page. */
const markup = (html) => html.replaceAll(/<!--[^]*?-->|<script\b[^>]*>[^]*?<\/script>/g, (part) => /^<script[^>]*>/.exec(part)?.[0] ?? '');
const known = new Map();

/** The links of a page, and what can be linked to in it. */
function read(path) {
    const there = known.get(path);
    if (there) {
        return there;
    }
    const html = markup(readFileSync(path, 'utf8'));
    const values = (names) => [...html.matchAll(new RegExp(`\\s(?:${names})="([^"]*)"`, 'g'))].map(([, value]) => decoded(value));
    const page = { links: values('href|src'), anchors: new Set(values('id|name')) };
    known.set(path, page);
    return page;
}

function problem(link, from) {
    if (/^[a-z][-+.a-z0-9]*:/i.test(link)) {
        return undefined;
    }
    if (link.startsWith('/')) {
        return 'begins at the root of a host, and the site may be in a folder';
    }
    const [path, anchor = ''] = link.split('#');
    const name = decodeURIComponent(path.split('?')[0]);
    let target = name === '' ? from : resolve(dirname(from), name);
    if (relative(root, target).startsWith('..')) {
        return 'leads out of the site';
    }
    if (existsSync(target) && statSync(target).isDirectory()) {
        target = join(target, 'index.html');
    }
    if (!existsSync(target)) {
        return 'leads to no file';
    }
    const isFound = anchor === '' || !target.endsWith('.html') || read(target).anchors.has(decodeURIComponent(anchor));
    return isFound ? undefined : `leads to no element "${anchor}"`;
}

const pages = readdirSync(root, { recursive: true }).filter((name) => name.endsWith('.html'));
let count = 0;
const problems = [];
for (const name of pages) {
    // The page for what is not there is served in any folder: mdBook has its addresses begin at the root.
    if (name === '404.html') {
        continue;
    }
    for (const link of new Set(read(join(root, name)).links)) {
        count += 1;
        const found = problem(link, join(root, name));
        if (found) {
            problems.push(`${name}: "${link}" ${found}`);
        }
    }
}
// The chapters of the playground's menu are links that its script makes.
const examples = join(root, 'playground/examples.json');
for (const { title, chapter } of existsSync(examples) ? JSON.parse(readFileSync(examples, 'utf8')) : []) {
    const found = chapter === undefined ? undefined : problem(chapter, join(root, 'index.html'));
    if (found) {
        problems.push(`the step "${title}": "${chapter}" ${found}`);
    }
}
if (problems.length > 0) {
    console.error(problems.join('\n'));
    process.exit(1);
}
console.log(`${count} links on ${pages.length} pages lead somewhere.`);
