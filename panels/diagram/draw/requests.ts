// What the page asks of the server while somebody draws, by way of the editor that shows the page. Places are of the text,
// lines and characters from 0.
import type { CrossReferenced } from '../../crossReference.ts';
import type { DrawableRow, Range } from '../../protocol.ts';
import type { Place } from '../messages.ts';

/** One change of the drawing. */
export type Edit =
    | { readonly op: 'insert'; readonly at: Place; readonly text: string; readonly copied?: boolean }
    | { readonly op: 'parallel'; readonly from: Place; readonly to: Place; readonly text: string; readonly side: 'below' | 'above'; readonly copied?: boolean }
    | { readonly op: 'delete'; readonly what: readonly Range[] }
    | { readonly op: 'delete'; readonly network: number }
    | { readonly op: 'operand' | 'head' | 'rename'; readonly what: Range; readonly text: string }
    | { readonly op: 'move'; readonly what: readonly Range[]; readonly to: { readonly at: Place } }
    | { readonly op: 'network'; readonly network?: number; readonly place: 'above' | 'below'; readonly text?: string; readonly entry?: string; readonly copied?: boolean }
    | { readonly op: 'branchEnd' | 'close'; readonly what: Place; readonly to: Place }
    | { readonly op: 'comment'; readonly network: number; readonly text: string }
    | { readonly op: 'comment'; readonly what: Range; readonly text: string }
    | { readonly op: 'declaration'; readonly what: Range; readonly row: Cells | null }
    | { readonly op: 'declaration'; readonly block?: string; readonly row: Cells }
    | { readonly op: 'moveNetwork'; readonly network: number; readonly before: number | null }
    | { readonly op: 'duplicate'; readonly network: number }
    | { readonly op: 'split'; readonly at: Place }
    | { readonly op: 'merge'; readonly networks: readonly number[] };

/** What a row of the table of declarations says; what is empty is left out. */
export interface Cells {
    /** The first line of its section: `VAR RETAIN`. */
    readonly section: string;
    readonly name: string;
    readonly address?: string;
    readonly type: string;
    readonly initial?: string;
    readonly comment?: string;
}

/** All that a program declares, in the order of its text. */
export interface Declarations {
    readonly version: number;
    readonly rows: readonly { readonly block?: string; readonly cells: Cells; readonly at: Range }[];
    readonly blocks?: readonly string[];
}

/** What an edit did: places are of the new text. */
export interface Edited {
    /** Of the text that the edits are for; of the new text where the page is told of it. */
    readonly version: number;
    readonly edits: readonly { readonly range: Range; readonly newText: string }[];
    readonly select: readonly Range[];
    readonly focus: Place | null;
    /** In a sentence. */
    readonly said: string;
    /** The edits of other files. */
    readonly also?: readonly { readonly uri: string; readonly version: number | null; readonly edits: Edited['edits'] }[];
}

/** What can be done at a place or with some elements. */
export interface Offered {
    readonly offers: readonly { readonly op: string; readonly why?: string }[];
    /** The elements as ladder text. */
    readonly text?: string;
    readonly points?: { readonly before?: Place; readonly behind?: Place };
    /** The things of the next larger group. */
    readonly largerThings?: readonly Range[];
    /** All that acts on the line. */
    readonly acting?: { readonly from: Place; readonly to: Place };
    /** The names of a text that are new, and what they would be. */
    readonly declares?: readonly { readonly name: string; readonly section: string; readonly type: string }[];
    /** A free name for an empty field. */
    readonly name?: string;
}

/** What an offer is asked for. */
export type Asked = ({ readonly at: Place } | { readonly what: readonly Range[] } | { readonly network: number }) & { readonly text?: string };

/** The questions, by name. */
export interface Requests {
    edit: { argument: { readonly version: number; readonly edit: Edit }; answer: Pick<Edited, 'version' | 'select' | 'focus' | 'said'> };
    offer: { argument: { readonly version: number } & Asked; answer: Offered };
    palette: { argument: { readonly search: string }; answer: { readonly rows: readonly DrawableRow[] } };
    tags: { argument: object; answer: Pick<CrossReferenced, 'tags'> };
    declarations: { argument: object; answer: Declarations };
    /** What would put right what is reported at a place, by title. */
    fixes: { argument: { readonly range: Range }; answer: readonly string[] };
    /** Does one of them. */
    fix: { argument: { readonly range: Range; readonly title: string }; answer: void };
}

/** The command of the server that answers a question; the others are the editor's own. */
export const commands = {
    edit: 'ladder.diagramEdit',
    offer: 'ladder.diagramOffer',
    palette: 'ladder.diagramPalette',
    tags: 'ladder.crossReference',
    declarations: 'ladder.declarations',
} as const satisfies Partial<Record<keyof Requests, string>>;
