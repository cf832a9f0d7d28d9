// What changed in a program, as the server says it, and what the page that shows it and the extension say to each other.
import type { Lines } from '../diagram/messages.ts';

/** The answer to `ladder.compare`. */
export interface Compared {
    readonly uri: string;
    readonly version: number;
    /** How many of each there are, in words. */
    readonly summary: string;
    readonly changes: readonly Changed[];
    readonly style?: string;
}

/** A network, declaration or comment that is not as it was. */
export interface Changed {
    /** `same` of what has only moved. */
    readonly change: 'edited' | 'redrawn' | 'commented' | 'new' | 'gone' | 'same';
    readonly moved?: boolean;
    readonly kind: string;
    readonly names?: readonly string[];
    /** What an edited network does. */
    readonly meaning?: 'same' | 'other' | 'declared' | 'unknown';
    readonly reason?: string;
    readonly title: string;
    /** Its first line; of what is gone the line above which it was. */
    readonly line: number;
    readonly new?: Lines;
    readonly old?: Lines;
    /** Both forms, as HTML. */
    readonly drawing?: string;
}

export type ToPage =
    | { readonly kind: 'compared'; readonly name: string; readonly compared: Compared }
    /** There is nothing to compare: why. */
    | { readonly kind: 'refused'; readonly message: string };

export type FromPage = { readonly kind: 'begin' } | { readonly kind: 'reveal'; readonly line: number };
