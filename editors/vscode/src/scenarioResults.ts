// What `ladder test --format json` says, and what of it is shown where.

export interface Results {
    readonly files: readonly FileResult[];
    readonly coverage?: readonly Covered[];
    readonly mutation?: readonly Mutated[];
}

export interface FileResult {
    readonly file: string;
    readonly program: string | null;
    readonly errors: readonly { readonly file: string; readonly line: number; readonly column: number; readonly message: string }[];
    readonly scenarios: readonly ScenarioResult[];
}

export interface ScenarioResult {
    readonly name: string;
    readonly line: number;
    readonly passed: boolean;
    readonly seconds: number;
    readonly differences: readonly Difference[];
    /** Properties that it violates: `line` and `column` are where the property has its name, from 1, in characters. */
    readonly violations?: readonly { readonly property: string; readonly line: number; readonly column: number; readonly message: string }[];
    /** Where it leaves what is assumed of what goes in, in words. */
    readonly outside?: string;
    readonly faults: readonly { readonly file: string; readonly line: number; readonly message: string; readonly scan: number }[];
    /** Both waveforms, with what differs. */
    readonly diagram?: string;
    readonly stopped_in_step?: number;
}

/** A row that is not as expected: the place of the first value that is not met, from 1, in characters. */
export interface Difference {
    readonly tag: string;
    readonly line: number;
    readonly column: number;
    /** From 0. */
    readonly steps: readonly number[];
    /** Where the values are that differ: from 1, `end_column` is the one after the last. */
    readonly places: readonly { readonly line: number; readonly column: number; readonly end_column: number }[];
    readonly message: string;
}

export interface Covered {
    readonly file: string;
    readonly networks: { readonly exercised: number; readonly all: number };
    readonly rungs: readonly { readonly line: number; readonly scans: number }[];
    readonly parts: readonly {
        readonly kind: 'contact' | 'comparison' | 'coil';
        readonly line: number;
        readonly column: number;
        readonly on: boolean;
        readonly off: boolean;
        /** Whether a scenario shows that it matters, where changes were tried. */
        readonly matters?: boolean;
    }[];
}

/** A change of a program, and whether a scenario notices it. */
export interface Mutated {
    readonly program: string;
    readonly caught: number;
    readonly missed: number;
    readonly changes: readonly {
        readonly line: number;
        readonly change: string;
        readonly before: string;
        readonly fate: string;
        /** A scenario that would notice it. */
        readonly scenario?: string;
    }[];
}

/** A stretch of a line: the line from 0, columns from 0 in UTF-16 units. */
export interface Stretch {
    readonly line: number;
    readonly start: number;
    readonly end: number;
}

/** A column in characters from 1 as one in UTF-16 units from 0. */
export function unitsBefore(line: string, column: number): number {
    return [...line].slice(0, column - 1).join('').length;
}

/** Where the values of a row are that are not as expected. */
export function failingStretches(lines: readonly string[], { places }: Difference): Stretch[] {
    return places.map(({ line, column, end_column: end }) => {
        const text = lines[line - 1] ?? '';
        return { line: line - 1, start: unitsBefore(text, column), end: unitsBefore(text, end) };
    });
}

/** The ways in which a contact, comparison or coil is to be seen. */
export function waysOf({ kind, on, off, matters }: Covered['parts'][number]): { name: string; isSeen: boolean }[] {
    const [isOn, isOff] = kind === 'coil' ? (['on', 'off'] as const) : (['closed', 'open'] as const);
    const shown = matters === undefined ? [] : [{ name: 'shown to matter', isSeen: matters }];
    return [{ name: isOn, isSeen: on }, { name: isOff, isSeen: off }, ...shown];
}

/** The scenarios that show a property to be violated, by the name of the property, each with what it says of that. */
export function violatedBy(scenarios: readonly ScenarioResult[]): Map<string, { scenario: ScenarioResult; message: string }[]> {
    const found = new Map<string, { scenario: ScenarioResult; message: string }[]>();
    for (const scenario of scenarios) {
        for (const { property, message } of scenario.violations ?? []) {
            found.set(property, [...(found.get(property) ?? []), { scenario, message }]);
        }
    }
    return found;
}

/**
 * What of a scenario is a failure of its own: all but the properties that it violates, each of which is one failure in its own
 * place however many scenarios show it.
 */
export function ownFailure(scenario: ScenarioResult, hasPlace: (property: string) => boolean): { isFailure: boolean; violations: NonNullable<ScenarioResult['violations']> } {
    const violations = (scenario.violations ?? []).filter(({ property }) => !hasPlace(property));
    const isElsewhere = violations.length < (scenario.violations?.length ?? 0);
    const isOwn = violations.length > 0 || scenario.differences.length > 0 || scenario.stopped_in_step !== undefined;
    return { isFailure: !scenario.passed && (isOwn || !isElsewhere), violations };
}

/** The changes that no scenario notices, for the output of a run. */
export function missedLines({ program, caught, missed, changes }: Mutated): string[] {
    const lines = changes
        .filter(({ fate }) => fate === 'missed')
        .flatMap(({ line, change, before, scenario }) => [
            `${program}:${line}: no scenario notices: ${change}, ${before}`,
            ...(scenario === undefined ? [] : ['this one would:', ...scenario.trimEnd().split('\n').map((row) => `    ${row}`)]),
        ]);
    return [`${program}: of ${caught + missed} changes the scenarios notice ${caught}`, ...lines];
}
