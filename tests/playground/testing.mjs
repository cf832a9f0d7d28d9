// Scenarios: they are run, what fails is shown with its waveforms, and what of the program was never tried.
import assert from 'node:assert/strict';

import { Playground } from './page.mjs';
import { step } from './steps.mjs';

export async function testing(site) {
    const it = await Playground.open(site);
    const failed = (name) => it.picture(`failed ${name}`);
    await step('the scenarios of an example pass, with their coverage', async () => {
        await it.tab('runs');
        await it.page.getByRole('button', { name: 'Run all scenarios' }).click();
        const summary = it.page.locator('.results .summary').first();
        await summary.waitFor();
        assert.match(await summary.textContent(), /^(\d+) of \1 scenarios passed$/);
        assert.match(await it.page.locator('.coverage .summary').textContent(), /networks were exercised/);
        await it.page.locator('#program .exercised').first().waitFor();
        await it.picture('scenarios');
    }, failed);
    await step('a scenario that fails is shown with both waveforms, and marked in its text', async () => {
        await it.tab('scenarios');
        await it.page.locator('#scenarios .cm-content').click();
        await it.page.keyboard.press('Control+a');
        await it.page.keyboard.insertText('program motor.clad\nstep 100ms\n\nscenario "it never starts"\nstart _-__\nrun => ____\n');
        await it.page.getByRole('button', { name: 'Run all scenarios' }).click();
        await it.page.locator('.results .not-passed pre').waitFor();
        assert.match(await it.page.locator('.results .not-passed').textContent(), /it never starts/);
        await it.page.locator('#scenarios .failed').first().waitFor();
        await it.picture('scenario that fails');
    }, failed);
    await step('what is wrong in the scenarios is found while they are typed', async () => {
        await it.page.locator('#scenarios .cm-content').click();
        await it.page.keyboard.press('Control+End');
        await it.type('starx _-__\n');
        await it.page.locator('#scenarios .cm-lintRange-error').first().waitFor();
    }, failed);
    await it.close().catch((error) => step('nothing strange happens while testing', () => Promise.reject(error)));
}
