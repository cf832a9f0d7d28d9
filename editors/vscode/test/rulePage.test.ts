import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

import { ruleOf, SCHEME } from '../src/rulePage.ts';

test('the address that a finding links names its rule', () => {
    // As docs/protocol.md of the project has it, which the server is tested against.
    const page = readFileSync(new URL('../../../docs/protocol.md', import.meta.url), 'utf8');
    const address = /`(ladder-rule:[^`]*)`/.exec(page)?.[1] ?? '';
    const { protocol, pathname } = new URL(address);
    assert.equal(protocol, `${SCHEME}:`);
    assert.equal(ruleOf(pathname), 'double-coil');
});

test('a link from one page leads to another', () => {
    assert.equal(ruleOf('wrong-shape.md'), 'wrong-shape');
});
