// Properties in the page: proved by a lens and in the Test Explorer, marked where they are violated, and debugged.
import assert from 'node:assert/strict';

import { command, open } from './palette.mjs';

/** The properties, one of which is violated. */
export const FILE = 'shutter.ladder-test';

/** Two scenarios that violate the same property. */
const SHOWN = 'ways.ladder-test';

export const files = {
    [SHOWN]: `program shutter.clad

property "it goes"
always up or not go_up

scenario "down, then up"
go_down  --
go_up    _-
down  => --

scenario "up later"
go_down  ---
go_up    __-
down  => ---
`,
    'shutter.clad': `VAR_INPUT
    go_up, go_down : BOOL;
END_VAR
VAR_OUTPUT
    up, down : BOOL;
END_VAR

+--[ ]( go_up )----[/]( down )--( )( up )----+

+--[ ]( go_down )--[/]( up )----( )( down )--+
`,
    [FILE]: `program shutter.clad

property "not both"
never up and down

property "it goes"
always up or not go_up
`,
};

export async function proofs(page, { step, until, screenshot }) {
    const editor = page.locator('.editor-group-container .monaco-editor').first();
    const mark = (name) => editor.locator(`.codicon-testing-${name}-icon`);
    await step('one that is violated has the run in its message, and is marked in its file', async () => {
        await open(page, FILE);
        await editor.locator('.testing-run-glyph').nth(1).waitFor();
        await command(page, 'Test: Run Tests in Current File');
        await mark('failed').first().waitFor();
        const panel = page.locator('.part.panel');
        await panel.getByText('violated in scan', { exact: false }).first().waitFor();
        await until('the rows', async () => /go_up\s*[_-]+/.test((await panel.textContent()).replace(/\u00a0/g, ' ')));
        await editor.locator('.squiggly-error').first().waitFor();
        await screenshot(page, 'proofs');
    });
    await step('the run that violates it is debugged from before its first scan up to where it does', async () => {
        await command(page, 'Test: Debug Tests in Current File');
        await page.locator('.debug-toolbar').waitFor();
        await page.keyboard.press('Control+Shift+D');
        const stack = page.locator('.debug-call-stack');
        await stack.getByText('scenario "it goes is violated", step 0').waitFor();
        await page.keyboard.press('F5');
        await page.locator('.exception-widget').getByText('the property "it goes" is violated in scan').waitFor();
        // The picture of the program is that of the stop.
        await page.getByText(/Ladder: paused, scan [1-9]/).waitFor();
        await screenshot(page, 'debug-proof');
        await page.keyboard.press('Shift+F5');
        await page.locator('.debug-toolbar').waitFor({ state: 'hidden' });
    });
    await step('what was found goes when the program changes', async () => {
        await open(page, 'shutter.clad');
        await page.keyboard.press('Control+Home');
        await page.keyboard.type('# changed #\n');
        await open(page, FILE);
        await editor.locator('.squiggly-error').first().waitFor({ state: 'detached' });
        await open(page, 'shutter.clad');
        await command(page, 'File: Revert File');
    });
    await step('a property is proved by its lens', async () => {
        await open(page, FILE);
        await command(page, 'Test: Clear All Results');
        await mark('failed').first().waitFor({ state: 'detached' });
        const lenses = page.locator('.codelens-decoration a', { hasText: /^Prove$/ });
        await lenses.nth(1).waitFor();
        await lenses.first().click();
        await mark('passed').first().waitFor();
        assert.equal(await mark('failed').count(), 0);
    });
    await step('a property that two scenarios violate is one failure, with both of them', async () => {
        await open(page, SHOWN);
        await editor.locator('.testing-run-glyph').nth(2).waitFor();
        await command(page, 'Test: Run Tests in Current File');
        // A message in the text has the same icon.
        const marks = (name) => editor.locator(`.testing-run-glyph.codicon-testing-${name}-icon`).count();
        await until('two that passed', async () => (await marks('passed')) === 2);
        await until('one that failed', async () => (await marks('failed')) === 1);
        const panel = page.locator('.part.panel');
        for (const name of ['down, then up', 'up later']) {
            await panel.locator('.monaco-list-row', { hasText: `scenario "${name}"` }).first().waitFor();
        }
        await screenshot(page, 'proofs-shown');
    });
}
