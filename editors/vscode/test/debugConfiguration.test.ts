import assert from 'node:assert/strict';
import { test } from 'node:test';

import { completed, expressionAt } from '../src/debugConfiguration.ts';

const program = { languageId: 'clad', path: '/plant/motor.clad', line: 1 };
const scenarios = { languageId: 'ladder-test', path: '/plant/motor.ladder-test', line: 7 };

test('without a launch.json the program of the active editor runs', () => {
    assert.deepEqual(completed({}, program), {
        type: 'ladder',
        request: 'launch',
        name: 'Run this program',
        program: '/plant/motor.clad',
        stopOnEntry: true,
    });
    assert.deepEqual(completed({ noDebug: true }, scenarios), {
        noDebug: true,
        type: 'ladder',
        request: 'launch',
        name: 'Run the scenario at the cursor',
        program: '/plant/motor.ladder-test',
        scenarioLine: 7,
    });
    assert.equal(completed({}, { languageId: 'python', path: '/plant/motor.py', line: 1 }), undefined);
    assert.equal(completed({}, undefined), undefined);
});

test('a configuration says what it says', () => {
    const given = { type: 'ladder', request: 'launch', name: 'Motor', program: '/plant/other.clad' };
    assert.equal(completed(given, program), given);
    const open = { type: 'ladder', request: 'launch', name: 'Motor' };
    assert.equal(completed(open, program)?.program, '/plant/motor.clad');
    assert.equal(completed(open, undefined), undefined);
    const scenario = { ...open, scenarioFile: '/plant/motor.ladder-test' };
    assert.equal(completed(scenario, undefined), scenario);
});

test('the expression under the pointer', () => {
    const at = (line: string) => {
        const found = expressionAt(line.replace('|', ''), line.indexOf('|'));
        return found && line.replace('|', '').slice(found.start, found.end);
    };
    assert.equal(at('+--[ ]( st|art )--+'), 'start');
    assert.equal(at('+--[GE]( t1.E|T, T#1s )--+'), 't1.ET');
    assert.equal(at('+--[GE]( a[i]|.3, 5 )--+'), 'a[i].3');
    assert.equal(at('+--[ ]( %IX0|.1 )--+'), '%IX0.1');
    assert.equal(at('+-|-[ ]( start )--+'), undefined);
});
