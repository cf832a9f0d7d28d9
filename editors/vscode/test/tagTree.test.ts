import assert from 'node:assert/strict';
import { test } from 'node:test';

import type { Tag } from '../src/protocol.ts';
import { changedTags, tagGroups, tagRow } from '../src/tagTree.ts';

const start: Tag = { name: 'start', type: 'BOOL', value: true, role: 'input', forced: false };
const run: Tag = { name: 'run', type: 'BOOL', value: false, role: 'output', forced: true };
const elapsed: Tag = { name: 't.ET', type: 'TIME', value: 1500, role: 'internal', forced: false };

test('tags are grouped by role, empty groups are left out', () => {
    assert.deepEqual(
        tagGroups({ tags: [elapsed, start] }).map(({ title, tags }) => [title, tags.map(({ name }) => name)]),
        [
            ['Inputs', ['start']],
            ['Internal', ['t.ET']],
        ],
    );
});

test('a BOOL input toggles on a click', () => {
    const row = tagRow(start);
    assert.equal(row.toggles, true);
    assert.equal(row.icon, 'circle-filled');
    assert.equal(row.context, 'settable free');
});

test('a forced output shows that it is forced, and does not toggle', () => {
    const row = tagRow(run);
    assert.equal(row.toggles, false);
    assert.equal(row.description, '0  forced');
    assert.equal(row.icon, 'lock');
    assert.equal(row.context, 'forced');
});

test('a value that is not BOOL is shown as text', () => {
    assert.equal(tagRow(elapsed).description, '1.5s');
    assert.equal(tagRow(elapsed).toggles, false);
});

test('only rows that changed are drawn again', () => {
    assert.deepEqual(changedTags([start, run], [{ ...start, value: false }, run])?.map(({ name }) => name), ['start']);
    assert.deepEqual(changedTags([start], [start]), []);
    assert.equal(changedTags([start], [run]), undefined);
    assert.equal(changedTags([start], [start, run]), undefined);
});
