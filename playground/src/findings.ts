// What the server finds in a text: marked in its editor with the fixes there are, and told to whoever lists it.
import { type Diagnostic, setDiagnostics } from '@codemirror/lint';
import { LSPPlugin, type LSPClient, type LSPClientExtension } from '@codemirror/lsp-client';
import type { Text } from '@codemirror/state';
import { type EditorView, ViewPlugin, type ViewUpdate } from '@codemirror/view';

import type { Range } from '../../panels/protocol.ts';

export interface Finding {
    readonly range: Range;
    /** 1 is an error, 2 a warning, 3 information, 4 a hint. */
    readonly severity?: 1 | 2 | 3 | 4;
    /** The rule. */
    readonly code?: string;
    /** The page of the rule, if it is one: `ladder-rule:/double-coil.md`. */
    readonly codeDescription?: { readonly href: string };
    readonly message: string;
    readonly data?: { readonly fixes?: readonly string[] };
}

interface TextEdit {
    readonly range: Range;
    readonly newText: string;
}

interface CodeAction {
    readonly title: string;
    readonly kind?: string;
    readonly isPreferred?: boolean;
    readonly edit?: { readonly changes?: Readonly<Record<string, readonly TextEdit[]>> };
}

const severities = { 1: 'error', 2: 'warning', 3: 'info', 4: 'hint' } as const;

/** Sends what is typed as soon as the editor has taken it in. */
const sending = ViewPlugin.fromClass(
    class {
        update(update: ViewUpdate): void {
            if (update.docChanged) {
                queueMicrotask(() => LSPPlugin.get(update.view)?.client.sync());
            }
        }
    },
);

/** What can be done in a range, in the order of the server. */
export async function actionsAt(view: EditorView, range: Range, only: readonly string[]): Promise<readonly CodeAction[]> {
    const plugin = LSPPlugin.get(view);
    if (!plugin) {
        return [];
    }
    plugin.client.sync();
    const asked = { textDocument: { uri: plugin.uri }, range, context: { diagnostics: [], only } };
    return (await plugin.client.request<typeof asked, readonly CodeAction[] | null>('textDocument/codeAction', asked)) ?? [];
}

/** Makes the edits of an action in all texts that are open, each in one step of undo. */
export function make(client: LSPClient, { edit }: CodeAction): void {
    for (const [uri, edits] of Object.entries(edit?.changes ?? {})) {
        const view = client.workspace.getFile(uri)?.getView();
        if (view) {
            view.dispatch({ changes: changesOf(view.state.doc, edits), userEvent: 'input.fix' });
        }
    }
}

/** The edits of an answer as changes of the text that it is about. */
export function changesOf(doc: Text, edits: readonly TextEdit[]) {
    const offset = ({ line, character }: Range['start']) => {
        const at = doc.line(Math.min(line + 1, doc.lines));
        return Math.min(at.from + character, at.to);
    };
    return edits.map(({ range: { start, end }, newText }) => ({ from: offset(start), to: offset(end), insert: newText }));
}

/** Applies the fix of this title to what was found in a range. */
export async function fix(view: EditorView, range: Range, title: string): Promise<void> {
    const client = LSPPlugin.get(view)?.client;
    const { doc } = view.state;
    const action = (await actionsAt(view, range, ['quickfix'])).find((it) => it.title === title);
    if (client && action && view.state.doc === doc) {
        make(client, action);
    }
}

export function findings(found: (uri: string, all: readonly Finding[]) => void): LSPClientExtension {
    return {
        clientCapabilities: {
            experimental: { rulePages: true },
            textDocument: {
                publishDiagnostics: { versionSupport: true, relatedInformation: true, dataSupport: true },
                // The package says that it asks for diagnostics, which it does not. In JSON a function is nothing.
                diagnostic: () => undefined,
            },
        },
        notificationHandlers: {
            'textDocument/publishDiagnostics': (client, { uri, version, diagnostics }: { uri: string; version?: number; diagnostics: readonly Finding[] }) => {
                const file = client.workspace.getFile(uri);
                const view = file?.getView();
                const plugin = view && LSPPlugin.get(view);
                if (!file || !view || !plugin || (version !== undefined && version !== file.version)) {
                    return true;
                }
                const { syncedDoc, unsyncedChanges } = plugin;
                const offset = (place: Range['start']) => unsyncedChanges.mapPos(plugin.fromPosition(place, syncedDoc));
                // Scenarios that nobody has begun are not wrong.
                const all = view.state.doc.length === 0 ? [] : diagnostics;
                const shown = all.map(({ range, severity = 1, code, message, data }): Diagnostic => ({
                    from: offset(range.start),
                    to: offset(range.end),
                    severity: severities[severity],
                    message,
                    ...(code === undefined ? {} : { source: code }),
                    actions: (data?.fixes ?? []).map((title) => ({ name: title, apply: (of) => void fix(of, range, title) })),
                }));
                view.dispatch(setDiagnostics(view.state, shown));
                found(uri, all);
                return true;
            },
        },
        editorExtension: sending,
    };
}
