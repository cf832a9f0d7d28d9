// Drawing in the diagram: by keys alone from an empty file, then by the mouse. Each change is one edit of the text, and one undo.
import assert from 'node:assert/strict';

import { handsIn, PROGRAMS } from '../../diagram-page/gestures.mjs';
import { command, open } from './palette.mjs';

/** Whole programs that are drawn from nothing, each in a file of its own. */
const WHOLE = Object.entries(PROGRAMS).flatMap(([name, { text, mouse, keys }], index) => [
    { name: `${name} is drawn from nothing by the mouse alone`, file: `by_mouse_${index}.clad`, text, draw: (hands) => hands.byMouse(mouse) },
    { name: `${name} is drawn from nothing by keys alone`, file: `by_keys_${index}.clad`, text, draw: (hands) => hands.byKeys(keys) },
]);

/** The programs that are drawn: their names in the project, and their texts. */
export const PENNED = {
    ...Object.fromEntries(WHOLE.map(({ file }) => [file, ''])),
    'penned.clad': '',
    'dragged.clad': 'VAR_INPUT\n    go, hold : BOOL;\nEND_VAR\n\n+--[ ]( go )--[/]( hold )------------------------------------------( )( out )--+\n',
};

const STARTER = [
    '+--\\--[ ]( start )--\\--[/]( stop )---------------------------------( )( run )--+',
    '|  /--[ ]( run )----/                                                          |',
];

export async function pen(page, { step, until, screenshot }) {
    let frame;
    /** The text next to the diagram, which has the focus. */
    const text = () =>
        page.evaluate(() => {
            const shown = [...document.querySelectorAll('.editor-group-container .monaco-editor .view-line')];
            const placed = shown.map((line) => ({ top: parseFloat(line.style.top), text: line.textContent.replace(/\u00a0/g, ' ') }));
            return placed.sort((a, b) => a.top - b.top).map(({ text }) => text.trimEnd()).join('\n').trimEnd();
        });
    const becomes = (wanted) => until(`the text\n${wanted.join('\n')}`, async () => (await text()) === wanted.join('\n'));
    const field = () => frame.locator('.field :is(input, textarea)');
    /** Writes into the field that a key has opened. */
    const write = async (words, key = 'Enter') => {
        await field().waitFor();
        await field().fill(words);
        await field().press(key);
    };
    const focused = () => frame.evaluate(() => document.activeElement?.getAttribute('aria-label') ?? '');
    const show = async (name) => {
        await page.keyboard.press('Control+1');
        await open(page, name);
        await command(page, 'Ladder: Open Diagram to the Side');
        await until(`the diagram of ${name}`, async () => {
            const frames = await Promise.all(page.frames().map(async (found) => [found, await found.title().catch(() => ''), await found.locator('.view').isVisible().catch(() => false)]));
            frame = frames.find(([, title, isSeen]) => title === name && isSeen)?.[0];
            return frame !== undefined;
        });
    };
    for (const { name, file, text, draw } of WHOLE) {
        await step(name, async () => {
            await show(file);
            await frame.locator('.view').focus();
            await draw(handsIn(page, frame));
            await becomes(text.split('\n'));
            await screenshot(page, file.replace('.clad', ''));
        });
    }
    await step('a motor starter grows, and has the focus', async () => {
        await show('penned.clad');
        await frame.locator('.view').focus();
        await page.keyboard.press('n');
        await write('XIC start XIO stop OTE run');
        await becomes(['+--[ ]( start )--[/]( stop )---------------------------------------( )( run )--+']);
        await until('the focus', async () => (await focused()).startsWith('Open contact start'));
        await page.keyboard.press('b');
        await write('run');
        await becomes(STARTER);
        await screenshot(page, 'drawn');
    });
    await step('a timer is found by what it is called elsewhere, and its operands follow one another', async () => {
        await page.keyboard.press('n');
        await write('[ ]( run )--( )( lamp )');
        await frame.locator('g.element.coil', { hasText: 'lamp' }).waitFor({ state: 'attached' });
        await until('the network', async () => (await focused()).startsWith('Open contact run'));
        await page.keyboard.press('f');
        await page.keyboard.type('TONR');
        await frame.locator('.palette .row[aria-selected="true"]', { hasText: '[RTO]' }).waitFor();
        await page.keyboard.press('Enter');
        await write('warm, 5s');
        await becomes([...STARTER, '', '+--[ ]( run )----------------------------------[RTO]( warm, 5s )--( )( lamp )--+']);
        await until('the timer', async () => (await focused()).startsWith('Retentive on-delay timer warm'));
    });
    await step('one undo takes back one change, and what cannot be done is said', async () => {
        await page.keyboard.press('Control+Z');
        await becomes([...STARTER, '', '+--[ ]( run )-----------------------------------------------------( )( lamp )--+']);
        await until('the focus as it was', async () => (await focused()).startsWith('Open contact run'));
        // In a branch: the network cannot be split there.
        await frame.locator('g.element.contact', { hasText: 'run' }).first().focus();
        await page.keyboard.press('k');
        await frame.locator('.refusal:not([hidden])').waitFor();
    });
    await step('a contact is dragged from the palette below another, and its new tag is declared', async () => {
        await show('dragged.clad');
        // What is above the drawing has its height.
        await frame.locator('.declarations summary', { hasText: '(2)' }).waitFor();
        await frame.locator('.wave').first().waitFor({ state: 'attached' });
        const go = await frame.locator('g.element.contact .hit').first().boundingBox();
        const closed = await frame.locator('.favourites button', { hasText: '[/]' }).boundingBox();
        await page.mouse.move(closed.x + 10, closed.y + 10);
        await page.mouse.down();
        await page.mouse.move(go.x + 20, go.y + go.height + 2, { steps: 6 });
        await frame.locator('.lane').waitFor();
        await screenshot(page, 'dragging');
        await page.mouse.up();
        await field().waitFor();
        await field().fill('by_hand');
        await frame.locator('.note-of-field', { hasText: 'by_hand is new: BOOL in VAR_INPUT' }).waitFor();
        await field().press('Enter');
        await becomes([
            'VAR_INPUT',
            '    go, hold : BOOL;',
            '    by_hand  : BOOL;',
            'END_VAR',
            '',
            '+--\\--[ ]( go )-------\\--[/]( hold )-------------------------------( )( out )--+',
            '|  /--[/]( by_hand )--/                                                        |',
        ]);
        await until('the focus', async () => (await focused()).startsWith('Closed contact by_hand'));
    });
    await step('an element is dragged to another place', async () => {
        const hold = await frame.locator('g.element.contact', { hasText: 'hold' }).locator('.hit').boundingBox();
        const go = await frame.locator('g.element.contact', { hasText: 'go' }).first().locator('.hit').boundingBox();
        await page.mouse.move(hold.x + hold.width / 2, hold.y + hold.height - 8);
        await page.mouse.down();
        await page.mouse.move(go.x - 4, go.y + go.height - 12, { steps: 6 });
        await frame.locator('.point.aim').waitFor({ state: 'attached' });
        await page.mouse.up();
        await until('the move', async () => /\[\/\]\( hold \)--\[ \]\( go \)/.test(await text()));
    });
    await step('while a program is simulated the mouse operates it, and a press of D draws again', async () => {
        await frame.locator('button.start').click();
        await frame.locator('.modes button[aria-pressed="true"]', { hasText: 'Operate' }).waitFor();
        const isSeen = () => frame.locator('.point').first().isVisible();
        assert.equal(await isSeen(), false);
        await frame.locator('g.element.contact').first().focus();
        await page.keyboard.press('d');
        await frame.locator('.modes button[aria-pressed="true"]', { hasText: 'Draw' }).waitFor();
        assert.equal(await isSeen(), true);
        await page.keyboard.press('Delete');
        await until('the contact gone', async () => !(await text()).includes('hold )--'));
        await frame.locator('button.stop').click();
        await frame.locator('button.start').waitFor();
    });
    await step('a row of the table is added, and what is reported is put right by its fix', async () => {
        await frame.locator('.declarations summary').waitFor();
        const row = frame.locator('.declarations .empty-row input').first();
        await row.fill('spare');
        await row.press('Enter');
        await until('the row', async () => /spare\s*: BOOL;/.test(await text()));
        await frame.locator('.wave').first().waitFor({ state: 'attached' });
        await frame.locator('g.element').first().focus();
        await page.keyboard.press('F8');
        await frame.locator('.findings').waitFor();
        await page.keyboard.press('Control+.');
        await frame.getByRole('menuitem', { name: /Declare/ }).first().click();
        await until('the declaration', async () => (await text()).includes('VAR_OUTPUT'));
    });
    await step('the title of the diagram has what an electrician needs: run, check, text', async () => {
        await frame.locator('g.element').first().focus();
        const title = page.locator('.editor-group-container.active .editor-actions');
        await title.getByRole('button', { name: /Check the Program/ }).waitFor();
        await title.getByRole('button', { name: /Start Simulation/ }).waitFor();
        await title.getByRole('button', { name: /Show the Text/ }).click();
        await page.locator('.editor-group-container.active .monaco-editor.focused').first().waitFor();
    });
}
