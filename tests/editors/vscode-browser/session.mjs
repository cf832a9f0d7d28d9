// Opens VS Code (code-server) in a headless browser with the packaged extension, lets the probe run in the extension
// host, and looks at the page: what has power must be bold, and values must be after the lines.
import assert from 'node:assert/strict';
import { cpSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { access, SEEN, SEEN_TEXT } from './access.mjs';
import { openBrowser, QUIET, removeScratch, scratchFolder, serve, until } from './codeServer.mjs';
import { book, emptyFiles } from './book.mjs';
import { changing, CHANGING, CHANGING_TEXT } from './changing.mjs';
import { comparedProgram, comparing } from './comparing.mjs';
import { debug, PROGRAM, TEXT } from './debug.mjs';
import { diagram, programs } from './diagram.mjs';
import { drawing, NAME as DRAWN, TEXT as DRAWN_TEXT } from './drawing.mjs';
import { dying, SLOW } from './dying.mjs';
import { foreign, FOREIGN, FOREIGN_TEXT } from './foreign.mjs';
import { heldTest } from './heldTest.mjs';
import { HOVERED, HOVERED_TEXT, hovering } from './hovering.mjs';
import { live, LIVE, LIVE_TEXT } from './live.mjs';
import { command, open } from './palette.mjs';
import { PENNED, pen } from './pen.mjs';
import { files as PROPERTIES, proofs } from './proofs.mjs';
import { PROGRAMS, running } from './running.mjs';
import { FILE as SCENARIO_FILE, files as SCENARIOS, scenarios } from './scenarios.mjs';
import { online, WATCHED } from './online.mjs';
import { MACHINE, scene } from './scene.mjs';
import { failures, step, tell, whenFailed } from './steps.mjs';
import { CROOKED, lines, NAME, RUNG, SAVED, typing } from './typing.mjs';

const { LADDER_BIN, LADDER_FIXTURES, LADDER_PACKAGES, LADDER_PARTS, LADDER_SCREENSHOTS } = process.env;
/** The parts that are asked for. Only the first of all needs what the probe leaves. */
const wanted = LADDER_PARTS?.split(' ');
const isProbed = !wanted || wanted.includes('simulation');
const scratch = scratchFolder();
const report = join(scratch, 'report');

const { program, holdTest } = heldTest(scratch, LADDER_BIN, SCENARIO_FILE);

const settings = {
    'ladder.server.path': program,
    'workbench.colorTheme': process.env.LADDER_THEME ?? 'Default Dark Modern',
};

function prepare() {
    writeFileSync(report, '');
    cpSync(LADDER_FIXTURES, join(scratch, 'project'), { recursive: true });
    cpSync(join(import.meta.dirname, 'probe/tally.clad'), join(scratch, 'project/tally.clad'));
    writeFileSync(join(scratch, 'project/ladder.toml'), '');
    writeFileSync(join(scratch, 'project', PROGRAM), TEXT);
    writeFileSync(join(scratch, 'project', LIVE), LIVE_TEXT);
    writeFileSync(join(scratch, 'project', CHANGING), CHANGING_TEXT);
    writeFileSync(join(scratch, 'project', HOVERED), HOVERED_TEXT);
    writeFileSync(join(scratch, 'project', FOREIGN), FOREIGN_TEXT);
    writeFileSync(join(scratch, 'project', SLOW), '');
    writeFileSync(join(scratch, 'project', SEEN), SEEN_TEXT);
    writeFileSync(join(scratch, 'project', NAME), `${RUNG}\n`);
    writeFileSync(join(scratch, 'project', SAVED), `${CROOKED}\n`);
    writeFileSync(join(scratch, 'project/watch.clad'), '+--[TON]( clock, T#1h )--( )( late )--+\n');
    writeFileSync(join(scratch, 'project', DRAWN), DRAWN_TEXT);
    comparedProgram(join(scratch, 'project'));
    mkdirSync(join(scratch, 'project/watched'));
    emptyFiles(join(scratch, 'project'));
    for (const [name, text] of Object.entries({ ...programs, ...PENNED, ...MACHINE, ...WATCHED, ...PROGRAMS, ...SCENARIOS, ...PROPERTIES })) {
        writeFileSync(join(scratch, 'project', name), text);
    }
}

/** The weights of the characters of one line of the editor, as the page shows them. */
function weights(page, start) {
    return page.evaluate((wanted) => {
        const blank = /\u00a0/g;
        const lines = [...document.querySelectorAll('.monaco-editor .view-line')];
        const line = lines.find((candidate) => candidate.textContent.replace(blank, ' ').startsWith(wanted));
        const spans = [...(line?.querySelectorAll('span > span') ?? [])];
        return spans.map((span) => ({
            text: span.textContent.replace(blank, ' '),
            bold: Number(getComputedStyle(span).fontWeight) >= 600,
            line: getComputedStyle(span).textDecorationLine,
            color: getComputedStyle(span).color,
        }));
    }, start);
}

/** Where values are on the page: pseudo-elements, which have no place of their own to be asked for. */
function labels(page, text) {
    return page.evaluate((wanted) => {
        const found = [];
        for (const span of document.querySelectorAll('.monaco-editor .view-line span > span')) {
            const style = getComputedStyle(span, '::before');
            if (style.content === `"${wanted}"` && style.position === 'absolute') {
                const { left, top } = span.getBoundingClientRect();
                found.push({ left: left + parseFloat(style.marginLeft), top: top + parseFloat(style.top), width: parseFloat(style.width) });
            }
        }
        return found;
    }, text);
}

/** Where an operand is on the page, and where the part of the editor ends that is not covered. */
function operandBox(page, name) {
    return page.evaluate((wanted) => {
        const root = document.querySelector('.editor-group-container .monaco-editor');
        const walker = document.createTreeWalker(root.querySelector('.view-lines'), NodeFilter.SHOW_TEXT);
        const minimap = root.querySelector('.minimap')?.getBoundingClientRect();
        const editor = root.getBoundingClientRect();
        const visibleTo = minimap && minimap.width > 0 ? minimap.left : editor.right;
        while (walker.nextNode()) {
            const at = walker.currentNode.textContent.indexOf(wanted);
            if (at >= 0) {
                const range = document.createRange();
                range.setStart(walker.currentNode, at);
                range.setEnd(walker.currentNode, at + wanted.length);
                const { left, top } = range.getBoundingClientRect();
                return { left, top, visibleTo };
            }
        }
        throw new Error(`${wanted} is not on the page`);
    }, name);
}

async function look(page) {
    await step('what has power is bold', async () => {
        await until('bold characters', async () => (await weights(page, '+--\\')).some(({ bold }) => bold));
        const rung = (await weights(page, '+--\\')).filter(({ text }) => text.trim() !== '');
        const thin = rung.filter(({ bold }) => !bold).map(({ text }) => text);
        assert.deepEqual(thin, [], `these parts of the rung are not bold: ${thin.join(' ')}`);
    });
    await step('a contact that lets power through is underlined, a wire is not', async () => {
        const rung = await weights(page, '+--\\');
        const underlined = rung.filter(({ line }) => line.includes('underline')).map(({ text }) => text.trim());
        assert.equal(underlined.join('').replaceAll(' ', ''), '[](start)[/](stop)');
    });
    await step('a value is above its operand, and can be seen', async () => {
        const [box] = await labels(page, '20ms');
        assert.ok(box, 'there is no such value');
        // The value hangs on the first letter.
        const operand = await operandBox(page, 'armup');
        assert.ok(Math.abs(box.left - operand.left) < 12, `at ${box.left}, its operand at ${operand.left}`);
        assert.ok(box.top < operand.top && box.top > operand.top - 30, `at ${box.top}, its operand at ${operand.top}`);
        assert.ok(box.left + box.width < operand.visibleTo, 'it lies under the minimap');
    });
    await step('the rail is not brighter than what has no power', async () => {
        const rails = (await weights(page, '|  ')).filter(({ text }) => text === '|');
        assert.equal(rails.length, 4);
        assert.ok(rails.every(({ bold, color }) => !bold && color === 'rgb(139, 139, 139)'), JSON.stringify(rails));
    });
    await step('the status bar tells the scan', async () => {
        await page.getByText('Ladder: paused, scan 3, 30ms').waitFor();
    });
    await step('the view lists the tags, and a timer opens into its members', async () => {
        await row(page, 'warmupQ=').click();
        await row(page, 'warmup.ET').waitFor();
    });
}

/** Waits until something is asked for, and answers. */
async function answer(page, title, text) {
    await page.locator('.quick-input-title', { hasText: title }).waitFor();
    await page.keyboard.type(text);
    await page.keyboard.press('Enter');
}

const row = (page, name) => page.locator('.monaco-list-row', { hasText: name }).first();

async function operate(page) {
    await step('force: what is shown can be typed', async () => {
        // On a line without a tag, so that one is asked for.
        await page.locator('.monaco-editor .view-line').first().click();
        await command(page, 'Ladder: Force Tag...');
        await answer(page, 'Force Tag', 'lamp');
        await answer(page, 'Force lamp', '0');
        await page.getByText('Ladder: paused, scan 3, 30ms, 1 forced').waitFor();
        await row(page, 'lamp0').getByText('forced').waitFor();
        await command(page, 'Ladder: Release Force...');
        await answer(page, 'Release Force', '');
        await page.getByText('Ladder: paused, scan 3, 30ms', { exact: true }).waitFor();
    });
    await step('an internal tag has a pencil, a group has no buttons', async () => {
        await row(page, 'warmup.ET').hover();
        await row(page, 'warmup.ET').locator('.codicon-edit').waitFor();
        const group = page.locator('.monaco-list-row', { hasText: 'Internal' }).first();
        await group.hover();
        assert.equal(await group.locator('.action-item').count(), 0);
    });
    await step('what is watched is at the top of the view, and is kept', async () => {
        const watched = page.locator('.monaco-list-row', { hasText: 'Watched' });
        assert.equal(await watched.count(), 0);
        await row(page, 'warmup.ET').hover();
        await row(page, 'warmup.ET').locator('.codicon-eye').click();
        await watched.waitFor();
        await until('both rows of the tag', async () => (await page.locator('.monaco-list-row', { hasText: 'warmup.ET' }).count()) === 2);
        await screenshot(page, 'watched');
        await row(page, 'warmup.ET').hover();
        await row(page, 'warmup.ET').locator('.codicon-eye-closed').click();
        await watched.waitFor({ state: 'detached' });
    });
    await step('why is a tree with places', async () => {
        await command(page, 'Ladder: Step One Scan');
        await page.getByText('Ladder: paused, scan 4').waitFor();
        await row(page, 'lamp').hover();
        await row(page, 'lamp').locator('.codicon-question').click();
        const reason = page.locator('.monaco-list-row', { hasText: '[ ]( run ) (line 6' }).first();
        await reason.waitFor();
        await reason.click();
        await page.getByText('Ln 6, Col 14').waitFor();
        await screenshot(page, 'why');
    });
    await step('the view shows values while the program runs', async () => {
        // Something changes in every scan: a view that is drawn again with each would never be drawn.
        await open(page, 'watch.clad');
        await command(page, 'Ladder: Start Simulation');
        await page.getByText('Ladder: paused, scan 0').waitFor();
        await row(page, 'clockQ=').click();
        await row(page, 'clock.ET').waitFor();
        await page.locator('.monaco-editor .view-line').first().click();
        await page.keyboard.press('F5');
        await page.getByText('Ladder: running').waitFor();
        const values = new Set();
        await until('three values of the timer in the view', async () => {
            values.add(await row(page, 'clock.ET').textContent());
            return values.size > 2;
        });
        await page.getByText('Ladder: running').waitFor();
        await page.keyboard.press('F6');
        await page.getByText('Ladder: paused').waitFor();
        // The lens that starts a program ends it while it is there.
        const lens = (title) => page.locator('.codelens-decoration a', { hasText: title });
        await lens('Stop simulation').click();
        await lens('Start simulation').waitFor();
        await page.locator('.tab', { hasText: 'motor.clad' }).first().click();
        await page.getByText('Ladder: paused, scan 4').waitFor();
    });
    await step('the speed is in sight', async () => {
        await command(page, 'Ladder: Set Speed of the Simulation...');
        await answer(page, 'Speed of the Simulation', '0.01x');
        await page.getByText('0.01x speed').waitFor();
        await command(page, 'Ladder: Set Speed of the Simulation...');
        await answer(page, 'Speed of the Simulation', '1x');
        await page.getByText('0.01x speed').waitFor({ state: 'detached' });
    });
}

/** The page of a view, which is in a frame of a frame. */
const inView = (page) => page.frameLocator('iframe.webview.ready').frameLocator('#active-frame');

/** The scan that the status bar tells. */
async function scanShown(page) {
    const text = await page.getByText(/Ladder: (paused|running), scan \d+/).first().textContent();
    return Number(/scan (\d+)/.exec(text)[1]);
}

async function traceTags(page) {
    const view = inView(page);
    const traceRow = (name) => view.locator('#rows tr', { has: page.locator(`th span:text-is("${name}")`) });
    await step('the trace shows inputs and outputs while the program runs', async () => {
        await command(page, 'Ladder: Show Trace');
        await traceRow('start').waitFor();
        await page.locator('.monaco-editor .view-line').first().click();
        await page.keyboard.press('F5');
        await until('thirty scans in the trace', async () => Number(/scan (\d+)/.exec(await view.locator('#place').textContent())?.[1]) > 34);
        await page.keyboard.press('F6');
        await page.getByText('Ladder: paused').waitFor();
        const last = await scanShown(page);
        await until('the last scan in the trace', async () => (await view.locator('#place').textContent()).startsWith(`scan ${last},`));
        for (const name of ['start', 'stop', 'lamp']) {
            assert.match(await traceRow(name).locator('.line').getAttribute('d'), /^M[\d.]+ [\d.]+H/, name);
        }
        assert.equal(await traceRow('start').locator('td.now').textContent(), '1');
    });
    await step('what the trace has drawn stays on the page, and is changed where it is another', async () => {
        const line = traceRow('start').locator('.line');
        await line.evaluate((path) => {
            path.isKept = true;
            window.before = path.getAttribute('d');
        });
        await page.keyboard.press('F10');
        await until('another drawing', () => line.evaluate((path) => path.getAttribute('d') !== window.before));
        assert.ok(await line.evaluate((path) => path.isKept === true), 'it was drawn again');
    });
    await step('a tag is added from the Tags view, and drawn over a scale', async () => {
        await row(page, 'warmupQ=').click();
        await row(page, 'warmup.ET').hover();
        await row(page, 'warmup.ET').locator('.codicon-pulse').click();
        await traceRow('warmup.ET').locator('.line').waitFor({ state: 'attached' });
        await traceRow('warmup.ET').getByText('20 ms').first().waitFor();
    });
    await step('two cursors, and the difference between them', async () => {
        await view.locator('#trace').focus();
        await page.keyboard.press('0');
        await until('everything', async () => (await view.locator('#follow').getAttribute('aria-pressed')) === 'true');
        await page.keyboard.press('Home');
        await page.keyboard.press('b');
        for (let times = 0; times < 3; times += 1) {
            await page.keyboard.press('ArrowRight');
        }
        // A step is a column: more than one scan, if the run took long.
        await until('the difference', async () => /B − A \+\d*[1-9]0ms/.test(await view.locator('#measure').textContent()));
        assert.equal(await traceRow('warmup.ET').locator('td.difference').textContent(), '+20ms');
        await screenshot(page, 'trace');
    });
    await step('zoom and fit', async () => {
        const ticks = async () => (await view.locator('#axis .tick').allTextContents()).join(' ');
        await page.keyboard.press('0');
        const whole = await ticks();
        await page.keyboard.press('+');
        await until('other ticks', async () => (await ticks()) !== whole);
        await page.keyboard.press('0');
        await until('the ticks of everything', async () => (await ticks()) === whole);
    });
    await step('a click in the trace shows the program as it was', async () => {
        const picture = traceRow('start').locator('svg');
        const last = await scanShown(page);
        const box = await picture.boundingBox();
        await picture.click({ position: { x: box.width / 2, y: box.height / 2 } });
        await until('an earlier scan', async () => (await scanShown(page)) < last);
        const there = await scanShown(page);
        assert.ok(Math.abs(there - last / 2) < last / 8 + 2, `scan ${there} of ${last}`);
        await until('the rest as what was stepped back from', async () => (await picture.locator('.ahead').count()) === 1);
        await screenshot(page, 'trace-back');
        await view.locator('#trace').focus();
        await page.keyboard.press('a');
        await page.keyboard.press('Home');
        for (let times = 0; times < 3; times += 1) {
            await page.keyboard.press('ArrowRight');
        }
        await page.keyboard.press('Enter');
        await page.getByText('Ladder: paused, scan 4,').waitFor();
        await page.keyboard.press('Escape');
        await page.locator('.monaco-editor .view-line').first().click();
    });
}

async function edit(page) {
    await step('an edit goes on with what runs', async () => {
        const before = (await weights(page, '+--\\')).filter((span) => span.bold);
        await page.locator('.monaco-editor .view-line').first().click();
        await page.keyboard.press('Control+Home');
        await page.keyboard.press('Enter');
        await until('the live cells, a line below', async () => {
            const after = (await weights(page, '+--\\')).filter((span) => span.bold);
            return before.length > 0 && after.length === before.length;
        });
        assert.equal(await page.getByText('before the errors in the text').count(), 0);
        // The other parts find the program as it is on disk.
        await page.keyboard.press('Control+Z');
        await until('the program as it was', async () => (await lines(page))[0].startsWith('#'));
    });
}

async function screenshot(page, name) {
    if (LADDER_SCREENSHOTS) {
        await page.screenshot({ path: join(LADDER_SCREENSHOTS, `${name}.png`) });
    }
}

/** Another theme: the editor follows its settings. */
function useTheme(theme) {
    const all = { ...QUIET, 'security.workspace.trust.enabled': false, ...settings, 'workbench.colorTheme': theme };
    writeFileSync(join(scratch, 'data/Machine/settings.json'), JSON.stringify(all));
}

/** What is tried, in this order. */
const parts = (page) => ({
    simulation: async () => {
        await look(page);
        await screenshot(page, 'power');
        await operate(page);
        await traceTags(page);
        await edit(page);
    },
    live: () => live(page, { step, until, weights, labels, operandBox, row }),
    changing: () => changing(page, { step, until, weights, row, screenshot }),
    access: () => access(page, { step, until, weights, row, screenshot, useTheme }),
    running: () => running(page, { step, until, weights, row, screenshot }),
    hovering: () => hovering(page, { step, until, screenshot }),
    typing: () => typing(page, { step, until, screenshot, project: join(scratch, 'project') }),
    drawing: () => drawing(page, { step, until }),
    pen: () => pen(page, { step, until, screenshot }),
    scene: () => scene(page, { step, until, screenshot }),
    online: () => online(page, { step, until, weights, screenshot }),
    foreign: () => foreign(page, { step, until, screenshot }),
    dying: () => dying(page, { step, until, screenshot, scratch, answer }),
    book: () => book(page, { step, until, project: join(scratch, 'project') }),
    debug: () => debug(page, { step, until, weights, screenshot }),
    scenarios: () => scenarios(page, { step, until, screenshot, holdTest }),
    comparing: () => comparing(page, { step, until, screenshot }),
    proofs: () => proofs(page, { step, until, screenshot }),
    // Its last step loads the page again.
    diagram: () => diagram(page, { step, until, screenshot }),
});

/** What the probe finds in the extension host. It leaves a simulation and the view of its tags. */
async function probed() {
    let reported = 0;
    await until('the probe to end', () => {
        const lines = readFileSync(report, 'utf8').trimEnd().split('\n').filter(Boolean).map((line) => JSON.parse(line));
        for (const line of lines.slice(reported)) {
            reported += 1;
            if (!line.done) {
                tell(line);
            }
        }
        return lines.at(-1)?.done;
    }, 600);
}

/** The same view, without a simulation. */
async function unprobed(page) {
    const ladder = page.locator('.activitybar .action-label[aria-label="Ladder"]');
    await ladder.waitFor();
    // What the editor sends while it begins is not what a part of the session counts, and a key that is pressed before is lost.
    await open(page, 'unpaired.clad');
    await page.locator('.squiggly-error').first().waitFor();
    await page.keyboard.press('Control+W');
    await page.locator('.tab', { hasText: 'unpaired.clad' }).waitFor({ state: 'detached' });
    await ladder.click();
}

async function main() {
    prepare();
    const packages = ['ladder.vsix', ...(isProbed ? ['probe.vsix'] : [])];
    const extensions = packages.map((name) => join(LADDER_PACKAGES, name));
    const { server, address } = await serve(scratch, { extensions, settings, env: { ...process.env, LADDER_REPORT: report } });
    const { browser, page } = await openBrowser(scratch, address);
    whenFailed((name) => screenshot(page, `failed-${name.replaceAll(/\W+/g, '-').slice(0, 60)}`));
    try {
        await (isProbed ? probed() : unprobed(page));
        for (const [name, part] of Object.entries(parts(page))) {
            if (!wanted || wanted.includes(name)) {
                await part();
            }
        }
    } finally {
        await screenshot(page, 'end');
        await browser.close();
        server.kill();
    }
}

try {
    await main();
} catch (error) {
    tell({ name: 'the session runs', ok: false, ms: 0, message: error.stack });
} finally {
    removeScratch(scratch);
}
process.exit(failures() === 0 ? 0 : 1);
