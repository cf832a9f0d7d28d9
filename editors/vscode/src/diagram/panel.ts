// One diagram of a program: draws what its page shows, tells it what runs, and does what a person asks there.
import * as vscode from 'vscode';

import { answer, type Side } from '../../../../panels/diagram/answer.ts';
import { answerOf } from '../../../../panels/diagram/draw/asker.ts';
import type { Edited } from '../../../../panels/diagram/draw/requests.ts';
import type { FromPage, Names, Place, ToPage } from '../../../../panels/diagram/messages.ts';
import { Teller } from '../../../../panels/diagram/teller.ts';
import { withTheRest } from '../../../../panels/pace.ts';
import type { Server } from '../server.ts';
import { findingsOf, fix, fixesAt } from './findings.ts';
import type { Simulation } from '../simulation.ts';

/** The place of the cursor is not sent more often. In milliseconds. */
const CURSOR_EVERY = 50;

export class DiagramPanel implements vscode.Disposable {
    readonly document: vscode.TextDocument;
    readonly #panel: vscode.WebviewPanel;
    readonly #simulation: Simulation;
    readonly #teller: Teller;
    readonly #subscriptions: vscode.Disposable;
    #isReady = false;
    #later: NodeJS.Timeout | undefined;
    /** What the page itself has shown in the text: the cursor is there because of that. */
    #revealed: vscode.Range | undefined;

    constructor(document: vscode.TextDocument, panel: vscode.WebviewPanel, server: Server, simulation: Simulation) {
        this.document = document;
        this.#panel = panel;
        this.#simulation = simulation;
        const side: Side = {
            send: (message) => this.#send(message),
            begin: () => {
                this.#isReady = true;
                this.#open();
            },
            version: () => document.version,
            draw: ({ lines, rail, known }) => server.execute('ladder.diagram', { uri: document.uri.toString(), lines, rail, known }),
            look: () => simulation.look(),
            reveal: (from, to, focus, isQuiet) => this.reveal(from, to, focus, isQuiet),
            request: (question) =>
                answerOf(question, document.uri.toString(), {
                    execute: (command, argument) => server.execute(command, argument),
                    make: (edited) => this.#make(edited),
                    fixes: async (range) => (await fixesAt(document, range)).map(({ title }) => title),
                    fix: (range, title) => fix(document, range, title),
                }),
            // The editor itself acts on these keys, also in a page.
            history: async (step, isKey) => {
                await (!isKey && vscode.commands.executeCommand<void>(step));
            },
            command: async (name) => vscode.commands.executeCommand<void>(`ladder.simulation.${name}`),
            why: async (name) => vscode.commands.executeCommand<void>('ladder.simulation.why', { name }),
            toggle: async (tag) => {
                const known = simulation.current?.tag(tag);
                await (known && simulation.toggle(known));
            },
            change: (name, argument) => simulation.command(name, argument),
        };
        this.#teller = new Teller((message) => this.#send(message), () => simulation.of(document), () => panel.visible);
        this.#subscriptions = vscode.Disposable.from(
            panel.webview.onDidReceiveMessage((message: FromPage) => {
                if (message.type === 'command' || 'tag' in message) {
                    simulation.lookAt(document);
                }
                void answer(message, this.#teller, side);
            }),
            panel.onDidChangeViewState(() => this.#appear()),
            vscode.workspace.onDidChangeTextDocument((event) => this.#edited(event)),
            vscode.window.onDidChangeTextEditorSelection((event) => this.#cursor(event)),
            simulation.onDidChange((changed) => {
                if (changed === document) {
                    withTheRest(() => this.#teller.tell());
                }
            }),
            simulation.alsoShows((other) => (other === document && this.#panel.visible ? this.#teller.lines : undefined)),
            vscode.languages.onDidChangeDiagnostics(({ uris }) => {
                if (uris.some((uri) => uri.toString() === document.uri.toString())) {
                    this.#report();
                }
            }),
            server.onDidStart(() => this.#open()),
            this.#teller,
            new vscode.Disposable(() => clearTimeout(this.#later)),
        );
        this.#appear();
    }

    dispose(): void {
        this.#isReady = false;
        this.#subscriptions.dispose();
        this.#simulation.look();
    }

    #send(message: ToPage): void {
        void this.#panel.webview.postMessage(message);
    }

    /** Commands are about the diagram that one looks at. */
    #appear(): void {
        if (this.#panel.active) {
            this.#simulation.lookAt(this.document);
        }
        this.#simulation.look();
    }

    #open(): void {
        if (!this.#isReady) {
            return;
        }
        const { document } = this;
        const editor = vscode.window.visibleTextEditors.find((editor) => editor.document === document);
        const line = editor?.visibleRanges[0]?.start.line ?? 0;
        const name = document.uri.path.split('/').at(-1) ?? '';
        const names = vscode.workspace.getConfiguration('ladder.diagram', document.uri).get<Names>('names', 'iec');
        this.#send({ type: 'open', name, version: document.version, lineCount: document.lineCount, line, names });
        this.#teller.begin();
        this.#report();
    }

    #report(): void {
        if (this.#isReady) {
            this.#send({ type: 'findings', version: this.document.version, findings: findingsOf(this.document) });
        }
    }

    #edited({ document, contentChanges }: vscode.TextDocumentChangeEvent): void {
        if (document !== this.document || contentChanges.length === 0) {
            return;
        }
        const changes = contentChanges.map(({ range, text }) => ({
            first: range.start.line,
            last: range.end.line,
            count: text.split(/\r\n|\r|\n/).length,
        }));
        // The editor lists them from the end of the text to its start, so that none moves another.
        this.#send({ type: 'edited', version: document.version, lineCount: document.lineCount, changes });
    }

    #cursor({ textEditor, selections }: vscode.TextEditorSelectionChangeEvent): void {
        const [selection] = selections;
        if (textEditor.document !== this.document || !selection) {
            return;
        }
        const revealed = this.#revealed;
        this.#revealed = undefined;
        if (revealed && selection.isEqual(revealed)) {
            return;
        }
        clearTimeout(this.#later);
        const { line, character } = selection.active;
        this.#later = setTimeout(() => this.#send({ type: 'cursor', place: { line, character } }), CURSOR_EVERY);
    }

    /** Makes the edits of a change of the drawing. */
    async #make({ version, edits, also = [] }: Edited): Promise<number> {
        const { document } = this;
        if (document.version !== version) {
            throw new Error('The text has changed meanwhile: try again');
        }
        const change = new vscode.WorkspaceEdit();
        for (const { uri, edits: own } of [{ uri: document.uri.toString(), edits }, ...also]) {
            for (const { range: { start, end }, newText } of own) {
                change.replace(vscode.Uri.parse(uri), new vscode.Range(start.line, start.character, end.line, end.character), newText);
            }
        }
        if (!(await vscode.workspace.applyEdit(change))) {
            throw new Error('The text cannot be changed: it may be read-only');
        }
        return document.version;
    }

    /** Shows a place in the text, in the editor that shows it already if there is one. */
    async reveal(from: Place, to: Place, focus: boolean, isQuiet = false): Promise<void> {
        const { document } = this;
        const selection = document.validateRange(new vscode.Range(from.line, from.character, to.line, to.character));
        const shown = vscode.window.visibleTextEditors.find((editor) => editor.document === document);
        if (isQuiet && !shown) {
            return;
        }
        this.#revealed = selection;
        const viewColumn = shown?.viewColumn ?? (this.#panel.viewColumn === vscode.ViewColumn.One ? vscode.ViewColumn.Beside : vscode.ViewColumn.One);
        if (shown && !focus) {
            shown.selection = new vscode.Selection(selection.start, selection.end);
            shown.revealRange(selection, vscode.TextEditorRevealType.InCenterIfOutsideViewport);
            return;
        }
        await vscode.window.showTextDocument(document, { viewColumn, selection, preserveFocus: !focus });
    }
}
