import assert from 'node:assert/strict';
import { test } from 'node:test';

import { blockOf, SCHEME } from '../src/libraryBlock.ts';

test('the address of a source names its block', () => {
    const { protocol, pathname } = new URL('ladder-library:/Debounce.clad');
    assert.equal(protocol, `${SCHEME}:`);
    assert.equal(blockOf(pathname), '$Debounce');
});
