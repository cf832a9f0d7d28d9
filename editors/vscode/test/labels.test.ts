import assert from 'node:assert/strict';
import { test } from 'node:test';

import { placeLabels } from '../src/labels.ts';
import { labelCases } from './shared.ts';

for (const { name, lines, labels, placed } of labelCases) {
    test(`labels: ${name}`, () => {
        const given = labels.map(([row, column, text, room]) => ({ row, column, text, room }));
        const places = placeLabels(given, (row) => lines[row]);
        assert.deepEqual(places.map(({ side, column }) => [side, column]), placed);
    });
}
