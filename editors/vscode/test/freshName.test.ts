import assert from 'node:assert/strict';
import { test } from 'node:test';

import { freshName } from '../src/freshName.ts';

test('a file that is there is left alone', () => {
    const there = new Set(['motor-recorded.ladder-test', 'motor-recorded-2.ladder-test', 'plain']);
    assert.equal(freshName('motor-recorded.ladder-test', there), 'motor-recorded-3.ladder-test');
    assert.equal(freshName('tank-recorded.ladder-test', there), 'tank-recorded.ladder-test');
    assert.equal(freshName('plain', there), 'plain-2');
});

test('a name that differs only in case is the same file', () => {
    assert.equal(freshName('motor-recorded.ladder-test', ['Motor-Recorded.ladder-test']), 'motor-recorded-2.ladder-test');
});
