import assert from 'node:assert/strict';
import { test } from 'node:test';

import { parseValue, showDuration, showValue } from '../src/value.ts';

test('a BOOL is typed in many ways', () => {
    for (const text of ['1', 'TRUE', 'true', 'on', ' High ']) {
        assert.equal(parseValue('BOOL', text), true, text);
    }
    for (const text of ['0', 'FALSE', 'off', 'low']) {
        assert.equal(parseValue('BOOL', text), false, text);
    }
});

test('what is not understood goes to the server as it is', () => {
    assert.equal(parseValue('BOOL', 'maybe'), 'maybe');
    assert.equal(parseValue('TIME', 'T#1h30m'), 'T#1h30m');
    assert.equal(parseValue('INT', '16#FF'), '16#FF');
    assert.equal(parseValue('INT', '0x10'), '0x10');
    assert.equal(parseValue('INT', ''), '');
});

test('numbers go as numbers, unless they would lose digits', () => {
    assert.equal(parseValue('DINT', '-1_000'), -1000);
    assert.equal(parseValue('LREAL', '1.5e-3'), 0.0015);
    assert.equal(parseValue('LINT', '9007199254740993'), '9007199254740993');
});

test('strings keep their blanks and lose their quotes', () => {
    assert.equal(parseValue('STRING[80]', "'it''s'"), "it''s");
    assert.equal(parseValue('STRING', ' a b '), ' a b ');
});

test('times read as they are written in a program', () => {
    assert.equal(showDuration(0), '0ms');
    assert.equal(showDuration(20), '20ms');
    assert.equal(showDuration(0.1), '0.1ms');
    assert.equal(showDuration(1000), '1s');
    assert.equal(showDuration(90_500), '1m30.5s');
    assert.equal(showDuration(86_400_000 + 3_600_000), '1d1h');
    assert.equal(showDuration(-250), '-250ms');
});

test('values read by their type', () => {
    assert.equal(showValue({ type: 'BOOL', value: true }), '1');
    assert.equal(showValue({ type: 'TIME', value: 1500 }), '1.5s');
    assert.equal(showValue({ type: 'DINT', value: -7 }), '-7');
    assert.equal(showValue({ type: 'REAL', value: 0.1 + 0.2 }), '0.3');
    assert.equal(showValue({ type: 'STRING', value: 'hi' }), "'hi'");
    assert.equal(showValue({ type: 'LINT', value: '9007199254740993' }), '9007199254740993');
});
