// Random hands: whatever they do in the page, text and diagram stay two views of one program, and undo leads back.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { diagrams, railed, until } from './drawn.mjs';

const open = diagrams();
const PAGES = 20;
const STEPS = 6;
const SEED = Number(process.env.LADDER_SEED ?? 1131);

const PROGRAM = `# The first. #
${railed('+--\\--[ ]( a )--\\--[/]( b )--', '( )( y )')}${railed('|  /--[ ]( c )--/')}
${railed('+--[ ]( d )--', '[TON]( t, 5s )--(S)( z )')}`;

/** Numbers that are the same for the same seed. */
function numbers(seed) {
    let state = seed >>> 0;
    return (below) => {
        state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
        return Math.floor((state / 2 ** 32) * below);
    };
}

const KEYS = ['c', 'Shift+c', 'b', 'Shift+b', 'q', '/', 'e', 's', 'r', 'Delete', 'k', 'j', 'y', 'Alt+ArrowLeft', 'Alt+ArrowRight', 'Alt+ArrowUp', 'Alt+ArrowDown', 'Alt+Shift+ArrowUp', 'Alt+Shift+ArrowDown', 'n', '#', 'a', 'Shift+ArrowRight'];

/** The drawing that is on the page, without what has the focus and what is only new. */
const shown = (page) => page.evaluate(() => [...document.querySelectorAll('.piece > svg')].map((svg) => [...svg.querySelectorAll(':scope > line, :scope > text, g.element:not(.point, .join, .note)')].map((node) => `${node.tagName} ${node.getAttribute('data-at') ?? node.getAttribute('data-power') ?? ''} ${node.textContent}`).join('\n')));

for (let number = 0; number < PAGES; number += 1) {
    test(`hands with seed ${SEED + number}`, async () => {
        const random = numbers(SEED + number);
        const { page, host, server, element, quiet } = await open(PROGRAM);
        await element('contact', 'a').focus();
        for (let step = 0; step < STEPS; step += 1) {
            const [key, chosen] = [KEYS[random(KEYS.length)], random(1000)];
            await page.evaluate((chosen) => {
                const nodes = document.querySelectorAll('g.element');
                nodes[chosen % nodes.length]?.focus();
            }, chosen);
            await page.keyboard.press(key);
            const field = page.locator('.field :is(input, textarea)');
            await quiet();
            if ((await field.count()) > 0) {
                await field.fill(key === 'n' ? 'XIC p OTE q' : key === '#' ? 'A note.' : `x${random(4)}`);
                await field.press('Enter');
                await quiet();
            }
            const { edits } = await server.execute('ladder.diagramEdit', { uri: 'file:///plant/drawn.clad', version: host.version, edit: { op: 'network', place: 'below', text: '[ ]( probe )--( )( probed )' } });
            assert.ok(edits.length > 0, 'the text can be drawn in');
            const wrong = host.findings.filter(({ severity, code }) => severity === 1 && ['unpaired-connector', 'unexpected-character', 'unclosed-block', 'missing-wire'].includes(code));
            assert.deepEqual(wrong, [], host.text);
        }
        const formatted = await server.request('textDocument/formatting', { textDocument: { uri: 'file:///plant/drawn.clad' }, options: { tabSize: 4, insertSpaces: true } });
        assert.deepEqual(formatted ?? [], [], `is laid out:\n${host.text}`);
        const fresh = await open(host.text);
        await until('the same drawing', async () => JSON.stringify(await shown(page)) === JSON.stringify(await shown(fresh.page))).catch(async () => assert.deepEqual(await shown(page), await shown(fresh.page), host.text));
        for (let count = host.edits; count > 0; count -= 1) {
            const { version } = host;
            await page.locator('.view').focus().catch(() => undefined);
            await page.keyboard.press('Control+z');
            await until('a step back', () => host.version > version);
        }
        assert.equal(host.text, PROGRAM);
        assert.deepEqual(host.errors, []);
    });
}
