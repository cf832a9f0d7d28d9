// Which breakpoints of a file the debugger refuses, read from the messages that pass between it and the editor.

/** A breakpoint that never stops, and why. */
export interface Refusal {
    /** From 0. */
    readonly line: number;
    readonly message: string;
}

/** A request of the editor, or what the debugger answers to one. */
export interface Message {
    readonly seq?: number;
    readonly type?: string;
    readonly command?: string;
    readonly request_seq?: number;
    readonly arguments?: { readonly source?: { readonly path?: string }; readonly breakpoints?: readonly { readonly line: number }[] };
    readonly event?: string;
    readonly body?: { readonly breakpoints?: readonly Answered[]; readonly breakpoint?: Answered; readonly reason?: string };
}

interface Answered {
    readonly id?: number;
    readonly verified?: boolean;
    readonly line?: number;
    readonly message?: string;
}

/** A breakpoint that was asked for: its line, from 0, and what was answered. */
interface Asked {
    readonly line: number;
    readonly answer: Answered;
}

export class Refusals {
    /** The files of the requests that are not answered yet. */
    readonly #open = new Map<number, { readonly path: string; readonly lines: readonly number[] }>();
    readonly #files = new Map<string, readonly Asked[]>();

    /** Takes in what the editor asks. */
    asks({ seq, command, arguments: given }: Message): void {
        if (seq !== undefined && command === 'setBreakpoints' && given?.source?.path !== undefined) {
            this.#open.set(seq, { path: given.source.path, lines: (given.breakpoints ?? []).map(({ line }) => line - 1) });
        }
    }

    /** Takes in what the debugger says. @returns whether it is about breakpoints */
    hears({ type, command, event, request_seq: request, body }: Message): boolean {
        const open = type === 'response' && command === 'setBreakpoints' && request !== undefined ? this.#open.get(request) : undefined;
        if (open && request !== undefined) {
            this.#open.delete(request);
            const answered = body?.breakpoints ?? [];
            this.#files.set(open.path, answered.map((answer, index) => ({ line: open.lines[index] ?? (answer.line ?? 1) - 1, answer })));
            return true;
        }
        const changed = event === 'breakpoint' ? body?.breakpoint : undefined;
        if (changed?.id === undefined) {
            return false;
        }
        for (const [path, asked] of this.#files) {
            const after = ({ line, answer }: Asked) => (answer.id === changed.id ? { line: (changed.line ?? line + 1) - 1, answer: changed } : { line, answer });
            this.#files.set(path, asked.map(after));
        }
        return true;
    }

    /** Those of a file, in their order. */
    of(path: string): Refusal[] {
        return (this.#files.get(path) ?? []).flatMap(({ line, answer: { verified, message } }) =>
            verified === false && message ? [{ line, message }] : [],
        );
    }
}
