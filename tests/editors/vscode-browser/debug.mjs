// The debugger in the page: F5 starts the program, a breakpoint stops it, tags are shown and held.
import assert from 'node:assert/strict';

import { command, open } from './palette.mjs';

/** The program that is debugged: its name in the project, and its text. */
export const PROGRAM = 'presses.clad';
export const TEXT = `VAR_INPUT
    button : BOOL;
END_VAR
VAR
    presses : INT;
END_VAR
VAR_OUTPUT
    lamp : BOOL;
END_VAR

+--[P]( button )--[ADD]( presses, presses, 1 )--+

# Enough #
+--[GE]( presses, 1 )-----------------( )( lamp )--+
`;

/** The row of the variables, or of the watched expressions, that begins with a text. */
const row = (page, name) => page.locator('.debug-view-content .monaco-list-row', { hasText: name }).first();

/** Opens a scope of the variables; the editor may have opened the first of them itself. A click that meets the drawing of a new state is lost. */
async function expand(page, scope) {
    const found = row(page, scope);
    await found.waitFor();
    const isOpen = async () => (await found.getAttribute('aria-expanded')) === 'true';
    for (let tries = 0; tries < 5 && !(await isOpen()); tries += 1) {
        await found.click();
        await page.waitForTimeout(500);
    }
}

/** Picks from the menu of a tag. A click that comes too soon after the opening of a menu is none to the editor. */
async function fromMenu(page, tag, title) {
    await row(page, tag).click({ button: 'right' });
    await page.locator('.action-label', { hasText: title }).first().hover();
    await page.keyboard.press('Enter');
}

/** Holds the button down. */
async function force(page) {
    await fromMenu(page, 'button', 'Force Value...');
    await page.locator('.quick-input-title', { hasText: 'Force button' }).waitFor();
    await page.keyboard.type('TRUE');
    await page.keyboard.press('Enter');
    await row(page, 'button').getByText('TRUE (forced)').waitFor();
}

export async function debug(page, { step, until, weights, screenshot }) {
    const stack = page.locator('.debug-call-stack');
    await step('F5 starts the program of the editor, without a launch.json', async () => {
        await open(page, PROGRAM);
        await page.locator('.monaco-editor .view-line', { hasText: '[GE]' }).click();
        await page.keyboard.press('F9');
        await page.locator('.codicon-debug-breakpoint').first().waitFor();
        await page.keyboard.press('F5');
        await page.locator('.debug-toolbar').waitFor();
        await page.keyboard.press('Control+Shift+D');
        await stack.getByText('main, before scan 0').waitFor();
        await expand(page, 'Inputs');
        await row(page, 'button').getByText('FALSE').waitFor();
    });
    await step('an input is held from the menu of the variables', async () => {
        await force(page);
    });
    await step('a breakpoint stops in front of its rung, and the tags are shown', async () => {
        await page.keyboard.press('F5');
        await stack.getByText('main, rung in line 14: Enough').waitFor();
        await page.locator('.debug-top-stack-frame-column, .codicon-debug-breakpoint-stackframe, .debug-top-stack-frame-line').first().waitFor();
        await expand(page, 'Internal');
        await row(page, 'presses').getByText('1').waitFor();
        await screenshot(page, 'debug');
    });
    await step('stopped there, the text shows power and values as in a simulation, and why answers', async () => {
        await page.getByText('Ladder: paused, scan 0, 0ms, 1 forced').waitFor();
        // On a line without a tag, so that one is asked for.
        await page.locator('.monaco-editor .view-line', { hasText: '# Enough #' }).click();
        const rung = () => weights(page, '+--[P]( button )');
        await until('power on the rung that has run', async () => (await rung()).some(({ bold }) => bold));
        await command(page, 'Ladder: Why Has the Tag This Value?');
        await page.locator('.quick-input-title', { hasText: 'Why' }).waitFor();
        await page.keyboard.type('presses');
        await page.keyboard.press('Enter');
        await page.locator('.monaco-list-row', { hasText: '[ADD]( presses' }).first().waitFor();
        await page.keyboard.press('Control+Shift+D');
    });
    await step('the marks of a breakpoint and of a stop move nothing within their line', async () => {
        const marks = '.debug-breakpoint-placeholder, .debug-top-stack-frame-column:not(.start-of-line)';
        assert.equal(await page.locator(marks).count(), 0);
    });
    await step('an expression of several tags is watched, and follows the program', async () => {
        const pane = page.locator('.debug-pane, .pane', { has: page.locator('.pane-header', { hasText: 'Watch' }) }).last();
        await pane.locator('.pane-header').hover();
        await pane.getByRole('button', { name: 'Add Expression' }).click();
        await pane.locator('.monaco-inputbox input').fill('presses * 2 + 1 > 2 AND button');
        await page.keyboard.press('Enter');
        const watched = row(page, 'presses * 2');
        await watched.getByText('TRUE').waitFor();
        await screenshot(page, 'debug-watch');
        await page.locator('.debug-toolbar .codicon-debug-step-back').first().click();
        await stack.getByText('main, before scan 0').waitFor();
        await watched.getByText('FALSE').waitFor();
        await page.locator('.monaco-editor .view-line', { hasText: '[GE]' }).click();
        await page.keyboard.press('F5');
        await stack.getByText('main, rung in line 14: Enough').waitFor();
        await watched.getByText('TRUE').waitFor();
    });
    await step('F11 goes to the next block, Shift+F11 to the end of the scan', async () => {
        await page.keyboard.press('F11');
        // The live view shows what has run; a selection would be replaced by the next letter.
        const rung = () => weights(page, '+--[GE]( presses');
        await until('power after the block', async () => (await rung()).some(({ text, bold }) => bold && text.includes('----')));
        await page.getByText('Paused on step').waitFor();
        await page.getByText('Ln 14, Col 1', { exact: true }).waitFor();
        await page.keyboard.press('Shift+F11');
        await stack.getByText('main, before scan 1').waitFor();
    });
    await step('a step back, and a run to the cursor', async () => {
        const back = page.locator('.debug-toolbar .codicon-debug-step-back').first();
        await back.click();
        await stack.getByText('main, rung in line 14: Enough').waitFor();
        await back.click();
        await stack.getByText('main, before scan 0').waitFor();
        await page.keyboard.press('F5');
        await stack.getByText('main, rung in line 14: Enough').waitFor();
        await page.locator('.monaco-editor .view-line', { hasText: '[P]' }).click();
        await command(page, 'Debug: Run to Cursor');
        await stack.getByText('main, rung in line 11').waitFor();
    });
    await step('a run stops where a condition holds, and only there', async () => {
        await page.locator('.monaco-editor .view-line', { hasText: '[GE]' }).click();
        await page.keyboard.press('F9');
        await command(page, 'Debug: Add Conditional Breakpoint...');
        await page.locator('.breakpoint-widget .monaco-editor').click();
        await page.keyboard.type('SYS.SCAN >= 7');
        // A list of proposals would take the Enter.
        await page.keyboard.press('Control+Enter');
        await page.keyboard.press('Enter');
        await page.locator('.codicon-debug-breakpoint-conditional').first().waitFor();
        await page.keyboard.press('F5');
        await stack.getByText('main, rung in line 14: Enough').waitFor();
        await expand(page, 'System');
        await row(page, 'SYS.SCAN').getByText('7', { exact: true }).waitFor();
        await screenshot(page, 'debug-condition');
        await page.locator('.monaco-editor .view-line', { hasText: '[GE]' }).click();
        await page.keyboard.press('F9');
    });
    await step('a condition on a tag that is unknown is refused, with the reason next to it', async () => {
        await page.locator('.monaco-editor .view-line', { hasText: '[P]' }).click();
        await command(page, 'Debug: Add Conditional Breakpoint...');
        await page.locator('.breakpoint-widget .monaco-editor').click();
        await page.keyboard.type('nix > 3');
        await page.keyboard.press('Control+Enter');
        await page.keyboard.press('Enter');
        await page.locator('.codicon-debug-breakpoint-unverified').first().waitFor();
        const reason = () => page.evaluate(() => {
            const spans = [...document.querySelectorAll('.monaco-editor .view-line span')];
            return spans.map((span) => getComputedStyle(span, '::after').content).find((content) => content.includes('nix')) ?? '';
        });
        await until('the reason', async () => /Breakpoint:.there.is.no.tag.`nix`/.test(await reason()));
        await screenshot(page, 'debug-refused');
        await page.locator('.monaco-editor .view-line', { hasText: '[P]' }).click();
        await page.keyboard.press('F9');
        await until('no reason', async () => (await reason()) === '');
    });
    await step('a run stops where a tag changes', async () => {
        await expand(page, 'Internal');
        await fromMenu(page, 'presses', 'Break on Value Change');
        // The button is let go for a scan, and pressed again.
        await fromMenu(page, 'button', 'Release');
        await page.keyboard.press('Shift+F11');
        await stack.getByText('main, before scan 8').waitFor();
        await page.keyboard.press('Shift+F11');
        await stack.getByText('main, before scan 9').waitFor();
        await row(page, 'SYS.SCAN').getByText('8', { exact: true }).waitFor();
        await force(page);
        await page.keyboard.press('F5');
        await row(page, 'presses').getByText('2', { exact: true }).waitFor();
        await screenshot(page, 'debug-data');
        assert.match(await stack.textContent(), /rung in line 14/);
    });
    await step('the console takes expressions and assignments', async () => {
        await page.keyboard.press('Control+Shift+Y');
        const input = page.locator('.repl-input-wrapper .monaco-editor');
        await input.click();
        await page.keyboard.type('presses > 0');
        await page.keyboard.press('Escape');
        await page.keyboard.press('Enter');
        await page.locator('.repl .monaco-list-row', { hasText: 'TRUE' }).first().waitFor();
        await screenshot(page, 'debug-console');
    });
    await step('Shift+F5 ends it, and the simulation with it', async () => {
        await page.keyboard.press('Shift+F5');
        await page.locator('.debug-toolbar').waitFor({ state: 'hidden' });
        await page.locator('.codelens-decoration a', { hasText: 'Start simulation' }).waitFor();
        assert.equal(await page.locator('.notification-list-item', { hasText: 'rror' }).count(), 0);
    });
    await step('a simulation that runs is given a breakpoint by the debugger, and is there without it', async () => {
        await page.locator('.monaco-editor .view-line', { hasText: '# Enough #' }).click();
        await command(page, 'Ladder: Start Simulation');
        await command(page, 'Ladder: Run');
        await page.getByText('Ladder: running').waitFor();
        await command(page, 'Ladder: Debug This Program');
        await page.locator('.debug-toolbar').waitFor();
        await page.getByText('Ladder: running').waitFor();
        await page.locator('.monaco-editor .view-line', { hasText: '[GE]' }).click();
        await page.keyboard.press('F9');
        await stack.getByText('main, rung in line 14: Enough').waitFor();
        await page.keyboard.press('F9');
        await page.keyboard.press('Shift+F5');
        await page.locator('.debug-toolbar').waitFor({ state: 'hidden' });
        await page.getByText('Ladder: paused').waitFor();
        await command(page, 'Ladder: Stop Simulation');
    });
    await step('F5 in a file of scenarios runs the one at the cursor', async () => {
        await open(page, 'motor.ladder-test');
        await page.locator('.monaco-editor .view-line', { hasText: 'stop does nothing' }).click();
        await page.keyboard.press('F5');
        await stack.getByText('scenario "stop does nothing", step 3').waitFor();
        await screenshot(page, 'debug-scenario-at-cursor');
    });
    await step('it stops at the coil that is wrong, in its scan, with the first scope open', async () => {
        await page.locator('.tab.active', { hasText: 'motor.clad' }).waitFor();
        await page.locator('.exception-widget').getByText('run is FALSE, expected TRUE in step 3').waitFor();
        await stack.getByText('main, rung in line').waitFor();
        await page.getByText('Ladder: paused, scan 3').waitFor();
        await until('a scope that is open', async () => (await page.locator('.debug-variables .monaco-list-row[aria-expanded="true"]').count()) > 0);
        await page.keyboard.press('Shift+F5');
        await page.locator('.debug-toolbar').waitFor({ state: 'hidden' });
    });
}
