// Properties in the page: proved by a lens and in the Test Explorer, marked where they are violated, and debugged.
import assert from 'node:assert/strict';

import { command, open } from './palette.mjs';

/** The properties, one of which is violated. */
export const FILE = 'shutter.ladder-test';

export const files = {
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
    await step('a property is proved by its lens', async () => {
        await command(page, 'Test: Clear All Results');
        await open(page, FILE);
        const lenses = page.locator('.codelens-decoration a', { hasText: /^Prove$/ });
        await lenses.nth(1).waitFor({ timeout: 15000 });
        await lenses.first().click();
        await mark('passed').first().waitFor({ timeout: 20000 });
        assert.equal(await mark('failed').count(), 0);
    });
    await step('one that is violated has the run in its message, and is marked in its file', async () => {
        await command(page, 'Test: Run Tests in Current File');
        await mark('failed').first().waitFor({ timeout: 20000 });
        const panel = page.locator('.part.panel');
        await panel.getByText('violated in scan', { exact: false }).first().waitFor({ timeout: 5000 });
        await until('the rows', 5, async () => /go_up\s*[_-]+/.test((await panel.textContent()).replace(/\u00a0/g, ' ')));
        await editor.locator('.squiggly-error').first().waitFor({ timeout: 10000 });
        await screenshot(page, 'proofs');
    });
    await step('the run that violates it is debugged from before its first scan', async () => {
        await command(page, 'Test: Debug Tests in Current File');
        await page.locator('.debug-toolbar').waitFor({ timeout: 20000 });
        await page.keyboard.press('Control+Shift+D');
        const stack = page.locator('.debug-call-stack');
        await stack.getByText('scenario "it goes is violated", step 0').waitFor({ timeout: 15000 });
        await screenshot(page, 'debug-proof');
        await page.keyboard.press('Shift+F5');
        await page.locator('.debug-toolbar').waitFor({ state: 'hidden', timeout: 5000 });
    });
    await step('what was found goes when the program changes', async () => {
        await open(page, 'shutter.clad');
        await page.keyboard.press('Control+Home');
        await page.keyboard.type('# changed #\n');
        await open(page, FILE);
        await editor.locator('.squiggly-error').first().waitFor({ state: 'detached', timeout: 10000 });
        await open(page, 'shutter.clad');
        await command(page, 'File: Revert File');
    });
}
