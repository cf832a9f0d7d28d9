import assert from 'node:assert/strict';
import { test } from 'node:test';

import { powerRanges } from '../powerRanges.ts';
import type { Power } from '../protocol.ts';

function piece(line: number, from: number, to: number, on: boolean): Power {
    return { range: { start: { line, character: from }, end: { line, character: to } }, on };
}

function show(ranges: readonly Power['range'][]): string[] {
    return ranges.map(({ start, end }) => `${start.line}:${start.character}-${end.line}:${end.character}`);
}

test('neighbours with the same power are one range', () => {
    const { on, off } = powerRanges([
        piece(0, 0, 1, true),
        piece(0, 1, 3, true),
        piece(0, 3, 13, false),
        piece(0, 13, 15, false),
        piece(1, 15, 16, false),
    ]);
    assert.deepEqual(show(on), ['0:0-0:3']);
    assert.deepEqual(show(off), ['0:3-0:15', '1:15-1:16']);
});

test('a gap is not bridged, and the order of the list does not matter', () => {
    const { on } = powerRanges([piece(0, 8, 9, true), piece(0, 0, 2, true), piece(0, 2, 4, true)]);
    assert.deepEqual(show(on), ['0:0-0:4', '0:8-0:9']);
});

test('contacts look by what they do, and two of them stay two', () => {
    const contact = (from: number, on: boolean, does: Power['contact']) => ({ ...piece(0, from, from + 5, on), contact: does }) as Power;
    const ranges = powerRanges([
        contact(0, true, 'closed'),
        contact(5, true, 'closed'),
        contact(10, false, 'blocks'),
        contact(15, false, 'closed'),
        contact(20, false, 'open'),
        piece(0, 25, 27, false),
    ]);
    assert.deepEqual(Object.entries(ranges).map(([look, list]) => `${look} ${show(list).join(' ')}`), [
        'on ',
        'off 0:20-0:27',
        'closedOn 0:0-0:5 0:5-0:10',
        'closed 0:15-0:20',
        'blocks 0:10-0:15',
        'flickers ',
        'unknown ',
    ]);
});

test('what flickers is of its own kind, whatever it is now', () => {
    const [first, second, third] = [piece(0, 0, 2, true), piece(0, 2, 4, false), piece(0, 4, 6, true)];
    const { on, off, flickers } = powerRanges([first, second, third], new Set([first, second]));
    assert.deepEqual([show(on), show(off), show(flickers)], [['0:4-0:6'], [], ['0:0-0:4']]);
});

test('what is not known of a controller is apart', () => {
    const ranges = powerRanges([piece(0, 0, 2, true), { ...piece(0, 2, 4, false), unknown: true }, piece(0, 4, 6, false)]);
    assert.deepEqual([show(ranges.on), show(ranges.unknown), show(ranges.off)], [['0:0-0:2'], ['0:2-0:4'], ['0:4-0:6']]);
});
