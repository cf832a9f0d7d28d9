// Turns lines into comments and back. A comment cannot hold a `#`, so the editor's own command would break a rung with a
// duration in it: `T#5s` becomes `5s`, which means the same; where another `#` is, the command refuses.

export type Toggled = { readonly lines: string[] } | { readonly refused: number };

const isComment = (line: string) => /^\s*#[^#]*#\s*$/.test(line);
const isBlank = (line: string) => line.trim() === '';

function uncommented(line: string): string {
    return line.replace(/^(\s*)#\s?([^#]*?)\s?#\s*$/, '$1$2');
}

/** @returns undefined if a `#` is in the way */
function commented(line: string): string | undefined {
    const [, indent = '', text = ''] = /^(\s*)(.*?)\s*$/.exec(line) ?? [];
    const bare = text.replaceAll(/'(?:\$.|[^'])*'|(?<![\p{L}\p{N}_])(?:TIME|T)#(-?\d[\w.]*)/giu, (found, duration) => duration ?? found);
    return bare.includes('#') ? undefined : `${indent}# ${bare} #`;
}

/** All lines are comments: they are no longer. Else those that are not become one each; `refused` counts from 1. */
export function toggleComment(lines: readonly string[]): Toggled {
    if (lines.every((line) => isBlank(line) || isComment(line))) {
        return { lines: lines.map(uncommented) };
    }
    const result: string[] = [];
    for (const [index, line] of lines.entries()) {
        const changed = isBlank(line) || isComment(line) ? line : commented(line);
        if (changed === undefined) {
            return { refused: index + 1 };
        }
        result.push(changed);
    }
    return { lines: result };
}
