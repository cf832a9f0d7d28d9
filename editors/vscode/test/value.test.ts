import assert from 'node:assert/strict';
import { test } from 'node:test';

import { parseValue, showDuration, showValue } from '../src/value.ts';
import { cases } from './shared.ts';

test('times read as they are written in a program', () => {
    for (const [ms, text] of cases.durations) {
        assert.equal(showDuration(ms), text);
    }
});

test('values read by their type', () => {
    for (const [type, value, text] of cases.shown) {
        assert.equal(showValue({ type, value }), text);
    }
});

test('what is typed is sent as its type wants it, what is not understood as it is', () => {
    for (const [type, text, value] of cases.typed) {
        assert.equal(parseValue(type, text), value, `${type} ${text}`);
    }
});
