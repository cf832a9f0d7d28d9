import assert from 'node:assert/strict';
import { test } from 'node:test';

import { Asker, answerOf, reply } from '../diagram/draw/asker.ts';
import { keyOf } from '../diagram/draw/keyOf.ts';
import { wordsOf } from '../diagram/draw/words.ts';
import type { FromPage, Question } from '../diagram/messages.ts';

test('a place is called by what is next to it, and by its line', () => {
    const things = [
        { left: 40, right: 80, y: 30, text: 'start' },
        { left: 120, right: 160, y: 31, text: 'stop' },
        { left: 40, right: 80, y: 70, text: 'run' },
    ];
    const at = (left: number, right: number, y: number) => wordsOf({ left, right, y }, things, [30, 30, 70]);
    assert.equal(at(80, 120, 30), 'between start and stop, line 1 of 2');
    assert.equal(at(20, 40, 30), 'between the left and start, line 1 of 2');
    assert.equal(at(160, 300, 31), 'between stop and the right, line 1 of 2');
    assert.equal(at(80, 120, 70), 'between run and the right, line 2 of 2');
    assert.equal(wordsOf({ left: 0, right: 40, y: 30 }, things, [30]), 'between the left and start');
});

test('each question has its own answer, in whatever order they come', async () => {
    const sent: FromPage[] = [];
    const asker = new Asker((message) => sent.push(message));
    const [one, two] = [asker.ask('palette', { search: 'a' }), asker.ask('palette', { search: 'b' })];
    const [first, second] = sent as Question[];
    asker.take({ type: 'reply', id: second?.id ?? 0, error: 'no' });
    asker.take({ type: 'reply', id: first?.id ?? 0, answer: { rows: [] } });
    assert.deepEqual(await one, { rows: [] });
    await assert.rejects(two, /^Error: no$/);
});

test('an edit is made before the page hears of it, and an error of the server is its answer', async () => {
    const range = { start: { line: 0, character: 3 }, end: { line: 0, character: 9 } };
    const edited = { version: 4, edits: [{ range, newText: '' }], select: [], focus: range.start, said: 'Contact a taken out' };
    const made: unknown[] = [];
    const make = async (given: unknown) => made.push(given) + 4;
    const question: Question = { type: 'request', id: 1, name: 'edit', argument: { version: 4, edit: { op: 'delete', what: [range] } } };
    const asked: unknown[] = [];
    const execute = async (command: string, argument: unknown): Promise<never> => {
        asked.push(command, argument);
        return edited as never;
    };
    const fixes = async () => ['Declare it'];
    const fix = async (_: unknown, title: string) => void made.push(title);
    assert.deepEqual(await reply(question, (question) => answerOf(question, 'file:///a.clad', { execute, make, fixes, fix })), {
        type: 'reply',
        id: 1,
        answer: { select: [], focus: range.start, said: 'Contact a taken out', version: 5 },
    });
    assert.deepEqual(asked, ['ladder.diagramEdit', { uri: 'file:///a.clad', ...question.argument }]);
    assert.deepEqual(made, [edited]);
    const of = { execute, make, fixes, fix };
    assert.deepEqual(await answerOf({ type: 'request', id: 2, name: 'fixes', argument: { range } }, 'file:///a.clad', of), ['Declare it']);
    await answerOf({ type: 'request', id: 3, name: 'fix', argument: { range, title: 'Declare it' } }, 'file:///a.clad', of);
    assert.deepEqual(made, [edited, 'Declare it']);
    const refuses = async () => Promise.reject(Object.assign(new Error('a comment is in the way'), { code: -32803 }));
    assert.deepEqual(await reply(question, refuses), { type: 'reply', id: 1, error: 'a comment is in the way' });
});

test('a key is called as the table has it, whatever keyboard it comes from', () => {
    const key = (key: string, held = '') => keyOf({ key, shiftKey: held.includes('s'), altKey: held.includes('a'), ctrlKey: held.includes('c'), metaKey: held.includes('m') });
    assert.equal(key('c'), 'C');
    assert.equal(key('C', 's'), 'Shift+C');
    assert.equal(key('#', 's'), '#');
    assert.equal(key(' '), 'Space');
    assert.equal(key('ArrowUp', 'as'), 'Alt+Shift+ArrowUp');
    assert.equal(key('z', 'm'), 'Ctrl+Z');
    assert.equal(key('F8', 's'), 'Shift+F8');
});
