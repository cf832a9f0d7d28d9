// What the diagram's page and the extension say to each other. Lines and characters count from 0.
import type { Contact, Given, Tag } from '../protocol.ts';
import type { Requests } from './draw/requests.ts';

/** Lines that follow one another, both ends included. */
export interface Lines {
    readonly first: number;
    readonly last: number;
}

export interface Place {
    readonly line: number;
    readonly character: number;
}

/** A comment, heading or network, as the server draws it. */
export interface DrawnPiece {
    readonly kind: 'comment' | 'heading' | 'network' | 'broken';
    readonly lines: Lines;
    readonly width: number;
    readonly height: number;
    /** Two drawings with the same key are the same. */
    readonly key: string;
    /** Missing if the page has it. */
    readonly svg?: string;
    /** False if nothing can be drawn in it, and why. */
    readonly editable?: false;
    readonly why?: string;
}

/** The answer to `ladder.diagram`. */
export interface Drawn {
    readonly uri: string;
    readonly version: number;
    readonly lineCount: number;
    /** The lines of which all is sent. */
    readonly lines: Lines;
    readonly pieces: readonly DrawnPiece[];
}

/** Lines of the text that have been replaced by so many others. */
export interface LineChange {
    readonly first: number;
    readonly last: number;
    readonly count: number;
}

/** What a contact does, that an element changes faster than anybody can follow, or that nothing is known of it. */
export type Does = Contact | 'flickers' | 'unknown';

/** Power of an element: its line, its character, whether it has power, and what it does. */
export type PowerAt = readonly [line: number, character: number, on: boolean, does?: Does];

/** The tags of an operand: its line, its character, and whether the drawing shows the value already. */
export type OperandAt = readonly [line: number, character: number, tags: readonly string[], drawn: boolean];

/** What has changed of what the page shows; all of it if it is whole. */
export interface LiveUpdate {
    readonly whole: boolean;
    readonly status: 'paused' | 'running' | 'ended' | 'faulted';
    /** How the simulation is, in words. */
    readonly text: string;
    readonly power: readonly PowerAt[];
    readonly operands: readonly OperandAt[];
    readonly tags: readonly Tag[];
}

/** What is reported about a place in the text. */
export interface Finding {
    readonly from: Place;
    readonly to: Place;
    readonly severity: 'error' | 'warning' | 'info';
    readonly message: string;
}

/** Whose names of instructions come first where they are chosen: "Open contact" or "XIC". */
export type Names = 'iec' | 'us';

export type ToPage =
    | { readonly type: 'open'; readonly name: string; readonly version: number; readonly lineCount: number; readonly line: number; readonly names?: Names }
    | { readonly type: 'edited'; readonly version: number; readonly lineCount: number; readonly changes: readonly LineChange[] }
    | { readonly type: 'drawn'; readonly drawn: Drawn }
    /** There is no drawing: why, for people. */
    | { readonly type: 'failed'; readonly version: number; readonly message: string }
    | { readonly type: 'live'; readonly update: LiveUpdate | undefined }
    | { readonly type: 'cursor'; readonly place: Place }
    | { readonly type: 'findings'; readonly version: number; readonly findings: readonly Finding[] }
    /** The answer to a question, or why there is none. */
    | { readonly type: 'reply'; readonly id: number; readonly answer?: unknown; readonly error?: string };

/** Something that the page asks of the server. */
export type Question = {
    [Name in keyof Requests]: { readonly type: 'request'; readonly id: number; readonly name: Name; readonly argument: Requests[Name]['argument'] };
}[keyof Requests];

export type FromPage =
    | { readonly type: 'ready' }
    | { readonly type: 'ask'; readonly lines: Lines; readonly rail: number; readonly known: readonly string[] }
    /** These lines are in sight. */
    | { readonly type: 'sees'; readonly lines: Lines }
    /** The last update is on the screen. */
    | { readonly type: 'painted' }
    | { readonly type: 'toggle'; readonly tag: string }
    | { readonly type: 'pulse'; readonly tag: string }
    | ({ readonly type: 'set' | 'force'; readonly tag: string } & Given)
    | { readonly type: 'unforce'; readonly tag: string }
    | { readonly type: 'why'; readonly tag: string }
    /** Shows it in the text; `isQuiet` only where that is seen already. */
    | { readonly type: 'reveal'; readonly from: Place; readonly to: Place; readonly focus: boolean; readonly isQuiet?: true }
    | Question
    /** A step of the text's own history; by a key, on which some editors act themselves. */
    | { readonly type: 'undo' | 'redo'; readonly isKey: boolean }
    | { readonly type: 'command'; readonly name: 'start' | 'run' | 'pause' | 'step' | 'back' | 'stop' };
