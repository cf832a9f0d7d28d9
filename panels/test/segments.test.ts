import assert from 'node:assert/strict';
import { test } from 'node:test';

import { segmentsInBlocks, segmentsOf } from '../diagram/draw/segments.ts';

for (const [text, operands] of [
    ['', ['']],
    ['t, T#1s', ['t', 'T#1s']],
    ["y, 'a, b', LIMIT(1, x, 9)", ['y', "'a, b'", 'LIMIT(1, x, 9)']],
    ['y[1,2],  R := r ', ['y[1,2]', 'R := r']],
    ['a,', ['a', '']],
] as const) {
    test(`the operands of \`${text}\``, () => {
        assert.deepEqual(segmentsOf(text).map(([start, end]) => text.slice(start, end)), operands);
    });
}

test('the operands of all blocks', () => {
    const text = '[ ]( a )--[TON]( t, 5s )';
    assert.deepEqual(segmentsInBlocks(text).map(([start, end]) => text.slice(start, end)), ['a', 't', '5s']);
});
