import assert from 'node:assert/strict';
import { test } from 'node:test';

import { indexTags, operandNames, tagPlaces } from '../src/operands.ts';
import type { Tag } from '../src/protocol.ts';

function tags(...names: string[]): Tag[] {
    return names.map((name) => ({ name, type: 'BOOL', value: false, role: 'internal', forced: false }));
}

test('the names of an operand list, without literals, strings and comments', () => {
    assert.deepEqual(operandNames('[ ]( start )'), ['start']);
    assert.deepEqual(operandNames('( )(run)'), ['run']);
    assert.deepEqual(operandNames('[TON]( t, T#5s, R := t.Q )'), ['t', 'R', 't.Q']);
    assert.deepEqual(operandNames('[TON]( t, 1h30m )'), ['t']);
    assert.deepEqual(operandNames("[MOV]( s, 'a # b $' c' )"), ['s']);
    assert.deepEqual(operandNames('[GT]( x # not me #, 16#FF )'), ['x']);
    assert.deepEqual(operandNames('[ADD]( y, a[3], word.3, 1.0e-3 )'), ['y', 'a[3]', 'word.3']);
    assert.deepEqual(operandNames('[ ]( %IX0.3 )'), ['%IX0.3']);
    assert.deepEqual(operandNames('[ ]( größe )'), ['größe']);
    assert.deepEqual(operandNames('[CALC]( y, (a + b) * MAX(c, 2) )'), ['y', 'a', 'b', 'MAX', 'c']);
});

test('wires, connectors and blocks without operands name nothing', () => {
    for (const element of ['--', '\\', '/', '+', '[OSR]', '<RET>', '[ ](', '']) {
        assert.deepEqual(operandNames(element), [], element);
    }
});

test('a timer shows its elapsed time and its output', () => {
    const index = indexTags(tags('run', 'warmup.IN', 'warmup.PT', 'warmup.Q', 'warmup.ET'));
    assert.deepEqual(tagPlaces(['[ ]( RUN )', '[TON]( Warmup, 5s )'], index), [0, 4, 3]);
});

test('a bit and an indexed element show the tag itself, and each tag stands once', () => {
    const index = indexTags(tags('word', 'a', 'a[3]'));
    assert.deepEqual(tagPlaces(['[ ]( word.3 )', '[/]( word.4 )', '[ ]( a[i] )', '[ ]( a[3] )'], index), [0, 1, 2]);
});

test('labels and functions that are no tags show nothing', () => {
    assert.deepEqual(tagPlaces(['<JMP>( top )', '[CALC]( y, MAX(a, b) )'], indexTags(tags('b'))), [0]);
});
