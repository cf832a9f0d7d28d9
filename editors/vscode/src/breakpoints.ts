// The editor's own breakpoints of a document as the simulator takes them.
import type { Breakpoint, SourceBreakpoint } from 'vscode';

function ofDocument(breakpoints: readonly Breakpoint[], uri: string): SourceBreakpoint[] {
    return breakpoints.filter((it): it is SourceBreakpoint => 'location' in it).filter(({ location }) => location.uri.toString() === uri);
}

/** Those on the block that begins at a place. */
export function breakpointsAt(breakpoints: readonly Breakpoint[], uri: string, place: { line: number; character: number }): SourceBreakpoint[] {
    return ofDocument(breakpoints, uri).filter(({ location: { range } }) => range.start.line === place.line && range.start.character === place.character);
}

/** The lines of a document with a breakpoint that is switched on, counted from 0. */
export function breakpointLines(breakpoints: readonly Breakpoint[], uri: string): number[] {
    const lines = ofDocument(breakpoints, uri)
        .filter(({ enabled }) => enabled)
        .map(({ location }) => location.range.start.line);
    return [...new Set(lines)].sort((a, b) => a - b);
}

/** The list without the name if it held it, else with it. */
export function toggled(names: readonly string[], name: string): readonly string[] {
    return names.includes(name) ? names.filter((it) => it !== name) : [...names, name];
}
