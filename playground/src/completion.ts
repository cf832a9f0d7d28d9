// Completion from the server. The package's own source cannot replace what is after the cursor, as the bracket that was closed by
// itself, nor ask for the documentation of one proposal.
import { autocompletion, type Completion, type CompletionSource, insertCompletionText, pickedCompletion, snippet } from '@codemirror/autocomplete';
import { LSPPlugin } from '@codemirror/lsp-client';
import { EditorState, type Extension } from '@codemirror/state';
import type { EditorView } from '@codemirror/view';

import type { Range } from '../../panels/protocol.ts';

interface Item {
    readonly label: string;
    readonly kind?: number;
    readonly detail?: string;
    readonly documentation?: string | { readonly kind: string; readonly value: string };
    readonly filterText?: string;
    readonly sortText?: string;
    readonly insertText?: string;
    readonly insertTextFormat?: 1 | 2;
    readonly textEdit?: { readonly range: Range; readonly newText: string };
    readonly additionalTextEdits?: readonly { readonly range: Range; readonly newText: string }[];
}

interface Answer {
    readonly items: readonly Item[];
}

/** The kinds of the protocol that have a sign of their own. */
const kinds: Readonly<Record<number, string>> = { 3: 'function', 5: 'property', 6: 'variable', 7: 'class', 12: 'constant', 14: 'keyword', 20: 'enum', 21: 'constant' };

/** The snippet's last stop comes after all others here, which count it as the first. */
function toSnippet(text: string): string {
    return text.replaceAll(/\\([$}\\])|\$(\d+)|\$\{0/g, (all, escaped: string | undefined, field: string | undefined) =>
        escaped ?? (field === undefined ? `${all.slice(0, -1)}99` : `\${${field === '0' ? '99' : field}}`),
    );
}

/** Whether a text has these letters in this order. */
function holds(text: string, letters: string): boolean {
    let at = -1;
    return [...letters].every((letter) => (at = text.indexOf(letter, at + 1)) >= 0);
}

async function documentation(plugin: LSPPlugin, item: Item): Promise<Node | null> {
    const { documentation: said } = item.documentation ? item : await plugin.client.request<Item, Item>('completionItem/resolve', item);
    if (!said) {
        return null;
    }
    const node = document.createElement('div');
    node.className = 'cm-lsp-documentation';
    node.innerHTML = plugin.docToHTML(said as Parameters<LSPPlugin['docToHTML']>[0]);
    return node;
}

const source: CompletionSource = async (context) => {
    const plugin = context.view && LSPPlugin.get(context.view);
    const before = context.state.sliceDoc(context.pos - 1, context.pos);
    const triggers = plugin?.client.serverCapabilities?.completionProvider?.triggerCharacters ?? [];
    const isTriggered = triggers.includes(before);
    if (!plugin || !(context.explicit || isTriggered || /[\p{L}\p{N}_]/u.test(before))) {
        return null;
    }
    plugin.client.sync();
    const asked = {
        textDocument: { uri: plugin.uri },
        position: plugin.toPosition(context.pos),
        context: isTriggered ? { triggerKind: 2, triggerCharacter: before } : { triggerKind: 1 },
    };
    context.addEventListener('abort', () => plugin.client.cancelRequest(asked));
    const answer = await plugin.client.request<typeof asked, Answer | readonly Item[] | null>('textDocument/completion', asked).catch(() => null);
    const items = answer && 'items' in answer ? answer.items : (answer ?? []);
    const first = items[0];
    if (context.aborted || !first) {
        return null;
    }
    const { doc } = context.state;
    const word = /[\p{L}\p{N}_]*$/u.exec(doc.sliceString(Math.max(context.pos - 100, 0), context.pos))?.[0].length ?? 0;
    const from = first.textEdit ? plugin.fromPosition(first.textEdit.range.start, doc) : context.pos - word;
    /** So much of what is after the cursor goes as well. */
    const after = first.textEdit ? Math.max(plugin.fromPosition(first.textEdit.range.end, doc) - context.pos, 0) : 0;
    const typed = doc.sliceString(from, context.pos).toLowerCase();
    const fitting = items
        .filter(({ label, filterText = label }) => holds(filterText.toLowerCase(), typed))
        .sort((a, b) => (a.sortText ?? a.label).localeCompare(b.sortText ?? b.label, 'en'));
    const options = fitting.map((item): Completion => {
        const { label, detail, kind = 0, filterText = label, insertTextFormat, insertText } = item;
        const text = item.textEdit?.newText ?? insertText ?? label;
        const type = kinds[kind];
        return {
            label: filterText,
            displayLabel: label,
            ...(detail === undefined ? {} : { detail }),
            ...(type === undefined ? {} : { type }),
            info: () => documentation(plugin, item).catch(() => null),
            apply(view: EditorView, completion: Completion, start: number, end: number) {
                const to = Math.min(end + after, view.state.doc.length);
                // What is put elsewhere, as a declaration, goes above: it is made first, and moves the rest.
                const more = (item.additionalTextEdits ?? []).map(({ range, newText }) => ({
                    from: plugin.fromPosition(range.start, doc),
                    to: plugin.fromPosition(range.end, doc),
                    insert: newText,
                }));
                const isAbove = more.every((edit) => edit.to <= start);
                const changes = view.state.changes(isAbove ? more : []);
                view.dispatch({ changes });
                const [at, until] = [changes.mapPos(start, 1), changes.mapPos(to, 1)];
                if (insertTextFormat === 2) {
                    snippet(toSnippet(text))(view, completion, at, until);
                } else {
                    view.dispatch({ ...insertCompletionText(view.state, text, at, until), annotations: pickedCompletion.of(completion) });
                }
            },
        };
    });
    // The order is the server's, which is asked again for each letter.
    return { from, to: context.pos, options, filter: false };
};

export const completion: Extension = [
    // Nothing is taken by an Enter that was meant for the next rung; so a Tab that comes at once is meant.
    autocompletion({ selectOnOpen: false, interactionDelay: 0 }),
    EditorState.languageData.of(() => [{ autocomplete: source }]),
];
