// Whole programs from nothing, by the mouse alone and by keys alone.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { diagrams } from './drawn.mjs';
import { handsIn, PROGRAMS } from './gestures.mjs';

const open = diagrams();

for (const [name, { text, mouse, keys }] of Object.entries(PROGRAMS)) {
    test(`${name} by the mouse alone`, async () => {
        const { page, becomes, host } = await open('');
        await handsIn(page, page).byMouse(mouse);
        await becomes(`${text}\n`);
        assert.deepEqual(host.errors, []);
    });

    test(`${name} by keys alone`, async () => {
        const { page, becomes, host } = await open('');
        await page.locator('.view').focus();
        await handsIn(page, page).byKeys(keys);
        await becomes(`${text}\n`);
        assert.deepEqual(host.errors, []);
    });
}
