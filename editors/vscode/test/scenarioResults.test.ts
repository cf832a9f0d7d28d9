import assert from 'node:assert/strict';
import { test } from 'node:test';

import { failingStretches, missedLines, unitsBefore, waysOf } from '../src/scenarioResults.ts';
import { scenariosOf } from '../src/scenarioFile.ts';

test('the scenarios of a file, and where they end', () => {
    const text = 'program motor.clad\r\n\r\nscenario "start"\r\nstart _-\r\nrun => _-\r\n\r\n# next #\r\n  scenario "stop"\nstop -\nscenario "start"\n# scenario "none" #\n';
    assert.deepEqual(scenariosOf(text), [
        { name: 'start', line: 2, lastLine: 4 },
        { name: 'stop', line: 7, lastLine: 8 },
    ]);
    assert.deepEqual(scenariosOf(''), []);
});

test('the values that differ are marked, in whichever row they are', () => {
    const lines = ['time  => 1s .', 'run   => _  -', '', 'ü => ä'];
    const places = [
        { line: 2, column: 10, end_column: 11 },
        { line: 4, column: 6, end_column: 7 },
    ];
    const difference = { tag: 'run', line: 2, column: 10, steps: [0, 2], places, message: '' };
    assert.deepEqual(failingStretches(lines, difference), [
        { line: 1, start: 9, end: 10 },
        { line: 3, start: 5, end: 6 },
    ]);
});

test('columns count characters', () => {
    assert.equal(unitsBefore('ä😀x', 3), 3);
    assert.equal(unitsBefore('abc', 1), 0);
});

test('what was never seen, or is not shown to matter', () => {
    const missing = (part: Parameters<typeof waysOf>[0]) => waysOf(part).filter(({ isSeen }) => !isSeen).map(({ name }) => name);
    const place = { line: 1, column: 1 };
    assert.deepEqual(missing({ kind: 'contact', ...place, on: true, off: false }), ['open']);
    assert.deepEqual(missing({ kind: 'coil', ...place, on: false, off: false }), ['on', 'off']);
    assert.deepEqual(missing({ kind: 'comparison', ...place, on: true, off: true }), []);
    assert.deepEqual(missing({ kind: 'contact', ...place, on: true, off: true, matters: false }), ['shown to matter']);
    assert.equal(waysOf({ kind: 'contact', ...place, on: true, off: true, matters: true }).length, 3);
});

test('changes that no scenario notices are told with one that would', () => {
    const bridged = { line: 8, change: 'contact bridged', before: '[ ]( guard )', fate: 'missed', scenario: 'scenario "line 8"\npedal -\n' };
    const changes = [bridged, { line: 9, change: 'coil inverted', before: '( )( press )', fate: 'same' }];
    assert.deepEqual(missedLines({ program: 'press.clad', caught: 4, missed: 1, changes }), [
        'press.clad: of 5 changes the scenarios notice 4',
        'press.clad:8: no scenario notices: contact bridged, [ ]( guard )',
        'this one would:',
        '    scenario "line 8"',
        '    pedal -',
    ]);
});
