// *Compare with HEAD*: both forms of what changed in a program, next to each other and next to its text.
import * as vscode from 'vscode';

import type { FromPage, ToPage } from '../../../../panels/compare/messages.ts';
import { reasonOf } from '../../../../panels/reason.ts';
import { folderOf, pageOf } from '../webviewPage.ts';
import type { Comparisons } from './comparisons.ts';

/** The protocol's code for an answer about a text that has moved on. */
const CONTENT_MODIFIED = -32801;

function theme(): 'light' | 'dark' {
    const { kind } = vscode.window.activeColorTheme;
    return kind === vscode.ColorThemeKind.Light || kind === vscode.ColorThemeKind.HighContrastLight ? 'light' : 'dark';
}

/** Shows a line in the editor that shows the text already, or next to the comparison. */
async function reveal(document: vscode.TextDocument, line: number): Promise<void> {
    const shown = vscode.window.visibleTextEditors.find((editor) => editor.document === document);
    const selection = document.validateRange(new vscode.Range(line, 0, line, 0));
    await vscode.window.showTextDocument(document, { selection, viewColumn: shown?.viewColumn ?? vscode.ViewColumn.Beside });
}

export class ComparePanels implements vscode.Disposable {
    readonly #extension: vscode.Uri;
    readonly #comparisons: Comparisons;
    readonly #panels = new Map<vscode.TextDocument, vscode.WebviewPanel>();

    constructor(extension: vscode.Uri, comparisons: Comparisons) {
        this.#extension = extension;
        this.#comparisons = comparisons;
    }

    /** Opens the comparison of a program: one of a menu, or the one that is in front. */
    async open(given?: unknown): Promise<void> {
        // The Source Control view says which of its rows, the others which file.
        const row = given as { resourceUri?: vscode.Uri } | undefined;
        const uri = given instanceof vscode.Uri ? given : row?.resourceUri;
        const editor = uri ? await vscode.window.showTextDocument(uri, { preview: false }) : vscode.window.activeTextEditor;
        const document = editor?.document;
        if (document?.languageId !== 'clad') {
            void vscode.window.showWarningMessage('Open a ladder program (.clad) to compare it with HEAD.');
            return;
        }
        const there = this.#panels.get(document);
        if (there) {
            there.reveal();
            return;
        }
        const name = document.uri.path.split('/').at(-1) ?? '';
        // A tab of its own, as any difference is: both forms have room next to each other.
        const panel = vscode.window.createWebviewPanel('ladder.compare', `${name} (HEAD)`, vscode.ViewColumn.Active, {
            enableScripts: true,
            localResourceRoots: [folderOf(this.#extension)],
        });
        this.#panels.set(document, panel);
        const send = (message: ToPage) => void panel.webview.postMessage(message);
        const show = async () => {
            try {
                const compared = await this.#comparisons.compare(document, theme());
                if (compared.version === document.version) {
                    send({ kind: 'compared', name, compared });
                }
            } catch (error) {
                // After an edit that has come meanwhile it is asked again.
                if ((error as { code?: number }).code !== CONTENT_MODIFIED) {
                    send({ kind: 'refused', message: `${name} cannot be compared with HEAD: ${reasonOf(error)}` });
                }
            }
        };
        const subscriptions = vscode.Disposable.from(
            panel.webview.onDidReceiveMessage((message: FromPage) =>
                message.kind === 'begin' ? show() : reveal(document, message.line),
            ),
            this.#comparisons.onMayDiffer((other) => {
                if (other === document && panel.visible) {
                    void show();
                }
            }),
            vscode.window.onDidChangeActiveColorTheme(() => void show()),
            vscode.workspace.onDidCloseTextDocument((closed) => {
                if (closed === document) {
                    panel.dispose();
                }
            }),
        );
        panel.onDidDispose(() => {
            this.#panels.delete(document);
            subscriptions.dispose();
        });
        panel.webview.html = pageOf(panel.webview, this.#extension, { name: 'compare', title: 'Compare with HEAD' });
    }

    dispose(): void {
        this.#panels.forEach((panel) => panel.dispose());
    }
}
