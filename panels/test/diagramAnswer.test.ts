import assert from 'node:assert/strict';
import { test } from 'node:test';

import { answer, type Side } from '../diagram/answer.ts';
import type { Drawn, FromPage } from '../diagram/messages.ts';
import { Teller } from '../diagram/teller.ts';
import { reasonOf } from '../reason.ts';

const drawn: Drawn = { uri: 'file:///a.clad', version: 3, lineCount: 1, lines: { first: 0, last: 0 }, pieces: [] };

/** What an editor is asked to do for a page that says this. */
async function asked(message: FromPage, draw: () => Promise<Drawn> = () => Promise.resolve(drawn)) {
    const done: unknown[][] = [];
    const note = (name: string) => (...given: unknown[]) => void done.push([name, ...given]);
    const names = ['send', 'begin', 'look', 'reveal', 'command', 'why', 'toggle', 'change'] as const;
    const side = { ...Object.fromEntries(names.map((name) => [name, note(name)])), draw, version: () => 2 } as unknown as Side;
    const teller = new Teller(() => undefined, () => undefined, () => true);
    await answer(message, teller, side);
    return { done, lines: teller.lines };
}

test('what a person asks for is done in the editor', async () => {
    const done = async (message: FromPage) => (await asked(message)).done;
    assert.deepEqual(await done({ type: 'command', name: 'run' }), [['command', 'run']]);
    assert.deepEqual(await done({ type: 'why', tag: 'a' }), [['why', 'a']]);
    assert.deepEqual(await done({ type: 'toggle', tag: 'a' }), [['toggle', 'a']]);
    assert.deepEqual(await done({ type: 'set', tag: 'a', text: '5s' }), [['change', 'set', { tag: 'a', text: '5s' }]]);
    assert.deepEqual(await done({ type: 'force', tag: 'a', value: true }), [['change', 'force', { tag: 'a', value: true }]]);
    assert.deepEqual(await done({ type: 'unforce', tag: 'a' }), [['change', 'unforce', { tag: 'a' }]]);
});

test('lines that come into sight are kept ready', async () => {
    const lines = { first: 3, last: 9 };
    assert.deepEqual(await asked({ type: 'sees', lines }), { done: [['look']], lines });
});

test('what is asked for is drawn, or said why it is not', async () => {
    const ask: FromPage = { type: 'ask', lines: { first: 0, last: 0 }, rail: 0, known: [] };
    assert.deepEqual((await asked(ask)).done, [['send', { type: 'drawn', drawn }]]);
    const refused = () => Promise.reject({ code: -32803, message: 'it is not open' });
    assert.deepEqual((await asked(ask, refused)).done, [['send', { type: 'failed', version: 2, message: 'it is not open' }]]);
});

test('a reason is what an error says', () => {
    assert.deepEqual([new Error('no'), { code: 1, message: 'no' }, 'no', undefined].map(reasonOf), ['no', 'no', 'no', 'undefined']);
});
