// What the text of a file of scenarios says about where its scenarios and properties are.

/** A scenario or a property, at its line from 0. */
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

/** A property, whose name may be on a line above it. A row of a tag that is called so has an arrow, or levels. */
const FORM = /^(?:no\s+faults$|(?:always|never|when|after|within|possible)\b(?!\s*(?:=>|[-_.\s]*$)))/;

/** What is before a comment: a # right after a letter or digit belongs to a literal. */
const withoutComment = (line: string) => line.replace(/(?<![\p{L}\p{N}])#.*$/u, '').trim();

/** The properties of a file, in their order. One without a name is called by its text. */
export function propertiesOf(text: string): Scenario[] {
    const found: Scenario[] = [];
    let named: { name: string; line: number } | undefined;
    text.split(/\r\n|\n|\r/).forEach((line, lastLine) => {
        const [, name, after] = /^\s*property\s+"([^"]*)"(.*)$/.exec(line) ?? [];
        const form = withoutComment(after ?? line);
        if (name !== undefined) {
            named = { name: name.trim(), line: lastLine };
        }
        if (FORM.test(form)) {
            found.push({ name: named?.name ?? form, line: named?.line ?? lastLine, lastLine });
            named = undefined;
        }
    });
    return found;
}
