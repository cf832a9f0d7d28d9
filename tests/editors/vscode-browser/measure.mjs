// What a simulation costs in VS Code: how long a user waits, and how busy the editor is. Prints a table.
import { execFileSync } from 'node:child_process';
import { chmodSync, writeFileSync } from 'node:fs';
import { loadavg, tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { allThreads, descendant, mainThread, median, notesSince } from '../measured/notes.mjs';
import { openBrowser, removeScratch, scratchFolder, serve, until } from './codeServer.mjs';
import { diagramOf } from './diagram.mjs';
import { command, list, open } from './palette.mjs';

const { LADDER_BIN, LADDER_PACKAGES, LADDER_ROOT } = process.env;
const SECONDS = Number(process.env.LADDER_SECONDS ?? 10);
/** So often each command is given. */
const TIMES = 9;

const given = process.argv.slice(2);
const programs = given.length > 0 ? given : ['usual-1000', 'usual-10000', 'flip-10000'];

const scratch = scratchFolder();
const tap = join(scratch, 'tap.jsonl');

function prepare() {
    writeFileSync(join(scratch, 'project/ladder.toml'), '');
    writeFileSync(tap, '');
    for (const rungs of new Set(programs.map((name) => name.split('-')[1]))) {
        execFileSync(join(LADDER_ROOT, 'tests/editors/measured/programs'), [join(scratch, 'project'), rungs]);
    }
    const wrapper = join(scratch, 'ladder');
    const tapped = fileURLToPath(import.meta.resolve('../measured/tap.mjs'));
    const variables = `LADDER_TAPPED='${LADDER_BIN}' LADDER_TAP='${tap}'`;
    writeFileSync(wrapper, `#!/bin/sh\n${variables} exec '${process.execPath}' '${tapped}' "$@"\n`);
    chmodSync(wrapper, 0o755);
    return wrapper;
}

/** Has a part of a page write down when it shows another text: when that is painted, not when it is known. */
function watch(frame, selector) {
    return frame.evaluate((wanted) => {
        // No more than this part is inspected: what looks is itself work of the page.
        const part = document.querySelector(wanted);
        const text = () => /\b(running|paused|ended)\b.{1,3}scan \d.*/.exec(part.textContent)?.[0] ?? '';
        window.shownTexts = [];
        let last = '';
        const look = () => {
            const now = text();
            if (now !== last) {
                last = now;
                requestAnimationFrame(() => setTimeout(() => window.shownTexts.push([Date.now(), now])));
            }
        };
        new MutationObserver(look).observe(part, { subtree: true, childList: true, characterData: true });
    }, selector);
}

/** How long it takes until a text is shown, in milliseconds. */
async function timeUntil(frame, act, pattern) {
    const began = Date.now();
    await act();
    let shown;
    await until(`${pattern} on the page`, async () => {
        const texts = await frame.evaluate((since) => window.shownTexts.filter(([at]) => at >= since), began);
        shown = texts.find(([, text]) => pattern.test(text));
        return shown;
    });
    return shown[0] - began;
}

/** Looks at a run, or at nothing that runs, for a while: how busy the parts of the editor are, and how many states are shown. */
async function lookAtRun({ renderers, host }) {
    const work = () => [...renderers().map((id) => [id, mainThread(id)]), [host, allThreads(host)]];
    const began = Date.now();
    const before = new Map(work());
    await new Promise((resolve) => setTimeout(resolve, SECONDS * 1000));
    const taken = Date.now() - began;
    const busy = work().map(([id, ms]) => [id, ((ms - (before.get(id) ?? 0)) / taken) * 100]);
    const notes = notesSince(tap, began);
    const count = (what) => notes.filter((note) => note.what === what).length;
    return {
        // The page of the editor and of a diagram may have a process each.
        page: Math.max(...busy.filter(([id]) => id !== host).map(([, share]) => share)),
        host: busy.find(([id]) => id === host)[1],
        states: count('shown') / (taken / 1000),
        bytes: median(notes.filter(({ what }) => what === 'state').map(({ bytes }) => bytes)),
    };
}

async function cursorTo(page, place) {
    await (await list(page, 'Control+G')).fill(`:${place}`);
    await page.keyboard.press('Enter');
    await page.getByText(`Ln ${place.split(':')[0]}, Col`).waitFor();
}

async function speedUp(page) {
    await command(page, 'Ladder: Set Speed of the Simulation...');
    await page.locator('.quick-input-title', { hasText: 'Speed of the Simulation' }).waitFor();
    await page.keyboard.type('max');
    await page.keyboard.press('Enter');
}

async function measure(page, processes, name) {
    const rungs = Number(name.split('-')[1]);
    const isUsual = name.startsWith('usual');
    const row = { program: name };
    await open(page, `${name}.clad`);
    const lens = page.locator('.codelens-decoration a', { hasText: 'Start simulation' }).first();
    await lens.waitFor();
    // What is asked when a file is opened comes first.
    await new Promise((resolve) => setTimeout(resolve, 3000));
    row.rest = await lookAtRun(processes);
    const opened = Date.now();
    row.start = await timeUntil(page, () => lens.click(), /paused, scan 0/);
    row.serverStart = notesSince(tap, opened).find(({ what }) => what === 'start').ms;
    // The text, not its first line: that may be above what is in sight.
    await page.keyboard.press('Control+1');
    if (isUsual) {
        const began = Date.now();
        await cursorTo(page, '2:9');
        await page.keyboard.press('F4');
        await until('the start', () => notesSince(tap, began).some(({ what }) => what === 'set'));
    }
    const key = async (name, pattern, times = TIMES) => {
        const taken = [];
        for (let time = 0; time < times; time += 1) {
            taken.push(await timeUntil(page, () => page.keyboard.press(name), pattern(time)));
        }
        return taken;
    };
    row.step = await key('F10', (time) => new RegExp(`scan ${time + 1},`));
    row.back = await key('Alt+F10', (time) => new RegExp(`scan ${TIMES - time - 1},`));
    await speedUp(page);
    await key('F5', () => /running/, 1);
    await new Promise((resolve) => setTimeout(resolve, 2000));
    row.text = await lookAtRun(processes);
    const pauses = async (frame) => {
        const taken = [];
        for (let time = 0; time < TIMES; time += 1) {
            taken.push(await timeUntil(frame, () => page.keyboard.press('F6'), /paused/));
            await timeUntil(frame, () => page.keyboard.press('F5'), /running/);
            await new Promise((resolve) => setTimeout(resolve, 700));
        }
        return taken;
    };
    row.pause = await pauses(page);
    await page.keyboard.press('F6');
    await page.getByText('Ladder: paused').waitFor();
    if (isUsual) {
        const began = Date.now();
        for (let time = 0; time < TIMES; time += 1) {
            // The view of reasons takes the focus.
            await cursorTo(page, `${2 * rungs - 2}:55`);
            const count = () => notesSince(tap, began).filter(({ what }) => what === 'why').length;
            await page.keyboard.press('Shift+F4');
            await until('the reason', () => count() > time);
            await new Promise((resolve) => setTimeout(resolve, 1500));
        }
        row.why = notesSince(tap, began).filter(({ what }) => what === 'why').map(({ ms }) => ms);
        await new Promise((resolve) => setTimeout(resolve, 1500));
        await cursorTo(page, '1:1');
    }
    await command(page, 'Ladder: Open Diagram to the Side');
    const diagram = await diagramOf(page, until);
    await watch(diagram, '.standing');
    // The text, not its first line: that may be above what is in sight.
    await page.keyboard.press('Control+1');
    await page.keyboard.press('F5');
    await until('the run in the diagram', () => diagram.evaluate(() => /running/.test(document.querySelector('.standing').textContent)));
    await new Promise((resolve) => setTimeout(resolve, 2000));
    row.diagram = await lookAtRun(processes);
    row.pauseInDiagram = await pauses(diagram);
    await page.keyboard.press('Shift+F5');
    await command(page, 'View: Close All Editors');
    return row;
}

function tell(rows) {
    const ms = (times) => (times ? `${Math.round(median(times))} (${Math.round(Math.max(...times))})` : '');
    const share = (value) => `${value.toFixed(1)} %`;
    const lines = [
        ['', ...rows.map(({ program }) => program)],
        ['start, ms', ...rows.map(({ start }) => String(start))],
        ['... of that the server', ...rows.map(({ serverStart }) => serverStart.toFixed(0))],
        ['step, ms', ...rows.map(({ step }) => ms(step))],
        ['back, ms', ...rows.map(({ back }) => ms(back))],
        ['pause, ms', ...rows.map(({ pause }) => ms(pause))],
        ['pause, next to the diagram', ...rows.map(({ pauseInDiagram }) => ms(pauseInDiagram))],
        ['why (the server), ms', ...rows.map(({ why }) => ms(why))],
        ['page at rest, thread busy', ...rows.map(({ rest }) => share(rest.page))],
        ['thread of the page busy', ...rows.map(({ text }) => share(text.page))],
        ['... with the diagram', ...rows.map(({ diagram }) => share(diagram.page))],
        ['extension host busy', ...rows.map(({ text }) => share(text.host))],
        ['... with the diagram', ...rows.map(({ diagram }) => share(diagram.host))],
        ['states shown in a second', ...rows.map(({ text }) => text.states.toFixed(1))],
        ['... with the diagram', ...rows.map(({ diagram }) => diagram.states.toFixed(1))],
        ['bytes of a state', ...rows.map(({ text }) => String(text.bytes))],
    ];
    const widths = lines[0].map((_, column) => Math.max(...lines.map((line) => line[column].length)));
    const bar = widths.map((width) => '-'.repeat(width));
    for (const line of [lines[0], bar, ...lines.slice(1)]) {
        console.log(`| ${line.map((cell, column) => cell.padEnd(widths[column])).join(' | ')} |`);
    }
    console.log(`\nMedians of ${TIMES}, in brackets the longest; load ${loadavg().map((load) => load.toFixed(1)).join(' ')}.`);
}

async function main() {
    const settings = { 'ladder.server.path': prepare(), 'workbench.colorTheme': 'Default Dark Modern' };
    const extensions = [join(LADDER_PACKAGES, 'ladder.vsix')];
    const { server, address } = await serve(scratch, { extensions, settings, env: process.env });
    const { browser, page } = await openBrowser(scratch, address);
    page.setDefaultTimeout(60_000);
    try {
        const chromium = await browser.newBrowserCDPSession();
        let ids = [];
        const look = async () => {
            const { processInfo } = await chromium.send('SystemInfo.getProcessInfo');
            ids = processInfo.filter(({ type }) => type === 'renderer').map(({ id }) => id);
        };
        await page.locator('.monaco-workbench').waitFor();
        // A list that is opened before the editor is at rest finds no file.
        await page.getByText('Activating Extensions').waitFor({ state: 'detached' });
        await watch(page, '.part.statusbar');
        const rows = [];
        for (const name of programs) {
            await open(page, `${name}.clad`);
            await look();
            const every = setInterval(() => void look().catch(() => undefined), 500);
            const host = descendant(server.pid, '--type=extensionHost');
            rows.push(await measure(page, { renderers: () => ids, host }, name));
            clearInterval(every);
        }
        tell(rows);
    } catch (error) {
        await page.screenshot({ path: join(tmpdir(), 'ladder-measure.png') }).catch(() => undefined);
        throw error;
    } finally {
        await browser.close();
        server.kill();
    }
}

try {
    await main();
} finally {
    removeScratch(scratch);
}
