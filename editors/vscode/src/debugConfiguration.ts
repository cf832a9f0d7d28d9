// What F5 starts: configurations of the debugger, as far as they need no editor to be understood.

/** A configuration as it is in launch.json, or an empty one where there is no such file. */
export interface Configuration {
    type?: string;
    request?: string;
    name?: string;
    program?: string;
    scenarioFile?: string;
    [more: string]: unknown;
}

/** The file that the active editor shows. */
export interface ActiveFile {
    readonly languageId: string;
    readonly path: string;
    /** The line of the cursor, from 1. */
    readonly line: number;
}

const LANGUAGES: readonly string[] = ['clad', 'ladder-test'];

/** Whether a file can be debugged. */
export function canBeDebugged(file: ActiveFile | undefined): file is ActiveFile {
    return file !== undefined && LANGUAGES.includes(file.languageId);
}

/**
 * The configuration with what is left out of it: without a launch.json the program of the active editor, which is
 * before its first scan; the scenario at the cursor runs.
 *
 * @returns undefined if there is nothing to be run
 */
export function completed(given: Configuration, active: ActiveFile | undefined): Configuration | undefined {
    const isEmpty = !given.type && !given.request && !given.name;
    if (isEmpty) {
        if (!canBeDebugged(active)) {
            return undefined;
        }
        const isProgram = active.languageId === 'clad';
        return {
            ...given,
            type: 'ladder',
            request: 'launch',
            name: isProgram ? 'Run this program' : 'Run the scenario at the cursor',
            program: active.path,
            ...(isProgram ? { stopOnEntry: true } : { scenarioLine: active.line }),
        };
    }
    if (given.program === undefined && given.scenarioFile === undefined) {
        return canBeDebugged(active) ? { ...given, program: active.path } : undefined;
    }
    return given;
}

/** The expression at a place of a line, for the value under the pointer: a tag with its members and its index. */
export function expressionAt(line: string, character: number): { start: number; end: number } | undefined {
    const pattern = /[\p{L}_%][\p{L}\p{N}_]*(?:\[[^[\]]*\])?(?:\.[\p{L}\p{N}_]+(?:\[[^[\]]*\])?)*/gu;
    for (const { index, 0: text } of line.matchAll(pattern)) {
        if (index <= character && character <= index + text.length) {
            return { start: index, end: index + text.length };
        }
    }
    return undefined;
}
