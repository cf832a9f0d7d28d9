// What happens while a program runs: reasons with their places, changes of the text, faults, values under the pointer, and
// what becomes a test.
import assert from 'node:assert/strict';

import { command, cursorTo, open } from './palette.mjs';

/** The programs: their names in the project, and their texts. */
export const PROGRAMS = {
    'running.clad': `VAR_INPUT  go, hold : BOOL;  END_VAR
VAR  since : TON;  END_VAR
VAR_OUTPUT  out, lamp, dark : BOOL;  END_VAR
+--[ ]( go )--[/]( hold )--( )( out )--+

+--[ ]( out )--[TON]( since, T#1h )--( )( lamp )--+

+--[ ]( go )--( )( dark )--+
`,
    'fault.clad': `VAR_INPUT  zero : INT;  go : BOOL;  END_VAR
VAR  shelf : ARRAY[0..3] OF INT;  place : INT := 9;  quotient, found : INT;  END_VAR
+--[ ]( go )--[DIV]( quotient, 10, zero )--+

+--[ ]( go )--[MOVE]( found, shelf[place] )--+
`,
};

export async function running(page, { step, until, weights, row, screenshot }) {
    const status = async () => (await page.locator('.statusbar-item', { hasText: 'Ladder: ' }).first().textContent()).trim();
    const scan = async () => Number(/scan (\d+)/.exec(await status())?.[1]);
    const line = (text) => page.locator('.editor-instance .view-line', { hasText: text }).first();
    /** Opens a program and starts it. */
    const start = async (name, text) => {
        await open(page, name);
        await line(text).click();
        await command(page, 'Ladder: Start Simulation');
        await page.getByText('Ladder: paused, scan 0').waitFor();
    };
    /** Types over what is at a place. */
    const overwrite = async (row, column, length, text) => {
        await cursorTo(page, row, column);
        for (let times = 0; times < length; times += 1) {
            await page.keyboard.press('Shift+ArrowRight');
        }
        await page.keyboard.type(text);
    };
    /** How many frames are around blocks that stop power. */
    const marks = () =>
        page.evaluate(() => [...document.querySelectorAll('.editor-instance .view-overlays .cdr')].filter((mark) => getComputedStyle(mark).borderTopStyle === 'dashed').length);
    const bold = async (text) => (await weights(page, text)).filter((part) => part.bold).map(({ text }) => text).join('').replace(/\s/g, '');

    await step('what stops the power is marked in the text, and its reason leads there', async () => {
        await start('running.clad', '( dark )');
        await cursorTo(page, 6, 40);
        await page.keyboard.press('F10');
        await page.getByText('Ladder: paused, scan 1,').waitFor();
        await page.keyboard.press('Shift+F4');
        const reason = page.locator('.monaco-list-row', { hasText: '[ ]( go ) (line 4' }).first();
        await reason.waitFor();
        await until('the marks', async () => (await marks()) >= 2);
        await reason.click();
        await page.getByText('Ln 4, Col 13 (9 selected)').waitFor();
        await screenshot(page, 'why-marks');
        await line('( dark )').click();
    });
    await step('a change while it runs takes effect, and what has run goes on', async () => {
        await cursorTo(page, 4, 9);
        await page.keyboard.press('F4');
        await page.keyboard.press('F5');
        // Of what stopped the power only the timer does so still.
        await until('one mark', async () => (await marks()) === 1);
        await until('the timer to run', async () => /since\.ET(?!0s?$|T#0)/.test(await row(page, 'since.ET').textContent()) && (await scan()) > 20);
        // The closed contact becomes an open one.
        const before = await scan();
        await overwrite(4, 16, 1, ' ');
        await until('no power at the coil', async () => (await bold('+--[ ]( go )--[ ]')) === '+--[](go)--');
        assert.match(await status(), /^Ladder: running/);
        await until('more scans than before', async () => (await scan()) > before + 5);
        await page.keyboard.press('Control+Z');
        await until('the power again', async () => (await bold('+--[ ]( go )--[/]')).endsWith('(out)--+'));
    });
    await step('the key that runs the program starts no debugger when it runs already', async () => {
        await page.keyboard.press('F5');
        const debugs = page.locator('.debug-toolbar').waitFor({ timeout: 4000 }).then(() => true, () => false);
        assert.equal(await debugs, false);
        assert.match(await status(), /^Ladder: running/);
    });
    await step('with an error in the text the last good program runs on, and undo brings all back', async () => {
        const before = await scan();
        await overwrite(6, 7, 1, ' ');
        await page.getByText('before the errors in the text').waitFor();
        assert.match(await status(), /^Ladder: running/);
        await until('more scans', async () => (await scan()) > before + 20);
        assert.match(await bold('+--[ ]( go )--[/]'), /\(out\)--\+$/, 'a line that is the same is not shown any more');
        await page.keyboard.press('Control+Z');
        await page.getByText('before the errors in the text').waitFor({ state: 'detached' });
        await until('the power of the line', async () => (await bold('+--[ ]( out )')).startsWith('+--[](out)--'));
        assert.match(await status(), /^Ladder: running/);
    });
    await step('one movement of the pointer shows a value while the program runs', async () => {
        await page.mouse.move(0, 0);
        const drawn = line('( out )--+').locator('> span');
        const { x, y, width } = await drawn.boundingBox();
        const letter = width / (await drawn.textContent()).length;
        await page.mouse.move(x + letter * 32.5, y + 8);
        await page.locator('.monaco-hover', { hasText: /out = 1/ }).first().waitFor();
        assert.match(await status(), /^Ladder: running/);
        await page.keyboard.press('Escape');
    });
    await step('the pointer shows a value that changes while the program runs', async () => {
        const value = page.locator('.monaco-hover', { hasText: /since\.ET = (T#)?\d/ }).first();
        await page.mouse.move(0, 0);
        await line('( since').getByText('since', { exact: false }).first().hover();
        await value.waitFor();
        assert.match(await status(), /^Ladder: running/);
        await page.keyboard.press('Escape');
        await page.mouse.move(0, 0);
    });
    const speed = async (text) => {
        await command(page, 'Ladder: Set Speed of the Simulation...');
        await page.locator('.quick-input-title', { hasText: 'Speed of the Simulation' }).waitFor();
        await page.keyboard.type(text);
        await page.keyboard.press('Enter');
    };
    await step('a run becomes slower while it goes', async () => {
        await speed('0.01x');
        await page.getByText('0.01x speed').waitFor();
        const before = await scan();
        await page.waitForTimeout(2000);
        const passed = (await scan()) - before;
        assert.ok(passed >= 1 && passed <= 6, `${passed} scans in two seconds`);
        await line('( dark )').click();
        await page.keyboard.press('F6');
        await page.getByText('Ladder: paused').waitFor();
    });
    await step('what was done becomes a test', async () => {
        await command(page, 'Ladder: Record as Test');
        await page.getByText('Tags of which the test expects values').or(page.locator('.quick-input-widget input[placeholder^="Tags of which"]')).first().waitFor();
        await page.keyboard.press('Enter');
        await page.locator('.tab', { hasText: 'running-recorded.ladder-test' }).first().waitFor();
        await line('scenario "recorded"').waitFor();
        await line('program running.clad').waitFor();
        await page.locator('.codicon-testing-passed-icon').first().waitFor();
        await screenshot(page, 'recorded');
        await command(page, 'View: Revert and Close Editor');
        await page.locator('.tab', { hasText: 'running.clad' }).first().click();
        await line('( dark )').click();
        await page.keyboard.press('Shift+F5');
    });
    await step('a run goes as fast as it can', async () => {
        await start('running.clad', '( dark )');
        await line('( dark )').click();
        await page.keyboard.press('F5');
        await page.getByText('Ladder: running').waitFor();
        await speed('max');
        await page.getByText('full speed').waitFor();
        const before = await scan();
        await page.waitForTimeout(2000);
        // In real time it would be 200.
        assert.ok((await scan()) - before > 2000, `${(await scan()) - before} scans in two seconds`);
        await line('( dark )').click();
        await page.keyboard.press('Shift+F5');
    });
    await step('a fault is reported at its place and in the status bar, also while the program runs', async () => {
        await start('fault.clad', 'DIV');
        assert.doesNotMatch(await status(), /fault/);
        await cursorTo(page, 3, 9);
        await page.keyboard.press('F4');
        await page.keyboard.press('F5');
        await page.getByText(/Ladder: running, .*, 2 faults/).waitFor();
        const squiggles = page.locator('.editor-instance .view-overlays .squiggly-error, .editor-instance .squiggly-error');
        await until('both places', async () => (await squiggles.count()) >= 2);
        await page.mouse.move(0, 0);
        await line('DIV').getByText('quotient', { exact: false }).first().hover();
        await page.locator('.monaco-hover', { hasText: /zero.*\(scan \d+\)/ }).first().waitFor();
        await screenshot(page, 'faults');
        await page.keyboard.press('Escape');
        await page.mouse.move(0, 0);
        await line('VAR_INPUT').click();
        await page.keyboard.press('Shift+F5');
        await until('no mark', async () => (await squiggles.count()) === 0);
    });
}
