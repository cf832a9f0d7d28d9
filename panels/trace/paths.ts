// Columns as paths of a picture.
import type { Column } from './messages.ts';

/** Where a column begins on the page. */
export type ToX = (column: number) => number;

/** Rounded, for a picture of a thousand columns is a long text. */
const at = (number: number) => String(Math.round(number * 10) / 10);

export interface BitPaths {
    /** The waveform. */
    readonly line: string;
    /** The area beneath it where it is high. */
    readonly high: string;
    /** Where it was both in one column. */
    readonly busy: string;
}

/** Of a BOOL, up to `end`. */
export function bitPaths(columns: readonly Column[], toX: ToX, end: number, top: number, bottom: number): BitPaths {
    let [line, high, busy] = ['', '', ''];
    let before: number | undefined;
    columns.forEach(([column, level], index) => {
        const from = Math.max(toX(column), 0);
        const next = columns[index + 1];
        const to = Math.min(next === undefined ? end : toX(next[0]), end);
        if (to <= from) {
            return;
        }
        const area = `M${at(from)} ${at(top)}H${at(to)}V${at(bottom)}H${at(from)}Z`;
        if (level === 2) {
            busy += area;
            before = undefined;
            return;
        }
        const y = at(level === 1 ? top : bottom);
        line += before === undefined ? `M${at(from)} ${y}` : `V${y}`;
        line += `H${at(to)}`;
        high += level === 1 ? area : '';
        before = Number(level);
    });
    return { line, high, busy };
}

/** Of a number, up to `end`: steps, and from the least to the greatest value where a column had several. */
export function numberPath(columns: readonly Column[], toX: ToX, end: number, toY: (value: number) => number): string {
    let path = '';
    let isOpen = false;
    columns.forEach((it, index) => {
        if (it.length !== 4) {
            // It was no number.
            isOpen = false;
            return;
        }
        const [column, least, greatest, last] = it;
        const from = Math.max(toX(column), 0);
        const next = columns[index + 1];
        const to = Math.min(next === undefined ? end : toX(next[0]), end);
        if (to <= from) {
            return;
        }
        const y = at(toY(last));
        if (least !== greatest) {
            path += `${isOpen ? '' : `M${at(from)} ${at(toY(least))}`}V${at(toY(least))}V${at(toY(greatest))}V${y}`;
        } else {
            path += isOpen ? `V${y}` : `M${at(from)} ${y}`;
        }
        path += `H${at(to)}`;
        isOpen = true;
    });
    return path;
}

/** Where a value is between the least and the greatest; one that never changed in the middle. */
export function scaleOf([least, greatest]: readonly [number, number], top: number, bottom: number): (value: number) => number {
    const span = greatest - least;
    if (!(span > 0) || !Number.isFinite(span)) {
        return () => (top + bottom) / 2;
    }
    return (value) => bottom - ((value - least) / span) * (bottom - top);
}

export interface Word {
    readonly from: number;
    readonly to: number;
    readonly text: string;
}

/** Of a text the stretches with the same words. */
export function words(columns: readonly Column[], toX: ToX, end: number): Word[] {
    return columns.flatMap(([column, text], index) => {
        const from = Math.max(toX(column), 0);
        const next = columns[index + 1];
        const to = Math.min(next === undefined ? end : toX(next[0]), end);
        return to > from ? [{ from, to, text: String(text) }] : [];
    });
}
