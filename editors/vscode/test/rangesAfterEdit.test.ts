import assert from 'node:assert/strict';
import { test } from 'node:test';

import type { Power } from '../src/protocol.ts';
import { type Change, rangesAfterEdit } from '../src/rangesAfterEdit.ts';

type Range = Power['range'];

function range(text: string): Range {
    const [line = 0, character = 0, endLine = 0, endCharacter = 0] = text.split(/[:-]/).map(Number);
    return { start: { line, character }, end: { line: endLine, character: endCharacter } };
}

function change(where: string, text: string): Change {
    return { range: range(where), text };
}

function after(ranges: string[], ...changes: Change[]): string[] {
    return rangesAfterEdit(ranges.map(range), changes).map(
        ({ start, end }) => `${start.line}:${start.character}-${end.line}:${end.character}`,
    );
}

test('an edit behind or below changes nothing', () => {
    assert.deepEqual(after(['1:3-1:9'], change('1:9-1:9', 'x'), change('2:0-2:4', '')), ['1:3-1:9']);
});

test('an edit before, on the same line, moves along the line', () => {
    assert.deepEqual(after(['1:3-1:9', '2:3-2:9'], change('1:0-1:2', 'abcde')), ['1:6-1:12', '2:3-2:9']);
});

test('a line put in or taken out above moves down or up', () => {
    assert.deepEqual(after(['1:3-1:9'], change('0:0-0:0', 'new\n')), ['2:3-2:9']);
    assert.deepEqual(after(['2:3-2:9'], change('0:0-1:0', '')), ['1:3-1:9']);
});

test('a line break before a range takes it along', () => {
    assert.deepEqual(after(['1:3-1:9'], change('1:2-1:2', '\nab')), ['2:3-2:9']);
    assert.deepEqual(after(['1:3-1:9'], change('0:5-1:1', '')), ['0:7-0:13']);
});

test('what an edit cuts into is dropped', () => {
    assert.deepEqual(after(['1:3-1:9', '1:9-1:12'], change('1:5-1:6', '')), ['1:8-1:11']);
});

test('several changes are all about the text before them, in any order', () => {
    assert.deepEqual(after(['1:5-1:6'], change('1:0-1:0', 'a'), change('1:2-1:3', '')), ['1:5-1:6']);
    assert.deepEqual(after(['3:5-3:6'], change('2:0-2:0', '\n'), change('1:0-1:0', '\n')), ['5:5-5:6']);
});
