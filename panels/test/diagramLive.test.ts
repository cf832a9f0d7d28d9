import assert from 'node:assert/strict';
import { test } from 'node:test';

import { Feed, type Source } from '../diagram/feed.ts';
import type { LiveUpdate } from '../diagram/messages.ts';
import type { Operand, Power, State, Tag } from '../protocol.ts';
import { isSwitch, Live } from '../diagram/live.ts';
import { describe } from '../diagram/speech.ts';

const at = (line: number, character: number, length = 5) => ({ start: { line, character }, end: { line, character: character + length } });

function tag(name: string, value: Tag['value'], more: Partial<Tag> = {}): Tag {
    const text = typeof value === 'boolean' ? String(Number(value)) : String(value);
    return { name, type: typeof value === 'boolean' ? 'BOOL' : 'DINT', value, text, role: 'input', forced: false, ...more };
}

const state: State = {
    session: 's1', uri: 'file:///a.clad', version: 1, stale: false, status: 'paused', text: 'paused, scan 3, 30ms', scan: 3, timeMs: 30,
    behind: 0, ahead: 0, forced: 0, tags: [], power: [], faults: [],
};

/** What is known of a rung in each of these lines: `[ ]( aN )--( )( y )`. */
function source(lines: readonly number[], tags: Tag[]): Source & { tags: Map<string, Tag>; texts: number } {
    const power = (line: number): [number, Power][] => [
        [3, { range: at(line, 3), on: false, contact: 'open' }],
        [12, { range: at(line, 12), on: false }],
    ];
    const operands = (line: number): Operand[] => [{ range: at(line, 8), block: at(line, 3), tags: [`a${line}`], drawn: true }];
    const byName = new Map(tags.map((tag) => [tag.name, tag]));
    return {
        state,
        texts: 1,
        stale: false,
        tags: byName,
        power: new Map(lines.map((line) => [line, new Map(power(line))])),
        operands: new Map(lines.map((line) => [line, operands(line)])),
        tag: (name) => byName.get(name),
    };
}

test('a page is sent the lines that it shows, and then of what changes there', () => {
    const feed = new Feed();
    const program = source([0, 1, 2], [tag('a0', false), tag('a1', false), tag('a2', false)]);
    const first = feed.changes(program, { first: 0, last: 1 });
    assert.equal(first.whole, true);
    assert.deepEqual(first.power, [[0, 3, false, 'open'], [0, 12, false], [1, 3, false, 'open'], [1, 12, false]]);
    assert.deepEqual(first.operands, [[0, 8, ['a0'], true], [1, 8, ['a1'], true]]);
    assert.deepEqual(first.tags.map(({ name }) => name), ['a0', 'a1']);

    const nothing = feed.changes(program, { first: 0, last: 1 });
    assert.deepEqual([nothing.whole, nothing.power, nothing.operands, nothing.tags], [false, [], [], []]);

    (program.power.get(1) as Map<number, Power>).set(3, { range: at(1, 3), on: true, contact: 'closed' });
    program.tags.set('a1', tag('a1', true));
    program.tags.set('a2', tag('a2', true));
    const second = feed.changes(program, { first: 0, last: 1 });
    assert.deepEqual([second.power, second.tags.map(({ name }) => name)], [[[1, 3, true, 'closed']], ['a1']]);
});

test('of a controller a page is told what is not known', () => {
    const program = source([0], []);
    (program.power.get(0) as Map<number, Power>).set(12, { range: at(0, 12), on: false, unknown: true });
    assert.deepEqual(new Feed().changes(program, { first: 0, last: 0 }).power, [[0, 3, false, 'open'], [0, 12, false, 'unknown']]);
});

test('what changes too fast to follow is said once, and as it is when the run is over', () => {
    const feed = new Feed();
    const running = source([0], []);
    const program = { ...running, state: { ...state, status: 'running' } as State };
    const sent: string[] = [];
    for (let time = 0; time < 20; time += 1) {
        (running.power.get(0) as Map<number, Power>).set(12, { range: at(0, 12), on: time % 2 === 1 });
        sent.push(...feed.changes(program, { first: 0, last: 0 }, true, time * 33).power.map(([, character, on, does]) => `${character} ${does ?? on}`));
    }
    assert.deepEqual(sent, ['3 open', '12 false', '12 true', '12 false', '12 true', '12 false', '12 true', '12 flickers']);
    program.state = { ...state, status: 'paused' };
    assert.deepEqual(feed.changes(program, { first: 0, last: 0 }, true, 700).power, [[0, 12, true]]);
});

test('values may wait, but not those of lines that come into sight', () => {
    const feed = new Feed();
    const program = source([0, 1], [tag('a0', 1), tag('a1', 1)]);
    const values = (last: number, withValues: boolean) =>
        feed.changes(program, { first: 0, last }, withValues).tags.map(({ name, value }) => `${name} ${value}`);
    assert.deepEqual(values(0, false), ['a0 1']);
    program.tags.set('a0', tag('a0', 2));
    assert.deepEqual([values(0, false), values(1, false), values(1, true), values(1, true)], [[], ['a1 1'], ['a0 2'], []]);
});

test('of another text, and after it has forgotten, all is sent again', () => {
    const feed = new Feed();
    const program = source([0], [tag('a0', false)]);
    const changes = () => feed.changes(program, { first: 0, last: 0 });
    assert.deepEqual([changes().power.length, changes().power.length], [2, 0]);
    program.texts += 1;
    assert.deepEqual([changes().whole, changes().whole], [true, false]);
    feed.forget();
    assert.equal(changes().power.length, 2);
});

function update(more: Partial<LiveUpdate>): LiveUpdate {
    return { whole: false, status: state.status, text: state.text, power: [], operands: [], tags: [], ...more };
}

test('what is known moves with the text', () => {
    const live = new Live();
    live.take(update({ whole: true, power: [[4, 3, true, 'closed']], operands: [[4, 8, ['start'], true]], tags: [tag('Start', true)] }));
    live.edit([{ first: 1, last: 1, count: 3 }]);
    assert.equal(live.power(4, 3), undefined);
    assert.deepEqual(live.power(6, 3), { on: true, does: 'closed' });
    assert.deepEqual(live.tagsOf([[6, 8], [6, 8], [6, 20]]).map(({ value }) => value), [true]);
    live.take(undefined);
    assert.deepEqual([live.power(6, 3), live.tag('start')], [undefined, undefined]);
});

test('the contact of an input is a switch; of anything else a click leads to the text', () => {
    assert.ok(isSwitch('contact', tag('start', false)));
    assert.ok(!isSwitch('coil', tag('start', false)));
    assert.ok(!isSwitch('contact', tag('run', false, { role: 'output' })));
    assert.ok(!isSwitch('contact', tag('limit', true, { readOnly: true })));
    assert.ok(!isSwitch('contact', tag('level', 4)));
    assert.ok(!isSwitch('contact', undefined), 'nothing runs');
});

test('elements are said in words', () => {
    const start = { kind: 'contact', name: 'Open contact', operands: ['start'] };
    assert.equal(describe(start, undefined, []), 'Open contact start');
    const flows = { on: true, does: 'closed' } as const;
    assert.equal(
        describe(start, flows, [tag('start', true, { forced: true })]),
        'Open contact start, lets power through, power flows, start is 1, forced',
    );
    const words = (does: 'closed' | 'open' | 'blocks' | 'flickers' | 'unknown') => describe(start, { on: false, does }, []).split(', ').slice(1);
    assert.deepEqual(words('closed'), ['lets power through', 'no power']);
    assert.deepEqual(words('open'), ['does not let power through', 'no power']);
    assert.deepEqual(words('blocks'), ['blocks the power that comes']);
    assert.deepEqual(words('flickers'), ['changes faster than can be followed']);
    assert.deepEqual(words('unknown'), ['it is not known whether power flows']);
    const timer = { kind: 'block', name: 'On-delay timer', operands: ['warm', 'T#5s'] };
    const tags = [tag('warm.ET', 1500, { type: 'TIME', text: '1.5s' }), tag('warm.Q', false)];
    assert.equal(describe(timer, { on: false, does: undefined }, tags), 'On-delay timer warm T#5s, no power, warm.ET is 1.5s, warm.Q is 0');
});
