// The Test Explorer in the page: scenarios are run and debugged, and what they exercise is drawn next to the program.
import assert from 'node:assert/strict';

import { command, cursorTo, open } from './palette.mjs';

/** The scenarios that are run, one of which fails. */
export const FILE = 'motor.ladder-test';

/** Files besides: a program that calls another, and one with a contact that no scenario shows to matter, with their scenarios. */
export const files = {
    'counted.clad': '+--<CALL>( count_up )--+\n',
    'library.clad': 'VAR\n    total : DINT;\n    warm : TON;\nEND_VAR\n+--<FUN>( count_up )--[INC]( total )--[TON]( warm, 5s )--<RET>--+\n',
    'counted.ladder-test': 'program counted.clad\n\nscenario "it counts"\n',
    'press.clad': '+--[ ]( guard )--[ ]( pedal )--( )( press )--+\n',
    'press.ladder-test': 'program press.clad\n\nscenario "it presses"\nguard    -_---\npedal    ___-_\npress => ___-_\n',
};

/**
 * @param holdTest has the next run of scenarios take seconds after it has read the files; says whether it has begun, and how many
 *     have ended since
 */
export async function scenarios(page, { step, until, screenshot, holdTest }) {
    const editor = page.locator('.editor-group-container .monaco-editor').first();
    const terminal = page.locator('.xterm-rows > div');
    await step('the scenarios of a file are tests, with marks next to them', async () => {
        await open(page, FILE);
        await editor.locator('.testing-run-glyph').nth(1).waitFor();
        await command(page, 'Test: Run Tests in Current File');
        await editor.locator('.codicon-testing-failed-icon').first().waitFor();
        await editor.locator('.codicon-testing-passed-icon').first().waitFor();
    });
    await step('the message has both waveforms, and the columns that differ are marked', async () => {
        const message = page.locator('.part.panel').getByText('expected', { exact: false }).first();
        await message.waitFor();
        assert.match(await page.locator('.part.panel').textContent(), /got\s*_--___/);
        await editor.getByText('run is FALSE in step 3').first().waitFor();
        await screenshot(page, 'tests');
        await editor.locator('.squiggly-error').first().waitFor();
    });
    await step('what the scenarios exercise is drawn next to the program', async () => {
        await command(page, 'Test: Run Tests with Coverage in Current File');
        await open(page, 'motor.clad');
        await editor.locator('.coverage-deco-gutter').first().waitFor();
        await screenshot(page, 'coverage');
    });
    await step('the lens above a program runs its scenarios in the Test Explorer', async () => {
        await command(page, 'Test: Clear All Results');
        await open(page, 'motor.clad');
        await page.locator('.codelens-decoration a', { hasText: 'Run scenarios' }).click();
        await open(page, FILE);
        await editor.locator('.codicon-testing-failed-icon').first().waitFor();
        assert.equal(await terminal.filter({ hasText: 'Executing task' }).count(), 0);
    });
    await step('the tasks run in a terminal, and what they find is under Problems once, in closed files, too', async () => {
        const problems = async (name) => {
            await command(page, 'Problems: Focus on Problems View');
            const filter = page.locator('.pane-composite-part.panel .viewpane-filter input, .part.panel .viewpane-filter input').first();
            await filter.fill(name);
            let found = [];
            await until(`"${name}" under Problems`, async () => {
                // The list is drawn again a moment later.
                await page.waitForTimeout(1000);
                const rows = await page.locator('.markers-panel .monaco-list-row').allTextContents();
                found = rows.filter((row) => row.includes(name)).map((row) => row.replaceAll('\u00a0', ' '));
                return found.length > 0;
            });
            await filter.fill('');
            return found;
        };
        const run = async (kind, name, last) => {
            await command(page, kind);
            // The list of commands, which is there a moment longer, has "test" in its rows, too.
            await page.locator('.quick-input-list .monaco-list-row', { hasText: `ladder: ${name}` }).first().click();
            await terminal.filter({ hasText: last }).last().waitFor();
        };
        // What the check finds comes from the server already.
        const unpairedOnce = async (when) => {
            const [unpaired, ...more] = await problems('unpaired-connector');
            assert.match(unpaired, /has no partner/);
            assert.deepEqual(more, [], when);
        };
        await unpairedOnce('before the check');
        await run('Tasks: Run Build Task', 'check', /Checked \d+ files/);
        await screenshot(page, 'task-check');
        await unpairedOnce('after the check');
        await open(page, 'unpaired.clad');
        await editor.locator('.squiggly-error').first().waitFor();
        await unpairedOnce('while it is open');
        await page.keyboard.press('Control+W');
        await unpairedOnce('when it is closed again');
        await run('Tasks: Run Test Task', 'test', /\d failed/);
        const failed = await problems('run is FALSE in step 3');
        assert.equal(failed.length, 1, failed.join('\n'));
        assert.match(failed[0], /ladder test/);
        await screenshot(page, 'tasks');
    });
    await step('a scenario that fails is debugged up to where it does', async () => {
        await open(page, FILE);
        await command(page, 'Test: Debug Tests in Current File');
        await page.locator('.debug-toolbar').waitFor();
        await page.keyboard.press('Control+Shift+D');
        await page.locator('.debug-call-stack').getByText('scenario "stop does nothing", step 3').waitFor();
        await screenshot(page, 'debug-scenario');
        await page.keyboard.press('Shift+F5');
        await page.locator('.debug-toolbar').waitFor({ state: 'hidden' });
        // Ended by hand it has not passed.
        await open(page, FILE);
        await editor.locator('.codicon-testing-failed-icon').first().waitFor();
    });
    const tree = page.locator('.test-explorer-tree');
    const result = (name) => tree.locator('.monaco-list-row', { hasText: FILE }).locator(`.codicon-testing-${name}-icon`);
    /** A motor that nothing stops is what the second scenario wants: its coil becomes one that sets. */
    const fix = async () => {
        await cursorTo(page, 2, 69);
        await page.keyboard.press('Shift+ArrowRight');
        await page.keyboard.type('S');
        await page.keyboard.press('Control+S');
    };
    const undo = async () => {
        await page.keyboard.press('Control+Z');
        await page.keyboard.press('Control+S');
    };
    await step('with continuous run the result changes with the program that is saved', async () => {
        await command(page, 'View: Show Testing');
        await page.getByRole('button', { name: 'Start Continuous Run' }).first().click();
        const profiles = page.locator('.quick-input-widget');
        await profiles.getByRole('checkbox', { name: /^Run/ }).first().click();
        await profiles.getByRole('button', { name: 'OK' }).click();
        await open(page, 'motor.clad');
        await fix();
        await result('passed').waitFor();
        await undo();
        await result('failed').waitFor();
        await screenshot(page, 'continuous');
    });
    await step('of two changes in quick succession the later one is shown, also where the earlier one takes longer', async () => {
        const held = holdTest();
        await fix();
        await until('the run of the first change', held.hasBegun);
        await undo();
        await until('both runs to end', () => held.ended() === 2);
        // What has ended is shown a moment later.
        await page.waitForTimeout(1000);
        await screenshot(page, 'succession');
        assert.deepEqual([await result('failed').count(), await result('passed').count()], [1, 0]);
        await page.getByRole('button', { name: 'Stop Continuous Run' }).first().click();
    });
    await step('in a row the tags of a called file are proposed', async () => {
        await open(page, 'counted.ladder-test');
        await cursorTo(page, 4, 1);
        await page.keyboard.type('library.w', { delay: 40 });
        await page.locator('.suggest-widget .monaco-list-row', { hasText: 'library.warm.ET' }).first().click();
        const written = page.locator('.editor-group-container.active .view-line').nth(3);
        await until('the row', async () => /^library.warm.ET => ?$/.test((await written.textContent()).replace(/\u00a0/g, ' ')));
        await page.keyboard.type('100ms');
        await page.keyboard.press('Control+S');
    });
    await step('a contact that no scenario shows to matter is not covered, and a scenario that would is in the output', async () => {
        await open(page, 'press.ladder-test');
        await editor.locator('.testing-run-glyph').first().waitFor();
        await command(page, 'View: Show Testing');
        await page.locator('.test-explorer-tree .monaco-list-row', { hasText: 'press.ladder-test' }).first().click({ button: 'right' });
        // A click that comes too soon after the opening of a menu is none to the editor.
        await page.getByRole('menuitem', { name: 'Execute Using Profile...' }).hover();
        await page.keyboard.press('Enter');
        await page.locator('.quick-input-list .monaco-list-row', { hasText: 'Coverage and What Matters' }).click();
        await open(page, 'press.clad');
        await editor.locator('.coverage-deco-gutter').first().hover();
        await editor.locator('.coverage-deco-miss').first().waitFor();
        await page.locator('.part.panel').getByText('no scenario notices: contact bridged').first().waitFor();
        await screenshot(page, 'matters');
    });
}
