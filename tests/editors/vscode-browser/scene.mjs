// A scene beside the text: opened from the program and from the drawing, moved by the simulation, pressed, and shown again when it is edited.
import assert from 'node:assert/strict';

import { command, cursorTo, open } from './palette.mjs';

/** The machine: the names of its files in the project, and their texts. */
export const MACHINE = {
    'filled.clad': 'VAR_INPUT\n    stop : BOOL;\nEND_VAR\nVAR_OUTPUT\n    fill : BOOL;\nEND_VAR\nVAR\n    level : INT;\nEND_VAR\n\n+--[/]( stop )--------------------------------------------------( )( fill )--+\n+--[ ]( fill )--[LT]( level, 1000 )--[ADD]( level, level, 1 )--+\n',
    'filled.scene.svg': `<svg xmlns="http://www.w3.org/2000/svg" xmlns:l="https://ladder.example/scene" viewBox="0 0 200 100" l:program="filled.clad">
<title>A tank</title>
<desc>It fills up.</desc>
<text x="20" y="40" l:text="level" l:unit="ml">0 ml</text>
<g l:toggle="stop" l:alt="stop"><rect x="100" y="10" width="60" height="30" fill="#c33"/></g>
</svg>
`,
};

export async function scene(page, { step, until, screenshot }) {
    let frame;
    const show = () =>
        until('the scene', async () => {
            const frames = await Promise.all(page.frames().map(async (found) => [found, await found.title().catch(() => '')]));
            frame = frames.find(([, title]) => title === 'A tank')?.[0];
            return frame !== undefined && (await frame.locator('.picture svg').isVisible());
        });
    const level = async () => Number.parseInt(await frame.locator('.picture text').textContent(), 10);
    await step('a scene is opened beside its drawing, with findings, and is shown again when that is edited', async () => {
        await open(page, 'filled.scene.svg');
        await command(page, 'Ladder: Open Scene to the Side');
        await show();
        await page.locator('.monaco-editor .view-line', { hasText: '<svg' }).first().click();
        await cursorTo(page, 4, 31);
        await page.keyboard.type('l');
        await page.locator('.squiggly-error').first().waitFor();
        await page.keyboard.press('Backspace');
        await page.locator('.squiggly-error').first().waitFor({ state: 'detached' });
        await cursorTo(page, 2, 14);
        await page.keyboard.type(' here');
        await until('the title', async () => (await frame.title()) === 'A tank here');
        await page.keyboard.press('Control+Z');
        await until('the title as it was', async () => (await frame.title()) === 'A tank');
    });
    await step('it moves when its program runs', async () => {
        await open(page, 'filled.clad');
        await command(page, 'Ladder: Open Scene to the Side');
        assert.equal(await level(), 0);
        await frame.getByRole('button', { name: 'Run' }).click();
        await until('the level', async () => (await level()) > 20);
        await screenshot(page, 'scene');
    });
    await step('what is pressed in it reaches the program', async () => {
        await frame.getByRole('switch', { name: 'stop' }).click();
        await until('the switch', async () => (await frame.getByRole('switch', { name: 'stop' }).getAttribute('aria-checked')) === 'true');
        await until('rest', async () => {
            const before = await level();
            await new Promise((resolve) => setTimeout(resolve, 300));
            return (await level()) === before;
        });
        await frame.getByRole('button', { name: 'Pause' }).click();
        await page.getByText('Ladder: paused').waitFor();
        await page.locator('.monaco-editor .view-line').first().click();
        await page.keyboard.press('Shift+F5');
        await page.getByText('Ladder: paused').waitFor({ state: 'detached' });
    });
}
