import assert from 'node:assert/strict';
import { test } from 'node:test';

import { indexTags, operandNames, tagPlaces } from '../src/operands.ts';
import { cases } from './shared.ts';

test('the names of an operand list, without literals, strings and comments', () => {
    for (const [block, names] of cases.operands) {
        assert.deepEqual(operandNames(block), names, block);
    }
});

test('the tags that a line shows', () => {
    for (const { tags, blocks, shown } of cases.places) {
        const list = tags.map((name) => ({ name, type: 'BOOL', value: false, role: 'internal', forced: false }) as const);
        assert.deepEqual(tagPlaces(blocks, indexTags(list)).map((place) => tags[place]), shown);
    }
});
