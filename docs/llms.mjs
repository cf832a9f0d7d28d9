// The book for programs that read: `llms.txt`, which names each page with its first sentence, `llms-full.txt`, which has all of them, and the pages
// themselves as Markdown next to those of the site.
//
//   node docs/llms.mjs SITE
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const out = process.argv[2];
const address = execFileSync('bash', [join(here, '../packages/project'), 'site'], { encoding: 'utf8' }).trim();

/** The text of a page, with what it includes. */
function text(path) {
    const including = (_, file) => text(join(dirname(path), file));
    return readFileSync(path, 'utf8').replaceAll(/\{\{#include ([^}:]+)\}\}/g, including).trim();
}

/** The first sentence of a page: of its first paragraph that is neither heading, table, program, list nor picture. */
function firstSentence(page) {
    const paragraph = page.replaceAll(/```[^]*?```/g, '').split(/\n\s*\n/).find((part) => /^[A-Za-z*`[]/.test(part) && !part.includes('<img')) ?? '';
    const plain = paragraph.replaceAll(/\s+/g, ' ').replaceAll(/\[([^\]]*)\]\([^)]*\)/g, '$1').replaceAll('**', '');
    // The point after an initial ends no sentence.
    const sentence = /^.*?[a-z0-9`)*"][.:](?= |$)/.exec(plain)?.[0] ?? plain;
    return sentence.replace(/[.,;:]?$/, '.');
}

/** The chapters: their titles, and each page with its title, its path and its text. */
function chapters() {
    const found = [{ title: 'Introduction', pages: [] }];
    for (const line of readFileSync(join(here, 'src/SUMMARY.md'), 'utf8').split('\n').slice(1)) {
        const [, heading] = /^# (.+)$/.exec(line) ?? [];
        const [, title, path] = /\[([^\]]+)\]\(([^)]+)\)/.exec(line) ?? [];
        if (heading) {
            found.push({ title: heading, pages: [] });
        } else if (path) {
            found.at(-1).pages.push({ title, path, text: text(join(here, 'src', path)) });
        }
    }
    return found;
}

const book = chapters();
const pages = book.flatMap((chapter) => chapter.pages);
const heading = '# Ladder\n\n> Ladder logic for controllers as plain text (`.clad`), with a checker, a formatter, a simulator, unit tests, proofs and a language server: the programs `ladder` and `ldfmt`.\n';
const list = book.map(({ title, pages: own }) => `## ${title}\n\n${own.map((page) => `- [${page.title}](${address}/${page.path}): ${firstSentence(page.text)}`).join('\n')}\n`);
mkdirSync(out, { recursive: true });
writeFileSync(join(out, 'llms.txt'), `${heading}\nAll pages in one file: [llms-full.txt](${address}/llms-full.txt)\n\n${list.join('\n')}`);
writeFileSync(join(out, 'llms-full.txt'), `${heading}\n${pages.map((page) => `<!-- ${page.path} -->\n\n${page.text}\n`).join('\n')}`);
for (const { path, text: page } of pages) {
    mkdirSync(dirname(join(out, path)), { recursive: true });
    writeFileSync(join(out, path), `${page}\n`);
}
