// What the text of a file of scenarios says about where its scenarios are.

/** A scenario, at its line from 0. */
export interface Scenario {
    readonly name: string;
    readonly line: number;
    /** The last line that belongs to it. */
    readonly lastLine: number;
}

/** The scenarios of a file, in their order; of two with one name the first. */
export function scenariosOf(text: string): Scenario[] {
    const lines = text.split(/\r\n|\n|\r/);
    const found: { name: string; line: number }[] = [];
    lines.forEach((line, index) => {
        const name = /^\s*scenario\s+"([^"]*)"/.exec(line)?.[1];
        if (name !== undefined) {
            found.push({ name, line: index });
        }
    });
    const scenarios = found.map(({ name, line }, index) => {
        let lastLine = (found[index + 1]?.line ?? lines.length) - 1;
        // Blank lines and comments before the next one are not its own.
        while (lastLine > line && /^\s*(#.*)?$/.test(lines[lastLine] ?? '')) {
            lastLine -= 1;
        }
        return { name, line, lastLine };
    });
    return scenarios.filter(({ name }, index) => scenarios.findIndex((other) => other.name === name) === index);
}
