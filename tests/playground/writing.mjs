// Writing: what is found while a person types, what the server proposes, explains, fixes, aligns and renames.
import assert from 'node:assert/strict';

import { Playground } from './page.mjs';
import { step } from './steps.mjs';

const MOTOR = `+--\\--[ ]( start )--\\--[/]( stop )---------------------------------( )( run )--+
|  /--[ ]( run )----/                                                          |

+--[ ]( run )-----------------------------[TON]( warmup, T#5s )--( )( ready )--+
`;

export async function writing(site) {
    let it = await Playground.open(site, { text: '' });
    const failed = (name) => it.picture(`failed ${name}`);
    await step('a program typed key by key is aligned while it grows', async () => {
        await it.page.locator('#program .cm-content').click();
        await it.type('+--\\--[ ]( go )--[/]( halt )--( )( run )--+\n');
        await it.until('the branch that Enter begins', async () => (await it.lines())[1] === '|  /--');
        await it.type('[ ]( run )--/');
        await it.until('the aligned drawing', async () => {
            const [first, second] = await it.lines();
            return first.length === 80 && second.length === 80 && second.startsWith('|  /--[ ]( run )--/');
        });
        await it.picture('typed');
    }, failed);
    await step('Tab takes the first proposal, and goes through what it asks for', async () => {
        // The right rail is after the cursor, and does not come along.
        await it.type('\n');
        await it.until('the rung that Enter begins', async () => (await it.lines())[2] === '+--');
        await it.type('[ ]( run )--[TO', 60);
        // Those to what was typed before the last letter can be seen, and not be taken.
        const proposals = it.page.locator('.cm-tooltip-autocomplete:not(.cm-tooltip-autocomplete-disabled) li');
        await proposals.filter({ hasText: '[TON]' }).first().waitFor();
        assert.equal(await it.page.locator('.cm-lintRange-error').count(), 0, 'a rung that is half typed has no errors');
        await it.picture('completion');
        await it.page.keyboard.press('Tab');
        await it.until('the timer', async () => (await it.lines())[2].startsWith('+--[ ]( run )--[TON]( t, T#1s )--'));
        await it.type('warm');
        await it.page.keyboard.press('Tab');
        await it.type('T#3s');
        await it.page.keyboard.press('Tab');
        await it.type('( )( hot )--+');
        await it.until('the aligned rung', async () => /^\+--\[ \]\( run \)-+\[TON\]\( warm, T#3s \)--\( \)\( hot \)--\+$/.test((await it.lines())[2]));
    }, failed);
    await step('a rung that Enter has begun goes again when the cursor leaves it', async () => {
        await it.page.keyboard.press('Control+End');
        await it.type('\n');
        await it.until('the rung', async () => (await it.lines())[3] === '+--');
        await it.page.keyboard.press('ArrowUp');
        await it.until('it to go', async () => (await it.lines())[3] === '');
        await it.page.keyboard.press('Control+End');
        await it.page.keyboard.press('Backspace');
    }, failed);
    await step('what is wrong is underlined while a person types, and listed', async () => {
        await it.page.keyboard.press('Control+End');
        await it.type('\n[ ]( hot )--[SET]( y )--+');
        await it.page.keyboard.press('Control+Home');
        await it.page.locator('.cm-lintRange-error').first().waitFor();
        await it.tab('problems');
        await it.page.locator('.problems li', { hasText: 'SET' }).first().waitFor();
        await it.picture('problems');
    }, failed);
    await step('a fix is one press', async () => {
        await it.page.locator('.problems .fixes button').first().click();
        await it.until('the fix', async () => !(await it.lines()).join('\n').includes('[SET]'));
    }, failed);
    await step('the page of a rule is one press', async () => {
        await it.page.locator('#program .cm-content').click();
        await it.page.keyboard.press('Control+End');
        await it.type('\n+--[ ]( hot )--( )( hot )--+');
        await it.page.keyboard.press('Control+Home');
        const link = it.page.locator('.problems a', { hasText: 'double-coil' }).first();
        await link.waitFor();
        const [other] = await Promise.all([it.context.waitForEvent('page'), link.click()]);
        await other.waitForLoadState();
        assert.match(await other.title(), /double-coil/);
        await other.close();
    }, failed);
    await it.close().catch((error) => step('nothing strange happens while writing', () => Promise.reject(error)));

    it = await Playground.open(site, { text: '+--[ ]( a )--( )( y )--+' });
    await step('a program that takes the place of one in which a rung was begun is left as it is', async () => {
        // The server is there.
        await it.diagram.locator('g.element').first().waitFor();
        await it.page.locator('#program .cm-content').click();
        await it.page.keyboard.press('Control+End');
        await it.type('\n');
        await it.until('the rung', async () => (await it.lines()).at(-1) === '+--');
        await it.page.locator('#file').setInputFiles({ name: 'motor.clad', mimeType: 'text/plain', buffer: Buffer.from(MOTOR) });
        await it.page.locator('#tab-program', { hasText: 'motor' }).waitFor();
        await it.page.locator('#program .cm-content').focus();
        await it.page.keyboard.press('Control+End');
        await it.page.keyboard.press('ArrowUp');
        assert.equal((await it.lines()).join('\n'), MOTOR);
    }, failed);
    await it.close().catch((error) => step('nothing strange happens while another program is opened', () => Promise.reject(error)));

    it = await Playground.open(site, { text: '' });
    await step('a server that cannot be loaded is said, and loaded again', async () => {
        await it.page.route('**/ladder.wasm', (route) => route.abort());
        await it.page.reload();
        await it.page.locator('#failure', { hasText: 'The language server could not be loaded' }).waitFor();
        await it.page.unroute('**/ladder.wasm');
        await it.page.locator('#failure button').click();
        await it.page.locator('#program .cm-content').click();
        await it.page.keyboard.insertText('+--[ ]( a )--( )( y )--+');
        await it.diagram.locator('g.element').first().waitFor();
        // The browser says what it could not load.
        assert.ok(it.strange.every((words) => words.includes('ladder.wasm') || words.includes('ERR_FAILED')), it.strange.join('\n'));
        it.strange.length = 0;
    }, failed);
    await it.close().catch((error) => step('nothing strange happens while it is loaded again', () => Promise.reject(error)));

    it = await Playground.open(site, { text: MOTOR });
    await step('a hover explains a timer with its timing diagram', async () => {
        await it.page.locator('#program .cm-line span', { hasText: '[TON]' }).first().hover();
        const hover = it.page.locator('.cm-tooltip-hover');
        await hover.waitFor();
        const said = await hover.textContent();
        assert.match(said, /On-delay timer/);
        assert.match(said, /EN\s+[_-]{8,}/);
        await it.picture('hover');
        await it.page.mouse.move(5, 600);
    }, failed);
    await step('a link in a hover leads to the line that it names, in the text that it names', async () => {
        await it.tab('scenarios');
        await it.page.locator('#scenarios .cm-content').click();
        await it.page.keyboard.insertText('program test.clad\nstep 100ms\n\nscenario "s"\nstart _-\nrun => _-\n');
        await it.page.locator('#scenarios .cm-line span', { hasText: /^run$/ }).first().hover();
        const link = it.page.locator('.cm-tooltip-hover a[href*="#L4"]').first();
        await link.waitFor();
        await it.picture('hover in scenarios');
        await link.click();
        await it.until('the line of the program', async () => (await it.page.locator('#program .cm-activeLine').textContent()).includes('warmup'));
        assert.ok(await it.page.locator('#program').isVisible());
        await it.page.mouse.move(5, 600);
    }, failed);
    await step('rename reaches all places, and the drawing stays aligned', async () => {
        await it.cursor(1, 65);
        await it.until('the tag at the cursor', async () => (await it.lines())[0].includes('( run )'));
        const column = (await it.lines())[0].indexOf('run') + 1;
        await it.cursor(1, column);
        await it.page.keyboard.press('F2');
        await it.page.locator('.cm-lsp-rename-panel input').fill('motor_runs');
        await it.page.keyboard.press('Enter');
        await it.until('the other name', async () => (await it.lines()).join('\n').match(/motor_runs/g)?.length === 3);
        assert.ok((await it.lines()).filter((line) => line !== '').every((line) => line.length === 80), (await it.lines()).join('\n'));
    }, failed);
    await step('references are listed', async () => {
        await it.cursor(1, (await it.lines())[0].indexOf('motor_runs') + 1);
        await it.page.keyboard.press('Shift+F12');
        await it.page.locator('.cm-lsp-reference').first().waitFor();
        // Three in the program, one in the scenarios.
        assert.equal(await it.page.locator('.cm-lsp-reference').count(), 4);
        await it.picture('references');
        await it.page.keyboard.press('Escape');
    }, failed);
    await step('what can be drawn in another way is in a list at the cursor', async () => {
        await it.cursor(1, 9);
        await it.page.keyboard.press('Control+.');
        await it.page.locator('.menu[aria-label="What can be done here"] button').first().waitFor();
        await it.picture('actions');
        await it.page.keyboard.press('Escape');
    }, failed);
    await step('Format aligns the text', async () => {
        await it.page.locator('#program .cm-content').click();
        await it.page.keyboard.press('Control+a');
        await it.page.keyboard.insertText('+-[ ]( a )-( )( b )-+');
        await it.page.locator('#format').click();
        await it.until('the aligned text', async () => (await it.lines())[0] === `+--[ ]( a )${'-'.repeat(58)}( )( b )--+`);
    }, failed);
    await it.close().catch((error) => step('nothing strange happens while writing', () => Promise.reject(error)));
}
