import assert from 'node:assert/strict';
import { test } from 'node:test';

import { withLinesOnly } from '../src/stackFrames.ts';

test('a stop marks nothing within a line, and selects nothing', () => {
    const frame = { id: 1, name: 'main', line: 14, column: 22, endLine: 14, endColumn: 40 };
    const answer = { type: 'response', command: 'stackTrace', body: { stackFrames: [frame], totalFrames: 1 } };
    assert.deepEqual(withLinesOnly(answer), {
        type: 'response',
        command: 'stackTrace',
        body: { stackFrames: [{ id: 1, name: 'main', line: 14, column: 1 }], totalFrames: 1 },
    });
    const other = { type: 'event', event: 'stopped' };
    assert.equal(withLinesOnly(other), other);
    const failed = { type: 'response', command: 'stackTrace', success: false };
    assert.equal(withLinesOnly(failed), failed);
});
