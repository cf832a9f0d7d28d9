// The lines with a key whose edits another key has overtaken, and where these lines are after further changes.

/** What Enter types. */
export const LINE_END = '\n';

/** A key that was typed in a line. */
export interface Typed {
    line: number;
    readonly typed: string;
    /** Its edits came too late. */
    isLate: boolean;
}

export class Overtaken {
    /** A user asks about them already. */
    isCatchingUp = false;
    readonly #typed: Typed[] = [];

    add(line: number, typed: string): Typed {
        const added = { line, typed, isLate: false };
        this.#typed.push(added);
        return added;
    }

    remove(one: Typed): void {
        const at = this.#typed.indexOf(one);
        if (at >= 0) {
            this.#typed.splice(at, 1);
        }
    }

    /** The first that is still to be asked about. */
    late(): Typed | undefined {
        return this.#typed.find(({ isLate }) => isLate);
    }

    /** The lines from `first` to `last` have become one line and `added` more. */
    shift(first: number, last: number, added: number): void {
        for (const typed of this.#typed) {
            if (typed.line > last) {
                typed.line += added - (last - first);
            } else if (typed.line > first) {
                typed.line = first;
            }
        }
    }
}
