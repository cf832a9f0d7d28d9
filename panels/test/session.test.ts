import assert from 'node:assert/strict';
import { test } from 'node:test';

import type { State } from '../protocol.ts';
import { type Send, Session } from '../session.ts';

const state: State = {
    session: 's1',
    uri: 'file:///motor.clad',
    version: 1,
    stale: false,
    status: 'paused',
    text: 'paused, scan 0, 0ms',
    scan: 0,
    timeMs: 0,
    behind: 0,
    ahead: 0,
    forced: 0,
    tags: [],
    power: [{ range: { start: { line: 0, character: 0 }, end: { line: 0, character: 1 } }, on: true }],
    faults: [],
};

const nothing = { lines: [], tags: [] };

// Only the address and the version of the document are used.
const document = { uri: { toString: () => 'file:///motor.clad' }, version: 1 } as unknown as Session['document'];

/** A server that answers when it is asked to, and a list of what it was sent. */
function slowServer() {
    const sent: string[] = [];
    const answers: ((value: unknown) => void)[] = [];
    const send = ((name: string, argument: object) => {
        sent.push(`${name} ${JSON.stringify(argument)}`);
        return name === 'start' ? Promise.resolve({ session: 's1', state }) : new Promise((resolve) => answers.push(resolve));
    }) as unknown as Send;
    return { sent, send, answer: () => answers.shift()?.(state) };
}

const nextTurn = () => new Promise(setImmediate);

test('commands wait for one another, a pause does not', async () => {
    const { sent, send, answer } = slowServer();
    const session = await Session.start(document, nothing, send);
    void session.command('set', { tag: 'start', value: true });
    void session.command('step', { scans: 3 });
    await nextTurn();
    assert.deepEqual(sent, [
        'start {"uri":"file:///motor.clad","options":{"show":{"lines":[],"tags":[]}}}',
        'set {"tag":"start","value":true,"session":"s1"}',
    ]);
    answer();
    await nextTurn();
    assert.equal(sent.at(-1), 'step {"scans":3,"session":"s1"}');
    void session.urgent('pause', {});
    assert.equal(sent.at(-1), 'pause {"session":"s1"}');
});

test('a refused command does not hold up the next', async () => {
    const sent: string[] = [];
    const send = ((name: string) => {
        sent.push(name);
        return name === 'set' ? Promise.reject(new Error('no such tag')) : Promise.resolve(name === 'start' ? { state } : state);
    }) as unknown as Send;
    const session = await Session.start(document, nothing, send);
    await assert.rejects(session.command('set', { tag: 'strat', value: true }), /no such tag/);
    await session.command('step', { scans: 1 });
    assert.deepEqual(sent, ['start', 'set', 'step']);
});

test('an edit waits for what the server says of the new text, which is all there is', async () => {
    const session = await Session.start(document, nothing, slowServer().send);
    session.edited();
    assert.equal(session.stale, true);
    const tag = { name: 'Run', type: 'BOOL', value: true, text: '1', role: 'output', forced: false } as const;
    session.take({ ...state, delta: true, tags: [tag] });
    assert.equal(session.stale, true, 'of the text before');
    session.take({ ...state, version: document.version, tags: [], power: [] });
    assert.deepEqual([session.stale, session.tag('Run')], [false, undefined]);
});

test('what is sent is kept, until its lines are shown no more', async () => {
    const { sent, send } = slowServer();
    const session = await Session.start(document, nothing, send);
    const range = (line: number) => ({ start: { line, character: 0 }, end: { line, character: 1 } });
    const tag = { name: 'Run', type: 'BOOL', value: true, text: '1', role: 'output', forced: false } as const;
    const operands = [3, 3, 4].map((line) => ({ range: range(line), block: range(line), tags: ['Run'] }));
    assert.equal(session.take({ ...state, tags: [tag], power: [{ range: range(3), on: true }], operands }), true);
    assert.equal(session.take({ ...state, delta: true, scan: 7, tags: [], power: [] }), false, 'nothing of the drawing');
    assert.deepEqual([session.tag('RUN')?.value, session.state.scan, session.operands.get(3)?.length], [true, 7, 2]);
    const shown = { lines: [{ first: 4, last: 9 }], tags: [] };
    assert.equal(session.show(shown), true);
    assert.equal(session.show({ ...shown }), false, 'the same is not sent again');
    assert.deepEqual([...session.power.keys(), ...session.operands.keys()], [4]);
    const label = { tag: 'Run', at: range(4).start, side: 'above', column: 0 } as const;
    assert.equal(session.take({ ...state, delta: true, tags: [], power: [], labels: [label] }), true);
    session.take({ ...state, delta: true, tags: [], power: [] });
    assert.deepEqual(session.labels, [label], 'until it is given others');
    assert.equal(sent.at(-1), 'show {"lines":[{"first":4,"last":9}],"tags":[],"session":"s1"}');
});
