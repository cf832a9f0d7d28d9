// The diagram next to the text, as a user uses it: what is drawn, clicked and typed there.
import assert from 'node:assert/strict';

import { command, cursorTo, open } from './palette.mjs';

/** The page of the diagram that is in sight: a frame in a frame. */
export async function diagramOf(page, until) {
    let found;
    await until('the diagram', async () => {
        for (const frame of page.frames()) {
            const isDiagram = await frame.evaluate(() => document.querySelector('.view')?.checkVisibility()).catch(() => false);
            const isShown = isDiagram && (await frame.frameElement().then((element) => element.isVisible()).catch(() => false));
            // A frame may be exchanged while it is asked.
            if (isShown && (await frame.locator('g.element').count().catch(() => 0)) > 0) {
                found = frame;
                return true;
            }
        }
        return false;
    });
    return found;
}

/** The diagram that has this operand: the frame of the one before may be in sight for a while. */
async function diagramWith(page, until, operand) {
    let frame;
    await until(`the diagram with ${operand}`, async () => {
        frame = await diagramOf(page, until);
        const names = await frame.locator('g.element text').allTextContents().catch(() => []);
        return names.includes(operand);
    });
    return frame;
}

/** The element whose operand this is, on the first rung that has it. */
const element = (frame, operand, kind = 'contact') =>
    frame.locator(`g.element.${kind}`, { has: frame.locator('text', { hasText: new RegExp(`^${operand}$`) }) }).first();

const words = (frame, operand, kind) => element(frame, operand, kind).getAttribute('aria-label');

/** A click on the symbol, not on its name. */
const press = (frame, operand) => element(frame, operand).locator('.gate').click({ force: true });

/** Opens a file in the first group: diagrams are in the second. */
async function openFirst(page, name) {
    await page.keyboard.press('Control+1');
    await open(page, name);
}

/** The line of the network that has this operand, as its number next to it says. */
async function lineOf(frame, operand) {
    const piece = frame.locator('.piece', { has: frame.locator('text', { hasText: new RegExp(`^${operand}$`) }) }).first();
    return Number(await piece.locator('.gutter').textContent());
}

/** Programs that the steps need besides. */
export const programs = {
    'level.clad': 'VAR_INPUT  level : INT;  END_VAR\n+--[GT]( level, 50 )--( )( high )--+\n',
    'long.clad': Array.from({ length: 10_000 }, (_, index) => `+--[ ]( a${index} )--[/]( b )--( )( c${index} )--+\n`).join(''),
};

export async function diagram(page, { step, until, screenshot }) {
    let frame;
    await step('the diagram is next to the text, and shows the power', async () => {
        await openFirst(page, 'motor.clad');
        // A hint at a tab would lie over the diagram.
        await page.mouse.move(0, 0);
        // Another part may have left one.
        if ((await page.getByText(/Ladder: (paused|running), scan/).count()) > 0) {
            await command(page, 'Ladder: Stop Simulation');
        }
        await command(page, 'Ladder: Open Diagram to the Side');
        frame = await diagramOf(page, until);
        assert.equal(await frame.locator('.on, .off').count(), 0, 'nothing runs');
        await frame.locator('button.start').click();
        await frame.locator('button.step').waitFor();
        await press(frame, 'start');
        await until('start', async () => /start is 1$/.test(await words(frame, 'start')));
        await frame.locator('button.step').click();
        await frame.locator('line.on').first().waitFor({ state: 'attached' });
        const look = (selector) =>
            frame.locator(selector).first().evaluate((line) => {
                const { strokeWidth, strokeDasharray } = getComputedStyle(line);
                return { width: parseFloat(strokeWidth), dash: strokeDasharray };
            });
        const [on, rail] = [await look('line.on'), await look('line.rail')];
        assert.ok(on.width > 3 && on.dash === 'none' && rail.width >= 3, JSON.stringify({ on, rail }));
        assert.match(await words(frame, 'start'), /^Open contact start, lets power through, power flows, start is 1$/);
        await screenshot(page, 'diagram');
    });
    await step('the page runs no script but its own, and takes nothing from elsewhere', async () => {
        const found = await frame.evaluate(async () => {
            const policy = document.querySelector('meta[http-equiv]')?.content ?? '';
            const script = document.createElement('script');
            script.textContent = 'window.strange = true';
            document.body.append(script);
            const answer = await fetch('data:text/plain,x').then(() => 'fetched', () => 'refused');
            return { policy, strange: window.strange === true, answer };
        });
        assert.match(found.policy, /^default-src 'none'; style-src [^;']*('self')?[^;']*; script-src 'nonce-[0-9a-f]{32}'$/);
        assert.deepEqual([found.strange, found.answer], [false, 'refused']);
    });
    await step('a click on an input inverts it, in the text too', async () => {
        await press(frame, 'stop');
        await until('stop in the diagram', async () => /stop is 1$/.test(await words(frame, 'stop')));
        await command(page, 'Ladder: Step One Scan');
        await until('no power after it', async () => /blocks the power that comes/.test(await words(frame, 'stop')));
        await page.locator('.monaco-editor .view-line span', { hasText: 'stop' }).first().waitFor();
        const off = await frame.locator('line.off').first().evaluate((line) => getComputedStyle(line).strokeDasharray);
        assert.notEqual(off, 'none');
        await press(frame, 'stop');
        await until('stop again', async () => /stop is 0$/.test(await words(frame, 'stop')));
    });
    await step('who holds a button down lets it go again', async () => {
        const box = await element(frame, 'stop').locator('.hit').boundingBox();
        await page.mouse.move(box.x + box.width / 2, box.y + box.height - 10);
        await page.mouse.down();
        await until('stop', async () => /stop is 1$/.test(await words(frame, 'stop')));
        await page.mouse.up();
        await until('stop again', async () => /stop is 0$/.test(await words(frame, 'stop')));
    });
    await step('the keyboard goes from element to element, forces, pulses and steps', async () => {
        const here = () => frame.evaluate(() => document.activeElement?.getAttribute('aria-label') ?? '');
        await element(frame, 'start').focus();
        await page.keyboard.press('f');
        await until('the force', async () => /start is 1, forced$/.test(await here()));
        assert.equal(await element(frame, 'start').locator('.badge').textContent(), 'F');
        await page.keyboard.press('Enter');
        await until('the other value', async () => /start is 0, forced$/.test(await here()));
        await frame.locator('.standing', { hasText: '1 forced' }).waitFor();
        await page.keyboard.press('f');
        // What was given before the force counts again.
        await until('no force', async () => /start is 1$/.test(await here()));
        await page.keyboard.press('p');
        await until('the pulse', async () => /start is 0$/.test(await here()));
        await page.keyboard.press('F10');
        await until('its end', async () => /start is 1$/.test(await here()));
        await page.keyboard.press('F10');
        await until('the motor', async () => (await words(frame, 'run', 'coil')) === 'Coil run, has power, run is 1');
        await page.keyboard.press('ArrowRight');
        assert.match(await here(), /^Closed contact stop/);
        await page.keyboard.press('ArrowDown');
        assert.match(await here(), /^Open contact run/);
    });
    await step('the menu of an element forces it, and says why', async () => {
        const choose = async (name) => {
            await element(frame, 'stop').locator('.gate').click({ button: 'right', force: true });
            await page.getByRole('menuitem', { name }).waitFor();
            // A menu that has just appeared takes no click yet.
            await page.waitForTimeout(400);
            await page.getByRole('menuitem', { name }).click();
        };
        await choose('Force On');
        await until('the force', async () => /stop is 1, forced$/.test(await words(frame, 'stop')));
        await choose('Release Force');
        await until('no force', async () => /stop is 0$/.test(await words(frame, 'stop')));
        const marks = page.locator('.codicon-debug-breakpoint');
        await choose('Toggle Breakpoint');
        await until('the mark of a breakpoint', async () => (await marks.count()) > 0);
        await choose('Toggle Breakpoint');
        await until('no mark', async () => (await marks.count()) === 0);
    });
    await step('a click on a name shows it in the text, and the cursor of the text its element', async () => {
        await frame.locator('text', { hasText: /^lamp$/ }).first().click();
        await page.locator('.monaco-editor .selected-text').first().waitFor({ state: 'attached' });
        assert.equal(await page.getByText(/Ln \d+, Col \d+/).count(), 0, 'the cursor is still in the diagram');
        await frame.locator('text', { hasText: /^lamp$/ }).first().dblclick();
        await page.getByText(/Ln \d+, Col \d+ \(4 selected\)/).waitFor();
        await cursorTo(page, await lineOf(frame, 'start'), 10);
        await until('the element at the cursor', async () => {
            const marked = await frame.locator('g.element.cursor').evaluateAll((found) => found.map((one) => one.getAttribute('aria-label')));
            return marked.length === 1 && /^Open contact start/.test(marked[0]);
        });
    });
    await step('an edit draws one network again', async () => {
        await frame.evaluate(() => document.querySelectorAll('.piece').forEach((piece) => (piece.old = true)));
        await cursorTo(page, await lineOf(frame, 'lamp'), 9);
        await page.keyboard.type('x');
        const isNew = () => frame.evaluate(() => [...document.querySelectorAll('.piece')].map((piece) => !piece.old));
        await until('the network', async () => (await isNew()).filter(Boolean).length === 1);
        assert.ok((await isNew()).length > 2);
        await frame.locator('text', { hasText: /^xrun$/ }).waitFor();
        await page.keyboard.press('Control+Z');
        await frame.locator('text', { hasText: /^xrun$/ }).waitFor({ state: 'detached' });
    });
    await step('a network that is half typed stays as it was', async () => {
        await cursorTo(page, await lineOf(frame, 'lamp'), 4);
        // The first bracket goes.
        await page.keyboard.press('Delete');
        await frame.locator('.piece.held g.element').first().waitFor();
        assert.equal(await frame.locator('.piece.held text', { hasText: /^lamp$/ }).count(), 1);
        await page.keyboard.press('Control+Z');
        await until('the drawing', async () => (await frame.locator('.piece.held').count()) === 0);
    });
    await step('an error that swallows all networks below it leaves them as they were', async () => {
        await cursorTo(page, await lineOf(frame, 'start'), 1);
        await page.keyboard.type('# ');
        await until('two networks as they were', async () => (await frame.locator('.piece.held g.element').count()) >= 5);
        assert.equal(await frame.locator('.piece.held text', { hasText: /^lamp$/ }).count(), 1);
        await screenshot(page, 'diagram-held');
        await page.keyboard.press('Backspace');
        await page.keyboard.press('Backspace');
        await until('the drawings', async () => (await frame.locator('.piece.held').count()) === 0);
    });
    await step('a number is set below the drawing', async () => {
        await openFirst(page, 'level.clad');
        await command(page, 'Ladder: Open Diagram to the Side');
        frame = await diagramWith(page, until, 'level');
        await frame.locator('button.start').click();
        await frame.locator('button.step').waitFor();
        await frame.locator('g.element.contact .gate').click({ force: true });
        const field = frame.locator('.inspector input[type="text"]');
        await field.fill('60');
        await field.press('Enter');
        await frame.locator('text.value', { hasText: /^60$/ }).waitFor();
        assert.equal(await frame.locator('.inspector input[type="range"]').inputValue(), '60');
        await frame.locator('button.step').click();
        await until('power at the coil', async () => /has power/.test(await words(frame, 'high', 'coil')));
        await screenshot(page, 'diagram-number');
        await frame.locator('button.stop').click();
        await frame.locator('button.start').waitFor();
    });
    await step('of 10,000 rungs those are drawn that are in sight', async () => {
        await openFirst(page, 'long.clad');
        await page.locator('.monaco-editor .view-line', { hasText: 'a0' }).first().click();
        await command(page, 'Ladder: Open Diagram to the Side');
        frame = await diagramWith(page, until, 'a0');
        const drawn = () => frame.locator('.piece').count();
        assert.ok((await drawn()) < 60, `${await drawn()} networks are on the page`);
        await frame.evaluate(() => (document.querySelector('.view').scrollTop = 200_000));
        const lines = () => frame.locator('.gutter').allTextContents();
        await until('the middle', async () => (await lines()).some((line) => Number(line) > 4000));
        assert.ok((await drawn()) < 60, `${await drawn()} networks are on the page`);
        await screenshot(page, 'diagram-long');
    });
    await step('the diagrams are there again after a reload', async () => {
        await page.reload();
        await page.locator('.monaco-workbench').waitFor();
        frame = await diagramOf(page, until);
        assert.ok((await frame.locator('g.element').count()) > 0);
        await screenshot(page, 'diagram-reload');
    });
}
