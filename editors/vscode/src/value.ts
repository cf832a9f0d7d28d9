// Values of tags, from what a person types and to what a person reads.
import type { Tag, Value } from './protocol.ts';

const bools = new Map<string, boolean>([
    ['1', true],
    ['true', true],
    ['on', true],
    ['high', true],
    ['0', false],
    ['false', false],
    ['off', false],
    ['low', false],
]);

/**
 * What is sent to the server for a value that was typed. What is not understood here goes as it is: the server knows
 * the tag's type best and says what is wrong.
 */
export function parseValue(type: string, text: string): Value {
    const trimmed = text.trim();
    if (type === 'BOOL') {
        return bools.get(trimmed.toLowerCase()) ?? trimmed;
    }
    if (type.startsWith('STRING')) {
        return /^'(.*)'$/s.exec(trimmed)?.[1] ?? text;
    }
    const plain = trimmed.replaceAll('_', '');
    const number = /^[-+]?\d+(\.\d+)?(e[-+]?\d+)?$/i.test(plain) ? Number(plain) : Number.NaN;
    // Past 2^53 a number would lose its last digits on the way: it goes as text.
    return Math.abs(number) <= Number.MAX_SAFE_INTEGER ? number : trimmed;
}

const units: readonly (readonly [string, number])[] = [
    ['d', 86_400_000],
    ['h', 3_600_000],
    ['m', 60_000],
];

/** A time in milliseconds as it is written in a program: 90500 is `1m30.5s`. */
export function showDuration(ms: number): string {
    if (ms < 0) {
        return `-${showDuration(-ms)}`;
    }
    if (ms < 1000) {
        return `${Number(ms.toPrecision(10))}ms`;
    }
    let rest = ms;
    let text = '';
    for (const [unit, length] of units) {
        const count = Math.floor(rest / length);
        if (count > 0) {
            text += `${count}${unit}`;
            rest -= count * length;
        }
    }
    return rest > 0 ? `${text}${Number((rest / 1000).toPrecision(10))}s` : text;
}

export function showValue(tag: Pick<Tag, 'type' | 'value'>): string {
    const { type, value } = tag;
    if (typeof value === 'boolean') {
        return value ? '1' : '0';
    }
    if (typeof value === 'number') {
        if (type === 'TIME') {
            return showDuration(value);
        }
        return type === 'REAL' || type === 'LREAL' ? String(Number(value.toPrecision(7))) : String(value);
    }
    return type.startsWith('STRING') ? `'${value}'` : value;
}
