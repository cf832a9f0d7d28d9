// The page of the diagram in a browser, with the server at its other end: what VS Code and the playground are to it, without either.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { setTimeout as pause } from 'node:timers/promises';

import { chromium } from 'playwright-core';

import { answer } from '../../panels/diagram/answer.ts';
import { answerOf } from '../../panels/diagram/draw/asker.ts';
import { Teller } from '../../panels/diagram/teller.ts';
import { startServer } from './server.mjs';

const { LADDER_BIN, LADDER_BROWSER, LADDER_ROOT } = process.env;
const URI = 'file:///plant/drawn.clad';
const THEMES = {
    light: { '--vscode-editor-background': '#ffffff', '--vscode-editor-foreground': '#1f1f1f', '--vscode-focusBorder': '#005fb8', '--vscode-panel-border': '#d0d0d0', '--vscode-editorError-foreground': '#e51400', '--vscode-editorWarning-foreground': '#895503', '--vscode-editorInfo-foreground': '#0067b5', '--vscode-button-background': '#005fb8', '--vscode-button-foreground': '#ffffff', '--vscode-button-secondaryBackground': '#e5e5e5', '--vscode-button-secondaryForeground': '#1f1f1f', '--vscode-descriptionForeground': '#3b3b3b', '--vscode-ladder-powerOn': '#0a7d32', '--vscode-ladder-powerOff': '#6b6b6b' },
    dark: { '--vscode-editor-background': '#1f1f1f', '--vscode-editor-foreground': '#cccccc', '--vscode-focusBorder': '#0078d4', '--vscode-panel-border': '#3c3c3c', '--vscode-editorError-foreground': '#f85149', '--vscode-editorWarning-foreground': '#cca700', '--vscode-editorInfo-foreground': '#59a4f9', '--vscode-button-background': '#0078d4', '--vscode-button-foreground': '#ffffff', '--vscode-button-secondaryBackground': '#313131', '--vscode-button-secondaryForeground': '#cccccc', '--vscode-descriptionForeground': '#9d9d9d', '--vscode-ladder-powerOn': '#3fb950', '--vscode-ladder-powerOff': '#8b8b8b' },
};

export function openBrowser() {
    const args = ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync'];
    return chromium.launch({ executablePath: LADDER_BROWSER, args });
}

/** Waits until something holds. */
export async function until(what, holds, most = 10_000) {
    const end = Date.now() + most;
    for (;;) {
        const held = await holds();
        if (held) {
            return held;
        }
        if (Date.now() > end) {
            throw new Error(`waited in vain for ${what}`);
        }
        await pause(15);
    }
}

/** Where a place of a text is in it. */
function offsetOf(text, { line, character }) {
    let at = 0;
    for (let count = 0; count < line; count += 1) {
        at = text.indexOf('\n', at) + 1;
    }
    return at + character;
}

/** A diagram of a text, as an editor shows it. */
export async function openDiagram(browser, text, { theme = 'light', width = 1000, height = 700, context = {}, names } = {}) {
    const opened = await browser.newContext({ viewport: { width, height }, reducedMotion: 'reduce', ...context });
    const page = await opened.newPage();
    const host = { text, version: 1, past: [], future: [], edits: 0, findings: [], errors: [], open: 0, held: undefined };
    page.on('pageerror', (error) => host.errors.push(String(error)));
    page.on('console', (message) => message.type() === 'error' && host.errors.push(message.text()));
    const server = startServer(LADDER_BIN, ({ diagnostics }) => {
        host.findings = diagnostics;
        void report();
    });
    const report = () => {
        const findings = host.findings.map(({ range: { start, end }, severity, message }) => ({ from: start, to: end, severity: severity === 1 ? 'error' : severity === 2 ? 'warning' : 'info', message }));
        return send({ type: 'findings', version: host.version, findings });
    };
    const send = (message) => page.evaluate((message) => window.postMessage(message, '*'), message).catch(() => undefined);
    await server.begin();
    const change = (next) => {
        const changes = [{ first: 0, last: host.text.split('\n').length - 1, count: next.split('\n').length }];
        return become(next, changes);
    };
    const become = async (next, changes) => {
        host.text = next;
        host.version += 1;
        server.notify('textDocument/didChange', { textDocument: { uri: URI, version: host.version }, contentChanges: [{ text: next }] });
        await send({ type: 'edited', version: host.version, lineCount: next.split('\n').length, changes });
    };
    const make = async ({ version, edits }) => {
        if (version !== host.version) {
            throw new Error('The text has changed meanwhile: try again');
        }
        host.past.push(host.text);
        host.future = [];
        host.edits += 1;
        const [last] = [...edits].reverse();
        let next = host.text;
        for (const { range, newText } of [...edits].reverse()) {
            next = next.slice(0, offsetOf(host.text, range.start)) + newText + next.slice(offsetOf(host.text, range.end));
        }
        const changes = [...edits].reverse().map(({ range, newText }) => ({ first: range.start.line, last: range.end.line, count: newText.split('\n').length }));
        await (last && become(next, changes));
        return host.version;
    };
    const fixesAt = async (range) => {
        const diagnostics = host.findings.filter(({ range: { start, end } }) => offsetOf(host.text, start) <= offsetOf(host.text, range.end) && offsetOf(host.text, range.start) <= offsetOf(host.text, end));
        const actions = await server.request('textDocument/codeAction', { textDocument: { uri: URI }, range, context: { diagnostics, only: ['quickfix'] } });
        return actions ?? [];
    };
    const asks = {
        execute: server.execute,
        make,
        fixes: async (range) => (await fixesAt(range)).map(({ title }) => title),
        fix: async (range, title) => {
            const action = (await fixesAt(range)).find((action) => action.title === title);
            const whole = action.edit ? action : await server.request('codeAction/resolve', action);
            const edits = Object.values(whole.edit.changes ?? {})[0] ?? whole.edit.documentChanges[0].edits;
            const at = (a) => offsetOf(host.text, a.range.start);
            await make({ version: host.version, edits: [...edits].sort((a, b) => at(a) - at(b)) });
        },
    };
    const side = {
        send,
        begin: async () => {
            await send({ type: 'open', name: 'drawn.clad', version: host.version, lineCount: host.text.split('\n').length, line: 0, names });
            await report();
        },
        version: () => host.version,
        draw: async ({ lines, rail, known }) => (await host.held, server.execute('ladder.diagram', { uri: URI, lines, rail, known })),
        look() {},
        reveal() {},
        request: (question) => {
            host.open += 1;
            return answerOf(question, URI, asks).finally(() => {
                host.open -= 1;
            });
        },
        history: async (step) => {
            const [from, to] = step === 'undo' ? [host.past, host.future] : [host.future, host.past];
            const next = from.pop();
            if (next !== undefined) {
                to.push(host.text);
                await change(next);
            }
        },
        command() {},
        why() {},
        toggle() {},
        change() {},
    };
    const teller = new Teller(send, () => undefined, () => true);
    server.notify('textDocument/didOpen', { textDocument: { uri: URI, languageId: 'clad', version: 1, text } });
    await page.exposeFunction('sendToEditor', (message) => answer(message, teller, side));
    await page.addInitScript(() => {
        window.acquireVsCodeApi = () => ({ postMessage: (message) => void window.sendToEditor(message), getState: () => undefined, setState() {} });
    });
    const built = (name) => readFileSync(join(LADDER_ROOT, 'editors/vscode/dist/webview', name), 'utf8');
    const colours = Object.entries(THEMES[theme]).map(([name, value]) => `${name}: ${value};`).join(' ');
    await page.route('http://page.test/', (route) =>
        route.fulfill({ contentType: 'text/html', body: `<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><title>Diagram</title><style>:root { ${colours} }\n${built('diagram.style.css')}</style></head><body><script>${built('diagram.js').replaceAll('</script', '<\\/script')}</script></body></html>` }),
    );
    await page.goto('http://page.test/');
    const isDrawn = async () => host.text === '' || Number(await page.evaluate(() => document.querySelector('.canvas').dataset.version)) === host.version;
    // An answer leads to the next question in a task of the page, so it is asked more than once.
    const isQuiet = async () => {
        for (let count = 0; count < 3; count += 1) {
            await page.evaluate(() => new Promise((resolve) => setTimeout(resolve, 0)));
            if (host.open > 0 || !(await isDrawn())) {
                return false;
            }
        }
        return true;
    };
    await until('the drawing', () => page.evaluate(() => document.querySelector('.piece') !== null || document.querySelector('.empty').textContent !== ''));
    return {
        page,
        host,
        server,
        change,
        focused: () => page.evaluate(() => document.activeElement?.getAttribute('aria-label') ?? ''),
        refusal: () => page.evaluate(() => document.querySelector('.refusal:not([hidden])')?.textContent ?? ''),
        settled: () => until('the drawing', isDrawn),
        /** What has been pressed has done all that it does: no question is without its answer, and the text is drawn. */
        quiet: () => until('the end of what was pressed', isQuiet),
        becomes: (wanted) => until(`the text\n${wanted}\n`, () => host.text === wanted).catch((error) => { throw new Error(`${error.message}but it is\n${host.text}`); }),
        end: async () => {
            server.end();
            await opened.close();
        },
    };
}
