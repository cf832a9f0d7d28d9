// The field: nothing that was written is lost, and nothing half written is in the text.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { diagrams, railed, until } from './drawn.mjs';

const open = diagrams();
const LINE = railed('+--[ ]( a )--', '( )( y )');

test('what cannot be read stays in the field, with the reason', async () => {
    const { page, element, press, becomes } = await open(LINE);
    await element('contact', 'a').focus();
    await press('n');
    const field = page.locator('.field input');
    await field.fill('XIC b FOO c');
    await field.press('Enter');
    await until('the reason', async () => (await page.locator('.note-of-field').innerText()) === '`FOO` is not read');
    assert.equal(await field.inputValue(), 'XIC b FOO c');
    await field.press('End');
    for (let letters = 0; letters < 'FOO c'.length; letters += 1) {
        await field.press('Backspace');
    }
    await page.keyboard.type('OTE c');
    await press('Enter');
    await becomes(`${LINE}\n${railed('+--[ ]( b )--', '( )( c )')}`);
});

test('a press elsewhere takes what was written, and has the focus', async () => {
    const { page, element, press, becomes } = await open(LINE);
    await element('contact', 'a').focus();
    await press('c');
    await page.locator('.field input').fill('b');
    await page.locator('.palette input').click();
    await becomes(railed('+--[ ]( a )--[ ]( b )--', '( )( y )'));
    assert.equal(await page.evaluate(() => document.activeElement.getAttribute('aria-label')), 'Search what can be drawn');
    assert.equal(await page.locator('.field').count(), 0);
});

test('what is pressed next goes after what was written last', async () => {
    const { page, element, press, write, becomes } = await open(LINE);
    await element('contact', 'a').focus();
    await press('c');
    await page.locator('.field input').fill('b');
    await page.locator('.favourites').getByText('[/]', { exact: true }).click();
    await becomes(railed('+--[ ]( a )--[ ]( b )--', '( )( y )'));
    await write('c');
    await becomes(railed('+--[ ]( a )--[ ]( b )--[/]( c )--', '( )( y )'));
});

test('a press elsewhere ends a field that nothing was written in', async () => {
    const { page, host, element, press } = await open(LINE);
    await element('contact', 'a').focus();
    await press('Enter');
    await page.locator('.field input').waitFor();
    await element('coil', 'y').locator('.hit').click();
    await page.locator('.field').waitFor({ state: 'detached' });
    assert.equal(host.text, LINE);
});

test('the buttons of a field stay where they are, whatever is below it', async () => {
    const { page, element, press } = await open(`VAR_INPUT\n    a : BOOL;  # a comment that is much wider than the field for its name, and goes on and on #\nEND_VAR\n\n${LINE}`);
    await element('contact', 'a').focus();
    await press('c');
    const take = page.locator('.field .take');
    const before = await take.boundingBox();
    await page.locator('.field li').first().waitFor();
    assert.deepEqual(await take.boundingBox(), before);
    await page.keyboard.type('a_new_one');
    await page.locator('.note-of-field', { hasText: 'is new' }).waitFor();
    assert.deepEqual(await take.boundingBox(), before);
});

for (const [how, keys] of [['the tabulator', ['warm', 'Tab', '5s']], ['a comma', ['warm, 5s']]]) {
    test(`operands are written one after the other, by ${how}`, async () => {
        const { page, element, press, becomes } = await open(LINE);
        await element('contact', 'a').focus();
        await press('f');
        await page.keyboard.type('TON');
        await page.locator('.palette .row[aria-selected="true"]', { hasText: '[TON]' }).waitFor();
        await press('Enter');
        await page.locator('.field input').waitFor();
        for (const words of keys) {
            await (words === 'Tab' ? press(words) : page.keyboard.type(words));
        }
        await press('Enter');
        await becomes(railed('+--[ ]( a )--', '[TON]( warm, 5s )--( )( y )'));
    });
}

test('the tabulator goes on to the next element', async () => {
    const { page, element, press, becomes } = await open(LINE);
    await element('contact', 'a').focus();
    await press('Enter');
    await page.locator('.field input[aria-label="Open contact"]').fill('start');
    await press('Tab');
    await page.locator('.field input[aria-label="Coil"]').fill('run');
    await press('Enter');
    await becomes(railed('+--[ ]( start )--', '( )( run )'));
});

test('the arrows, Home and End stay on a line; PageDown goes to the next network', async () => {
    const two = `${railed('+--\\--[ ]( a )--\\--[ ]( b )--', '( )( y )')}${railed('|  /--[ ]( c )--/')}\n${railed('+--[ ]( d )--', '( )( z )')}`;
    const { element, press, focusOn } = await open(two);
    await element('contact', 'c').focus();
    for (const [key, there] of [['ArrowUp', 'Open contact a'], ['End', 'Coil y'], ['Home', 'Open contact a'], ['ArrowDown', 'Open contact c'], ['PageDown', 'Open contact d'], ['PageUp', 'Open contact a'], ['Control+End', 'Open contact d'], ['Control+Home', 'Open contact a']]) {
        await press(key);
        await focusOn(there);
    }
});

test('all kinds of a coil are in its menu', async () => {
    const { page, element, menu, becomes } = await open(LINE);
    await element('coil', 'y').locator('.hit').click({ button: 'right' });
    await page.locator('.menu').waitFor();
    assert.deepEqual((await page.getByRole('menuitem', { name: 'Make it' }).allInnerTexts()).map((text) => text.trim().slice(-3)), ['(/)', '(S)', '(R)', '(P)', '(N)']);
    await menu('Make it: Set coil');
    await becomes(railed('+--[ ]( a )--', '(S)( y )'));
});

test('a new network is written in its field, and nothing of what is made up stays', async () => {
    const { page, host, press, becomes } = await open(`VAR_INPUT\n    a : BOOL;\nEND_VAR\nVAR_OUTPUT\n    y : BOOL;\nEND_VAR\n\n${LINE}`);
    await page.locator('.add').click();
    // What is made up is marked, and gives way to what is typed.
    const marked = (name) =>
        until(`${name} to be marked`, () => page.locator('.field input').evaluate((input, name) => input.value.slice(input.selectionStart, input.selectionEnd) === name, name));
    await page.locator('.field li', { hasText: 'A contact and a coil' }).click();
    await marked('contact_1');
    await page.keyboard.type('a');
    await press('Tab');
    await marked('coil_1');
    await page.keyboard.type('y');
    await press('Enter');
    await becomes(`VAR_INPUT\n    a : BOOL;\nEND_VAR\nVAR_OUTPUT\n    y : BOOL;\nEND_VAR\n\n${LINE}\n${LINE}`);
    assert.equal(host.edits, 1);
});
