import assert from 'node:assert/strict';
import test from 'node:test';

import { Refusals } from '../src/refusals.ts';

const PATH = '/tank.clad';
const MESSAGE = 'the program has no tag "nix"';

/** Two breakpoints, of which the second is refused. */
function asked(): Refusals {
    const refusals = new Refusals();
    const breakpoints = [{ line: 3 }, { line: 5 }];
    refusals.asks({ seq: 7, type: 'request', command: 'setBreakpoints', arguments: { source: { path: PATH }, breakpoints } });
    const answered = [{ id: 1, verified: true, line: 4 }, { id: 2, verified: false, line: 6, message: MESSAGE }];
    assert.ok(refusals.hears({ type: 'response', command: 'setBreakpoints', request_seq: 7, body: { breakpoints: answered } }));
    return refusals;
}

test('a refused breakpoint is in the line where it was asked for', () => {
    assert.deepEqual(asked().of(PATH), [{ line: 4, message: MESSAGE }]);
    assert.deepEqual(asked().of('/other.clad'), []);
});

test('the next answer about a file is in the place of the last', () => {
    const refusals = asked();
    refusals.asks({ seq: 8, type: 'request', command: 'setBreakpoints', arguments: { source: { path: PATH }, breakpoints: [] } });
    refusals.hears({ type: 'response', command: 'setBreakpoints', request_seq: 8, body: { breakpoints: [] } });
    assert.deepEqual(refusals.of(PATH), []);
});

test('after a change of the program it is as the event tells', () => {
    const refusals = asked();
    refusals.hears({ type: 'event', event: 'breakpoint', body: { reason: 'changed', breakpoint: { id: 2, verified: true, line: 8 } } });
    assert.deepEqual(refusals.of(PATH), []);
    refusals.hears({ type: 'event', event: 'breakpoint', body: { reason: 'changed', breakpoint: { id: 1, verified: false, line: 9, message: MESSAGE } } });
    assert.deepEqual(refusals.of(PATH), [{ line: 8, message: MESSAGE }]);
});

test('other messages are not about breakpoints', () => {
    assert.equal(asked().hears({ type: 'event', event: 'stopped', body: { reason: 'step' } }), false);
});
