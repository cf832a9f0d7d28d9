import assert from 'node:assert/strict';
import { test } from 'node:test';

import { changeOf } from '../src/client.ts';

const range = (line: number, from: number, to: number, lastLine = line) => ({ start: { line, character: from }, end: { line: lastLine, character: to } });

test('a letter that was typed is where it was typed', () => {
    assert.deepEqual(changeOf('+--\n+--', '+--\n+---'), { range: range(1, 3, 3), text: '-' });
    assert.deepEqual(changeOf('', 'a'), { range: range(0, 0, 0), text: 'a' });
});

test('what is deleted and what is replaced is one stretch', () => {
    assert.deepEqual(changeOf('a\nb\nc', 'a\nc'), { range: range(1, 0, 0, 2), text: '' });
    assert.deepEqual(changeOf('start stop', 'start halt'), { range: range(0, 6, 10), text: 'halt' });
});

test('a text that stays has no change', () => {
    assert.deepEqual(changeOf('aaa', 'aaa'), { range: range(0, 3, 3), text: '' });
});
