// Where the editor shows that a program is stopped.

interface Frame {
    readonly endLine?: number;
    readonly endColumn?: number;
}

interface Message {
    readonly type?: string;
    readonly command?: string;
    readonly body?: { readonly stackFrames?: readonly Frame[] };
}

/**
 * A message of the debugger, whose stack frames are lines. For a column the editor would draw a mark within the line, which
 * moves the drawing apart, and for an end it would select text, which the next letter would replace. Which block is next
 * the live view shows.
 */
export function withLinesOnly(message: Message): object {
    const frames = message.body?.stackFrames;
    if (message.type !== 'response' || message.command !== 'stackTrace' || !frames) {
        return message;
    }
    const stackFrames = frames.map(({ endLine: _line, endColumn: _column, ...frame }) => ({ ...frame, column: 1 }));
    return { ...message, body: { ...message.body, stackFrames } };
}
