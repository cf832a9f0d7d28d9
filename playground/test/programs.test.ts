import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';

import { programs } from '../programs.ts';

const all = programs(join(import.meta.dirname, '../..'));

test('a machine that moves comes first, with all that belongs to it', () => {
    assert.equal(all[0]?.name, 'water_tank.clad');
    assert.deepEqual(Object.keys(all[0]?.files ?? {}), ['ladder.toml', 'machine.clad', 'water_tank.scene.svg']);
});

test('the examples come next, with their scenarios, and the motor before all', () => {
    const first = all.find(({ group }) => group === 'Examples');
    assert.equal(first?.name, 'motor.clad');
    assert.match(first?.scenarios ?? '', /^program motor\.clad$/m);
});

test('a chapter is a list of steps, each with its place in the book', () => {
    const steps = all.filter(({ group }) => group === 'A first program');
    assert.ok(steps.length >= 4);
    assert.equal(steps[0]?.title, '1. One rung');
    assert.equal(steps[0]?.chapter, 'guide/first-program.html#one-rung');
    assert.equal(steps[0]?.text, '+--[ ]( start )--( )( run )--+\n');
});

test('two steps of a chapter have different titles', () => {
    const titles = all.map(({ group, title }) => `${group} ${title}`);
    assert.equal(new Set(titles).size, titles.length);
});
