import assert from 'node:assert/strict';
import { test } from 'node:test';

import type { Drawn, DrawnPiece } from '../diagram/messages.ts';
import { Layout, moved } from '../diagram/layout.ts';

function network(key: string, first: number, last = first, kind: DrawnPiece['kind'] = 'network'): DrawnPiece {
    return { kind, lines: { first, last }, width: 400, height: 60, key, svg: '<svg/>' };
}

function drawn(version: number, first: number, last: number, pieces: readonly DrawnPiece[], lineCount = 1000): Drawn {
    return { uri: 'file:///a.clad', version, lineCount, lines: { first, last }, pieces };
}

function opened(lineCount = 1000): Layout {
    const layout = new Layout();
    layout.open(1, lineCount);
    return layout;
}

/** What is where: `key@first-last`, blank lines as `-`. */
function shown(layout: Layout): string[] {
    return layout.segments.map(({ first, last, piece }) => `${piece ? piece.key + (piece.isHeld ? '?' : '') : '-'}@${first}-${last}`);
}

test('only what is in sight is asked for, and not twice', () => {
    const layout = opened();
    assert.deepEqual(layout.wanted(0, 400), { first: 0, last: 10 });
    layout.take(drawn(1, 0, 20, [network('a', 0, 1), network('b', 3)]));
    // Blank lines take no room: what is after them comes into sight.
    assert.deepEqual(shown(layout), ['a@0-1', '-@2-2', 'b@3-3', '-@4-20']);
    assert.deepEqual(layout.wanted(0, 100), undefined);
    assert.deepEqual(layout.wanted(0, 400), { first: 21, last: 27 });
});

test('10,000 rungs have a place before anything is drawn', () => {
    const layout = opened(10_000);
    const { height } = layout;
    assert.equal(height, 400_000);
    assert.equal(layout.lineAt(200_000), 5000);
    assert.equal(layout.topOf(5000), 200_000);
    layout.take(drawn(1, 5000, 5009, Array.from({ length: 10 }, (_, at) => network(`n${at}`, 5000 + at)), 10_000));
    assert.equal(layout.between(200_000, 200_100).length, 2, 'only what is in sight is put on the page');
    assert.equal(layout.height, height + 10 * (74 - 40));
});

test('an answer about another text is not taken', () => {
    const layout = opened();
    layout.edit(2, 1000, [{ first: 5, last: 5, count: 1 }]);
    assert.equal(layout.take(drawn(1, 0, 20, [network('a', 0)])), false);
    assert.deepEqual(shown(layout), []);
});

test('an edit moves what is below it, and asks again only for where each drawing is', () => {
    const layout = opened();
    layout.take(drawn(1, 0, 30, [network('a', 2), network('b', 10, 11), network('c', 20)]));
    const ids = new Map(layout.segments.map(({ piece }) => [piece?.key, piece?.id]));
    // Two lines more in front of the second network, and one line of it is another one.
    layout.edit(2, 1002, [{ first: 5, last: 5, count: 3 }]);
    assert.deepEqual(shown(layout), ['-@0-1', 'a@2-2', '-@3-11', 'b@12-13', '-@14-21', 'c@22-22', '-@23-32']);
    assert.deepEqual(layout.wanted(0, 300), { first: 0, last: 34 });
    layout.take(drawn(2, 0, 32, [network('a', 2), network('new', 12, 13), network('c', 22)], 1002));
    const now = new Map(layout.segments.map(({ piece }) => [piece?.key, piece?.id]));
    assert.equal(now.get('a'), ids.get('a'), 'the drawing stays on the page');
    assert.equal(now.get('c'), ids.get('c'));
    assert.notEqual(now.get('new'), ids.get('b'), 'this one is drawn again');
});

test('lines that are gone take their drawings with them', () => {
    const layout = opened();
    layout.take(drawn(1, 0, 9, [network('a', 1), network('b', 3, 4), network('c', 6)]));
    layout.edit(2, 996, [{ first: 2, last: 5, count: 1 }]);
    assert.deepEqual(shown(layout), ['-@0-0', 'a@1-1', '-@2-2', 'c@3-3', '-@4-6']);
});

test('a network that is half typed is shown as it was', () => {
    const layout = opened();
    layout.take(drawn(1, 0, 9, [network('good', 3)]));
    layout.edit(2, 1000, [{ first: 3, last: 3, count: 1 }]);
    layout.take(drawn(2, 0, 9, [network('bad', 3, 3, 'broken')]));
    assert.deepEqual(shown(layout), ['-@0-2', 'good?@3-3', '-@4-9']);
    const id = layout.at(3)?.piece?.id;
    layout.edit(3, 1000, [{ first: 3, last: 3, count: 1 }]);
    layout.take(drawn(3, 0, 9, [network('worse', 3, 3, 'broken')]));
    assert.equal(layout.at(3)?.piece?.id, id);
    layout.edit(4, 1000, [{ first: 3, last: 3, count: 1 }]);
    layout.take(drawn(4, 0, 9, [network('good', 3)]));
    assert.deepEqual(shown(layout), ['-@0-2', 'good@3-3', '-@4-9']);
    // One that was never good is shown as text.
    layout.take(drawn(4, 20, 29, [network('bad', 23, 23, 'broken')]));
    assert.equal(layout.at(23)?.piece?.kind, 'broken');
});

test('an error that swallows several networks leaves all of them as they were', () => {
    const layout = opened();
    layout.take(drawn(1, 0, 14, [network('a', 1), network('b', 3, 4), network('c', 6), network('d', 10)]));
    layout.edit(2, 1000, [{ first: 3, last: 3, count: 1 }]);
    layout.take(drawn(2, 0, 14, [network('a', 1), network('bad', 3, 8, 'broken'), network('d', 10)]));
    assert.deepEqual(shown(layout), ['-@0-0', 'a@1-1', '-@2-2', 'b?@3-4', '-@5-5', 'c?@6-8', '-@9-9', 'd@10-10', '-@11-14']);
    layout.edit(3, 1000, [{ first: 3, last: 3, count: 1 }]);
    layout.take(drawn(3, 0, 14, [network('a', 1), network('b', 3, 4), network('c', 6), network('d', 10)]));
    assert.deepEqual(shown(layout), ['-@0-0', 'a@1-1', '-@2-2', 'b@3-4', '-@5-5', 'c@6-6', '-@7-9', 'd@10-10', '-@11-14']);
});

test('what a user looks at stays where it is', () => {
    const layout = opened();
    layout.take(drawn(1, 100, 109, [network('a', 100), network('b', 105)]));
    const anchor = layout.anchorAt(layout.topOf(105) + 10);
    assert.deepEqual(anchor, { line: 105, offset: 10 });
    const changes = [{ first: 50, last: 50, count: 4 }];
    layout.edit(2, 1003, changes);
    anchor.line = moved(anchor.line, changes);
    assert.equal(layout.heightOfAnchor(anchor), layout.topOf(108) + 10);
});

test('a line moves with what is changed above it, and stays in what is changed', () => {
    const changes = [{ first: 10, last: 12, count: 1 }];
    assert.deepEqual([5, 10, 11, 12, 13].map((line) => moved(line, changes)), [5, 10, 10, 10, 11]);
});
