// What the drawing does of itself while a person types: the server says how a rung that is complete is laid out, and what
// Enter begins.
import { acceptCompletion, completionStatus, moveCompletionSelection } from '@codemirror/autocomplete';
import { LSPPlugin } from '@codemirror/lsp-client';
import { type ChangeDesc, ChangeSet, EditorSelection, type Extension, Prec, type StateCommand, type Text } from '@codemirror/state';
import { type Command, EditorView, keymap, ViewPlugin, type ViewUpdate } from '@codemirror/view';

import { isDrawn, nextStop } from '../../panels/nextStop.ts';
import type { Range } from '../../panels/protocol.ts';
import { begins, begunRung } from './begunRung.ts';
import { changesOf } from './findings.ts';
import type { Server } from './server.ts';

interface Edit {
    readonly range: Range;
    readonly newText: string;
}

function triggers(view: EditorView): readonly string[] {
    const provider = LSPPlugin.get(view)?.client.serverCapabilities?.documentOnTypeFormattingProvider;
    return provider ? [provider.firstTriggerCharacter, ...(provider.moreTriggerCharacter ?? [])] : [];
}

/** What the first key of an element is. */
const ELEMENT = /^[[(<\-\\/]/;

/** Whether nothing was done since but to type the first elements of the rung that Enter begins, at this place of the text before. */
function beginsRung(since: ChangeDesc, place: number, now: Text): boolean {
    let isThere = true;
    since.iterChangedRanges((from, to) => (isThere &&= from === place && to === place));
    return isThere && ELEMENT.test(now.sliceString(place, since.mapPos(place, 1)));
}

/** Where the text ends that changes put at a place, also in place of what is there: the right rail, which Enter takes along. */
function afterInserted(changes: ChangeSet, place: number): number {
    let end = changes.mapPos(place, 1);
    changes.iterChanges((from, _to, _start, to) => {
        end = from === place ? to : end;
    });
    return end;
}

/** Makes what the server answers to a typed character, unless more was typed meanwhile; the rail of a new rung is put in front of that. */
async function typed(view: EditorView, ch: string): Promise<void> {
    const plugin = LSPPlugin.get(view);
    if (!plugin) {
        return;
    }
    const { client, uri } = plugin;
    client.sync();
    const { doc, selection } = view.state;
    const { head: place } = selection.main;
    const asked = { textDocument: { uri }, position: plugin.toPosition(place), ch, options: { tabSize: 4, insertSpaces: true } };
    await client.withMapping(async (mapping) => {
        const edits = await client.request<typeof asked, readonly Edit[] | null>('textDocument/onTypeFormatting', asked);
        const { state } = view;
        const since = mapping.getMapping(uri);
        const isBegun = ch === '\n' && since !== null && beginsRung(since, place, state.doc);
        if (!edits || edits.length === 0 || LSPPlugin.get(view)?.uri !== uri || (state.doc !== doc && !isBegun)) {
            return;
        }
        const made = ChangeSet.of(changesOf(doc, edits), doc.length);
        const changes = since ? made.map(since, true) : made;
        // What comes after the cursor leaves it where it is, but that a new line begins with.
        const { head } = state.selection.main;
        const anchor = ch === '\n' ? afterInserted(changes, head) : changes.mapPos(head, -1);
        const effects = ch === '\n' ? begins(changes.apply(state.doc), anchor) : [];
        view.dispatch({ changes, effects, selection: { anchor }, userEvent: 'input.type.format', scrollIntoView: true });
    });
}

const drawing = ViewPlugin.fromClass(
    class {
        update(update: ViewUpdate): void {
            const last = update.transactions.at(-1);
            if (!last?.docChanged || !last.isUserEvent('input') || last.isUserEvent('input.type.format') || last.isUserEvent('input.fix')) {
                return;
            }
            let text = '';
            last.changes.iterChanges((_from, _to, _start, _end, inserted) => (text = inserted.toString()));
            const ch = text.startsWith('\n') ? '\n' : text;
            if (triggers(update.view).includes(ch)) {
                queueMicrotask(() => void typed(update.view, ch).catch(() => undefined));
            }
        }
    },
);

const stop =
    (isBackwards: boolean): StateCommand =>
    ({ state, dispatch }) => {
        const { from, to, head } = state.selection.main;
        const line = state.doc.lineAt(head);
        if (!isDrawn(line.text) || from < line.from || to > line.to) {
            return false;
        }
        const next = nextStop(line.text, { start: from - line.from, end: to - line.from }, isBackwards);
        const selection = EditorSelection.range(line.from + next.start, line.from + next.end);
        dispatch(state.update({ selection: EditorSelection.create([selection]), scrollIntoView: true }));
        return true;
    };

const takeFirst: Command = (view) => {
    if (completionStatus(view.state) !== 'active') {
        return false;
    }
    return acceptCompletion(view) || (moveCompletionSelection(true)(view) && acceptCompletion(view));
};

/** Enter begins a line with nothing: what a rung begins with the server knows. */
const enter: StateCommand = ({ state, dispatch }) => {
    dispatch(state.update(state.replaceSelection('\n'), { userEvent: 'input', scrollIntoView: true }));
    return true;
};

/** Says where the cursor is, so that a rung that is half typed is not full of errors. */
function cursor(server: Server): Extension {
    let said: string | undefined;
    const tell = (view: EditorView, line: number | null) => {
        const uri = LSPPlugin.get(view)?.uri;
        const key = `${uri} ${line}`;
        if (uri !== undefined && key !== said) {
            said = key;
            void server.execute('ladder.cursor', { uri, line }).catch(() => undefined);
        }
    };
    return EditorView.updateListener.of(({ view, state, changes, docChanged, selectionSet, focusChanged }) => {
        const here = state.doc.lineAt(state.selection.main.head);
        let isElsewhere = false;
        changes.iterChanges((_from, _to, from, to) => (isElsewhere ||= to < here.from || from > here.to));
        if (isElsewhere) {
            // The server takes the change for typing, and is told once more that the cursor is not there.
            said = undefined;
        }
        if ((docChanged || selectionSet || focusChanged) && view.hasFocus) {
            tell(view, here.number - 1);
        } else if (focusChanged) {
            tell(view, null);
        }
    });
}

export function typing(server: Server): Extension {
    return [
        drawing,
        begunRung,
        cursor(server),
        Prec.high(
            keymap.of([
                { key: 'Tab', run: takeFirst },
                { key: 'Tab', run: stop(false), shift: stop(true) },
                { key: 'Enter', run: enter },
            ]),
        ),
    ];
}
