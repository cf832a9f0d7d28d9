// A program in a real git repository: marks next to what changed since HEAD, and both forms side by side.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { command, cursorTo, open } from './palette.mjs';

const NAME = 'compared.clad';
const HEAD = [
    '+--[ ]( a )--[ ]( b )--( )( x )--+',
    '',
    '+--[ ]( a )--( )( y )--+',
    '',
    '+--[ ]( c )--( )( z )--+',
];
const NOW = [
    '+--[ ]( b )--[ ]( a )--( )( x )--+',
    '',
    '+--[/]( a )--( )( y )--+',
    '',
    '+--[ ]( c )--( )( z )--+',
    '',
    '+--[ ]( d )--( )( v )--+',
];

/** A repository of its own in the project, with a change that is not committed. */
export function comparedProgram(project) {
    const folder = join(project, 'repository');
    mkdirSync(folder);
    writeFileSync(join(folder, NAME), `${HEAD.join('\n')}\n`);
    const git = (...words) => execFileSync('git', ['-c', 'user.name=t', '-c', 'user.email=t@example.com', ...words], { cwd: folder });
    git('init', '-q');
    git('add', '-A');
    git('commit', '-qm', 'x');
    writeFileSync(join(folder, NAME), `${NOW.join('\n')}\n`);
}

/** The marks in the gutter, from top to bottom: for each line that has one the path of its sign. */
const marks = (page) =>
    page.evaluate(() => {
        const found = [...document.querySelectorAll('.editor-group-container.active .monaco-editor .glyph-margin-widgets > *')];
        const signs = found.map((element) => ({ top: element.getBoundingClientRect().top, image: getComputedStyle(element).backgroundImage }));
        const shown = signs.filter(({ image }) => image.includes('svg')).sort((one, other) => one.top - other.top);
        return shown.map(({ image }) => /d="([^"]*)"/.exec(atob(/base64,([^"]*)/.exec(image)[1]))[1]);
    });

const [SAME, OTHER, NEW] = ['M5 6h6M5 10h6', 'M4.5 6h7M4.5 10h7M10.5 3l-5 10', 'M8 4v8M4 8h8'];

/** The page of the comparison: a frame in a frame. */
async function comparison(page, until) {
    let found;
    await until('the comparison', async () => {
        for (const frame of page.frames()) {
            if ((await frame.locator('.change').count().catch(() => 0)) > 0) {
                found = frame;
                return true;
            }
        }
        return false;
    });
    return found;
}

export async function comparing(page, { step, until, screenshot }) {
    const marked = async (wanted) => {
        let found;
        // Half typed, a program with errors has marks that say nothing yet.
        await until(`marks, ${wanted.length} of them`, async () => {
            found = await marks(page);
            return found.join() === wanted.join();
        }).catch((error) => {
            throw new Error(`${error.message}; there are ${found.join(', ')}`);
        });
    };
    let frame;
    const headings = () => frame.locator('.change h3').allTextContents();
    await step('each rung that is not as HEAD has it is marked', async () => {
        await open(page, NAME);
        await marked([SAME, OTHER, NEW]);
        await screenshot(page, 'marks');
    });
    await step('the pointer on a mark\'s rung is told the reason', async () => {
        const rail = page.locator('.monaco-editor .view-line', { hasText: 'y' }).first();
        const said = page.locator('.monaco-hover', { hasText: 'with a off, y goes off in the old and on in the new program' }).first();
        // A lens that comes late moves the lines away from the pointer.
        await until('the reason', async () => {
            await page.mouse.move(0, 0);
            await rail.hover({ position: { x: 8, y: 8 } });
            return said.waitFor({ timeout: 3000 }).then(() => true, () => false);
        });
        await page.mouse.move(0, 0);
    });
    await step('both forms are side by side, with what differs marked', async () => {
        await command(page, 'Ladder: Compare with HEAD');
        frame = await comparison(page, until);
        assert.deepEqual(await headings(), [
            'edited, does the same: network, line 1, writes x',
            'edited, does another thing: network, line 3, writes y',
            'new: network, line 7, writes v',
        ]);
        assert.equal(await frame.locator('.change svg').count(), 5);
        const boxes = await Promise.all(['old', 'new'].map((side) => frame.locator(`.change figure.${side}`).first().boundingBox()));
        assert.ok(boxes[0].y === boxes[1].y && boxes[0].x + boxes[0].width <= boxes[1].x, JSON.stringify(boxes));
        // The drawing has the style sheet that came with it, in the colours of a dark editor.
        const stroke = await frame.locator('svg .line').first().evaluate((line) => getComputedStyle(line).stroke);
        assert.match(stroke, /^rgb\((1[5-9]\d|2\d\d), /);
        await screenshot(page, 'comparison');
    });
    await step('a key goes to the next change, and Enter to its rung', async () => {
        await frame.locator('body').click({ position: { x: 2, y: 2 } });
        await frame.locator('body').press('n');
        await frame.locator('body').press('n');
        await frame.locator('.change:focus h3', { hasText: 'line 3' }).waitFor();
        await frame.locator('.change:focus').press('Enter');
        await page.getByText('Ln 3, Col 1').waitFor();
    });
    await step('both follow what is typed', async () => {
        await cursorTo(page, 5, 13);
        await page.keyboard.type('[/]( e )--');
        await marked([SAME, OTHER, OTHER, NEW]);
        await until('the change in the comparison', async () => (await headings()).some((heading) => heading.includes('line 5, writes z')));
        await frame.locator('.change', { hasText: 'line 5' }).click();
        await page.getByText('Ln 5, Col 1').waitFor();
    });
    await step('the page runs no script but its own', async () => {
        const ran = await frame.evaluate(() => {
            const script = document.createElement('script');
            script.textContent = 'window.strange = true';
            document.body.append(script);
            return window.strange === true;
        });
        assert.equal(ran, false);
    });
}
