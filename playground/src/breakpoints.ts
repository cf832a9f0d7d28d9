// Breakpoints in the margin of the text: lines in front of which a run stops.
import { type EditorState, type Extension, RangeSet, StateEffect, StateField } from '@codemirror/state';
import { type Command, EditorView, gutter, GutterMarker, keymap } from '@codemirror/view';

import { opens } from './opened.ts';

const toggle = StateEffect.define<number>({ map: (from, changes) => changes.mapPos(from) });

class Dot extends GutterMarker {
    override toDOM(): Node {
        const node = document.createElement('span');
        node.className = 'breakpoint';
        node.title = 'A run stops in front of this rung (F9)';
        return node;
    }
}
const dot = new Dot();

const field = StateField.define<RangeSet<GutterMarker>>({
    create: () => RangeSet.empty,
    update(value, { changes, effects, state }) {
        const moved = value.map(changes);
        return effects.reduce((now, effect) => {
            if (effect.is(opens)) {
                return RangeSet.empty;
            }
            if (!effect.is(toggle)) {
                return now;
            }
            const from = state.doc.lineAt(effect.value).from;
            const isThere = linesOf(now, state).includes(state.doc.lineAt(from).number - 1);
            return isThere ? now.update({ filter: (at) => state.doc.lineAt(at).from !== from }) : now.update({ add: [dot.range(from)] });
        }, moved);
    },
});

function linesOf(dots: RangeSet<GutterMarker>, state: EditorState): number[] {
    const lines = new Set<number>();
    dots.between(0, state.doc.length, (from) => {
        lines.add(state.doc.lineAt(from).number - 1);
    });
    return [...lines].sort((a, b) => a - b);
}

const toggleHere: Command = (view) => {
    view.dispatch({ effects: toggle.of(view.state.selection.main.head) });
    return true;
};

/** @param changed called with the lines of all breakpoints, counted from 0 */
export function breakpoints(changed: (lines: readonly number[]) => void): Extension {
    return [
        field,
        gutter({
            class: 'cm-breakpoints',
            markers: (view) => view.state.field(field),
            initialSpacer: () => dot,
            domEventHandlers: {
                mousedown(view, line) {
                    view.dispatch({ effects: toggle.of(line.from) });
                    return true;
                },
            },
        }),
        keymap.of([{ key: 'F9', run: toggleHere, preventDefault: true }]),
        EditorView.updateListener.of(({ state, startState }) => {
            const [now, before] = [state.field(field), startState.field(field, false)];
            if (now !== before) {
                changed(linesOf(now, state));
            }
        }),
    ];
}

export function toggleBreakpoint(view: EditorView): void {
    toggleHere(view);
    view.focus();
}
