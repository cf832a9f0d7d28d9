// A rung that Enter has begun goes again when the cursor leaves it and nothing was typed there, as editors of code take back the
// blanks of an indentation.
import { EditorState, type Extension, StateEffect, StateField, type Text, type Transaction } from '@codemirror/state';

/** What Enter begins a rung with. */
const BEGUN = /^\+-*$/;

interface Stretch {
    readonly from: number;
    readonly to: number;
}

const begin = StateEffect.define<Stretch>();

/** A transaction with this has begun a rung, if there is one in that line. */
export function begins(doc: Text, place: number): readonly StateEffect<Stretch>[] {
    const { from, to, text } = doc.lineAt(place);
    return BEGUN.test(text) ? [begin.of({ from, to })] : [];
}

/** Where that rung is after a transaction in which nothing happened to it. */
function moved(rung: Stretch, { changes }: Transaction): Stretch | undefined {
    return changes.touchesRange(rung.from, rung.to) ? undefined : { from: changes.mapPos(rung.from, 1), to: changes.mapPos(rung.to, -1) };
}

const isLeft = ({ from, to }: Stretch, { newSelection: { main } }: Transaction) => main.head < from || main.head > to;

/** The state's own: another text that takes its place has begun no rung. */
const begun = StateField.define<Stretch | undefined>({
    create: () => undefined,
    update(before, transaction) {
        const rung = before && moved(before, transaction);
        const now = rung && !isLeft(rung, transaction) ? rung : undefined;
        return transaction.effects.reduce((last, effect) => (effect.is(begin) ? effect.value : last), now);
    },
});

const leaving = EditorState.transactionFilter.of((transaction) => {
    const before = transaction.startState.field(begun);
    const rung = before && moved(before, transaction);
    return rung && isLeft(rung, transaction) ? [transaction, { changes: rung, sequential: true }] : transaction;
});

export const begunRung: Extension = [begun, leaving];
