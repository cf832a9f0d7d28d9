import assert from 'node:assert/strict';
import { test } from 'node:test';

import { type CrossReferenced, referenceRows } from '../crossReference.ts';

const at = (line: number) => ({ start: { line, character: 3 }, end: { line, character: 7 } });

const answer: CrossReferenced = {
    uri: 'file:///plant.clad',
    version: 1,
    tags: [
        {
            name: 'lamp',
            type: 'BOOL',
            kind: 'output',
            address: '%QX0.1',
            comment: 'on the door',
            declared: true,
            range: at(1),
            places: [
                { does: 'set', network: 1, range: at(4) },
                { does: 'read', network: 2, range: at(6) },
                { does: 'read', network: 3, range: at(8) },
            ],
        },
        { name: 'out', block: '$Blink', type: 'BOOL', kind: 'output', declared: true, range: at(12), places: [] },
    ],
};

test('a tag says what is done with it, and each place where', () => {
    const [lamp, out] = referenceRows(answer, '');
    assert.deepEqual([lamp?.label, lamp?.description], ['lamp', 'BOOL · output · %QX0.1 · set 1, read 2 · on the door']);
    assert.deepEqual(
        lamp?.children.map(({ label, description }) => `${label}: ${description}`),
        ['set: line 5, network 1', 'read: line 7, network 2', 'read: line 9, network 3'],
    );
    assert.deepEqual([out?.label, out?.description], ['$Blink.out', 'BOOL · output · used nowhere']);
});

test('tags are found by name, block, address and comment', () => {
    const found = (wanted: string) => referenceRows(answer, wanted).map(({ label }) => label);
    assert.deepEqual(found('LAM'), ['lamp']);
    assert.deepEqual(found('qx0'), ['lamp']);
    assert.deepEqual(found('door'), ['lamp']);
    assert.deepEqual(found('blink'), ['$Blink.out']);
    assert.deepEqual(found('nothing'), []);
});
