// The steps of the book's page "Draw a program", by mouse alone but for the names; LADDER_SCREENSHOTS takes its pictures again.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';

import { diagrams, railed, until } from './drawn.mjs';

const open = diagrams();
const { LADDER_ROOT, LADDER_SCREENSHOTS } = process.env;
const SIZE = { width: 760, height: 400 };

for (const theme of ['light', 'dark']) {
    test(`a motor starter as the book draws it, in ${theme} colours`, async () => {
        const { page, host, write, becomes, settled, element } = await open('VAR_INPUT\n    start, stop : BOOL;\nEND_VAR\nVAR_OUTPUT\n    run : BOOL;\nEND_VAR\n', { theme, ...SIZE });
        const picture = async (name) => {
            await settled();
            await (LADDER_SCREENSHOTS && page.screenshot({ path: join(LADDER_SCREENSHOTS, `draw-${name}-${theme}.png`) }));
        };
        const favourite = (block) => page.locator('.favourites button', { hasText: block });
        const hold = async (from, to, dy = 0) => {
            await settled();
            const [a, b] = [await from.boundingBox(), await to.boundingBox()];
            await page.mouse.move(a.x + a.width / 2, a.y + a.height / 2);
            await page.mouse.down();
            await page.mouse.move(b.x + b.width / 2, b.y + b.height / 2 + dy, { steps: 5 });
        };
        await page.getByRole('button', { name: 'New network' }).click();
        await page.locator('.field li').first().waitFor();
        await picture('network');
        await page.locator('.field li', { hasText: 'A contact and a coil' }).click();
        // Its names are written one after the other.
        await page.keyboard.type('st');
        await until('the tags that fit', async () => (await page.locator('.field li').count()) === 2);
        await picture('name');
        await page.locator('.field li', { hasText: 'start' }).click();
        await page.keyboard.type('run');
        await page.locator('.field .take').click();
        await until('the network', () => host.text.includes('( start )') && host.text.includes('( )( run )'));
        await hold(favourite('[/]'), page.locator('g.element.point[aria-label*="start and run"] .ring'));
        await picture('wire');
        await page.mouse.up();
        await write('stop');
        await until('the contact', () => host.text.includes('[/]( stop )'));
        await hold(favourite('[ ]'), element('contact', 'start').locator('.hit'), 22);
        await page.locator('.lane').waitFor();
        await picture('branch');
        await page.mouse.up();
        await write('run');
        const drawn = railed('+--\\--[ ]( start )--\\--[/]( stop )--', '( )( run )') + railed('|  /--[ ]( run )----/');
        await until('the seal-in', () => host.text.endsWith(drawn));
        assert.ok(!/contact_1|coil_1/.test(host.text), host.text);
        await settled();
        const stop = element('contact', 'stop').locator('.hit');
        await stop.click();
        await picture('done');
        await stop.click();
        await page.locator('.menu').waitFor();
        await picture('menu');
    });
}

test('the walkthrough of VS Code shows what the book does', () => {
    for (const theme of ['light', 'dark']) {
        const [shown, drawn] = [`editors/vscode/walkthrough/draw-${theme}.png`, `docs/src/guide/pictures/draw-branch-${theme}.png`].map((file) => readFileSync(join(LADDER_ROOT, file)));
        assert.ok(shown.equals(drawn), theme);
    }
});

test('the book has a picture of each step', () => {
    const page = readFileSync(join(LADDER_ROOT, 'docs/src/guide/draw.md'), 'utf8');
    for (const name of ['network', 'name', 'wire', 'branch', 'done', 'menu'].flatMap((name) => [`draw-${name}-light.png`, `draw-${name}-dark.png`])) {
        assert.ok(page.includes(`pictures/${name}`), name);
        assert.ok(readFileSync(join(LADDER_ROOT, 'docs/src/guide/pictures', name)).length > 1000, name);
    }
});
