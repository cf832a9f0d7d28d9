import assert from 'node:assert/strict';
import { test } from 'node:test';

import type { Tag } from '../src/protocol.ts';
import { tagHere } from '../src/tagHere.ts';

const tags = ['run', 'warmup.Q', 'warmup.ET', 'größe'].map((name) => ({ name })) as unknown as Tag[];
const line = '+--[ ]( Run )--[TON]( warmup, 5s )--[MOV]( größe, a[3] )--( )( t1.ET )--+';

test('the tag around a place', () => {
    for (const [word, tag] of [['Run', 'run'], ['warmup', 'warmup.Q'], ['größe', 'größe'], ['a[3]', 'a[3]'], ['t1.ET', 't1.ET']] as const) {
        assert.equal(tagHere(line, line.indexOf(word) + 1, tags), tag);
    }
    assert.equal(tagHere(line, 1, tags), undefined);
});
