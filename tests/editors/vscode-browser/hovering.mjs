// A value under the pointer while a program runs as fast as it goes. A line that the editor draws again while the pointer
// comes it takes for one that the pointer has left, and shows nothing: a hand that then holds still sees no value.
import assert from 'node:assert/strict';

import { command, open } from './palette.mjs';

const ROW = (name) => `+--[/]( ${name} )--( )( ${name} )--+`;

/** The program: its name in the project, and its text. Every contact and coil changes with each scan. */
export const HOVERED = 'flicker.clad';
export const HOVERED_TEXT = `${Array.from({ length: 12 }, (_, number) => ROW(`flip${number}`)).join('\n')}

+--[/]( late )--[TON]( since, T#1h )--( )( late )--+

${ROW('last')}
`;

/** So often the pointer comes, once each time. */
const TIMES = 20;

export async function hovering(page, { step, until, screenshot }) {
    const line = (text) => page.locator('.editor-instance .view-line', { hasText: text }).first();
    const hover = (text) => page.locator('.monaco-hover:visible', { hasText: text }).first();
    /** Where a text is on the page. */
    const placeOf = async (name) => {
        const span = line(`( ${name}`).locator('> span');
        let box;
        // A line that is drawn again just then has no place.
        await until(`the place of ${name}`, async () => (box = await span.boundingBox()) !== null);
        const { x, y, width } = box;
        const text = await span.textContent();
        return { x: x + (width / text.length) * (text.indexOf(name) + 1.5), y: y + 9 };
    };
    /** How often a value is shown of all the times that the pointer comes to a name. */
    const shown = async (name, value) => {
        const { x, y } = await placeOf(name);
        let count = 0;
        for (let time = 0; time < TIMES; time += 1) {
            await page.mouse.move(2, 2);
            await page.keyboard.press('Escape');
            await page.locator('.monaco-hover:visible').first().waitFor({ state: 'detached' });
            await page.mouse.move(x, y);
            // However long it takes on a busy machine: to a hand that was lost nothing comes.
            count += await hover(value).waitFor().then(() => 1, () => 0);
        }
        await page.mouse.move(2, 2);
        return count;
    };
    await open(page, HOVERED);
    await line('since').click();
    await command(page, 'Ladder: Start Simulation');
    await page.getByText('Ladder: paused, scan 0').waitFor();
    await line('since').click();
    await command(page, 'Ladder: Set Speed of the Simulation...');
    await page.locator('.quick-input-title', { hasText: 'Speed of the Simulation' }).waitFor();
    await page.keyboard.type('max');
    await page.keyboard.press('Enter');
    await line('since').click();
    await page.keyboard.press('F5');
    await page.getByText('full speed').waitFor();
    await page.waitForTimeout(2000);
    await screenshot(page, 'flicker');
    for (const [what, name, value] of [
        ['contact that changes with each scan', 'flip6', /flip6 = [01]/],
        ['timer whose value is above its line', 'since', /since\.ET = (T#)?\d/],
    ]) {
        await step(`one movement of the pointer shows the value of a ${what}, each of ${TIMES} times`, async () => {
            assert.equal(await shown(name, value), TIMES);
        });
    }
    await step('what changes with each scan has a dotted line while it runs, and is as it is when it does not', async () => {
        await page.getByText('full speed').waitFor();
        const parts = () =>
            line('flip6').evaluate((node) =>
                [...node.querySelectorAll('span > span')].map((span) => {
                    const { textDecorationLine, textDecorationStyle, fontWeight } = getComputedStyle(span);
                    const look = textDecorationLine === 'none' ? '' : `${textDecorationStyle} `;
                    return `${span.textContent.replaceAll('\u00a0', ' ')} ${look}${Number(fontWeight) >= 600 ? 'bold' : 'thin'}`;
                }),
            );
        const dotted = async () => (await parts()).filter((part) => part.includes('dotted')).map((part) => part.replace(/ dotted.*/, '')).join('');
        await until('the dotted line', async () => (await dotted()) === '[/]( flip6 )--( )( flip6 )--+');
        await line('since').click();
        await page.keyboard.press('F6');
        await page.getByText('Ladder: paused').waitFor();
        await until('no dotted line', async () => (await dotted()) === '');
        // The view of the tags is drawn a moment later than the text.
        await until('the coil as its tag', async () => {
            const isOn = (await page.locator('.monaco-list-row', { hasText: 'flip6' }).first().textContent()).endsWith('1');
            return (isOn ? /bold$/ : /thin$/).test((await parts()).at(-1));
        });
    });
    await step('the hover of a program that is paused is its value and why, and all of it when that is asked for', async () => {
        const { x, y } = await placeOf('late');
        await page.mouse.move(x, y);
        await hover(/late = 0/).waitFor();
        const text = async () => (await page.locator('.monaco-hover:visible').allTextContents()).join(' ');
        await until('why', async () => /late is 0/.test(await text()));
        assert.doesNotMatch(await text(), /BOOL/);
        await screenshot(page, 'hover-brief');
        await page.locator('.monaco-hover:visible a', { hasText: 'More' }).click();
        await hover(/BOOL/).waitFor();
        await screenshot(page, 'hover-more');
        await page.mouse.move(2, 2);
        await page.keyboard.press('Escape');
        await page.locator('.monaco-hover:visible').first().waitFor({ state: 'detached' });
    });
    await line('since').click();
    await page.keyboard.press('Shift+F5');
}
