// The programs of eight pages of the book and two examples, typed key by key by a user who looks at the book only: every character, and
// Enter at the end of a line. What is saved is the program that is in the book.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync, statSync, writeFileSync } from 'node:fs';
import { basename, join } from 'node:path';

import { open } from './palette.mjs';

const { LADDER_BIN, LADDER_ROOT } = process.env;

const PAGES = [
    'first-program.md',
    'for-electricians.md',
    'for-programmers.md',
    'drawing-rungs.md',
    'testing.md',
    '../language/blocks.md',
    '../language/drawing.md',
    '../language/layout.md',
    '../../../examples/garage_door.clad',
    '../../../examples/traffic_light.clad',
];

/** Milliseconds after a key: a user who types faster than the answers come, whom the editor's own aids can still follow. */
const KEY = 25;

/** The programs of a page that are right, each with the number of its first line; or the program of a file. */
function programs(name) {
    const lines = readFileSync(join(LADDER_ROOT, 'docs/src/guide', name), 'utf8').trimEnd().split('\n');
    if (name.endsWith('.clad')) {
        return [{ line: 1, lines }];
    }
    const fences = lines.flatMap((line, index) => (line.startsWith('```clad') && !line.includes('wrong') ? [index + 1] : []));
    return fences.map((from) => ({ line: from, lines: lines.slice(from, lines.indexOf('```', from)) }));
}

/** What the formatter makes of a text. */
function aligned(text) {
    return execFileSync(LADDER_BIN, ['fmt', '-'], { input: text, encoding: 'utf8' }).trim();
}

/** The files that are typed into; they must be there when the project is opened. */
export function emptyFiles(folder) {
    for (const page of PAGES) {
        for (const { line } of programs(page)) {
            writeFileSync(join(folder, fileOf(page, line)), '');
        }
    }
}

const fileOf = (page, line) => `book-${basename(page).replace(/\.\w+$/, '')}-${line}.clad`;

/** @param project the folder that is open */
export async function book(page, { step, until, project }) {
    const errors = page.locator('.editor-group-container.active .monaco-editor .squiggly-error');
    for (const name of PAGES) {
        await step(`the programs of ${name}, typed by a user who looks at the book only`, async () => {
            for (const { line, lines } of programs(name)) {
                const file = fileOf(name, line);
                const where = `${name}:${line}`;
                await open(page, file);
                await page.locator('.editor-group-container.active .monaco-editor .view-lines').click();
                await page.keyboard.type(lines.join('\n'), { delay: KEY });
                await until(`no error in ${where}`, async () => (await errors.count()) === 0);
                await page.keyboard.press('Control+S');
                await until(`${file} to be saved`, () => statSync(join(project, file)).size > 0);
                await page.waitForTimeout(100);
                assert.equal(aligned(readFileSync(join(project, file), 'utf8')), aligned(`${lines.join('\n')}\n`), where);
                await page.keyboard.press('Control+W');
            }
        });
    }
}
