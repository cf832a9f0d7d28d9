// What an editor has open, as part of its state: so Undo crosses a change of program, too, and brings its name again.
import { invertedEffects } from '@codemirror/commands';
import { type Extension, StateEffect, StateField, type Transaction } from '@codemirror/state';

export interface Opened {
    readonly name: string;
    /** What the page keeps the program under. */
    readonly id: string;
}

/** Another text takes the place of the one that is there. */
export const opens = StateEffect.define<Opened>();

export const opensAnother = ({ effects }: Transaction): boolean => effects.some((effect) => effect.is(opens));

export const opened = StateField.define<Opened>({
    create: () => ({ name: '', id: '' }),
    update: (value, { effects }) => effects.reduce((now, effect) => (effect.is(opens) ? effect.value : now), value),
});

export function opening(first: Opened): Extension {
    return [
        opened.init(() => first),
        invertedEffects.of((transaction) => (opensAnother(transaction) ? [opens.of(transaction.startState.field(opened))] : [])),
    ];
}
