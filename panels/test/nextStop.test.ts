// Where Tab leads on a rung.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { isDrawn, nextStop, type Stop } from '../nextStop.ts';

/** What Tab selects from the line's start on, one after the other: `^` under each operand, `|` under a place. */
function marks(line: string): string {
    let marked = '';
    for (let at: Stop = { start: 0, end: 0 }; ; ) {
        const next = nextStop(line, at, false);
        if (next.start === at.start && next.end === at.end) {
            return marked;
        }
        marked = marked.padEnd(next.start) + (next.start === next.end ? '|' : '^'.repeat(next.end - next.start));
        at = next;
    }
}

test('Tab selects operand after operand, then goes after the wire, and inserts nothing', () => {
    for (const [line, stops] of [
        [
            '+--[ ]( a )--[TON]( t1, T#1s )--',
            '        ^           ^^  ^^^^    |',
        ],
        [
            '+--[ ]( a )------( )( yes )--+',
            '        ^             ^^^  |  |',
        ],
        [
            '|  /--[ ]( b )--/      |',
            '           ^     |      |',
        ],
        [
            '+--# ( a, b ) #--[ ]( c )--',
            '                      ^    |',
        ],
        [
            '+--[$PID]( p, T#1s, 2.5, OUT => y )--[TON]( t, T#2s, R := r )--',
            '           ^  ^^^^  ^^^         ^           ^  ^^^^       ^    |',
        ],
        [
            "+--[CALC]( y, (a + b) * MAX(c, d) )--[MOV]( s, 'a,)' )--<JMP>( x )--+",
            '           ^  ^^^^^^^^^^^^^^^^^^^           ^  ^^^^^           ^  |  |',
        ],
        [
            '+--[MOV]( g[1, 2], v# note, #, 16#FF )--',
            '          ^^^^^^^  ^^^^^^^^^^  ^^^^^    |',
        ],
        [
            '+--[TON]( t, )--',
            '          ^  |  |',
        ],
    ] as const) {
        assert.equal(marks(line), stops, line);
    }
});

test('Tab leads on from the middle of an operand, and from what is selected', () => {
    const line = '+--[ ]( a )--[TON]( t1, T#1s )--';
    assert.deepEqual(nextStop(line, { start: 21, end: 21 }, false), { start: 24, end: 28 });
    assert.deepEqual(nextStop(line, { start: 20, end: 22 }, false), { start: 24, end: 28 });
    // A preset that was just reached without being selected is selected: what is typed takes its place.
    assert.deepEqual(nextStop(line, { start: 24, end: 24 }, false), { start: 24, end: 28 });
});

test('Shift+Tab goes back', () => {
    const line = '+--[ ]( a )--[TON]( t, T#1s )--';
    assert.deepEqual(nextStop(line, { start: 23, end: 27 }, true), { start: 20, end: 21 });
    assert.deepEqual(nextStop(line, { start: 25, end: 25 }, true), { start: 20, end: 21 });
    assert.deepEqual(nextStop('+--[ ]( a )--', { start: 8, end: 9 }, true), { start: 8, end: 8 });
});

test('declarations and empty lines are not drawn', () => {
    for (const line of ['', '    ', 'VAR', '    a, b : BOOL;', '# a comment #']) {
        assert.ok(!isDrawn(line), line);
    }
    for (const line of ['+--', '|  /--[ ]( b )--/', '[ ]( a )--( )( y )', '   /--( )( y )']) {
        assert.ok(isDrawn(line), line);
    }
});
