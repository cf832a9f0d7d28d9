import assert from 'node:assert/strict';
import { test } from 'node:test';

import { failingStretches, missedLines, ownFailure, unitsBefore, violatedBy, waysOf, type ScenarioResult } from '../src/scenarioResults.ts';
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

const violating = (name: string, more: Partial<ScenarioResult> = {}): ScenarioResult => ({
    name,
    line: 1,
    passed: false,
    seconds: 0,
    differences: [],
    violations: [{ property: 'not both', line: 3, column: 10, message: 'it is violated in scan 2' }],
    faults: [],
    ...more,
});

test('a property that several scenarios violate is one failure, with each of them', () => {
    const found = violatedBy([violating('a'), violating('b'), violating('c', { passed: true, violations: [] })]);
    assert.deepEqual([...found.keys()], ['not both']);
    assert.deepEqual(found.get('not both')?.map(({ scenario }) => scenario.name), ['a', 'b']);
});

test('a scenario that only violates a property is no failure of its own', () => {
    const difference = { tag: 'run', line: 2, column: 10, steps: [0], places: [], message: '' };
    const fails = (scenario: ScenarioResult, hasPlace = true) => ownFailure(scenario, () => hasPlace).isFailure;
    assert.equal(fails(violating('a')), false);
    assert.equal(fails(violating('a', { differences: [difference] })), true);
    assert.equal(fails(violating('a', { stopped_in_step: 1 })), true);
    // A property that is not in the list would be lost.
    assert.equal(fails(violating('a'), false), true);
    assert.equal(fails(violating('a', { violations: [] })), true);
    assert.equal(fails(violating('a', { passed: true, violations: [] })), false);
});
