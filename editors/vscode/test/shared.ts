// Cases that every editor's plugin must pass alike: what a value looks like does not depend on the editor.
import { readFileSync } from 'node:fs';

import type { Value } from '../src/protocol.ts';

interface Cases {
    readonly durations: readonly [ms: number, text: string][];
    readonly shown: readonly [type: string, value: Value, text: string][];
    readonly typed: readonly [type: string, text: string, value: Value][];
}

interface LabelCase {
    readonly name: string;
    readonly lines: string[];
    readonly labels: [row: number, column: number, text: string, room: number][];
    readonly placed: [side: string, column: number][];
}

function read(name: string) {
    return JSON.parse(readFileSync(new URL(`../../shared/${name}`, import.meta.url), 'utf8'));
}

export const cases: Cases = read('values.json');
export const labelCases: LabelCase[] = read('labels.json');
