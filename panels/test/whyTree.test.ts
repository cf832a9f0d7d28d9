import assert from 'node:assert/strict';
import { test } from 'node:test';

import type { Reason } from '../protocol.ts';
import { stillStopping, stoppingBlocks, type WhyRow, whyRow } from '../whyTree.ts';

const range = (line: number) => ({ start: { line, character: 3 }, end: { line, character: 9 } });

const stop: Reason = { tag: 'stop', type: 'BOOL', value: true, cause: 'given', text: 'stop is 1 since scan 4 (40 ms): it was given from outside' };
const run: Reason = {
    tag: 'run',
    type: 'BOOL',
    value: false,
    cause: 'block',
    text: 'run is 0 since scan 4 (40 ms): line 1, ( )( run ) wrote it; blocked by [/]( stop )',
    write: {
        block: '( )( run )',
        range: range(0),
        scan: 4,
        power: false,
        ways: [
            [{ block: '[/]( stop )', range: range(1), stops: true, text: '[/]( stop ) (line 2): stop is 1', because: [stop] }],
            [{ block: '[ ]( hand )', range: range(2), stops: true, text: '[ ]( hand ) (line 3): hand is 0' }],
        ],
    },
};

function drawn(row: WhyRow, depth = 0): string[] {
    const place = row.range ? ` @${row.range.start.line}` : '';
    return [`${'  '.repeat(depth)}${row.icon} ${row.label}${place}`, ...row.children.flatMap((child) => drawn(child, depth + 1))];
}

test('the reasons are a tree, each with its place', () => {
    assert.deepEqual(drawn(whyRow(run)), [
        'symbol-variable run is 0 since scan 4 (40 ms) @0',
        '  edit ( )( run ) wrote it in line 1, scan 4 @0',
        '  arrow-right One way is blocked by',
        '    circle-slash [/]( stop ) (line 2): stop is 1 @1',
        '      symbol-variable stop is 1 since scan 4 (40 ms): it was given from outside',
        '  arrow-right Another way is blocked by',
        '    circle-slash [ ]( hand ) (line 3): hand is 0 @2',
    ]);
});

test('the blocks that stop power are found', () => {
    assert.deepEqual(stoppingBlocks(whyRow(run)).map(({ start }) => start.line), [1, 2]);
});

test('a block that lets power through by now stops none', () => {
    const at = (line: number) => ({ start: { line, character: 3 }, end: { line, character: 9 } });
    const blocks = [0, 1, 2, 3, 4].map(at);
    const known = [
        { on: false, contact: 'blocks' as const },
        // Closed, though no power reaches it.
        { on: false, contact: 'closed' as const },
        { on: true },
        { on: false },
    ];
    const still = stillStopping(blocks, (block) => {
        const power = known[block.start.line];
        return power && { range: block, ...power };
    });
    assert.deepEqual(still.map(({ start }) => start.line), [0, 3, 4]);
});
