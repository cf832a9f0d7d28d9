// A controller that is watched: its power is shown in the text and its values in the status bar, and nothing is written to it.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';

import { command, cursorTo, open } from './palette.mjs';

/** In a folder of its own: the names of its files in the project, and their texts. */
export const WATCHED = {
    'watched/online.clad': readFileSync(join(process.env.LADDER_FIXTURES, 'watched.clad'), 'utf8'),
    'watched/ladder.toml': `[online]\nmodbus = "${process.env.LADDER_CONTROLLER}"\n`,
};

export async function online(page, { step, until, weights, screenshot }) {
    await step('a running controller is shown in the text', async () => {
        await open(page, 'online.clad');
        await command(page, 'Ladder: Go Online: Watch the Controller');
        await page.locator('.statusbar-item', { hasText: 'READ ONLY; values' }).first().waitFor();
        await until('the power', async () => (await weights(page, '+--\\')).some(({ text, bold }) => bold && text.includes('run')));
        await screenshot(page, 'online');
    });
    await step('nothing is written to it, and it says why a tag is on', async () => {
        await page.locator('.monaco-editor .view-line', { hasText: '( run )' }).first().click();
        await cursorTo(page, 14, 68);
        await command(page, 'Ladder: Why Has the Tag This Value?');
        await page.getByText('start is 1: it is an input').first().waitFor();
        await command(page, 'Ladder: Go Offline');
        await page.locator('.statusbar-item', { hasText: 'READ ONLY' }).first().waitFor({ state: 'detached' });
        assert.ok((await weights(page, '+--\\')).every(({ bold }) => !bold));
    });
}
