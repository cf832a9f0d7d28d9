// What the server says of a trace, as docs/protocol.md of the project defines it, and what the extension and the page of the
// view say to one another.

/** Which part of a trace is asked for. */
export interface TraceAsked {
    /** How many scans are drawn; all that are recorded if it is missing. */
    readonly span?: number;
    /** The last of them; the newest if it is missing. */
    readonly last?: number;
    /** In no more columns than so many. */
    readonly columns: number;
    /** Only the columns from that of this scan on. */
    readonly since?: number;
    /** About so many ticks for the time. */
    readonly ticks: number;
    /** Scans whose values are read. */
    readonly cursors: readonly number[];
}

/** A column and what is drawn there and in those after it; of a number the least, the greatest and the last value. */
export type Column =
    | readonly [column: number, least: number, greatest: number, last: number]
    | readonly [column: number, level: number]
    | readonly [column: number, text: string];

export interface Tick {
    readonly at: number;
    readonly text: string;
}

export interface TraceTag {
    readonly name: string;
    readonly type?: string;
    readonly kind: 'bit' | 'number' | 'text' | 'unknown';
    readonly now?: string;
    readonly oldest?: number;
    readonly range?: readonly [least: number, greatest: number];
    readonly ticks?: readonly Tick[];
    readonly columns?: readonly Column[];
    readonly readings?: readonly (string | null)[];
    readonly difference?: string;
}

export interface Traced {
    readonly revision: number;
    readonly intervalMs: number;
    readonly first: number;
    readonly last: number;
    readonly per: number;
    readonly oldest: number;
    readonly newest: number;
    readonly here: number;
    readonly reach: { readonly first: number; readonly last: number };
    readonly ticks: readonly Tick[];
    readonly cursors?: { readonly times: readonly string[]; readonly difference?: string };
    readonly tags: readonly TraceTag[];
}

/** How the simulation is, for the page. */
export interface Situation {
    /** The session whose trace it is; none if nothing is simulated. */
    readonly session?: string;
    readonly running: boolean;
    readonly tags: readonly string[];
}

export type ToPage =
    | { readonly kind: 'situation'; readonly situation: Situation }
    | { readonly kind: 'traced'; readonly session: string; readonly asked: TraceAsked; readonly traced: Traced }
    /** What was asked for is not to be had now. */
    | { readonly kind: 'refused' };

export type FromPage =
    | { readonly kind: 'ready' }
    /** Of the session that the page knows: while it asked another may have come into sight. */
    | { readonly kind: 'ask'; readonly session: string; readonly asked: TraceAsked }
    | { readonly kind: 'goTo'; readonly scan: number }
    | { readonly kind: 'choose' }
    | { readonly kind: 'remove'; readonly tag: string }
    | { readonly kind: 'move'; readonly tag: string; readonly by: 1 | -1 }
    | { readonly kind: 'runOrPause' };
