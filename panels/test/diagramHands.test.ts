import assert from 'node:assert/strict';
import { test } from 'node:test';

import { neighbour } from '../diagram/neighbours.ts';
import { sliderSpan } from '../diagram/slider.ts';

// Two rungs of one network, and one of the next:
//   start  stop         run
//   seal
//   lamp                horn
const spots = [
    { x: 60, y: 20 },
    { x: 120, y: 21 },
    { x: 400, y: 20 },
    { x: 60, y: 60 },
    { x: 60, y: 140 },
    { x: 400, y: 140 },
];

test('the arrow keys go along a rung, and on to the next', () => {
    const right = (from: number) => neighbour(spots, spots[from] ?? { x: 0, y: 0 }, 'right');
    const left = (from: number) => neighbour(spots, spots[from] ?? { x: 0, y: 0 }, 'left');
    assert.deepEqual([0, 1, 2, 3, 4, 5].map(right), [1, 2, 3, 4, 5, -1]);
    assert.deepEqual([0, 1, 2, 3, 4, 5].map(left), [-1, 0, 1, 2, 3, 4]);
});

test('up and down go to what is near and in line', () => {
    const down = (from: number) => neighbour(spots, spots[from] ?? { x: 0, y: 0 }, 'down');
    const up = (from: number) => neighbour(spots, spots[from] ?? { x: 0, y: 0 }, 'up');
    assert.deepEqual([0, 2, 3, 5].map(down), [3, 5, 4, -1]);
    assert.deepEqual([0, 3, 4, 5].map(up), [-1, 0, 3, 2]);
});

test('a slider reaches a round number past the value', () => {
    assert.deepEqual(sliderSpan({ type: 'INT', value: 42 }), { min: 0, max: 100, step: 1 });
    assert.deepEqual(sliderSpan({ type: 'DINT', value: 4200 }), { min: 0, max: 10_000, step: 10 });
    assert.deepEqual(sliderSpan({ type: 'USINT', value: 200 }), { min: 0, max: 255, step: 1 });
    assert.deepEqual(sliderSpan({ type: 'REAL', value: -2.5 }), { min: -100, max: 100, step: 0.1 });
    assert.deepEqual(sliderSpan({ type: 'TIME', value: 1500 }), { min: 0, max: 10_000, step: 10 });
});

test('a slider does not shrink while the value does, and grows with it', () => {
    const wide = sliderSpan({ type: 'INT', value: 700 });
    assert.deepEqual(sliderSpan({ type: 'INT', value: 5 }, wide), wide);
    assert.deepEqual(sliderSpan({ type: 'INT', value: 1200 }, wide), { min: 0, max: 10_000, step: 10 });
});

test('what is not a number has no slider', () => {
    for (const [type, value] of [['BOOL', true], ['STRING', 'a'], ['LREAL', Number.NaN], ['TIME', -5], ['DATE', 'D#2026-11-22']] as const) {
        assert.equal(sliderSpan({ type, value }), undefined, type);
    }
});
