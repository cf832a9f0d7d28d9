// VS Code as code-server ships it, in folders of its own, and a browser without a screen that shows it.
import { execFileSync, spawn } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { chromium } from 'playwright-core';

const codeServer = fileURLToPath(import.meta.resolve('code-server/out/node/entry.js'));

/** What every session has: nothing that comes in between, and nothing that goes out. */
export const QUIET = {
    'workbench.startupEditor': 'none',
    'workbench.secondarySideBar.defaultVisibility': 'hidden',
    'chat.disableAIFeatures': true,
    'telemetry.telemetryLevel': 'off',
    // In a browser it is on: an answer that comes after a save would be a step of undo of its own.
    'files.autoSave': 'off',
    // What is counted in scans begins with the first.
    'ladder.start.paused': true,
    // As text on the page, which can be read.
    'terminal.integrated.gpuAcceleration': 'off',
};

/** How long anything is waited for, in seconds: much longer than it takes, for a busy machine is no fault. */
const PATIENCE = 60;

/** Waits until something holds. */
export async function until(what, holds, seconds = PATIENCE) {
    const limit = Date.now() + seconds * 1000;
    while (!(await holds())) {
        if (Date.now() > limit) {
            throw new Error(`waited ${seconds} s in vain for ${what}`);
        }
        await new Promise((resolve) => setTimeout(resolve, 50));
    }
}

/** A fresh folder with the folders of a user: data, extensions, home and the project that is opened. */
export function scratchFolder() {
    const scratch = mkdtempSync(join(tmpdir(), 'ladder-vscode-'));
    for (const folder of ['data/Machine', 'data/User', 'extensions', 'home', 'project']) {
        mkdirSync(join(scratch, folder), { recursive: true });
    }
    return scratch;
}

/**
 * Starts the server of VS Code with extensions.
 *
 * @param extensions paths of packages
 * @param settings in addition to those that keep it quiet
 * @param env the environment of the extension host
 * @returns its process and its address
 */
export async function serve(scratch, { extensions, settings, env, trust = true }) {
    const trusted = trust ? { 'security.workspace.trust.enabled': false } : {};
    writeFileSync(join(scratch, 'data/Machine/settings.json'), JSON.stringify({ ...QUIET, ...trusted, ...settings }));
    writeFileSync(join(scratch, 'config.yaml'), 'auth: none\n');
    // Without these code-server would write its configuration and data into the user's home.
    const folders = ['--user-data-dir', join(scratch, 'data'), '--extensions-dir', join(scratch, 'extensions')];
    const common = [codeServer, '--config', join(scratch, 'config.yaml'), ...folders];
    for (const extension of extensions) {
        execFileSync(process.execPath, [...common, '--install-extension', extension], { stdio: 'pipe' });
    }
    const quiet = ['--disable-telemetry', '--disable-update-check', ...(trust ? ['--disable-workspace-trust'] : [])];
    const server = spawn(process.execPath, [...common, ...quiet, '--bind-addr', '127.0.0.1:0', join(scratch, 'project')], {
        env,
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
    await until('code-server to listen', () => address);
    return { server, address };
}

/** Opens the project in a browser. */
export async function openBrowser(scratch, address, options = {}) {
    const browser = await chromium.launch({
        executablePath: process.env.LADDER_CHROMIUM,
        args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking'],
    });
    const page = await browser.newPage({ viewport: { width: 1400, height: 860 }, ...options });
    page.setDefaultTimeout(PATIENCE * 1000);
    await page.goto(new URL(`/?folder=${join(scratch, 'project')}`, address).href);
    return { browser, page };
}

export function removeScratch(scratch) {
    rmSync(scratch, { recursive: true, force: true, maxRetries: 5, retryDelay: 200 });
}
