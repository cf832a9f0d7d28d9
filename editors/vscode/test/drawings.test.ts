import assert from 'node:assert/strict';
import { test } from 'node:test';

import { drawingOf, Drawings } from '../src/drawings.ts';

const PROGRAM = 'file:///plant/tank.py';
const DRAWING = 'ladder-click://file/plant/tank.py.clad';
const previewed = (version: number, text: string) => ({ uri: PROGRAM, version, text });

test('a drawing is named like its program, and is ladder text', () => {
    const program = { scheme: 'file', path: '/plant/tank.py' };
    assert.deepEqual(drawingOf(program), { scheme: 'ladder-click', authority: 'file', path: '/plant/tank.py.clad' });
    assert.equal(drawingOf({ scheme: 'untitled', path: 'Untitled-1' }).path, '/Untitled-1.clad');
});

test('a drawing shows the newest text of its program', () => {
    const drawings = new Drawings();
    assert.match(drawings.text(DRAWING), /^# .* #\n$/);
    drawings.begin(DRAWING, previewed(3, 'three'));
    assert.equal(drawings.text(DRAWING), 'three');
    assert.equal(drawings.take(previewed(4, 'four')), DRAWING);
    assert.equal(drawings.text(DRAWING), 'four');
    assert.equal(drawings.take(previewed(2, 'two')), undefined);
    // The answer to a second question was overtaken.
    drawings.begin(DRAWING, previewed(3, 'three'));
    assert.equal(drawings.text(DRAWING), 'four');
});

test('a program that is opened again begins with its versions', () => {
    const drawings = new Drawings();
    drawings.begin(DRAWING, previewed(9, 'nine'));
    drawings.end(PROGRAM);
    assert.equal(drawings.text(DRAWING), 'nine');
    drawings.begin(DRAWING, previewed(1, 'one'));
    assert.equal(drawings.text(DRAWING), 'one');
});

test('what nobody shows is not a drawing', () => {
    const drawings = new Drawings();
    assert.equal(drawings.take(previewed(1, 'one')), undefined);
    assert.ok(!new Drawings().has(PROGRAM));
});
