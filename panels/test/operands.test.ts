import assert from 'node:assert/strict';
import { test } from 'node:test';

import { operandAt } from '../operands.ts';
import type { Operand } from '../protocol.ts';

const line = '+--[ ]( run )--[TON]( warmup, 5s, R := stop )--+';

function operand(block: string, name: string): Operand {
    const range = (text: string) => {
        const at = line.indexOf(text);
        return { start: { line: 0, character: at }, end: { line: 0, character: at + text.length } };
    };
    return { range: range(name), block: range(block), tags: [name] };
}

const timer = '[TON]( warmup, 5s, R := stop )';
const operands = [operand('[ ]( run )', 'run'), operand(timer, 'warmup'), operand(timer, 'stop')];

test('the operand at a place: around it, after it, or the first one of the block', () => {
    for (const [text, offset, tag] of [
        ['run', 0, 'run'],
        ['run', 3, 'run'],
        ['[ ]', 0, 'run'],
        ['run )', 5, 'run'],
        ['[TON]', 2, 'warmup'],
        ['5s', 1, 'warmup'],
        ['stop', 4, 'stop'],
    ] as const) {
        const place = { line: 0, character: line.indexOf(text) + offset };
        assert.equal(operandAt(operands, place)?.tags[0], tag, `${text} + ${offset}`);
    }
    assert.equal(operandAt(operands, { line: 0, character: 1 }), undefined);
});
