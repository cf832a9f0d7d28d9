// For those who work with the keyboard, hear the page, or see few colours: the diagram and the trace, and where keys are listed.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';

import { diagramOf } from './diagram.mjs';
import { command, cursorTo, open } from './palette.mjs';

/** The program: its name in the project, and its text. */
export const SEEN = 'seen.clad';
export const SEEN_TEXT = `VAR_INPUT  go, hold : BOOL;  level : INT;  END_VAR
VAR  warm : TON;  END_VAR
VAR_OUTPUT  out, lamp : BOOL;  END_VAR
+--[ ]( go )--[/]( hold )--[ ]( go )-------( )( out )--+

+--[GT]( level, 50 )--[TON]( warm, T#1h )--( )( lamp )--+
`;

const THEMES = ['Default Dark Modern', 'Default Light Modern', 'Default High Contrast', 'Default High Contrast Light'];

/** What has to be clear against its background, and how well: text by 4.5 to 1, lines and shapes by 3. */
const DIAGRAM = [
    ['line.on', 'stroke', 3],
    ['line.off', 'stroke', 3],
    ['line.rail', 'stroke', 3],
    ['.element.blocks > .line', 'stroke', 3],
    ['.element.forced .hit', 'stroke', 3],
    ['.element:focus .hit', 'stroke', 3],
    ['.badge rect', 'fill', 3],
    ['.element text[data-operand]', 'fill', 4.5],
    ['.value', 'fill', 4.5],
    ['.pin', 'fill', 4.5],
    ['.standing', 'color', 4.5],
    ['button.run', 'color', 4.5],
    ['.inspector .is', 'color', 4.5],
    ['.inspector .type', 'color', 4.5],
    ['.inspector button', 'color', 4.5],
    ['.inspector input[type="range"]', 'accentColor', 3],
];
const TRACE = [
    ['tr.bit .line', 'stroke', 3],
    ['tr.number .line', 'stroke', 3],
    ['line.cursor.A', 'stroke', 3],
    ['line.cursor.B', 'stroke', 3],
    ['text.tick', 'fill', 4.5],
    ['td.now', 'color', 4.5],
    ['thead th', 'color', 4.5],
    ['td.reading.A', 'color', 4.5],
    ['td.reading.B', 'color', 4.5],
    ['#place', 'color', 4.5],
    ['#fit', 'color', 4.5],
];

/** The colour of the first of each kind, and that of its background. */
function colours(frame, kinds) {
    return frame.evaluate((wanted) => {
        const isSeen = (colour) => !/^rgba\(.*, 0(\.[0-4]\d*)?\)$/.test(colour);
        const ground = (node) => {
            for (let at = node; at; at = at.parentElement) {
                const back = getComputedStyle(at).backgroundColor;
                if (isSeen(back)) {
                    return back;
                }
            }
            return undefined;
        };
        return wanted.map(([selector, property, least]) => {
            const node = document.querySelector(selector);
            // What a slider is at is on the ground of the page.
            const back = node && ground(property === 'accentColor' ? node.parentElement : node);
            return { selector, least, front: node && getComputedStyle(node)[property], back };
        });
    }, kinds);
}

/** How well two colours are told apart, from 1 to 21. */
function contrast(front, back) {
    const luminance = (colour) => {
        const parts = colour.match(/\d+(\.\d+)?/g).slice(0, 3).map((part) => Number(part) / 255);
        const [red, green, blue] = parts.map((part) => (part <= 0.03928 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4));
        return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
    };
    const [light, dark] = [luminance(front), luminance(back)].sort((a, b) => b - a);
    return (light + 0.05) / (dark + 0.05);
}

/** Of colours those that are not clear enough against their background, in words. */
function faint(all) {
    return all.flatMap(({ selector, least, front, back }) => {
        if (!front || !back || front === 'none') {
            return [`${selector}: ${front} on ${back}`];
        }
        const found = contrast(front, back);
        return found >= least ? [] : [`${selector}: ${front} on ${back} is ${found.toFixed(1)}`];
    });
}

/** What can have the focus in a page, by Tab alone, in its order: role and name. */
async function reached(page, frame) {
    const here = () =>
        frame.evaluate(() => {
            const node = document.activeElement;
            const name = node?.getAttribute('aria-label') ?? (node?.textContent || node?.title) ?? '';
            return document.hasFocus() && node !== document.body ? { tag: node.tagName.toLowerCase(), id: node.id || node.className?.baseVal || node.className, name: name.trim() } : undefined;
        });
    // The first in the order of the page.
    await frame.evaluate((selector) => [...document.querySelectorAll(selector)].find((node) => node.checkVisibility() && !node.disabled).focus(), CONTROLS);
    const found = [await here()];
    for (let tries = 0; tries < 40; tries += 1) {
        await page.keyboard.press('Tab');
        const next = await here();
        if (!next || (next.id === found[0].id && next.name === found[0].name)) {
            return found;
        }
        found.push(next);
    }
    return found;
}

const CONTROLS = 'button, input, select, textarea, a[href], [tabindex="0"]';

/** All that can be pressed or typed into, and is in sight. */
function controls(frame) {
    return frame.evaluate((selector) => {
        const all = [...document.querySelectorAll(selector)];
        const shown = all.filter((node) => node.checkVisibility() && !node.disabled);
        return shown.map((node) => (node.getAttribute('aria-label') ?? (node.textContent || node.title) ?? '').trim());
    }, CONTROLS);
}

/** Of a page a script and a style that nobody let in, and a word from elsewhere: what became of them. */
export function strangers(frame) {
    return frame.evaluate(async () => {
        const script = document.createElement('script');
        script.textContent = 'window.strange = true';
        document.body.append(script);
        const style = document.createElement('style');
        style.textContent = 'body { outline-width: 7px !important; outline-style: solid !important; }';
        document.head.append(style);
        const plain = document.createElement('div');
        plain.setAttribute('style', 'outline-width: 9px; outline-style: solid');
        plain.setAttribute('onclick', 'window.strange = true');
        document.body.append(plain);
        plain.click();
        const found = {
            script: window.strange === true,
            style: getComputedStyle(document.body).outlineWidth === '7px',
            attribute: getComputedStyle(plain).outlineWidth === '9px',
            fetched: await fetch('data:text/plain,x').then(() => true, () => false),
        };
        [script, style, plain].forEach((node) => node.remove());
        return found;
    });
}

const NONE = { script: false, style: false, attribute: false, fetched: false };

export async function access(page, { step, until, weights, row, screenshot, useTheme }) {
    let diagram;
    let trace;
    /** The page of the trace: the one with its table. */
    const traceOf = async () => {
        await until('the trace', async () => {
            for (const frame of page.frames()) {
                if (await frame.evaluate(() => document.querySelector('#rows .line') !== null).catch(() => false)) {
                    trace = frame;
                    return true;
                }
            }
            return false;
        });
        return trace;
    };
    await step('a program with all that can be seen of it', async () => {
        await open(page, SEEN);
        await page.locator('.monaco-editor .view-line', { hasText: 'VAR_INPUT' }).first().click();
        await command(page, 'Ladder: Open Diagram to the Side');
        diagram = await diagramOf(page, until);
        await diagram.locator('button.start').click();
        await page.getByText('Ladder: paused, scan 0').waitFor();
        await page.keyboard.press('Control+1');
        for (const column of [9, 20]) {
            await cursorTo(page, 4, column);
            await page.keyboard.press('F4');
        }
        await row(page, 'hold').getByText('1', { exact: true }).waitFor();
        await cursorTo(page, 6, 14);
        await command(page, 'Ladder: Force Tag...');
        await page.locator('.quick-input-title', { hasText: 'Force level' }).waitFor();
        await page.keyboard.type('60');
        await page.keyboard.press('Enter');
        await page.getByText('1 forced').first().waitFor();
        await cursorTo(page, 1, 1);
        for (let scan = 1; scan <= 3; scan += 1) {
            await page.keyboard.press('F10');
            await page.getByText(`Ladder: paused, scan ${scan},`).waitFor();
        }
        if (!(await row(page, 'warm.ET').isVisible())) {
            await row(page, 'warmQ=').click();
        }
        await row(page, 'warm.ET').hover();
        await row(page, 'warm.ET').locator('.codicon-pulse').click();
        await traceOf();
        await trace.locator('#trace').focus();
        for (const key of ['Home', 'b', 'ArrowRight']) {
            await page.keyboard.press(key);
        }
        await trace.locator('line.cursor.B').first().waitFor({ state: 'attached' });
        await diagram.locator('.value', { hasText: '60' }).waitFor();
        await screenshot(page, 'access');
    });
    await step('a value that the text and a diagram show is in the text once', async () => {
        const shown = await page.evaluate(() => {
            const spans = [...document.querySelectorAll('.editor-instance .view-line span > span')];
            return spans.map((span) => getComputedStyle(span, '::before').content).filter((content) => content.includes('60'));
        });
        // Besides that after its declaration.
        assert.deepEqual(shown.toSorted(), ['"60!"', '"level=60!"']);
    });
    await step('the values of the diagram are above their operands', async () => {
        for (const name of ['level', 'warm']) {
            const part = diagram.locator('g.element', { has: diagram.locator('text', { hasText: new RegExp(`^${name}$`) }) }).first();
            const [value, operand] = [part.locator('.value').first(), part.locator('text', { hasText: new RegExp(`^${name}$`) }).first()];
            const [above, below] = [await value.boundingBox(), await operand.boundingBox()];
            assert.ok(above.y + above.height <= below.y + 4 && above.y > below.y - 30, JSON.stringify({ name, above, below }));
        }
    });
    await step('neither page takes a script, a style or anything else that the extension did not bring', async () => {
        assert.deepEqual(await strangers(diagram), NONE);
        assert.deepEqual(await strangers(trace), NONE);
    });
    await step('Tab reaches all that can be pressed in the diagram, and all of it has a name', async () => {
        await diagram.locator('g.element', { has: diagram.locator('text', { hasText: /^level$/ }) }).first().focus();
        await diagram.locator('.inspector input[type="range"]').waitFor();
        const [there, found] = [await controls(diagram), await reached(page, diagram)];
        assert.deepEqual(found.map(({ name }) => name), there);
        assert.deepEqual(found.filter(({ name }) => name === ''), []);
        const heard = await diagram.locator('body').ariaSnapshot();
        assert.match(heard, /toolbar "Simulation"/);
        assert.match(heard, /group "Network in line 4"/);
        assert.match(heard, /button "Closed contact hold, blocks the power that comes, hold is 1"/);
        assert.match(heard, /slider "Value of level"/);
        assert.doesNotMatch(heard, /^\s*- (button|slider|textbox|checkbox|link)(:|$)/m, 'something that can be pressed is nameless');
    });
    await step('Tab reaches all that can be pressed in the trace, and all of it has a name', async () => {
        const [there, found] = [await controls(trace), await reached(page, trace)];
        assert.deepEqual(found.map(({ name }) => name), there);
        assert.deepEqual(found.filter(({ name }) => name === ''), []);
        const heard = await trace.locator('body').ariaSnapshot();
        assert.match(heard, /row "warm\.ET .*20ms/);
        assert.match(heard, /img "Waveform of warm\.ET, TIME"/);
        assert.doesNotMatch(heard, /^\s*- (button|slider|textbox|checkbox|link)(:|$)/m, 'something that can be pressed is nameless');
    });
    await step('a slider sets a number, and what sets it is in sight', async () => {
        const slider = diagram.locator('.inspector input[type="range"]');
        await diagram.locator('g.element', { has: diagram.locator('text', { hasText: /^level$/ }) }).first().focus();
        await slider.waitFor();
        const [needed, there] = await diagram.locator('.inspector').evaluate((strip) => [strip.scrollWidth, strip.clientWidth]);
        assert.ok(needed <= there, `it needs ${needed} pixels, and has ${there}`);
        await slider.focus();
        for (let times = 0; times < 5; times += 1) {
            await page.keyboard.press('ArrowRight');
        }
        await diagram.locator('.value', { hasText: /65/ }).waitFor();
        await row(page, 'level').getByText('65', { exact: false }).first().waitFor();
        for (let times = 0; times < 5; times += 1) {
            await page.keyboard.press('ArrowLeft');
        }
        await diagram.locator('.value', { hasText: /60/ }).waitFor();
    });
    for (const theme of THEMES) {
        await step(`all is clear against its background in ${theme}`, async () => {
            await useTheme(theme);
            await diagram.locator('g.element', { has: diagram.locator('text', { hasText: /^level$/ }) }).first().focus();
            const ground = () => diagram.evaluate(() => getComputedStyle(document.body).backgroundColor);
            const wanted = { 'Default Dark Modern': 'rgb(31, 31, 31)', 'Default High Contrast': 'rgb(0, 0, 0)' }[theme] ?? 'rgb(255, 255, 255)';
            await until('the theme in the diagram', async () => (await ground()) === wanted);
            let found;
            // The editor fades its colours in.
            const settled = async () => {
                const text = await page.evaluate(() => getComputedStyle(document.querySelector('.editor-instance .monaco-editor-background')).backgroundColor);
                const parts = (await weights(page, '+--[ ]( go )')).filter((part) => part.text.trim() !== '');
                const kinds = [...new Set(parts.map(({ color }) => color))];
                found = [
                    ...(kinds.length >= 3 ? [] : [`the text has the colours ${kinds.join('; ')}`]),
                    ...faint(kinds.map((front) => ({ selector: 'the text', least: 4.5, front, back: text }))),
                    ...faint(await colours(diagram, DIAGRAM)),
                    ...faint(await colours(trace, TRACE)),
                ];
                return found.length === 0;
            };
            await until('it', settled).catch(() => assert.deepEqual(found, []));
            await screenshot(page, `access-${theme.replaceAll(' ', '-')}`);
        });
    }
    await step('the keys of a simulation are listed among the keyboard shortcuts', async () => {
        await useTheme('Default Dark Modern');
        const manifest = JSON.parse(readFileSync(join(process.env.LADDER_ROOT, 'editors/vscode/package.json'), 'utf8'));
        const keys = manifest.contributes.keybindings.filter((binding) => binding.command.startsWith('ladder.simulation.'));
        assert.ok(keys.length >= 9, `${keys.length} keys`);
        await command(page, 'Preferences: Open Keyboard Shortcuts');
        const search = page.locator('.keybindings-editor .keybindings-header input').first();
        const shown = page.locator('.keybindings-editor .monaco-list-row').first();
        for (const { command: name, key } of keys) {
            await search.fill(`@command:${name}`);
            await until(`${key} for ${name}`, async () => {
                const [text, keycaps] = [await shown.textContent().catch(() => ''), await shown.locator('.monaco-keybinding-key').allTextContents()];
                return text.includes('Ladder: ') && keycaps.join('+').toLowerCase() === key;
            });
        }
        await screenshot(page, 'keys');
        await page.keyboard.press('Escape');
        const isGone = () => search.waitFor({ state: 'hidden', timeout: 2000 }).then(() => true, () => false);
        if (!(await isGone())) {
            // The first has only emptied the field.
            await page.keyboard.press('Escape');
            await isGone();
        }
        // The diagram goes: other parts find the text alone.
        await page.keyboard.press('Control+2');
        await command(page, 'View: Close All Editors in Group');
        await page.keyboard.press('Control+1');
        await page.locator('.monaco-editor .view-line', { hasText: 'VAR_INPUT' }).first().click();
        await page.keyboard.press('Shift+F5');
    });
}
