// The Test Explorer in the page: scenarios are run and debugged, and what they exercise is drawn beside the program.
import assert from 'node:assert/strict';

import { command, open } from './palette.mjs';

const FILE = 'motor.ladder-test';

export async function scenarios(page, { step, screenshot }) {
    const editor = page.locator('.editor-group-container .monaco-editor').first();
    await step('the scenarios of a file are tests, with marks beside them', async () => {
        await open(page, FILE);
        await editor.locator('.testing-run-glyph').nth(1).waitFor({ timeout: 15000 });
        await command(page, 'Test: Run Tests in Current File');
        await editor.locator('.codicon-testing-failed-icon').first().waitFor({ timeout: 15000 });
        await editor.locator('.codicon-testing-passed-icon').first().waitFor({ timeout: 5000 });
    });
    await step('the message has both waveforms, and the columns that differ are marked', async () => {
        const message = page.locator('.part.panel').getByText('expected', { exact: false }).first();
        await message.waitFor({ timeout: 5000 });
        assert.match(await page.locator('.part.panel').textContent(), /got\s*_--___/);
        await editor.getByText('run is FALSE in step 3').first().waitFor({ timeout: 5000 });
        await screenshot(page, 'tests');
        await editor.locator('.squiggly-error').first().waitFor({ timeout: 5000 });
    });
    await step('what the scenarios exercise is drawn beside the program', async () => {
        await command(page, 'Test: Run Tests with Coverage in Current File');
        await open(page, 'motor.clad');
        await editor.locator('.coverage-deco-gutter').first().waitFor({ timeout: 15000 });
        await screenshot(page, 'coverage');
    });
    await step('checking the folder is a task', async () => {
        // It is not run: terminals need a native part that the tests leave out.
        await command(page, 'Tasks: Run Build Task');
        await page.locator('.quick-input-list .monaco-list-row', { hasText: 'check' }).first().waitFor({ timeout: 10000 });
        await page.keyboard.press('Escape');
    });
    await step('a scenario that fails is debugged up to where it does', async () => {
        await open(page, FILE);
        await command(page, 'Test: Debug Tests in Current File');
        await page.locator('.debug-toolbar').waitFor({ timeout: 15000 });
        await page.keyboard.press('Control+Shift+D');
        await page.locator('.debug-call-stack').getByText('scenario "stop does nothing", step 3').waitFor({ timeout: 15000 });
        await screenshot(page, 'debug-scenario');
        await page.keyboard.press('Shift+F5');
        await page.locator('.debug-toolbar').waitFor({ state: 'hidden', timeout: 5000 });
    });
}
