// The trace: which scans are shown, how columns are joined and drawn, which tags there are, and what the page lets in.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import type { Tag } from '../protocol.ts';
import { added, atFirst, moved, picked, removed, renamed } from '../trace/chosenTags.ts';
import type { Column, Traced } from '../trace/messages.ts';
import { page } from '../trace/page.ts';
import { columnAt, Columns, edge, joined } from '../trace/columns.ts';
import { bitPaths, numberPath, scaleOf, words } from '../trace/paths.ts';
import { follows, panned, showing, zoomed } from '../trace/scanWindow.ts';

const drawn = { first: 401, last: 500, oldest: 1, newest: 1000 };
const newest = { first: 901, last: 1000, oldest: 1, newest: 1000 };

test('zooming keeps the scan under the pointer where it is', () => {
    const window = zoomed({ span: 100, last: 500 }, drawn, 0.5, 421);
    assert.deepEqual(window, { span: 50, last: 460 });
    // 421 was a fifth of the way from the left, and is.
    assert.equal((421 - (460 - 49)) / 50, 0.2);
});

test('zooming without a place keeps the middle, or the newest', () => {
    assert.deepEqual(zoomed({ span: 100, last: 500 }, drawn, 2), { span: 200, last: 550 });
    assert.deepEqual(zoomed({ span: 100 }, newest, 2), { span: 200 });
    assert.deepEqual(zoomed({ span: 8, last: 500 }, { ...drawn, first: 493 }, 0.5), { span: 8, last: 500 });
});

test('panning goes no further than what is recorded, and follows again at its end', () => {
    assert.deepEqual(panned(drawn, -50), { span: 100, last: 450 });
    assert.deepEqual(panned(drawn, -5000), { span: 100, last: 100 });
    assert.deepEqual(panned(drawn, 499), { span: 100, last: 999 });
    const end = panned(drawn, 500);
    assert.deepEqual(end, { span: 100 });
    assert.ok(follows(end));
});

test('a window with room after the newest does not jump', () => {
    assert.deepEqual(panned({ first: 1, last: 1000, oldest: 1, newest: 30 }, -10), { span: 1000 });
});

test('a scan out of sight comes into the middle', () => {
    assert.deepEqual(showing({ span: 100, last: 500 }, drawn, 450), { span: 100, last: 500 });
    assert.deepEqual(showing({ span: 100, last: 500 }, drawn, 700), { span: 100, last: 749 });
});

test('fresh columns take the place of what was there from their column on', () => {
    const known: Column[] = [
        [0, 0],
        [4, 1],
        [9, 2],
    ];
    assert.deepEqual(joined(known, [[9, 1], [12, 0]], 9, 0), [
        [0, 0],
        [4, 1],
        [12, 0],
    ]);
    // What lies left of the window goes, but for what reaches into it.
    assert.deepEqual(joined(known, [[9, 1], [12, 0]], 9, 8), [
        [4, 1],
        [12, 0],
    ]);
});

const answer = (traced: Partial<Traced>, columns: Column[]): Traced => ({
    revision: 0,
    intervalMs: 10,
    first: 1,
    last: 100,
    per: 1,
    oldest: 1,
    newest: 50,
    here: 50,
    reach: { first: 0, last: 50 },
    ticks: [],
    tags: [{ name: 'run', kind: 'bit', columns }],
    ...traced,
});

test('only what is new is asked for, as long as it fits to what is there', () => {
    const columns = new Columns();
    const asked = { span: 100, columns: 100, ticks: 8, cursors: [] };
    assert.equal(columns.since(asked, 1, ['run']), undefined);
    assert.ok(columns.take(asked, answer({}, [[1, 0]])));
    assert.equal(columns.since(asked, 1, ['run']), 50);
    assert.equal(columns.since({ ...asked, span: 500 }, 1, ['run']), undefined);
    assert.equal(columns.since(asked, 1, ['run', 'stop']), undefined);
    assert.equal(columns.since(asked, 0, ['run']), undefined, 'what lies to the left is not known');
    assert.ok(columns.take({ ...asked, since: 50 }, answer({ newest: 60 }, [[50, 0], [55, 1]])));
    assert.deepEqual(columns.of('run'), [[1, 0], [55, 1]]);
    // A window in what is known: nothing was sent, nothing goes.
    assert.ok(columns.take({ ...asked, since: 60 }, answer({ first: 1, last: 40, newest: 60 }, [])));
    assert.deepEqual(columns.of('run'), [[1, 0], [55, 1]]);
    // Another past.
    assert.ok(!columns.take({ ...asked, since: 60 }, answer({ revision: 1, newest: 61 }, [[60, 1]])));
    assert.equal(columns.since(asked, 1, ['run']), undefined);
});

test('an answer about what is new is nothing to a page that knows nothing any more', () => {
    const columns = new Columns();
    const asked = { span: 100, columns: 100, ticks: 8, cursors: [] };
    assert.ok(columns.take(asked, answer({}, [[1, 0]])));
    const since = columns.since(asked, 1, ['run']) ?? 0;
    // The page has become wider meanwhile.
    columns.forget();
    assert.ok(!columns.take({ ...asked, since }, answer({ newest: 60 }, [[50, 0], [55, 1]])), 'all of it has to be asked for');
});

test('what is drawn in a column, and where it changes', () => {
    const columns: Column[] = [[3, 0], [7, 1], [9, 0]];
    assert.deepEqual([columnAt(columns, 2), columnAt(columns, 7), columnAt(columns, 8)], [undefined, [7, 1], [7, 1]]);
    assert.deepEqual([edge(columns, 3, 1), edge(columns, 7, 1), edge(columns, 9, 1)], [7, 9, undefined]);
    assert.deepEqual([edge(columns, 9, -1), edge(columns, 7, -1)], [7, undefined]);
});

const toX = (column: number) => column * 10;

test('a waveform', () => {
    const columns: Column[] = [[0, 0], [2, 1], [4, 2], [5, 0]];
    assert.deepEqual(bitPaths(columns, toX, 80, 5, 25), {
        line: 'M0 25H20V5H40M50 25H80',
        high: 'M20 5H40V25H20Z',
        busy: 'M40 5H50V25H40Z',
    });
});

test('a number is a line of steps', () => {
    const toY = scaleOf([0, 10], 0, 100);
    assert.equal(numberPath([[0, 0, 0, 0], [1, 5, 5, 5], [2, 0, 10, 10]], toX, 40, toY), 'M0 100H10V50H20V100V0V0H40');
    assert.equal(scaleOf([3, 3], 0, 100)(3), 50);
});

test('words are where they hold', () => {
    assert.deepEqual(words([[0, 'idle'], [3, 'busy']], toX, 50), [
        { from: 0, to: 30, text: 'idle' },
        { from: 30, to: 50, text: 'busy' },
    ]);
});

test('the tags of a trace', () => {
    assert.deepEqual(added(['a'], 'A'), ['a']);
    assert.deepEqual(removed(['a', 'b'], 'B'), ['a']);
    assert.deepEqual(moved(['a', 'b', 'c'], 'c', -1), ['a', 'c', 'b']);
    assert.deepEqual(moved(['a', 'b'], 'b', 1), ['a', 'b']);
    assert.deepEqual(picked(['b', 'a'], ['a', 'b', 'c']), ['b', 'a', 'c']);
    const tag = (name: string, role: Tag['role']): Tag => ({ name, role, type: 'BOOL', value: false, text: '0', forced: false });
    assert.deepEqual(atFirst([tag('m', 'internal'), tag('lamp', 'output'), tag('start', 'input')]), ['start', 'lamp']);
});

test('the page lets in nothing but the script and the style of the extension', () => {
    const html = page({ script: 'https://x/trace.js', style: 'https://x/trace.css', styles: 'https://x', scripts: "'nonce-abc'", nonce: 'abc' });
    const [, policy] = /Content-Security-Policy" content="([^"]*)"/.exec(html) ?? [];
    assert.equal(policy, "default-src 'none'; style-src https://x; script-src 'nonce-abc'");
    assert.doesNotMatch(html, /unsafe|\son\w+=|style="|<style/);
    assert.equal([...html.matchAll(/<script/g)].length, 1);
});

test('a tag that was renamed takes its new name, and only then the list is another', () => {
    const tags = ['start', 'run'];
    assert.equal(renamed(tags, [{ name: 'Start' }, { name: 'run' }]), tags);
    assert.equal(renamed(tags, []), tags);
    assert.deepEqual(renamed(tags, [{ name: 'start' }, { name: 'turns' }]), ['start', 'turns']);
    assert.deepEqual(renamed(['run', 'turns'], [{ name: 'turns' }, { name: 'turns' }]), ['turns']);
});
