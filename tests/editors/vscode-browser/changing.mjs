// A program that is changed while it runs: what goes on, what could not be kept, and the way back across the change.
import assert from 'node:assert/strict';

import { command, cursorTo, open } from './palette.mjs';

/** The program: its name in the project, and its text. */
export const CHANGING = 'changing.clad';
export const CHANGING_TEXT = `# A motor that holds itself #
VAR_INPUT  go : BOOL;  END_VAR
VAR_OUTPUT  runs, lamp : BOOL;  END_VAR
+--\\--[ ]( go )----\\--( )( runs )--+
|  /--[ ]( runs )--/               |

+--[ ]( runs )--[TON]( warm, T#1h )--( )( lamp )--+
`;
const LAMP = '+--[ ]( runs )--[TO';

export async function changing(page, { step, until, weights, row, screenshot }) {
    const status = async () => (await page.locator('.statusbar-item', { hasText: 'Ladder: ' }).first().textContent()).trim();
    const scan = async () => Number(/scan (\d+)/.exec(await status())?.[1]);
    const bold = async (start) => (await weights(page, start)).filter((part) => part.bold).map(({ text }) => text).join('').replace(/\s/g, '');
    const is = (tag, value) => row(page, tag).getByText(value, { exact: true }).waitFor();
    const at = (number) => page.getByText(`Ladder: paused, scan ${number},`).waitFor();
    const steps = async (key, ...scans) => {
        for (const number of scans) {
            await page.keyboard.press(key);
            await at(number);
        }
    };
    await step('what a change could not keep is said', async () => {
        await open(page, CHANGING);
        await page.locator('.monaco-editor .view-line', { hasText: 'VAR_INPUT' }).first().click();
        await command(page, 'Ladder: Start Simulation');
        await page.getByText('Ladder: paused, scan 0').waitFor();
        await cursorTo(page, 4, 9);
        await page.keyboard.press('F4');
        await is('go', '1');
        await steps('F10', 1, 2, 3);
        await cursorTo(page, 7, 20);
        await page.keyboard.press('Delete');
        await page.keyboard.type('F');
        // A list of proposals would take keys.
        await page.keyboard.press('Escape');
        await page.locator('.notification-list-item', { hasText: 'warm was a TON and is a TOF now' }).first().waitFor();
        await screenshot(page, 'lost');
        await steps('F10', 4);
        await until('the lamp', async () => (await bold(LAMP)).endsWith('(lamp)--+'));
    });
    await step('stepping back goes across the change, and forward again', async () => {
        await steps('Alt+F10', 3, 2);
        await is('lamp', '0');
        if (!(await row(page, 'warm.ET').isVisible())) {
            await row(page, 'warmQ=').click();
        }
        await is('warm.ET', '10ms');
        await cursorTo(page, 7, 20);
        assert.equal(await bold(LAMP), '', 'a line that is another one now has no power to show');
        assert.match(await bold('+--\\--[ ]( go )'), /\(runs\)--\+$/);
        await steps('F10', 3, 4);
        await is('lamp', '1');
        await until('the lamp', async () => (await bold(LAMP)).endsWith('(lamp)--+'));
    });
    await step('another letter in a comment changes nothing that is seen, at any moment', async () => {
        await page.keyboard.press('F5');
        await until('the run', async () => (await scan()) > 10);
        await cursorTo(page, 1, 3);
        const before = [await bold(LAMP), await scan()];
        assert.match(before[0], /\(lamp\)--\+$/);
        for (const key of ['x', 'Backspace', 'Control+Z', 'Control+Shift+Z']) {
            await page.keyboard.press(key);
            for (let look = 0; look < 15; look += 1) {
                assert.equal(await bold(LAMP), before[0], `after ${key}`);
                await page.waitForTimeout(20);
            }
        }
        assert.match(await status(), /^Ladder: running/);
        assert.ok((await scan()) > before[1]);
    });
    await step('a tag that is renamed goes on, and its trace with it', async () => {
        await command(page, 'Ladder: Show Trace');
        const view = page.frameLocator('iframe.webview.ready').frameLocator('#active-frame');
        const traced = (name) => view.locator('#rows tr', { has: page.locator(`th span:text-is("${name}")`) });
        await traced('runs').waitFor();
        await cursorTo(page, 4, 9);
        await page.keyboard.press('F4');
        await is('go', '0');
        await cursorTo(page, 4, 28);
        const before = await scan();
        await page.keyboard.press('F2');
        await page.locator('.rename-box input').waitFor();
        await page.locator('.rename-box input').fill('turns');
        await page.keyboard.press('Enter');
        await row(page, 'turns').waitFor();
        await until('more scans', async () => (await scan()) > before + 20);
        await is('turns', '1');
        await until('its name in the trace', async () => (await traced('turns').count()) === 1 && (await traced('runs').count()) === 0);
        const begin = async (name) => /^M[\d.]+/.exec(await traced(name).locator('.line').getAttribute('d'))?.[0];
        await until('what it was before', async () => (await begin('turns')) === (await begin('go')));
        await until('its power', async () => (await bold('+--[ ]( turns )')).startsWith('+--[](turns)--'));
        assert.match(await status(), /^Ladder: running/);
        await page.keyboard.press('Shift+F5');
        // The other parts find nothing that is not saved.
        await command(page, 'File: Revert File');
    });
}
