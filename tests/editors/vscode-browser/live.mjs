// A program that runs, in the text: what contacts do, and what a line of 100 columns shows.
import assert from 'node:assert/strict';

import { command, cursorTo, open } from './palette.mjs';

/** The program: its name in the project, and its text. */
export const LIVE = 'plant.clad';
export const LIVE_TEXT = `VAR_INPUT  go, hold : BOOL;  END_VAR
VAR CONSTANT  LIMIT : INT := 80;  END_VAR
VAR  seconds : TON;  END_VAR
VAR_OUTPUT  out, late : BOOL;  END_VAR
+--[ ]( go )--[/]( hold )--[ ]( go )-----------------------------------------------( )( out )--+

+--[ ]( out )---------------------------------------------------[TON]( seconds, T#1h )--( )( late )--+
`;
const RUNG = '+--[ ]( go )';

const GREY = 'rgb(139, 139, 139)';
const ORANGE = 'rgb(240, 180, 90)';

export async function live(page, { step, until, weights, labels, operandBox, row }) {
    const rung = async () => (await weights(page, RUNG)).filter(({ text }) => text.trim() !== '');
    const bold = async () => (await rung()).filter((part) => part.bold).map(({ text }) => text).join('').replaceAll(' ', '');
    await step('a value at the end of a line of 100 columns can be seen', async () => {
        await open(page, LIVE);
        await page.locator('.monaco-editor .view-line', { hasText: 'VAR_INPUT' }).first().click();
        await command(page, 'Ladder: Start Simulation');
        await page.getByText('Ladder: paused, scan 0').waitFor();
        await cursorTo(page, 5, 5);
        await page.keyboard.press('F4');
        await row(page, 'go').getByText('1', { exact: true }).waitFor();
        for (let scan = 1; scan <= 3; scan += 1) {
            await page.keyboard.press('F10');
            await page.getByText(`Ladder: paused, scan ${scan}`).waitFor();
        }
        await until('the value', async () => (await labels(page, '20ms')).length === 1);
        const [box] = await labels(page, '20ms');
        const { visibleTo } = await operandBox(page, 'hold');
        assert.ok(box.left + box.width < visibleTo, 'it lies under the minimap');
    });
    await step('while a program runs that looks the same from state to state the page is left alone', async () => {
        const inspector = await page.context().newCDPSession(page);
        let messages = 0;
        inspector.on('Network.webSocketFrameReceived', () => (messages += 1));
        await page.keyboard.press('F5');
        await page.getByText('Ladder: running').waitFor();
        await inspector.send('Network.enable');
        await new Promise((resolve) => setTimeout(resolve, 4000));
        await inspector.detach();
        await page.keyboard.press('F6');
        await page.getByText('Ladder: paused').waitFor();
        // Values, the status bar and the view of tags come some five times a second; states come thirty times.
        assert.ok(messages >= 8 && messages < 80, `${messages} messages in 4 s`);
    });
    await step('a constant offers no force', async () => {
        await row(page, 'LIMIT').hover();
        assert.equal(await row(page, 'LIMIT').locator('.codicon-lock, .codicon-edit').count(), 0);
        if (!(await row(page, 'seconds.ET').isVisible())) {
            await row(page, 'secondsQ=').click();
        }
        await row(page, 'seconds.ET').hover();
        await row(page, 'seconds.ET').locator('.codicon-lock').waitFor();
    });
    await step('a contact that holds up the power is neither as one that lets it through nor as one without', async () => {
        await cursorTo(page, 5, 16);
        await page.keyboard.press('F4');
        await row(page, 'hold').getByText('1', { exact: true }).waitFor();
        await page.keyboard.press('F10');
        await until('no power after the contact', async () => (await bold()) === '+--[](go)--');
        const parts = (await rung()).map(({ text, bold, line, color }) => {
            const look = bold ? 'power' : color === ORANGE ? 'blocks' : color === GREY ? 'none' : 'passes';
            return `${text.trim()} ${look}${line.includes('underline') ? ' underlined' : ''}`;
        });
        const looks = (wanted) => parts.filter((part) => part.includes(wanted)).map((part) => part.replace(/^.* (?=power|blocks|none|passes)/, ''));
        assert.ok(looks('hold').every((look) => look === 'blocks'), parts.join('; '));
        assert.deepEqual([...new Set(looks('go'))], ['power underlined', 'passes underlined'], parts.join('; '));
        assert.ok(looks('out').every((look) => look === 'none'), parts.join('; '));
    });
    await page.locator('.monaco-editor .view-line', { hasText: 'VAR_INPUT' }).first().click();
    await page.keyboard.press('Shift+F5');
}
