// A diagram typed by hand: keys are pressed in the page, and what is in the editor is checked.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';

import { open } from './palette.mjs';

/** The program that is typed into: its name in the project, and its text. */
export const NAME = 'typed.clad';
export const RUNG = '+--[ ]( first )--[/]( second )--( )( third )--+';

/** What is not aligned, and what a save makes of it. */
export const SAVED = 'crooked-typed.clad';
export const CROOKED = '+-[ ]( crooked )-( )( rung )-+';
const ALIGNED = '+--[ ]( crooked )-------------------------------------------------( )( rung )--+';

/** The lines of the editor that is active, as the page shows them. */
export function lines(page) {
    return page.evaluate(() => {
        const shown = [...document.querySelectorAll('.editor-group-container.active .monaco-editor .view-line')];
        const placed = shown.map((line) => ({ top: parseFloat(line.style.top), text: line.textContent.replace(/\u00a0/g, ' ') }));
        return placed.sort((a, b) => a.top - b.top).map(({ text }) => text.trimEnd());
    });
}

const place = (page, line, column) => page.getByText(new RegExp(`Ln ${line}, Col ${column}( |$)`)).first().waitFor();

export async function typing(page, { step, until, screenshot, project }) {
    const errors = page.locator('.editor-group-container.active .monaco-editor .squiggly-error');
    /** A key that comes before the extension has answered the one before it would find what was selected then. */
    const selectSecond = async () => {
        const [first, second] = ['first', 'second'].map((name) => [RUNG.indexOf(name) + 1 + name.length, name.length]);
        await page.keyboard.press('Control+Home');
        for (const [column, length] of [first, second]) {
            await page.keyboard.press('Tab');
            await place(page, 1, `${column} \\(${length} selected\\)`);
        }
    };
    await step('a line becomes a comment and comes back, each in one step of undo', async () => {
        await open(page, NAME);
        await page.locator('.editor-group-container.active .view-line', { hasText: 'first' }).click();
        const shows = (what, text) => until(what, async () => (await lines(page))[0] === text);
        await page.keyboard.press('Control+/');
        await shows('the comment', `# ${RUNG} #`);
        await page.keyboard.press('Control+/');
        await shows('the rung', RUNG);
        await page.keyboard.press('Control+Z');
        await shows('the comment again', `# ${RUNG} #`);
        await page.keyboard.press('Control+Z');
        await shows('the rung again', RUNG);
    });
    await step('Enter after a rung begins the next one', async () => {
        await page.locator('.editor-group-container.active .view-line', { hasText: 'first' }).click();
        await page.keyboard.press('Control+Home');
        await page.keyboard.press('End');
        await page.keyboard.press('Enter');
        await until('the beginning of a rung', async () => (await lines(page)).some((line) => line === '+--'));
    });
    await step('a rung that was begun goes when the cursor leaves it', async () => {
        // Enter has laid out the rung above.
        const below = async (line) => (await lines(page)).slice(1).join('\n') === `${line}\n`;
        const begun = () => below('+--');
        const gone = () => until('the beginning to go', () => below(''));
        await page.keyboard.press('ArrowUp');
        await gone();
        // One undo brings it back, as a step of the editor's own, and the next one takes back Enter.
        const takeBack = async () => {
            await page.keyboard.press('Control+Z');
            await until('the beginning of a rung again', begun);
            await page.keyboard.press('Control+Z');
            await until('the text without Enter', async () => (await lines(page)).join('\n') === `${RUNG}\n`);
        };
        const beginAgain = async () => {
            await page.keyboard.press('Control+Home');
            await page.keyboard.press('End');
            await page.keyboard.press('Enter');
            await until('the beginning of a rung', begun);
        };
        await takeBack();
        // By a click, too; and what was typed into stays.
        await beginAgain();
        await page.locator('.editor-group-container.active .view-line', { hasText: 'first' }).click();
        await gone();
        await takeBack();
        await beginAgain();
        await page.keyboard.type('--', { delay: 30 });
        await until('what was typed', async () => (await lines(page)).includes('+----'));
        await page.keyboard.press('ArrowUp');
        await place(page, 1, '\\d+');
        await page.waitForTimeout(300);
        assert.ok((await lines(page)).includes('+----'), (await lines(page)).join('\n'));
        await page.keyboard.press('ArrowDown');
        await page.keyboard.press('End');
        await page.keyboard.press('Backspace');
        await page.keyboard.press('Backspace');
    });
    await step('a half-typed rung has no errors until it is left', async () => {
        await page.keyboard.type('[ ]( fourth )--[TON', { delay: 30 });
        await page.keyboard.press('Escape');
        // Longer than the answer takes.
        await page.waitForTimeout(600);
        assert.equal(await errors.count(), 0);
        await page.locator('.editor-group-container.active .view-line', { hasText: 'first' }).click();
        await until('the error', async () => (await errors.count()) > 0);
    });
    await step('an instruction is found by what it is for, and comes with its operands', async () => {
        await page.locator('.editor-group-container.active .view-line', { hasText: 'fourth' }).click();
        await page.keyboard.press('End');
        // The editor has closed the bracket.
        for (const _ of '[TON]') {
            await page.keyboard.press('Backspace');
        }
        await page.keyboard.type('[timer', { delay: 30 });
        const proposal = page.locator('.suggest-widget .monaco-list-row', { hasText: 'TON' }).first();
        await proposal.waitFor();
        await screenshot(page, 'typing');
        await proposal.click();
        await until('the block', async () => (await lines(page)).some((line) => /^\+--\[ \]\( fourth \)-+\[TON\]\( /.test(line)));
        await page.keyboard.press('Escape');
        await page.keyboard.press('Escape');
    });
    await step('Tab goes from operand to operand and selects each, and puts nothing in', async () => {
        const before = await lines(page);
        await selectSecond();
        assert.deepEqual(await lines(page), before);
    });
    await step('Tab takes the first proposal, Enter within a block takes it or does nothing', async () => {
        const before = await lines(page);
        await page.locator('.editor-group-container.active .view-line span', { hasText: /^third$/ }).first().dblclick();
        await page.keyboard.type('seco', { delay: 50 });
        // The lists to fewer letters have what is waited for too, further down.
        await page.locator('.suggest-widget.visible .monaco-list-row[data-index="0"]', { hasText: 'second' }).first().waitFor();
        await page.keyboard.press('Tab');
        await until('the whole name', async () => (await lines(page))[0].includes('( )( second )'));
        // What an undo has done is on the page a moment later; one more would take back what was there before.
        const undo = async () => {
            await page.keyboard.press('Control+Z');
            await page.waitForTimeout(200);
        };
        const asBefore = () =>
            until('the rung as it was', async () => {
                await undo();
                return (await lines(page))[0] === before[0];
            });
        await page.keyboard.press('Escape');
        await asBefore();
        await page.keyboard.press('Control+Home');
        await page.keyboard.press('End');
        await page.keyboard.press('Enter');
        await until('the beginning of a rung', async () => (await lines(page))[1] === '+--');
        await page.keyboard.type('[ ]( run )--[TON', { delay: 50 });
        await page.locator('.suggest-widget.visible .monaco-list-row[data-index="0"]', { hasText: 'TON' }).first().waitFor();
        const count = (await lines(page)).length;
        await page.keyboard.press('Enter');
        const whole = /^\+--\[ \]\( run \)-+\[TON\](\( |$)/;
        await until('the block on one line', async () => {
            const text = await lines(page);
            return text.length === count && whole.test(text[1]);
        });
        await page.keyboard.press('Escape');
        await page.keyboard.press('Escape');
        await until('the program as it was', async () => {
            await undo();
            return (await lines(page)).join('\n') === before.join('\n');
        });
        await selectSecond();
    });
    await step('a rung whose block came with operands is laid out when they are left, with a list open too, and by Escape', async () => {
        const before = await lines(page);
        for (const [typed, key, named] of [
            ['thi', 'Tab', 'thi'],
            ['', 'Escape', 'tag'],
        ]) {
            await page.keyboard.press('Control+Home');
            await page.keyboard.press('End');
            await page.keyboard.press('Enter');
            await until('the beginning of a rung', async () => (await lines(page))[1] === '+--');
            await page.keyboard.type('[ ]( run )--(S', { delay: 50 });
            await page.locator('.suggest-widget.visible .monaco-list-row[data-index="0"]', { hasText: '(S)' }).first().waitFor();
            await page.keyboard.press('Tab');
            await until('the coil', async () => (await lines(page))[1] === '+--[ ]( run )--(S)( tag )--+');
            await page.keyboard.type(typed, { delay: 50 });
            await (typed && page.locator('.suggest-widget.visible .monaco-list-row', { hasText: 'third' }).first().waitFor());
            // What tells of the operand goes first.
            await until('the rung to be laid out', async () => {
                await page.keyboard.press(key);
                await page.waitForTimeout(200);
                return new RegExp(`^\\+--\\[ \\]\\( run \\)-{30,}\\(S\\)\\( ${named} \\)--\\+$`).test((await lines(page))[1]);
            });
            await until('the program as it was', async () => {
                await page.keyboard.press('Control+Z');
                await page.waitForTimeout(200);
                return (await lines(page)).join('\n') === before.join('\n');
            });
        }
        await selectSecond();
    });
    await step('a key draws a contact, and one undo takes it back', async () => {
        const before = await lines(page);
        await page.keyboard.press('Alt+L');
        await page.keyboard.press('c');
        await until('another contact', async () => (await lines(page))[0].split('[ ]').length === 3);
        await page.keyboard.press('Escape');
        await page.keyboard.press('Control+Z');
        await until('the rung as it was', async () => (await lines(page))[0] === before[0]);
    });
    await step('a key draws a branch round what is selected', async () => {
        const before = await lines(page);
        await page.keyboard.press('Control+Home');
        await page.keyboard.press('Tab');
        await page.keyboard.press('Alt+L');
        await page.keyboard.press('b');
        await until('the branch', async () => {
            const [above, below] = await lines(page);
            return above.includes('\\') && /^\|? *\/--/.test(below);
        });
        await screenshot(page, 'branch');
        await page.keyboard.press('Escape');
        await page.keyboard.press('Control+Z');
        await until('the rung as it was', async () => (await lines(page))[0] === before[0]);
        await page.keyboard.press('Control+S');
    });
    await step('a save aligns the program, and one undo takes that back', async () => {
        await open(page, SAVED);
        await page.locator('.editor-group-container.active .view-line', { hasText: 'crooked' }).first().click();
        await page.keyboard.press('Control+End');
        await page.keyboard.type('# typed #', { delay: 30 });
        const typed = await lines(page);
        assert.equal(typed[0], CROOKED);
        await page.keyboard.press('Control+S');
        await until('the program to be aligned', async () => (await lines(page))[0] === ALIGNED);
        await until('the file to be saved', () => readFileSync(join(project, SAVED), 'utf8').startsWith(`${ALIGNED}\n`));
        await page.keyboard.press('Control+Z');
        await until('the program as it was typed', async () => (await lines(page))[0] === CROOKED);
        assert.deepEqual(await lines(page), typed);
        // A save of what is aligned changes nothing.
        await page.keyboard.press('Control+S');
        await until('the program to be aligned again', async () => (await lines(page))[0] === ALIGNED);
        await page.keyboard.press('Control+S');
        assert.equal((await lines(page))[0], ALIGNED);
    });
}
