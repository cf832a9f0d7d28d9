import assert from 'node:assert/strict';
import { test } from 'node:test';

import type { Fault } from '../src/protocol.ts';
import { statusText } from '../src/statusText.ts';

const zero = { line: 0, character: 0 };
const fault: Fault = { message: 'division by zero', range: { start: zero, end: zero }, scan: 3 };

test('status, scan and time are shown', () => {
    const { text, warning } = statusText({ status: 'paused', scan: 3, timeMs: 30, forced: 0, faults: [], stale: false }, 1);
    assert.equal(text, '$(debug-pause) Ladder: paused, scan 3, 30ms');
    assert.equal(warning, false);
});

test('a session whose text has errors says so', () => {
    const { text, tooltip, warning } = statusText({ status: 'running', scan: 12, timeMs: 1200, forced: 0, faults: [], stale: true }, 1);
    assert.match(text, /before the errors in the text$/);
    assert.match(tooltip, /has errors/);
    assert.equal(warning, true);
});

test('faults are counted, and the last one is in the tooltip', () => {
    const { text, tooltip } = statusText({ status: 'faulted', scan: 3, timeMs: 30, forced: 0, faults: [fault, fault], stale: false }, 1);
    assert.match(text, /2 faults$/);
    assert.equal(tooltip, 'division by zero');
});

test('forces and the speed are always in sight', () => {
    const { text, warning } = statusText({ status: 'running', scan: 3, timeMs: 30, forced: 2, faults: [], stale: false }, 0.1);
    assert.equal(text, '$(play) Ladder: running, scan 3, 30ms, 0.1x speed, 2 forced');
    assert.equal(warning, true);
    assert.match(statusText({ status: 'running', scan: 3, timeMs: 30, forced: 0, faults: [], stale: false }, 'max').text, /full speed$/);
});
