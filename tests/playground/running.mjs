// Running: power and values in the text and the diagram, inputs by click and by key, steps, breakpoints, why, traces.
import assert from 'node:assert/strict';

import { Playground } from './page.mjs';
import { step } from './steps.mjs';

const MOTOR = `VAR_INPUT
    start, stop : BOOL;
    level       : INT;
END_VAR
VAR_OUTPUT  run, ready, full : BOOL;  END_VAR
VAR  warmup : TON;  END_VAR

+--\\--[ ]( start )--\\--[/]( stop )---------------------------------( )( run )--+
|  /--[ ]( run )----/                                                          |

+--[ ]( run )------------------------------[TON]( warmup, 5s )--( )( ready )--+

+--[GT]( level, 50 )-----------------------------------------------( )( full )--+
`;

/** What of a line has power, as it looks: the classes of its parts. */
const looks = (it, words) => it.page.locator('#program .cm-line', { hasText: words }).first().locator('.power').evaluateAll((all) => all.map((node) => node.className));

export async function running(site) {
    const it = await Playground.open(site, { text: MOTOR });
    const failed = (name) => it.picture(`failed ${name}`);
    const run = it.page.locator('#simulation .act-run');
    /** A coil has power, in the text. */
    const coilIs = (name, isOn) => it.until(`${name} to be ${isOn}`, () => it.page.locator('#program .cm-line', { hasText: `( )( ${name} )` }).first().evaluate((line, wanted) => {
        const node = [...line.querySelectorAll('.power')].findLast((part) => /\( \)|\( \w+ \)/.test(part.textContent));
        return node?.classList.contains('on') === wanted;
    }, isOn));
    await step('Run shows power in the text and in the diagram', async () => {
        await run.click();
        await it.standing('running');
        await it.until('power in the text', async () => (await looks(it, 'start )')).some((name) => name.includes('blocks')));
        await it.diagram.locator('.element.blocks').first().waitFor();
        await it.picture('running');
    }, failed);
    await step('a click on a contact in the text switches the input', async () => {
        await it.page.locator('.switch').first().click();
        await coilIs('run', true);
        await it.diagram.locator('g.element', { has: it.diagram.locator('text', { hasText: /^run$/ }) }).first().waitFor();
        await it.page.locator('.switch').first().click();
        await coilIs('run', true);
    }, failed);
    await step('a click on a contact in the diagram switches the input', async () => {
        const stop = it.diagram.locator('g.element', { has: it.diagram.locator('text', { hasText: /^stop$/ }) }).first();
        await stop.click();
        await coilIs('run', false);
        await stop.click();
        await it.picture('switched in the diagram');
    }, failed);
    await step('F4 at the cursor inverts the tag', async () => {
        await it.cursor(8, 14);
        await it.page.keyboard.press('F4');
        await coilIs('run', true);
        await it.page.keyboard.press('F4');
    }, failed);
    await step('a hover says in two lines what a tag holds and why, and more when it is asked for', async () => {
        await it.page.locator('#program .cm-line span', { hasText: /^ready$/ }).last().hover();
        const live = it.page.locator('.cm-tooltip-hover .live');
        await live.waitFor();
        const lines = await live.locator('p').allTextContents();
        assert.equal(lines.length, 2, lines.join('\n'));
        assert.match(lines[0], /^ready = [01]$/);
        const heights = await live.evaluate((node) => [...node.querySelectorAll('p')].map((line) => line.getClientRects().length && line.offsetHeight / parseFloat(getComputedStyle(line).lineHeight)));
        assert.ok(heights.every((height) => height < 1.9), heights.join());
        await it.picture('hover while it runs');
        await live.getByRole('button', { name: 'More' }).click();
        await it.page.locator('.cm-tooltip-hover', { hasText: /Written|Read/ }).waitFor();
        await it.page.locator('h1').hover();
        await it.until('the hover to go', async () => (await it.page.locator('.cm-tooltip-hover').count()) === 0);
    }, failed);
    await step('the list of tags switches, sets and forces', async () => {
        await it.tab('tags');
        const tags = it.page.locator('#tags');
        const field = tags.getByRole('textbox', { name: 'level' });
        await field.fill('60');
        await field.press('Enter');
        await coilIs('full', true);
        await tags.getByRole('switch', { name: 'stop' }).click();
        await coilIs('run', false);
        await tags.getByRole('switch', { name: 'stop' }).click();
        await tags.getByRole('button', { name: 'Force run', exact: true }).click();
        await it.standing('1 forced');
        await it.picture('tags');
        await tags.getByRole('button', { name: 'Force run', exact: true }).click();
        await it.until('the release', async () => !(await it.page.locator('#simulation .standing').textContent()).includes('forced'));
    }, failed);
    await step('values are above their operands, and no letter of the text has moved', async () => {
        const value = it.page.locator('.value', { hasText: '60' }).last();
        await value.waitFor();
        assert.equal((await it.lines()).join('\n').trimEnd(), MOTOR.trimEnd());
    }, failed);
    await step('why a tag holds what it holds is a tree that leads to the text', async () => {
        await it.page.locator('#tags').getByRole('button', { name: 'Why run', exact: true }).click();
        const row = it.page.locator('.why button', { hasText: 'start' }).first();
        await row.waitFor();
        await row.click();
        await it.picture('why');
        await it.until('the place in the text', async () => (await it.page.locator('#program .cm-activeLine').textContent()).includes('start'));
    }, failed);
    await step('traces are drawn, and their tags chosen', async () => {
        await it.tab('traces');
        await it.traces.locator('#rows tr').nth(1).waitFor();
        await it.traces.locator('#rows path.line').first().waitFor({ state: 'attached' });
        await it.traces.locator('#choose').click();
        await it.page.locator('#choice').getByRole('checkbox', { name: 'warmup.ET' }).check();
        await it.page.locator('#choice').getByRole('button', { name: 'Show' }).click();
        await it.traces.locator('#rows th', { hasText: 'warmup.ET' }).waitFor();
        await it.page.waitForTimeout(400);
        await it.picture('traces');
    }, failed);
    await step('it pauses, goes scan by scan, and back', async () => {
        await it.page.keyboard.press('F6');
        await it.standing('paused');
        const scan = async () => Number(/scan (\d+)/.exec(await it.page.locator('#simulation .standing').textContent())[1]);
        const before = await scan();
        await it.page.keyboard.press('F10');
        await it.until('the next scan', async () => (await scan()) === before + 1);
        await it.page.keyboard.press('Alt+F10');
        await it.until('the scan before', async () => (await scan()) === before);
    }, failed);
    await step('it goes block by block, and shows which one is next', async () => {
        await it.page.keyboard.press('F11');
        await it.page.locator('#program .next').waitFor();
        await it.picture('block by block');
    }, failed);
    await step('a breakpoint stops a run in front of its rung', async () => {
        await it.cursor(11, 3);
        await it.page.keyboard.press('F9');
        await it.page.locator('#program .breakpoint:visible').first().waitFor();
        await it.page.keyboard.press('F5');
        await it.page.locator('#message', { hasText: 'Stopped in front of the rung in line 11' }).waitFor();
        await it.standing('paused');
        await it.picture('breakpoint');
        await it.page.keyboard.press('F9');
        await it.page.keyboard.press('F5');
        await it.standing('running');
    }, failed);
    await step('the program is changed while it runs, and goes on with what it holds', async () => {
        await it.cursor(8, 14);
        await it.page.keyboard.press('F4');
        await coilIs('run', true);
        await it.page.keyboard.press('F4');
        await it.page.keyboard.press('Control+End');
        await it.type('+--[ ]( run )--( )( lamp )--+');
        await coilIs('lamp', true);
        await it.standing('running');
    }, failed);
    await step('Stop ends it, and nothing of it stays in the text', async () => {
        await it.page.keyboard.press('Shift+F5');
        await it.standing('at rest');
        await it.until('the text without power', async () => (await it.page.locator('#program .power, #program .value').count()) === 0);
    }, failed);
    await it.close().catch((error) => step('nothing strange happens while running', () => Promise.reject(error)));
}
