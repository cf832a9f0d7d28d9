// What others wrote, in Markdown: an image in it would be loaded when it is shown.

/** A text as it is, in a sentence. */
export function escaped(text: string): string {
    return text.replace(/[\\`*_{}[\]()#+.!|<>:&~-]/g, '\\$&').replace(/\p{Cc}/gu, ' ');
}

/** Lines as they are: no line of them ends the block. */
export function fenced(lines: string): string {
    const runs = lines.match(/`+/g) ?? [];
    const fence = '`'.repeat(Math.max(2, ...runs.map((run) => run.length)) + 1);
    return `${fence}text\n${lines}\n${fence}`;
}
