// The page of a scene in a browser, with the server at its other end: what VS Code and the playground are to it, without either.
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

import { SceneTeller } from '../../panels/scene/teller.ts';
import { Session } from '../../panels/session.ts';
import { until } from './host.mjs';
import { startServer } from './server.mjs';

const { LADDER_BIN, LADDER_ROOT } = process.env;
const built = (name) => readFileSync(join(LADDER_ROOT, 'editors/vscode/dist/webview', name), 'utf8');

/** A scene of a folder of files, as an editor shows it. */
export async function openScene(browser, files, name, { context = {} } = {}) {
    const folder = mkdtempSync(join(tmpdir(), 'ladder-scene-'));
    Object.entries(files).forEach(([name, text]) => writeFileSync(join(folder, name), text));
    const address = (name) => pathToFileURL(join(folder, name)).href;
    const opened = await browser.newContext({ viewport: { width: 800, height: 600 }, reducedMotion: 'reduce', ...context });
    const page = await opened.newPage();
    const host = { errors: [], requests: [], dialogs: 0, messages: [] };
    page.on('pageerror', (error) => host.errors.push(String(error)));
    page.on('console', (message) => message.type() === 'error' && host.errors.push(message.text()));
    page.on('request', (request) => host.requests.push(request.url()));
    page.on('dialog', (dialog) => { host.dialogs += 1; void dialog.dismiss(); });
    let session;
    const server = startServer(LADDER_BIN, () => undefined, ({ method, params }) => {
        if (method === 'ladder/simulationState' && params.session === session?.id) {
            session.take(params);
            teller.tell();
            server.notify('ladder/simulationShown', { session: session.id });
        }
    });
    await server.begin();
    const send = (message) => {
        host.messages.push(message);
        return page.evaluate((message) => window.postMessage(message, '*'), message).catch(() => undefined);
    };
    const command = async (name, argument) => session.take(await session.command(name, argument));
    const start = async (program) => {
        const text = readFileSync(new URL(program), 'utf8');
        server.notify('textDocument/didOpen', { textDocument: { uri: program, languageId: 'clad', version: 1, text } });
        session = await Session.start({ uri: program, version: 1 }, { lines: [], tags: [] }, (name, argument) => server.execute(`ladder.simulate.${name}`, argument));
        teller.tell();
    };
    const teller = new SceneTeller({
        send,
        scene: (session) => server.execute('ladder.scene', { uri: address(name), ...(session && { session }) }),
        session: () => session,
        give: (tag, given) => command('set', { tag, ...given }),
        run: async (program) => {
            await (session ? undefined : start(program));
            await command('run', {});
            teller.tell();
        },
        pause: async () => {
            session.take(await session.urgent('pause', {}));
            teller.tell();
        },
    }, () => address(name));
    await page.exposeFunction('sendToEditor', (message) => teller.answer(message));
    await page.addInitScript(() => {
        let state;
        window.acquireVsCodeApi = () => ({ postMessage: (message) => void window.sendToEditor(message), getState: () => state, setState: (next) => { state = next; } });
    });
    // As an editor lets the page in.
    const policy = "default-src 'none'; style-src 'nonce-own'; script-src 'nonce-own'";
    await page.route('http://page.test/', (route) =>
        route.fulfill({ contentType: 'text/html', body: `<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><meta http-equiv="Content-Security-Policy" content="${policy}"><title>Scene</title><style nonce="own">${built('scene.style.css')}</style></head><body><script nonce="own">${built('scene.js').replaceAll('</script', '<\\/script')}</script></body></html>` }),
    );
    await page.goto('http://page.test/');
    await until('the picture', () => page.evaluate(() => document.querySelector('.picture svg, .notice:not([hidden])') !== null));
    return {
        page,
        host,
        teller,
        start: () => start(teller.program),
        command,
        tag: async (name) => (await session.urgent('tags', { names: [name] })).tags[0]?.value,
        end: async () => {
            server.end();
            await opened.close();
            rmSync(folder, { recursive: true });
        },
    };
}
