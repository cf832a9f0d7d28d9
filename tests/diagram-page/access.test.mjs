// Nobody is left out: what axe finds, how large targets are, forced colours, and what is said.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { test } from 'node:test';

import { diagrams, railed, until } from './drawn.mjs';

const open = diagrams();
const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const PROGRAM = `VAR_INPUT
    a, c : BOOL;
END_VAR

# The first. #
${railed('+--\\--[ ]( a )--# why #--\\--[ ]( b )--', '( )( y )')}${railed('|  /--[ ]( c )----------/')}
`;

/** What axe finds in a page, as text. */
async function found(page) {
    await page.evaluate(axe);
    const { violations } = await page.evaluate(() => window.axe.run(document, { runOnly: ['wcag2a', 'wcag2aa', 'wcag21aa', 'wcag22aa', 'best-practice'], rules: { region: { enabled: false }, 'page-has-heading-one': { enabled: false }, 'landmark-one-main': { enabled: false } } }));
    return violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html.slice(0, 160)).join(' | ')}`);
}

for (const theme of ['light', 'dark']) {
    test(`axe finds nothing, in ${theme} colours`, async () => {
        const { page, element, press } = await open(PROGRAM, { theme });
        await page.locator('.wave').first().waitFor({ state: 'attached' });
        assert.deepEqual(await found(page), [], 'the page');
        await element('contact', 'b').focus();
        await press('Space');
        await page.locator('.menu').waitFor();
        assert.deepEqual(await found(page), [], 'the menu');
        await press('Escape', 'c');
        await page.locator('.field li').first().waitFor();
        assert.deepEqual(await found(page), [], 'the field');
        await press('Escape', 'f');
        await page.keyboard.type('timer');
        await page.locator('.palette .row').first().waitFor();
        assert.deepEqual(await found(page), [], 'the palette');
        await press('Escape');
        await element('contact', 'b').focus();
        await press('?');
        assert.deepEqual(await found(page), [], 'the list of keys');
    });
}

test('targets are large enough for a finger', async () => {
    const { page } = await open(PROGRAM);
    await page.locator('.declarations tbody tr').nth(2).waitFor();
    const small = await page.evaluate(() => {
        const nodes = [...document.querySelectorAll('g.element .hit, .piece.network > .gutter, button, summary, .declarations input, .declarations select, .palette input')];
        const boxes = nodes.filter((node) => node.checkVisibility()).map((node) => [node, node.getBoundingClientRect()]);
        const isSmall = ([, { width, height }]) => Math.min(width, height) < 23.9;
        return boxes.filter(isSmall).map(([node, { width, height }]) => `${node.parentElement.getAttribute('class')} ${width}x${height}`);
    });
    assert.deepEqual(small, []);
});

test('with forced colours what has the focus is seen, and what is selected', async () => {
    const { page, wire } = await open(PROGRAM, { context: { forcedColors: 'active' } });
    const ring = wire('between b and y');
    await ring.focus();
    const looks = await ring.locator('.ring').evaluate((node) => getComputedStyle(node).stroke);
    const ground = await page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    assert.notEqual(looks, 'none');
    assert.notEqual(looks, ground);
});

test('a change is said, and why something cannot be done', async () => {
    const { page, element, press, write } = await open(PROGRAM);
    await element('contact', 'b').focus();
    await press('b');
    await write('d');
    await until('the words', async () => (await page.locator('.spoken').innerText()) === 'Open contact d added in parallel to b; d declared as BOOL in VAR_INPUT');
    await page.locator('g.element.join').first().focus();
    await press('Alt+ArrowLeft');
    await until('why not', async () => (await page.locator('[role="alert"]:not([hidden])').count()) === 1);
});

test('the tabulator goes through all parts of the page, and comes back to the drawing', async () => {
    const { page, element } = await open(PROGRAM);
    await element('contact', 'a').focus();
    const seen = [];
    for (let count = 0; count < 60; count += 1) {
        await page.keyboard.press('Tab');
        const where = await page.evaluate(() => document.activeElement?.closest('.declarations, .toolbar, .palette, .view, .findings')?.className ?? 'outside');
        if (seen.at(-1) !== where) {
            seen.push(where);
        }
        if (where === 'view') {
            break;
        }
    }
    for (const part of ['toolbar', 'palette', 'declarations']) {
        assert.ok(seen.includes(part), `${part} in ${seen.join(', ')}`);
    }
    assert.equal(seen.at(-1), 'view', 'it comes round to the drawing');
});
