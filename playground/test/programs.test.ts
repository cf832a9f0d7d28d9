import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';

import { programs } from '../programs.ts';

const all = programs(join(import.meta.dirname, '../..'));

test('the examples come first, with their scenarios, and the motor before all', () => {
    assert.equal(all[0]?.name, 'motor.clad');
    assert.match(all[0]?.scenarios ?? '', /^program motor\.clad$/m);
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
