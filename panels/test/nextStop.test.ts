// Where Tab leads on a rung.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { isDrawn, nextStop } from '../nextStop.ts';

/** A `^` under each place that Tab leads to from the line's start. */
function marks(line: string): string {
    let marked = '';
    for (let column = 0; ; ) {
        const next = nextStop(line, column, false);
        if (next === column) {
            return marked;
        }
        marked = `${marked.padEnd(next)}^`;
        column = next;
    }
}

test('Tab goes from operand to operand, then after the wire, and inserts nothing', () => {
    for (const [line, stops] of [
        [
            '+--[ ]( a )--[TON]( t, T#1s )--',
            '        ^           ^  ^       ^',
        ],
        [
            '+--[ ]( a )------( )( y )--+',
            '        ^             ^  ^  ^',
        ],
        [
            '|  /--[ ]( b )--/      |',
            '           ^     ^      ^',
        ],
        [
            '+--# ( a, b ) #--[ ]( c )--',
            '                      ^    ^',
        ],
    ] as const) {
        assert.equal(marks(line), stops, line);
    }
});

test('Shift+Tab goes back', () => {
    assert.equal(nextStop('+--[ ]( a )--[TON]( t, T#1s )--', 23, true), 20);
    assert.equal(nextStop('+--[ ]( a )--', 8, true), 8);
});

test('declarations and empty lines are not drawn', () => {
    for (const line of ['', '    ', 'VAR', '    a, b : BOOL;', '# a comment #']) {
        assert.ok(!isDrawn(line), line);
    }
    for (const line of ['+--', '|  /--[ ]( b )--/', '[ ]( a )--( )( y )', '   /--( )( y )']) {
        assert.ok(isDrawn(line), line);
    }
});
