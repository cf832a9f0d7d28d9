// Which scans the trace shows: zoom, pan, and following the newest.
import type { Traced } from './messages.ts';

export interface ScanWindow {
    /** How many scans are shown; all that are recorded if it is missing. */
    readonly span?: number;
    /** The last of them; the newest, whichever that is, if it is missing. */
    readonly last?: number;
}

/** What was drawn last: the numbers that zooming starts from. */
export type Drawn = Pick<Traced, 'first' | 'last' | 'oldest' | 'newest'>;

/** Fewer scans than this are not worth a picture. */
const FEWEST = 8;
const MOST = 4_000_000_000;

/** What is shown at first: ten seconds at 10 ms. */
export const BEGINNING: ScanWindow = { span: 1000 };

/** Everything that is recorded. */
export const EVERYTHING: ScanWindow = {};

export function follows({ last }: ScanWindow): boolean {
    return last === undefined;
}

/** So many times as many scans; the scan `at` stays where it is, unless the newest is followed. */
export function zoomed(window: ScanWindow, drawn: Drawn, factor: number, at?: number): ScanWindow {
    const before = drawn.last - drawn.first + 1;
    const rounded = factor < 1 ? Math.floor(before * factor) : Math.ceil(before * factor);
    const span = Math.min(Math.max(rounded, FEWEST), MOST);
    if (at === undefined) {
        return follows(window) ? { span } : centred(span, (drawn.first + drawn.last + 1) / 2, drawn);
    }
    const part = (at - drawn.first) / before;
    return bounded(span, Math.round(at - part * span) + span - 1, drawn);
}

/** So many scans to the right; the newest is followed again where it comes into sight. */
export function panned(drawn: Drawn, scans: number): ScanWindow {
    const span = drawn.last - drawn.first + 1;
    // The window may have room after the newest scan.
    const last = Math.min(drawn.last, Math.max(drawn.newest, span)) + Math.round(scans);
    return bounded(span, last, drawn);
}

/** The same number of scans, with one of them in the middle if it is not in sight. */
export function showing(window: ScanWindow, drawn: Drawn, scan: number): ScanWindow {
    if (drawn.first <= scan && scan <= drawn.last) {
        return window;
    }
    return centred(drawn.last - drawn.first + 1, scan, drawn);
}

function centred(span: number, scan: number, drawn: Drawn): ScanWindow {
    return bounded(span, Math.round(scan + span / 2) - 1, drawn);
}

function bounded(span: number, last: number, { oldest, newest }: Drawn): ScanWindow {
    const least = oldest + span - 1;
    return last >= newest ? { span } : { span, last: Math.max(last, least) };
}
