// What became of a program of another system, in words.
import type { Converted } from './protocol.ts';

/** One line: how much of the program says the same. */
export function summary(file: string, { translated, approximated, refused }: Converted): string {
    return `${file}: ${translated} translated, ${approximated} approximated, ${refused} refused`;
}

/** Whether there is more to say than the summary. */
export function hasReport({ remarks, notes = [] }: Converted): boolean {
    return remarks.length + notes.length > 0;
}

/** The whole report, a line for each remark, as `ladder convert` writes it. */
export function report(file: string, converted: Converted): string {
    const remarks = converted.remarks.map(({ line, column, outcome, element, reason }) => {
        const place = line === undefined ? '' : `:${line}:${column}`;
        return `${file}${place}: ${outcome}: ${element}: ${reason}`;
    });
    const notes = (converted.notes ?? []).map((note) => `${file}: ${note}`);
    return [...remarks, ...notes, summary(file, converted), ''].join('\n');
}
