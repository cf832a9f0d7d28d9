import assert from 'node:assert/strict';
import { test } from 'node:test';

import { placeOfName } from '../src/placeOfName.ts';

test('a name is found whole', () => {
    const text = '<FUN>( function_10 ) [$function_1] <FUN>( function_1 )';
    assert.equal(placeOfName(text, 'function_1'), text.lastIndexOf('function_1'));
    assert.equal(placeOfName(text, '$function_1'), text.indexOf('$'));
    assert.equal(placeOfName(text, 'function'), -1);
});
