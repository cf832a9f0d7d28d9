// How far a slider goes for a number whose limits nobody knows.
import type { Tag } from '../protocol.ts';

export interface Span {
    readonly min: number;
    readonly max: number;
    readonly step: number;
}

/** What whole numbers of a type can be. */
const limits: Readonly<Record<string, readonly [number, number]>> = {
    SINT: [-128, 127],
    USINT: [0, 255],
    BYTE: [0, 255],
    INT: [-32_768, 32_767],
    UINT: [0, 65_535],
    WORD: [0, 65_535],
    DINT: [-2_147_483_648, 2_147_483_647],
    UDINT: [0, 4_294_967_295],
    DWORD: [0, 4_294_967_295],
    LINT: [Number.MIN_SAFE_INTEGER, Number.MAX_SAFE_INTEGER],
    ULINT: [0, Number.MAX_SAFE_INTEGER],
    LWORD: [0, Number.MAX_SAFE_INTEGER],
};

const times: readonly number[] = [10_000, 60_000, 600_000, 3_600_000, 86_400_000];

/** The least round number from 100 on that a value does not pass. */
function rounded(value: number): number {
    return Math.max(100, 10 ** Math.ceil(Math.log10(Math.max(value, 1))));
}

/**
 * @param before how far it went: a slider does not shrink while a user drags it
 * @returns nothing for what has no slider
 */
export function sliderSpan({ type, value }: Pick<Tag, 'type' | 'value'>, before?: Span): Span | undefined {
    if (typeof value !== 'number' || !Number.isFinite(value)) {
        return undefined;
    }
    if (before && before.min <= value && value <= before.max) {
        return before;
    }
    if (type === 'TIME') {
        const max = times.find((time) => value <= time);
        return max === undefined || value < 0 ? undefined : { min: 0, max, step: max / 1000 };
    }
    const size = rounded(Math.abs(value));
    const isNegative = value < 0 || (before !== undefined && before.min < 0);
    if (type === 'REAL' || type === 'LREAL') {
        return { min: isNegative ? -size : 0, max: size, step: size / 1000 };
    }
    const [least, most] = limits[type] ?? limits['DINT'] ?? [0, 0];
    const [min, max] = [isNegative ? Math.max(-size, least) : 0, Math.min(size, most)];
    return { min, max, step: Math.max(1, Math.round(size / 1000)) };
}
