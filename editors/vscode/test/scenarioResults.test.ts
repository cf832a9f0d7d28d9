import assert from 'node:assert/strict';
import { test } from 'node:test';

import { scenariosOf } from '../src/scenarioFile.ts';
import { failingStretches, missing, unitsBefore } from '../src/scenarioResults.ts';

test('the scenarios of a file, and where they end', () => {
    const text = 'program motor.clad\r\n\r\nscenario "start"\r\nstart _-\r\nrun => _-\r\n\r\n# next #\r\n  scenario "stop"\nstop -\nscenario "start"\n# scenario "none" #\n';
    assert.deepEqual(scenariosOf(text), [
        { name: 'start', line: 2, lastLine: 4 },
        { name: 'stop', line: 7, lastLine: 8 },
    ]);
    assert.deepEqual(scenariosOf(''), []);
});

test('the steps of a waveform that fail, run by run', () => {
    const difference = { tag: 'run', line: 4, column: 10, steps: [2, 3, 6], message: '' };
    assert.deepEqual(failingStretches('run => __-----', difference), [
        { line: 3, start: 9, end: 11 },
        { line: 3, start: 13, end: 14 },
    ]);
});

test('of a row of values the first that fails', () => {
    const difference = { tag: 'level', line: 1, column: 12, steps: [1, 2], message: '' };
    assert.deepEqual(failingStretches('level => 0 12.5 13.0', difference), [{ line: 0, start: 11, end: 15 }]);
});

test('columns count characters', () => {
    assert.equal(unitsBefore('ä😀x', 3), 3);
    assert.equal(unitsBefore('abc', 1), 0);
});

test('what was never seen', () => {
    assert.deepEqual(missing({ kind: 'contact', line: 1, column: 1, on: true, off: false }), ['open']);
    assert.deepEqual(missing({ kind: 'coil', line: 1, column: 1, on: false, off: false }), ['on', 'off']);
    assert.deepEqual(missing({ kind: 'comparison', line: 1, column: 1, on: true, off: true }), []);
});
