import assert from 'node:assert/strict';
import { test } from 'node:test';

import { breakpointLines, breakpointsAt, toggled } from '../src/breakpoints.ts';

type Breakpoints = Parameters<typeof breakpointLines>[0];

const at = (uri: string, line: number, enabled = true) => ({ enabled, location: { uri: { toString: () => uri }, range: { start: { line } } } });

test('the lines of one document, in order, without those that are switched off', () => {
    const all = [at('file:///a.clad', 7), at('file:///b.clad', 1), at('file:///a.clad', 2), at('file:///a.clad', 3, false), at('file:///a.clad', 7), { enabled: true, functionName: 'main' }];
    assert.deepEqual(breakpointLines(all as unknown as Breakpoints, 'file:///a.clad'), [2, 7]);
});

test('those on a block are told from others of its line', () => {
    const on = (character: number) => ({ enabled: true, location: { uri: { toString: () => 'file:///a.clad' }, range: { start: { line: 4, character } } } });
    const all = [on(0), on(12)];
    const found = (character: number) => breakpointsAt(all as unknown as Breakpoints, 'file:///a.clad', { line: 4, character });
    assert.deepEqual(found(12), [all[1]]);
    assert.deepEqual(found(3), []);
});

test('a name goes in and out', () => {
    assert.deepEqual(toggled([], 'run'), ['run']);
    assert.deepEqual(toggled(['run', 'n'], 'run'), ['n']);
});
