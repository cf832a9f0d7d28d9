import assert from 'node:assert/strict';
import { test } from 'node:test';

import { findLineTags, lineText } from '../src/lineValues.ts';
import type { Power, Tag } from '../src/protocol.ts';

const text = ['+--[ ]( start )--( )( run )--+', '|  |', '+--[TON]( t, 5s )--+'];

function textIn({ start, end }: Power['range']): string {
    return text[start.line]?.slice(start.character, end.character) ?? '';
}

function block(line: number, from: number, to: number): Power {
    return { range: { start: { line, character: from }, end: { line, character: to } }, on: false };
}

const tags: Tag[] = [
    { name: 'start', type: 'BOOL', value: true, role: 'input', forced: false },
    { name: 'run', type: 'BOOL', value: false, role: 'output', forced: true },
    { name: 't.Q', type: 'BOOL', value: false, role: 'internal', forced: false },
    { name: 't.ET', type: 'TIME', value: 1500, role: 'internal', forced: false },
];

test('each line shows the tags of its blocks', () => {
    const power = [block(0, 0, 1), block(0, 3, 15), block(0, 17, 27), block(2, 3, 17)];
    const lines = findLineTags({ power, tags }, textIn);
    assert.deepEqual([...lines.keys()], [0, 2]);
    assert.equal(lineText(tags, lines.get(0) ?? []), 'start=1  run=0!');
    assert.equal(lineText(tags, lines.get(2) ?? []), 't.ET=1.5s  t.Q=0');
});
