import assert from 'node:assert/strict';
import { test } from 'node:test';

import { EditorState, type TransactionSpec } from '@codemirror/state';

import { begins, begunRung } from '../src/begunRung.ts';

const FIRST = '+--[ ]( a )--( )( y )--+\n';

/** The state after Enter at the end of a rung, and after each of these. */
function after(...specs: TransactionSpec[]): EditorState {
    const state = EditorState.create({ doc: FIRST, selection: { anchor: FIRST.length }, extensions: begunRung });
    const changes = state.changes({ from: FIRST.length, insert: '+--' });
    const entered = state.update({ changes, selection: { anchor: FIRST.length + 3 }, effects: begins(changes.apply(state.doc), FIRST.length + 3) });
    return specs.reduce((now, spec) => now.update(spec).state, entered.state);
}

const text = (...specs: TransactionSpec[]) => after(...specs).doc.toString();
const away: TransactionSpec = { selection: { anchor: 2 } };
const end = FIRST.length + 3;

test('a rung that was begun goes when the cursor leaves it', () => {
    assert.equal(text(), `${FIRST}+--`);
    assert.equal(text({ selection: { anchor: end - 1 } }), `${FIRST}+--`);
    assert.equal(text(away), FIRST);
    assert.equal(after(away).selection.main.head, 2);
});

test('it stays where something was typed in it', () => {
    assert.equal(text({ changes: { from: end, insert: '[' }, selection: { anchor: end + 1 } }, away), `${FIRST}+--[`);
    assert.equal(text({ changes: { from: end - 1, to: end } }, away), `${FIRST}+-`);
});

test('it goes from where another change has moved it', () => {
    assert.equal(text({ changes: { from: 0, insert: '# one #\n' } }, away), `# one #\n${FIRST}`);
});

test('it goes once', () => {
    assert.equal(text(away, { selection: { anchor: FIRST.length } }, { changes: { from: FIRST.length, insert: '+--' } }, away), `${FIRST}+--`);
});

test('a line with more than a rung that begins is none', () => {
    assert.deepEqual(begins(after().doc, 2), []);
});
