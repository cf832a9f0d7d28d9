import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

import { taskArguments } from '../src/taskArguments.ts';

const manifest = JSON.parse(readFileSync(new URL('../package.json', import.meta.url), 'utf8'));

test('what tasks start', () => {
    assert.deepEqual(taskArguments('check', '/plant'), ['check', '--format', 'concise', '--', '/plant']);
    assert.deepEqual(taskArguments('test', '/plant', 'belt'), ['test', '--', '/plant/belt']);
    assert.deepEqual(taskArguments('format', '/plant', '/other/motor.clad'), ['fmt', '--', '/other/motor.clad']);
});

test('the matchers find what the commands write', () => {
    const matcher = (name: string) => manifest.contributes.problemMatchers.find((it: { name: string }) => it.name === name);
    const [line] = [matcher('ladder').pattern].flat();
    const found = new RegExp(line.regexp).exec('/plant/belt.clad:15:5: info[never-read] `rate` is written, and nothing reads it');
    assert.deepEqual(
        [line.file, line.line, line.column, line.severity, line.code, line.message].map((group) => found?.[group]),
        ['/plant/belt.clad', '15', '5', 'info', 'never-read', '`rate` is written, and nothing reads it'],
    );
    const [message, place] = matcher('ladder-test').pattern;
    const said = new RegExp(message.regexp).exec('        run is FALSE in step 3 (at 30ms), TRUE was expected; 3 of 6 steps differ');
    assert.equal(said?.[message.message], 'run is FALSE in step 3 (at 30ms), TRUE was expected; 3 of 6 steps differ');
    const there = new RegExp(place.regexp).exec('        at /plant/belt.ladder-test:10:12');
    assert.deepEqual([place.file, place.line, place.column].map((group) => there?.[group]), ['/plant/belt.ladder-test', '10', '12']);
});
