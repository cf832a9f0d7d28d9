// What the server says of a scene, as docs/protocol.md of the project defines it, and what the page of a scene and the editor around it say to one another.
import type { Given } from '../protocol.ts';

export interface SceneNode {
    readonly parent?: number;
    /** An element of SVG; else there is `text`. */
    readonly name?: string;
    readonly attributes?: Readonly<Record<string, string>>;
    /** It blinks, once in so many milliseconds. */
    readonly blink?: number;
    readonly text?: string;
}

export interface SceneSlot {
    readonly node: number;
    /** An attribute; `text`: what is written there; `given`: what a click gives; `row`: the value of a row. */
    readonly use: string;
}

export interface SceneAct {
    readonly node: number;
    readonly kind: 'press' | 'toggle' | 'set';
    readonly tag: string;
}

export interface SceneRow {
    readonly name: string;
    readonly attribute: string;
    readonly expression: string;
}

/** The answer to `ladder.scene`. */
export interface SceneShown {
    readonly uri: string;
    /** The address of its program. */
    readonly program?: string;
    readonly title: string;
    readonly nodes: readonly SceneNode[];
    readonly slots: readonly SceneSlot[];
    readonly acts: readonly SceneAct[];
    readonly rows: readonly SceneRow[];
    /** Of each place. Empty: as it is drawn. */
    readonly values: readonly string[];
    readonly findings: readonly string[];
}

export type Changed = readonly [slot: number, value: string];

/** What has changed in a scene. */
export interface SceneValues {
    readonly uri: string;
    readonly values?: readonly Changed[];
    /** Another program runs: the scene is to be asked for again. */
    readonly again?: boolean;
}

export interface SceneSituation {
    /** Something is simulated, and its inputs can be given. */
    readonly live: boolean;
    readonly running: boolean;
    /** How it is, in words. */
    readonly text: string;
}

export type ToPage =
    | { readonly kind: 'scene'; readonly shown: SceneShown }
    | { readonly kind: 'values'; readonly values: readonly Changed[] }
    | { readonly kind: 'situation'; readonly situation: SceneSituation }
    | { readonly kind: 'failed'; readonly message: string };

export type FromPage =
    | { readonly kind: 'ready' }
    | { readonly kind: 'give'; readonly tag: string; readonly given: Given }
    | { readonly kind: 'runOrPause' };
