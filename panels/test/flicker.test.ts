// What changes too fast to follow is known from what does not.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { Flicker } from '../flicker.ts';
import type { Power } from '../protocol.ts';

function piece(character: number, on: boolean): Power {
    return { range: { start: { line: 0, character }, end: { line: 0, character: character + 1 } }, on };
}

/** Whether the only piece flickers in each of these states, which come so many milliseconds after each other. */
function shown(flicker: Flicker, begin: number, every: number, states: readonly boolean[]): boolean[] {
    return states.map((on, index) => flicker.among([piece(3, on)], true, begin + index * every).size > 0);
}

const ALTERNATING = Array.from({ length: 8 }, (_, index) => index % 2 === 1);

test('what changes six times in a second flickers from then on', () => {
    assert.deepEqual(shown(new Flicker(), 0, 33, ALTERNATING), [false, false, false, false, false, false, true, true]);
});

test('what changes three times a second can be followed', () => {
    assert.ok(shown(new Flicker(), 0, 333, ALTERNATING).every((flickers) => !flickers));
});

test('what has come to rest is drawn again as it is, though not at once: it changes by chance from state to state', () => {
    const flicker = new Flicker();
    shown(flicker, 0, 33, ALTERNATING);
    assert.deepEqual(shown(flicker, 500, 100, Array(7).fill(true)), [true, true, true, true, true, true, false]);
});

test('nothing flickers where nothing runs, and steps by hand begin again', () => {
    const flicker = new Flicker();
    shown(flicker, 0, 33, ALTERNATING);
    assert.equal(flicker.among([piece(3, true)], false, 270).size, 0);
    assert.deepEqual(shown(flicker, 300, 33, [false, true]), [false, false]);
});

test('what was out of sight begins again', () => {
    const flicker = new Flicker();
    shown(flicker, 0, 33, ALTERNATING);
    flicker.among([], true, 260);
    assert.deepEqual(shown(flicker, 290, 33, [true]), [false]);
});
