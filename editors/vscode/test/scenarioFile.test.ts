import assert from 'node:assert/strict';
import { test } from 'node:test';

import { propertiesOf, scenariosOf } from '../src/scenarioFile.ts';

const TEXT = `program door.clad
assume not (a and b)

property "not both" # a comment
# another
never up and down

always up or T#5s > t   # why

property "at once" within 1s of go: up

scenario "goes"
go    _-
never _-
after => _-
no faults
`;

test('properties are found with their names or texts, and rows that are called so are none', () => {
    assert.deepEqual(propertiesOf(TEXT), [
        { name: 'not both', line: 3, lastLine: 5 },
        { name: 'always up or T#5s > t', line: 7, lastLine: 7 },
        { name: 'at once', line: 9, lastLine: 9 },
        { name: 'no faults', line: 15, lastLine: 15 },
    ]);
});

test('scenarios end where the next one begins', () => {
    assert.deepEqual(
        scenariosOf(TEXT).map(({ name, line }) => [name, line]),
        [['goes', 11]],
    );
});
