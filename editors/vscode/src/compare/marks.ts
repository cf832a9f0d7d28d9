// Marks next to the rungs that are not as HEAD has them: whether each does the same, with the reason when the pointer is on it.
import * as vscode from 'vscode';

import { escaped } from '../markdown.ts';
import { type Mark, type MarkedLine, markedLines } from '../../../../panels/compare/marks.ts';
import type { Comparisons } from './comparisons.ts';

/** A sign in the gutter: its path in a square of 16, and its colours on light and on dark. */
const signs: Readonly<Record<Mark, { readonly path: string; readonly light: string; readonly dark: string }>> = {
    same: { path: 'M5 6h6M5 10h6', light: '#15803d', dark: '#4ade80' },
    other: { path: 'M4.5 6h7M4.5 10h7M10.5 3l-5 10', light: '#b23c00', dark: '#ff9e64' },
    unknown: { path: 'M5.5 6a2.5 2.5 0 1 1 3.5 2.3q-1 .4-1 1.7M8 12.5v1', light: '#6b6b6b', dark: '#b0b0b0' },
    new: { path: 'M8 4v8M4 8h8', light: '#0b5cad', dark: '#7cc7ff' },
    gone: { path: 'M4 3h8M8 5v7M5 9l3 3 3-3', light: '#b3261e', dark: '#ff8182' },
    drawn: { path: 'M3.5 9q2.25-4 4.5-1t4.5-1', light: '#6b6b6b', dark: '#b0b0b0' },
};

function icon(mark: Mark, theme: 'light' | 'dark'): vscode.Uri {
    const { path, [theme]: colour } = signs[mark];
    const svg = `<svg xmlns="http://www.w3.org/2000/svg" width="16" height="16"><path d="${path}" fill="none" stroke="${colour}" stroke-width="1.6" stroke-linecap="round"/></svg>`;
    return vscode.Uri.parse(`data:image/svg+xml;base64,${Buffer.from(svg).toString('base64')}`);
}

const marks = Object.keys(signs) as Mark[];

export class ReviewMarks implements vscode.Disposable {
    readonly #comparisons: Comparisons;
    readonly #kinds: Readonly<Record<Mark, vscode.TextEditorDecorationType>>;
    readonly #subscriptions: vscode.Disposable;
    /** What was shown last of each document. */
    readonly #lines = new Map<string, readonly MarkedLine[]>();

    constructor(comparisons: Comparisons) {
        this.#comparisons = comparisons;
        const kind = (mark: Mark) =>
            vscode.window.createTextEditorDecorationType({
                light: { gutterIconPath: icon(mark, 'light') },
                dark: { gutterIconPath: icon(mark, 'dark') },
                gutterIconSize: 'contain',
                rangeBehavior: vscode.DecorationRangeBehavior.ClosedClosed,
            });
        this.#kinds = Object.fromEntries(marks.map((mark) => [mark, kind(mark)])) as Record<Mark, vscode.TextEditorDecorationType>;
        this.#subscriptions = vscode.Disposable.from(
            ...Object.values(this.#kinds),
            comparisons.onMayDiffer((document) => void this.#refresh(document)),
            vscode.window.onDidChangeVisibleTextEditors(() => this.#all()),
            vscode.workspace.onDidChangeConfiguration((event) => {
                if (event.affectsConfiguration('ladder.review.marks')) {
                    this.#all();
                }
            }),
            vscode.workspace.onDidCloseTextDocument(({ uri }) => this.#lines.delete(uri.toString())),
        );
        this.#all();
    }

    /** What is marked in a document, for those who want to know. */
    lines(document: vscode.TextDocument): readonly MarkedLine[] {
        return this.#lines.get(document.uri.toString()) ?? [];
    }

    #all(): void {
        const documents = vscode.window.visibleTextEditors.map(({ document }) => document);
        for (const document of new Set(documents)) {
            void this.#refresh(document);
        }
    }

    async #refresh(document: vscode.TextDocument): Promise<void> {
        const isShown = () => vscode.window.visibleTextEditors.some((editor) => editor.document === document);
        if (document.languageId !== 'clad' || !isShown()) {
            return;
        }
        const isWanted = vscode.workspace.getConfiguration('ladder.review', document).get('marks', true);
        // Where there is no base there are no marks, and nobody asked for them.
        const compared = isWanted ? await this.#comparisons.compare(document).catch(() => undefined) : undefined;
        if (compared && compared.version !== document.version) {
            return;
        }
        const lines = compared ? markedLines(compared) : [];
        this.#lines.set(document.uri.toString(), lines);
        for (const editor of vscode.window.visibleTextEditors.filter((editor) => editor.document === document)) {
            for (const mark of marks) {
                editor.setDecorations(this.#kinds[mark], lines.filter((line) => line.mark === mark).map((line) => this.#option(document, line)));
            }
        }
    }

    #option(document: vscode.TextDocument, { line, titles }: MarkedLine): vscode.DecorationOptions {
        // Its rail: over the rest of the line the pointer asks what is drawn there.
        const range = document.validateRange(new vscode.Range(line, 0, line, 3));
        const command = vscode.Uri.from({ scheme: 'command', path: 'ladder.compareWithHead' });
        const hover = new vscode.MarkdownString(`${titles.map(escaped).join('\n\n')}\n\n[Compare with HEAD](${command.toString()})`);
        hover.isTrusted = { enabledCommands: ['ladder.compareWithHead'] };
        return { range, hoverMessage: hover };
    }

    dispose(): void {
        this.#subscriptions.dispose();
    }
}
