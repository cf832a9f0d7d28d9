// Lines that change with every state are known from those that do not.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { Restless } from '../restless.ts';

test('a line is restless from its second change on, until it has been still for a while', () => {
    const restless = new Restless();
    const look = (now: number, ...looks: string[]) => [...restless.among(new Map(looks.map((look, line) => [line, look])), now)];
    assert.deepEqual(look(0, 'a', 'a', 'a'), []);
    assert.deepEqual(look(30, 'b', 'a', 'a'), []);
    assert.deepEqual(look(60, 'a', 'a', 'b'), [0]);
    assert.deepEqual(look(90, 'a', 'a', 'a'), [0, 2]);
    // One that changes now and then is not.
    assert.deepEqual(look(2500, 'a', 'b', 'a'), []);
    assert.deepEqual(look(5000, 'a', 'a', 'a'), []);
});

test('a line that was out of sight begins again', () => {
    const restless = new Restless();
    restless.among(new Map([[7, 'a']]), 0);
    restless.among(new Map([[7, 'b']]), 30);
    restless.among(new Map(), 60);
    assert.deepEqual([...restless.among(new Map([[7, 'a']]), 90)], []);
});
