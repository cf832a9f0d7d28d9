import assert from 'node:assert/strict';
import { test } from 'node:test';

import { Overtaken } from '../src/overtaken.ts';

test('a line is followed through changes above it, and what it is joined to', () => {
    const lines = new Overtaken();
    const [above, below] = [lines.add(2, ')'), lines.add(5, '\n')];
    lines.shift(3, 3, 1);
    assert.deepEqual([above.line, below.line], [2, 6]);
    lines.shift(0, 1, 0);
    assert.deepEqual([above.line, below.line], [1, 5]);
    lines.shift(4, 5, 0);
    assert.deepEqual([above.line, below.line], [1, 4]);
});

test('only what came too late is asked about again, the first first', () => {
    const lines = new Overtaken();
    const [first, second] = [lines.add(0, '+'), lines.add(1, '\n')];
    assert.equal(lines.late(), undefined);
    second.isLate = true;
    assert.equal(lines.late(), second);
    first.isLate = true;
    assert.equal(lines.late(), first);
    lines.remove(first);
    lines.remove(first);
    assert.equal(lines.late(), second);
});
