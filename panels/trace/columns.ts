// The columns that the page knows: what is new is put after what was there.
import type { Column, TraceAsked, Traced } from './messages.ts';

export class Columns {
    #revision = -1;
    #per = 0;
    #tags: readonly string[] = [];
    /** The scans that the columns are about. */
    #first = 0;
    #newest = -1;
    readonly #byTag = new Map<string, Column[]>();

    /** From which scan on columns have to be asked for; none if all of them are wanted. */
    since(asked: Omit<TraceAsked, 'since'>, first: number, tags: readonly string[]): number | undefined {
        const span = asked.span ?? 0;
        const isKnown =
            this.#newest >= 0 &&
            span > 0 &&
            Math.ceil(span / asked.columns) === this.#per &&
            first >= this.#first &&
            tags.join('\n') === this.#tags.join('\n');
        return isKnown ? this.#newest : undefined;
    }

    /** @returns whether that is all that is shown; otherwise everything has to be asked for once more. */
    take(asked: TraceAsked, traced: Traced): boolean {
        const { since } = asked;
        const isSame = traced.revision === this.#revision && traced.per === this.#per;
        if (since !== undefined && !isSame) {
            this.forget();
            return false;
        }
        if (since === undefined) {
            this.forget();
            this.#first = traced.first;
        }
        this.#revision = traced.revision;
        this.#per = traced.per;
        const newest = Math.min(traced.newest, traced.last);
        if (since !== undefined && since > newest) {
            // The window lies in what is known, and nothing was sent.
            return true;
        }
        this.#newest = newest;
        this.#tags = traced.tags.map(({ name }) => name);
        for (const { name, columns = [] } of traced.tags) {
            const known = this.#byTag.get(name) ?? [];
            this.#byTag.set(name, joined(known, columns, Math.floor((since ?? 0) / traced.per), Math.floor(traced.first / traced.per)));
        }
        return true;
    }

    of(tag: string): readonly Column[] {
        return this.#byTag.get(tag) ?? [];
    }

    forget(): void {
        this.#byTag.clear();
        this.#newest = -1;
        // What is on its way was asked for to be put after what was known.
        this.#revision = -1;
    }
}

/** The known columns up to `from`, then the fresh ones; of what lies before `first` only what reaches into it. */
export function joined(known: readonly Column[], fresh: readonly Column[], from: number, first: number): Column[] {
    const all = known.filter(([column]) => column < from);
    for (const column of fresh) {
        const before = all.at(-1);
        // A column that is drawn like the one before it needs no place of its own.
        if (before === undefined || before.length !== column.length || before.slice(1).some((part, at) => part !== column[at + 1])) {
            all.push(column);
        }
    }
    const begins = all.findLastIndex(([column]) => column <= first);
    return begins > 0 ? all.slice(begins) : all;
}

/** What is drawn in a column. */
export function columnAt(columns: readonly Column[], column: number): Column | undefined {
    return columns.findLast(([start]) => start <= column);
}

/** The column of the next change after one, or before it. */
export function edge(columns: readonly Column[], column: number, way: 1 | -1): number | undefined {
    const changes = columns.slice(1).map(([start]) => start);
    return way === 1 ? changes.find((start) => start > column) : changes.findLast((start) => start < column);
}
