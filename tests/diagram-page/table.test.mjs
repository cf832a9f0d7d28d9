// The declarations as a table: an electrician needs no text for them. What is reported is a wave, with its fixes.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { diagrams, until } from './drawn.mjs';

const open = diagrams();
const PLANT = `VAR_INPUT
    start, stop : BOOL;  # buttons #
END_VAR

+--[ ]( start )--[/]( stop )---------------------------------------( )( run )--+
`;

const cell = (page, label) => page.locator(`.declarations input[aria-label="${label}"]`);

test('a cell is changed, and is one edit', async () => {
    const { page, becomes, host } = await open(PLANT);
    await cell(page, 'Address of stop').fill('%IX0.1');
    await cell(page, 'Address of stop').press('Enter');
    await becomes(PLANT.replace('    start, stop : BOOL;  # buttons #\n', '    start            : BOOL;  # buttons #\n    stop  AT %IX0.1 : BOOL;  # buttons #\n'.replace('start            :', 'start           :')));
    assert.equal(host.edits, 1);
    await page.locator('.declarations select[aria-label="Section of stop"]').selectOption('VAR');
    await until('the section', () => /^VAR\n {4}stop AT %IX0.1 : BOOL;/m.test(host.text));
    await cell(page, 'Name of stop').fill('halt');
    await cell(page, 'Name of stop').press('Tab');
    await until('the name everywhere', () => host.text.includes('[/]( halt )') && !host.text.includes('stop'));
});

test('a row is added by typing into the last', async () => {
    const { page, host } = await open('');
    const type = async (label, text) => page.locator(`.declarations .empty-row input[aria-label="${label} of a new tag"]`).fill(text);
    await type('Name', 'level');
    await type('Type', 'INT');
    await type('Comment', 'of the tank');
    await page.keyboard.press('Enter');
    await until('the row', () => host.text === 'VAR_INPUT\n    level : INT;  # of the tank #\nEND_VAR\n\n');
    await page.keyboard.type('pump');
    await page.locator('.toolbar').click();
    await until('the next', () => host.text.includes('    pump  : BOOL;'));
    assert.equal(host.edits, 2);
});

test('a row goes, unless something uses its tag', async () => {
    const { page, host, refusal } = await open(`VAR\n    idle : BOOL;\nEND_VAR\n\n${PLANT}`);
    await page.getByRole('button', { name: 'Delete start' }).click();
    await until('why not', refusal);
    assert.match(await refusal(), /`start` is used in one place/);
    await page.getByRole('button', { name: 'Delete idle' }).click();
    await until('the row gone', () => !host.text.includes('idle'));
    assert.equal(host.text, PLANT);
});

test('what cannot be read is refused, and the cell shows the text again', async () => {
    const { page, host, refusal } = await open(PLANT);
    await cell(page, 'Type of stop').fill('BOOL; x');
    await cell(page, 'Type of stop').press('Tab');
    await until('why not', refusal);
    await until('the old type', async () => (await cell(page, 'Type of stop').inputValue()) === 'BOOL');
    assert.equal(host.text, PLANT);
});

test('what is reported is a wave; its fix is one step', async () => {
    const { page, host, press, menu, focused, focusOn } = await open(PLANT);
    await page.locator('.wave').waitFor({ state: 'attached' });
    await page.locator('.view').press('F8');
    await focusOn('Coil run');
    assert.match(await page.locator('.findings').innerText(), /Warning `run` is not declared/);
    await press('Control+.');
    await menu('Declare `run : BOOL` in VAR_OUTPUT');
    await until('the declaration', () => host.text.includes('VAR_OUTPUT\n    run : BOOL;'));
    await until('no wave', async () => (await page.locator('.wave').count()) === 0);
    assert.equal(host.edits, 1);
    assert.match(await focused(), /^Coil run/);
});

test('findings are visited in the table and in the drawing', async () => {
    const { page, press, focusOn } = await open(`VAR\n    never : BOOOL;\nEND_VAR\n${PLANT}`);
    await page.locator('.declarations .reported').waitFor();
    await page.locator('.view').focus();
    await press('F8');
    await focusOn('Name of never');
    await press('F8');
    await focusOn('Coil run');
    await press('Shift+F8');
    await focusOn('Name of never');
});
