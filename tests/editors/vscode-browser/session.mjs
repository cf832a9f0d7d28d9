// Opens VS Code (code-server) in a headless browser with the packaged extension, lets the probe run in the extension
// host, and looks at the page: what has power must be bold, and values must stand behind the lines.
import assert from 'node:assert/strict';
import { execFileSync, spawn } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { chromium } from 'playwright-core';

const { LADDER_BIN, LADDER_FIXTURES, LADDER_CHROMIUM, LADDER_PACKAGES, LADDER_SCREENSHOTS } = process.env;
const codeServer = fileURLToPath(import.meta.resolve('code-server/out/node/entry.js'));
const scratch = mkdtempSync(join(tmpdir(), 'ladder-vscode-'));
const report = join(scratch, 'report');

const settings = {
    'ladder.server.path': LADDER_BIN,
    'security.workspace.trust.enabled': false,
    'workbench.startupEditor': 'none',
    'workbench.colorTheme': process.env.LADDER_THEME ?? 'Default Dark Modern',
    'workbench.secondarySideBar.defaultVisibility': 'hidden',
    'chat.disableAIFeatures': true,
    'editor.minimap.enabled': false,
    'telemetry.telemetryLevel': 'off',
};

let failed = 0;

function tell({ name, ok, ms, message }) {
    console.log(`${ok ? 'ok  ' : 'FAIL'}  vscode in a browser: ${name} (${ms} ms)`);
    if (!ok) {
        failed += 1;
        console.log(`      ${message.replaceAll('\n', '\n      ')}`);
    }
}

async function step(name, check) {
    const started = Date.now();
    try {
        await check();
        tell({ name, ok: true, ms: Date.now() - started });
    } catch (error) {
        tell({ name, ok: false, ms: Date.now() - started, message: error.message });
    }
}

async function until(what, seconds, holds) {
    const limit = Date.now() + seconds * 1000;
    while (!(await holds())) {
        if (Date.now() > limit) {
            throw new Error(`waited ${seconds} s in vain for ${what}`);
        }
        await new Promise((resolve) => setTimeout(resolve, 50));
    }
}

function prepare() {
    for (const folder of ['data/Machine', 'extensions', 'project']) {
        mkdirSync(join(scratch, folder), { recursive: true });
    }
    writeFileSync(join(scratch, 'data/Machine/settings.json'), JSON.stringify(settings));
    writeFileSync(join(scratch, 'config.yaml'), 'auth: none\n');
    writeFileSync(report, '');
    cpSync(LADDER_FIXTURES, join(scratch, 'project'), { recursive: true });
    writeFileSync(join(scratch, 'project/ladder.toml'), '');
    // Without these code-server would write its configuration and data into the user's home.
    const folders = ['--user-data-dir', join(scratch, 'data'), '--extensions-dir', join(scratch, 'extensions')];
    return [codeServer, '--config', join(scratch, 'config.yaml'), ...folders];
}

async function serve(common) {
    for (const name of ['ladder.vsix', 'probe.vsix']) {
        const install = ['--install-extension', join(LADDER_PACKAGES, name)];
        execFileSync(process.execPath, [...common, ...install], { stdio: 'pipe' });
    }
    const quiet = ['--disable-telemetry', '--disable-update-check', '--disable-workspace-trust'];
    const server = spawn(process.execPath, [...common, ...quiet, '--bind-addr', '127.0.0.1:0', join(scratch, 'project')], {
        env: { ...process.env, LADDER_REPORT: report },
        stdio: ['ignore', 'pipe', 'pipe'],
    });
    let output = '';
    let address;
    for (const stream of [server.stdout, server.stderr]) {
        stream.on('data', (data) => {
            output += data;
            address ??= /HTTP server listening on (\S+)/.exec(output)?.[1];
        });
    }
    await until('code-server to listen', 20, () => address);
    return { server, address };
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
            behind: getComputedStyle(span, '::after').content,
        }));
    }, start);
}

async function look(page) {
    await step('what has power is bold', async () => {
        await until('bold characters', 5, async () => (await weights(page, '+--\\')).some(({ bold }) => bold));
        const rung = (await weights(page, '+--\\')).filter(({ text }) => text.trim() !== '');
        const thin = rung.filter(({ bold }) => !bold).map(({ text }) => text);
        assert.deepEqual(thin, [], `these parts of the rung are not bold: ${thin.join(' ')}`);
    });
    await step('values stand behind the line', async () => {
        const behind = (await weights(page, '+--\\')).map(({ behind }) => behind).join(' ').replaceAll('\u00a0', ' ');
        assert.match(behind, /start=1  stop=0  run=1/);
    });
    await step('the status bar tells the scan', async () => {
        await page.getByText('Ladder: paused, scan 3, 30ms').waitFor({ timeout: 5000 });
    });
    await step('the view lists the tags', async () => {
        await page.locator('.monaco-list-row', { hasText: 'warmup.ET' }).waitFor({ timeout: 5000 });
    });
}

async function edit(page) {
    await step('an edit greys the drawing and says so', async () => {
        await page.locator('.monaco-editor .view-line').first().click();
        await page.keyboard.press('Control+Home');
        await page.keyboard.press('Enter');
        await page.getByText('the simulation still runs the old one').first().waitFor({ timeout: 5000 });
        const bold = (await weights(page, '+--\\')).filter((span) => span.bold);
        assert.deepEqual(bold, []);
        await page.getByText('of an older text').waitFor({ timeout: 5000 });
    });
}

async function screenshot(page, name) {
    if (LADDER_SCREENSHOTS) {
        await page.screenshot({ path: join(LADDER_SCREENSHOTS, `${name}.png`) });
    }
}

async function main() {
    const { server, address } = await serve(prepare());
    const browser = await chromium.launch({
        executablePath: LADDER_CHROMIUM,
        args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking'],
    });
    const page = await browser.newPage({ viewport: { width: 1280, height: 560 } });
    try {
        await page.goto(new URL(`/?folder=${join(scratch, 'project')}`, address).href);
        let told = 0;
        await until('the probe to end', 60, () => {
            const lines = readFileSync(report, 'utf8').trimEnd().split('\n').filter(Boolean).map((line) => JSON.parse(line));
            for (const line of lines.slice(told)) {
                told += 1;
                if (!line.done) {
                    tell(line);
                }
            }
            return lines.at(-1)?.done;
        });
        await look(page);
        await screenshot(page, 'power');
        await edit(page);
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
    if (existsSync(scratch)) {
        rmSync(scratch, { recursive: true, force: true });
    }
}
process.exit(failed === 0 ? 0 : 1);
