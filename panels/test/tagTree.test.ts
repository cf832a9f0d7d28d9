import assert from 'node:assert/strict';
import { test } from 'node:test';

import type { Tag } from '../protocol.ts';
import { filtered, opened, partsOf, rowId, tagGroups, tagRow, unfoldedGroup, watchedGroup, watchedRows } from '../tagTree.ts';

const start: Tag = { name: 'start', type: 'BOOL', value: true, text: '1', role: 'input', forced: false };
const run: Tag = { name: 'run', type: 'BOOL', value: false, text: '0', role: 'output', forced: true };
const elapsed: Tag = { name: 't.ET', type: 'TIME', value: 1500, text: '1.5s', role: 'internal', forced: false };

test('tags are grouped by role, empty groups are left out', () => {
    assert.deepEqual(
        tagGroups([elapsed, start]).map(({ title, tags }) => [title, tags.map(({ name }) => name)]),
        [
            ['Inputs', ['start']],
            ['Internal', ['t.ET']],
        ],
    );
});

test('tags are found by part of their name or type', () => {
    const found = (wanted: string) => filtered([start, run, elapsed], wanted).map(({ name }) => name);
    assert.deepEqual(found(''), ['start', 'run', 't.ET']);
    assert.deepEqual(found(' RU '), ['run']);
    assert.deepEqual(found('time'), ['t.ET']);
    const timer: Tag = { ...elapsed, name: 'hold', type: 'TON', parts: 2 };
    assert.deepEqual(filtered([timer], 'HOLD.E'), [timer]);
    assert.deepEqual(filtered([timer], 'holder'), []);
});

test('a BOOL input toggles on a click', () => {
    const row = tagRow(start);
    assert.equal(row.toggles, true);
    assert.equal(row.icon, 'circle-filled');
    assert.equal(row.context, 'tag settable free unwatched');
});

test('a forced output shows that it is forced, and toggles; one that the program writes does not', () => {
    const row = tagRow(run);
    assert.equal(row.toggles, true);
    assert.equal(tagRow({ ...run, forced: false }).toggles, false);
    assert.equal(row.description, '0  forced');
    assert.equal(row.icon, 'lock');
    assert.equal(row.context, 'tag settable forced unwatched');
});

test('a value that is not BOOL is shown as text', () => {
    assert.equal(tagRow(elapsed).description, '1.5s');
    assert.equal(tagRow(elapsed).toggles, false);
});

test('an internal tag can be set, a constant can be neither set nor forced', () => {
    assert.equal(tagRow(elapsed).context, 'tag settable free unwatched');
    const row = tagRow({ ...elapsed, readOnly: true });
    assert.equal(row.context, 'tag constant unwatched');
    assert.equal(row.tooltip, 't.ET : TIME, constant');
});

test('a long group is shown in parts, which begin folded', () => {
    const tags = Array.from({ length: 250 }, (_, index) => ({ ...start, name: `in${index}` }));
    const [group] = tagGroups(tags);
    assert.ok(group);
    const parts = partsOf(group);
    assert.deepEqual(parts.map(({ title, open }) => [title, open]), [
        ['in0 – in99', false],
        ['in100 – in199', false],
        ['in200 – in249', false],
    ]);
    assert.deepEqual(partsOf({ ...group, tags: tags.slice(0, 200) }), []);
});

test('an array is a row that opens into its elements', () => {
    const trip: Tag = { name: 'trip', type: 'ARRAY[1..2] OF BOOL', value: '', text: '', role: 'input', forced: false, parts: 2 };
    const elements = ['trip[1]', 'trip[2]'].map((name) => ({ ...start, name }));
    const row = tagRow(trip);
    assert.equal(row.label, 'trip');
    assert.equal(row.description, 'ARRAY[1..2] OF BOOL');
    assert.equal(tagRow({ ...trip, text: 'speed=20.0' }).description, 'speed=20.0');
    assert.equal(row.context, 'group unwatched');
    assert.equal(row.toggles, false);
    const [inputs] = tagGroups([start, trip]);
    assert.ok(inputs);
    const names = (open: readonly string[]) =>
        unfoldedGroup(inputs, (id) => open.includes(id), new Map([['trip', elements]])).map(({ name }) => name);
    assert.deepEqual(names([]), ['start', 'trip']);
    assert.deepEqual(names([opened(trip, []).id]), ['start', 'trip', 'trip[1]', 'trip[2]']);
});

test('what a tag opens into may open again', () => {
    const group = (name: string, type: string, parts: number): Tag => ({ name, type, value: '', text: '', role: 'internal', forced: false, parts });
    const lines = group('lines', 'ARRAY[1..2] OF Motor', 2);
    const line = group('lines[2]', 'Motor', 2);
    const parts = new Map([
        ['lines', [group('lines[1]', 'Motor', 2), line]],
        ['lines[2]', ['lines[2].speed', 'lines[2].on'].map((name) => ({ ...elapsed, name }))],
    ]);
    const [internal] = tagGroups([lines]);
    assert.ok(internal);
    const names = (...open: readonly Tag[]) => {
        const ids = open.map((tag) => opened(tag, []).id);
        return unfoldedGroup(internal, (id) => ids.includes(id), parts).map(({ name }) => name);
    };
    assert.deepEqual(names(lines), ['lines', 'lines[1]', 'lines[2]']);
    assert.deepEqual(names(line), ['lines']);
    assert.deepEqual(names(lines, line), ['lines', 'lines[1]', 'lines[2]', 'lines[2].speed', 'lines[2].on']);
});

test('what is watched is a group of its own, whose rows are others than those of the same tags below', () => {
    assert.deepEqual(watchedGroup([]), []);
    const rows = watchedRows([elapsed, start]);
    const [group] = watchedGroup(rows);
    assert.deepEqual([group?.title, group?.open, group?.tags.map(({ name }) => name)], ['Watched', true, ['t.ET', 'start']]);
    assert.deepEqual(rows.map(rowId), ['watched t.ET', 'watched start']);
    assert.equal(rowId(start), 'start');
    const [row] = rows;
    assert.equal(row && tagRow(row).context, 'tag settable free watched');
});
