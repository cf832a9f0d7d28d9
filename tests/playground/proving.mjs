// Proving: properties of the second text are decided, and the run that violates one is played.
import assert from 'node:assert/strict';

import { Playground } from './page.mjs';
import { step } from './steps.mjs';

const HOIST = `VAR_INPUT  up_button, down_button : BOOL;  END_VAR
VAR_OUTPUT  up, down : BOOL;  END_VAR

+--[ ]( up_button )--[/]( down )------------------------------------( )( up )--+
+--[ ]( down_button )---------------------------------------------( )( down )--+
`;
const PROPERTIES = `program test.clad
interval 100ms

property "both never"
never up and down

property "down goes by its button"
when down: down_button
`;

export async function proving(site) {
    const it = await Playground.open(site, { text: HOIST });
    const failed = (name) => it.picture(`failed ${name}`);
    const properties = async (words) => {
        await it.tab('scenarios');
        await it.page.locator('#scenarios .cm-content').click();
        await it.page.keyboard.press('Control+a');
        await it.page.keyboard.insertText(words);
    };
    const prove = it.page.getByRole('button', { name: 'Prove all properties' });
    await step('what proves is loaded when it is asked for', async () => {
        await it.diagram.locator('g.element').first().waitFor();
        assert.ok(!it.requested.some((url) => url.endsWith('ladder-complete.wasm')));
        await it.tab('runs');
        await properties(PROPERTIES);
        await prove.click();
        await it.page.locator('.proofs .summary', { hasText: '1 of 2 properties hold in every run' }).waitFor({ timeout: 60_000 });
        assert.ok(it.requested.some((url) => url.endsWith('ladder-complete.wasm')));
        assert.match(await it.page.locator('.proofs .passed').textContent(), /proved.*down goes by its button/);
        await it.picture('proved');
    }, failed);
    await step('the run that violates a property is played in the simulator', async () => {
        const violated = it.page.locator('.proofs .not-passed');
        assert.match(await violated.textContent(), /violated.*both never/);
        await violated.getByRole('button', { name: 'Play this run' }).click();
        await it.page.locator('#message', { hasText: 'both never' }).waitFor();
        await it.standing('paused');
        await it.until('the scan of the stop', async () => /scan [1-9]/.test(await it.page.locator('.standing').textContent()));
        await it.tab('tags');
        for (const tag of ['up', 'down']) {
            await it.until(`${tag} to be on`, async () => (await it.page.locator('#tags').getByRole('switch', { name: tag, exact: true }).getAttribute('aria-checked')) === 'true');
        }
        await it.picture('counterexample');
        await it.page.locator('#tags').getByRole('button', { name: 'Why up', exact: true }).click();
        await it.page.locator('.why button', { hasText: 'up_button' }).first().waitFor();
        await it.page.keyboard.press('Alt+F10');
        await it.tab('tags');
        await it.until('up to be off again', async () => (await it.page.locator('#tags').getByRole('switch', { name: 'up', exact: true }).getAttribute('aria-checked')) === 'false');
        await it.page.keyboard.press('Shift+F5');
    }, failed);
    await step('it is kept as a scenario, which is run', async () => {
        await it.tab('runs');
        await it.page.locator('.proofs .not-passed').getByRole('button', { name: 'Keep it as a scenario' }).click();
        await it.until('the scenario', async () => (await it.lines('#scenarios')).some((line) => line.startsWith('scenario ')));
        await it.page.locator('.proofs', { hasText: 'have changed since' }).waitFor();
        await it.page.getByRole('button', { name: 'Run all scenarios' }).click();
        await it.page.locator('.results .not-passed', { hasText: 'both never' }).waitFor();
        await it.picture('counterexample as a scenario');
    }, failed);
    await step('a file without properties says what to write', async () => {
        await properties('program test.clad\nstep 100ms\n\nscenario "s"\nup_button _-\nup => _-\n');
        await prove.click();
        await it.page.locator('.proofs .error', { hasText: 'write one, as in: never up and down' }).waitFor();
    }, failed);
    await step('a proof is given up when a text changes', async () => {
        await it.tab('program');
        await it.page.locator('#program .cm-content').click();
        await it.page.keyboard.press('Control+a');
        await it.page.keyboard.insertText(`VAR_INPUT  x, y : DINT;  END_VAR\nVAR  u, v : DINT;  END_VAR\n+--[CALC]( u, u * x + y )--[CALC]( v, v * x + y )--+\n`);
        await properties('program test.clad\ninterval 100ms\n\nalways u * u = v * v\n');
        await prove.click();
        await it.page.locator('.proofs', { hasText: 'being proved' }).waitFor();
        await it.page.waitForTimeout(300);
        await it.page.locator('#scenarios .cm-content').click();
        await it.page.keyboard.press('Control+End');
        await it.page.keyboard.insertText('\n');
        await it.page.locator('.proofs .error', { hasText: 'it was stopped' }).waitFor();
        // The next one begins with another worker.
        await properties('program test.clad\ninterval 100ms\n\nalways u = v\n');
        await prove.click();
        await it.page.locator('.proofs .summary').waitFor({ timeout: 60_000 });
    }, failed);
    await it.close().catch((error) => step('nothing strange happens while proving', () => Promise.reject(error)));
}
