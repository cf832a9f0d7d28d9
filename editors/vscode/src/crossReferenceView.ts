// The view "Cross-Reference": every tag of the program that is shown, and where it is read, written, set and reset.
import * as vscode from 'vscode';

import { type CrossReferenced, type ReferenceRow, referenceRows } from '../../../panels/crossReference.ts';
import type { Server } from './server.ts';
import { toRange } from './simulation.ts';

/** Typing is over, in milliseconds. */
const REST = 500;

export class CrossReferenceView implements vscode.Disposable, vscode.TreeDataProvider<ReferenceRow> {
    readonly #server: Server;
    readonly #changed = new vscode.EventEmitter<undefined>();
    readonly #view: vscode.TreeView<ReferenceRow>;
    readonly #subscriptions: vscode.Disposable;
    #document: vscode.TextDocument | undefined;
    #answer: CrossReferenced | undefined;
    #wanted = '';
    #waits: NodeJS.Timeout | undefined;

    readonly onDidChangeTreeData = this.#changed.event;

    constructor(server: Server) {
        this.#server = server;
        this.#view = vscode.window.createTreeView('ladder.crossReference', { treeDataProvider: this, showCollapseAll: true });
        this.#subscriptions = vscode.Disposable.from(
            this.#view,
            this.#changed,
            // A row of the view has it, the palette does not.
            vscode.commands.registerCommand('ladder.crossReference.open', (row: ReferenceRow) => this.open(row)),
            this.#view.onDidChangeVisibility(() => void this.#ask()),
            vscode.window.onDidChangeActiveTextEditor((editor) => this.#look(editor)),
            vscode.workspace.onDidChangeTextDocument(({ document }) => {
                if (document === this.#document) {
                    clearTimeout(this.#waits);
                    this.#waits = setTimeout(() => void this.#ask(), REST);
                }
            }),
            server.onDidStart(() => void this.#ask()),
        );
        this.#look(vscode.window.activeTextEditor);
    }

    async show(): Promise<void> {
        await vscode.commands.executeCommand('ladder.crossReference.focus');
        await this.#ask();
    }

    /** Leaves only the tags that a person looks for. */
    async filter(): Promise<void> {
        const placeHolder = 'Part of a name, an address or a comment; nothing shows all tags';
        const wanted = await vscode.window.showInputBox({ title: 'Filter the Cross-Reference', value: this.#wanted, placeHolder });
        if (wanted !== undefined) {
            this.#wanted = wanted;
            this.#show();
        }
    }

    /** Where a row is. */
    async open({ range }: ReferenceRow): Promise<void> {
        if (this.#document) {
            await vscode.window.showTextDocument(this.#document, { selection: toRange(range), preserveFocus: true });
        }
    }

    #look(editor: vscode.TextEditor | undefined): void {
        if (editor?.document.languageId === 'clad') {
            this.#document = editor.document;
            void this.#ask();
        }
    }

    async #ask(): Promise<void> {
        const document = this.#document;
        if (!document || !this.#view.visible) {
            return;
        }
        const uri = document.uri.toString();
        const answer = await this.#server.execute('ladder.crossReference', { uri }).catch(() => undefined);
        if (this.#document === document) {
            this.#answer = answer;
            this.#show();
        }
    }

    #show(): void {
        this.#view.description = this.#wanted;
        this.#changed.fire(undefined);
    }

    getChildren(row?: ReferenceRow): ReferenceRow[] {
        if (row) {
            return [...row.children];
        }
        return this.#answer ? referenceRows(this.#answer, this.#wanted) : [];
    }

    getTreeItem(row: ReferenceRow): vscode.TreeItem {
        const { None, Collapsed } = vscode.TreeItemCollapsibleState;
        const item = new vscode.TreeItem(row.label, row.children.length > 0 ? Collapsed : None);
        item.description = row.description;
        item.tooltip = `${row.label}: ${row.description}`;
        item.iconPath = new vscode.ThemeIcon(row.icon);
        item.command = { command: 'ladder.crossReference.open', title: 'Show in the Program', arguments: [row] };
        return item;
    }

    dispose(): void {
        clearTimeout(this.#waits);
        this.#subscriptions.dispose();
    }
}
