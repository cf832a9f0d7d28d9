// A server that is slow, and one that dies: what was simulated is had again as it was, and after the fifth death so is the server.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';

import { command, open } from './palette.mjs';
import { lines } from './typing.mjs';

/** The file that is typed into while the server is slow: its name in the project. It is empty. */
export const SLOW = 'slow.clad';

/** After so many deaths the extension starts it no more by itself. */
const MOST = 5;

/** Sends a signal to the language server of the session whose folder this is. */
function signal(scratch, name) {
    const isServer = (id) => {
        try {
            const of = (file) => readFileSync(`/proc/${id}/${file}`, 'utf8').split('\0');
            return of('cmdline')[1] === 'lsp' && of('environ').some((variable) => variable.includes(scratch));
        } catch {
            // It has ended meanwhile.
            return false;
        }
    };
    const found = readdirSync('/proc').filter((name) => /^\d+$/.test(name) && isServer(name));
    assert.equal(found.length, 1, `${found.length} servers`);
    process.kill(Number(found[0]), name);
}

export async function dying(page, { step, until, screenshot, scratch, answer }) {
    /** As a fault would end it. */
    const kill = () => signal(scratch, 'SIGKILL');
    const button = (name) => page.locator('.monaco-button:visible', { hasText: new RegExp(`^${name}$`) }).first();
    const state = (text) => page.getByText(text, { exact: true }).first();
    await step('an END_VAR whose Enter was overtaken by the next one finds its column', async () => {
        await open(page, SLOW);
        await page.locator('.editor-group-container.active .monaco-editor .view-lines').click();
        await page.keyboard.type('VAR\n    run : BOOL;\n', { delay: 50 });
        await page.waitForTimeout(1000);
        signal(scratch, 'SIGSTOP');
        await page.keyboard.type('END_VAR\n\nV', { delay: 50 });
        signal(scratch, 'SIGCONT');
        await until('the column', async () => (await lines(page)).join('\n') === 'VAR\n    run : BOOL;\nEND_VAR\n\nV');
        await command(page, 'View: Revert and Close Editor');
    });
    const WAS = 'Ladder: paused, scan 3, 30ms, 1 forced';
    await step('a simulation that the death of the server has ended starts again as it was', async () => {
        await open(page, 'motor.clad');
        await page.locator('.editor-group-container.active .view-line').first().click();
        await command(page, 'Ladder: Start Simulation');
        await state('Ladder: paused, scan 0, 0ms').waitFor();
        await command(page, 'Ladder: Force Tag...');
        await answer(page, 'Force Tag', 'lamp');
        await answer(page, 'Force lamp', '1');
        await state('Ladder: paused, scan 0, 0ms, 1 forced').waitFor();
        for (const scan of [1, 2, 3]) {
            await page.keyboard.press('F10');
            await state(`Ladder: paused, scan ${scan}, ${scan}0ms, 1 forced`).waitFor();
        }
        kill();
        await page.getByText('and the simulation of motor.clad with it, after 3 scans').first().waitFor();
        await screenshot(page, 'died');
        await state(WAS).waitFor({ state: 'detached' });
        await button('Start It Again as It Was').click();
        await state(WAS).waitFor();
    });
    await step(`after ${MOST} deaths the message starts the server, and what it simulated`, async () => {
        for (let deaths = 2; deaths <= MOST; deaths += 1) {
            kill();
            await state(WAS).waitFor({ state: 'detached' });
            await button('Start It Again as It Was').click();
            if (deaths < MOST) {
                await state(WAS).waitFor();
            }
        }
        await button('Restart').click();
        await state(WAS).waitFor();
        await command(page, 'Ladder: Stop Simulation');
        await state(WAS).waitFor({ state: 'detached' });
    });
}
