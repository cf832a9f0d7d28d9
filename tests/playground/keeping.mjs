// Nobody's work is lost: what was open comes again, in this tab and the next visit, in two tabs, and without a network.
import assert from 'node:assert/strict';

import { Playground } from './page.mjs';
import { step } from './steps.mjs';

const OWN = '# my own # +--[ ]( a )--( )( b )--+';

export async function keeping(site) {
    const it = await Playground.open(site);
    const failed = (name) => it.picture(`failed ${name}`);
    const text = async (of = it) => (await of.lines()).join('\n');
    const write = async (words, of = it) => {
        await of.tab('program');
        await of.page.locator('#program .cm-content').click();
        await of.page.keyboard.press('Control+a');
        await of.page.keyboard.insertText(words);
    };
    const shows = (words, of = it) => of.until(words, async () => (await text(of)).includes(words));
    const scenarios = async (words) => {
        await it.tab('scenarios');
        await it.page.locator('#scenarios .cm-content').click();
        await it.page.keyboard.press('Control+a');
        await it.page.keyboard.insertText(words);
        await it.tab('program');
    };
    await step('an example opens next to the last program, which Back brings again with its scenarios', async () => {
        await shows('Water is taken from a tank');
        await it.page.locator('#examples').selectOption({ label: 'Motor' });
        await shows('A motor starter');
        await write(OWN);
        await scenarios('# my own scenarios #');
        await it.page.locator('#examples').selectOption({ label: 'Traffic light' });
        await shows('A pedestrian crossing');
        await it.page.locator('#back').click();
        await shows('# my own #');
        await it.tab('scenarios');
        await it.until('the scenarios', async () => (await it.lines('#scenarios')).join('\n') === '# my own scenarios #');
        await it.tab('program');
        await it.picture('back');
    }, failed);
    await step('files that are dropped open next to it, scenarios as well', async () => {
        await it.page.locator('#file').setInputFiles([{ name: 'own.ladder-test', mimeType: 'text/plain', buffer: Buffer.from('# dropped #') }]);
        await it.until('the scenarios', async () => (await it.lines('#scenarios')).join('\n') === '# dropped #');
        await it.page.locator('#back').click();
        await it.until('those before', async () => (await it.lines('#scenarios')).join('\n') === '# my own scenarios #');
        await it.tab('program');
        await shows('# my own #');
    }, failed);
    await step('a link opens next to it, and is there again when the page is loaded again', async () => {
        await it.page.evaluate(() => (location.hash = '#name=linked.clad&text=%23%20linked%20%23'));
        await shows('# linked #');
        await write('# linked and changed #');
        await it.page.reload();
        await shows('# linked and changed #');
        await it.page.locator('#back').click();
        await it.until('another program', async () => !(await text()).includes('linked'));
        assert.equal(await it.page.evaluate(() => location.hash), '');
        await it.page.reload();
        await it.until('it to be there', async () => (await text()) !== '' && !(await text()).includes('linked'));
    }, failed);
    await step('Undo crosses a change of program, with its name and its scenarios', async () => {
        await write(OWN);
        const before = await it.page.locator('#tab-program').textContent();
        await scenarios('# of my own #');
        await it.page.locator('#examples').selectOption({ label: 'Motor' });
        await shows('A motor starter');
        await it.page.locator('#program .cm-content').focus();
        await it.page.keyboard.press('Control+z');
        await shows('# my own #');
        assert.equal(await it.page.locator('#tab-program').textContent(), before);
        await it.tab('scenarios');
        await it.until('its scenarios', async () => (await it.lines('#scenarios')).join('\n') === '# of my own #');
        await it.tab('program');
        // The server knows which text it is.
        await it.diagram.locator('g.element text', { hasText: /^b$/ }).first().waitFor();
        await it.page.locator('#program .cm-content').focus();
        await it.page.keyboard.press('Control+y');
        await shows('A motor starter');
        await it.page.locator('#tab-program', { hasText: 'motor.clad' }).waitFor();
        await it.page.keyboard.press('Control+z');
        await shows('# my own #');
    }, failed);
    await step('two tabs do not overwrite each other', async () => {
        await write('# the first tab #');
        // A tab that is left keeps its text at once; here both are in sight.
        await it.until('the text to be kept', () => it.page.evaluate(() => Object.values(localStorage).some((kept) => kept.includes('# the first tab #'))));
        const other = await it.another(site);
        await shows('# the first tab #', other);
        await write('# the second tab #', other);
        await it.page.bringToFront();
        await write('# still the first tab #');
        await it.page.reload();
        await shows('# still the first tab #');
        await other.page.reload();
        await shows('# the second tab #', other);
        await other.page.close();
    }, failed);
    await step('a dialog of one program is gone when another one is open', async () => {
        await it.page.locator('#examples').selectOption({ label: 'Motor' });
        await shows('A motor starter');
        await it.page.locator('#program .cm-line span', { hasText: /^run$/ }).first().click();
        await it.page.keyboard.press('F2');
        await it.page.locator('.cm-lsp-rename-panel input').waitFor();
        await it.page.locator('#examples').selectOption({ label: 'Traffic light' });
        await shows('A pedestrian crossing');
        await it.until('the dialog to go', async () => (await it.page.locator('.cm-lsp-rename-panel').count()) === 0);
    }, failed);
    await it.close().catch((error) => step('nothing strange happens while programs change', () => Promise.reject(error)));

    const away = await Playground.open(site, { text: OWN, serviceWorkers: 'allow' });
    await step('after the first visit it works without a network, and says so', async () => {
        await away.page.locator('#offline').waitFor({ timeout: 30_000 });
        await away.picture('works offline');
        await away.context.setOffline(true);
        await away.page.goto(`${site}/playground/`);
        await shows('# my own #', away);
        await away.diagram.locator('g.element text', { hasText: /^b$/ }).first().waitFor();
        await away.page.locator('#export').click();
        await away.page.getByRole('menuitem', { name: 'As PLCopen XML' }).waitFor();
    }, (name) => away.picture(`failed ${name}`));
    await away.close().catch((error) => step('nothing strange happens without a network', () => Promise.reject(error)));
}
