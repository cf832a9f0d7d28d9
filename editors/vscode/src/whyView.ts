// The view "Why": the reasons for a tag's value as a tree. A click leads to the place in the text, where the blocks that
// stop power are marked.
import * as vscode from 'vscode';

import { stillStopping, stoppingBlocks, type WhyRow, whyRow } from '../../../panels/whyTree.ts';
import type { Session } from './session.ts';
import { type Simulation, toRange } from './simulation.ts';

export class WhyView implements vscode.Disposable, vscode.TreeDataProvider<WhyRow> {
    readonly #simulation: Simulation;
    readonly #changed = new vscode.EventEmitter<undefined>();
    readonly #view: vscode.TreeView<WhyRow>;
    readonly #subscriptions: vscode.Disposable;
    readonly #stops = vscode.window.createTextEditorDecorationType({
        border: '1px dashed',
        borderColor: new vscode.ThemeColor('ladder.blocks'),
        overviewRulerColor: new vscode.ThemeColor('ladder.blocks'),
        rangeBehavior: vscode.DecorationRangeBehavior.ClosedClosed,
    });
    #root: WhyRow | undefined;
    #session: Session | undefined;
    /** The blocks that are marked. */
    #stopping: ReturnType<typeof stoppingBlocks> = [];
    readonly #parents = new Map<WhyRow, WhyRow>();

    readonly onDidChangeTreeData = this.#changed.event;

    constructor(simulation: Simulation) {
        this.#simulation = simulation;
        this.#view = vscode.window.createTreeView('ladder.why', { treeDataProvider: this });
        this.#subscriptions = vscode.Disposable.from(
            this.#view,
            this.#changed,
            this.#stops,
            // Reasons are those of the session, at the places of its text.
            simulation.onDidChange(() => {
                if (this.#session && (this.#simulation.current !== this.#session || this.#session.stale)) {
                    this.#show(undefined, undefined);
                } else if (this.#session && this.#stopping.length > 0) {
                    this.#follow(this.#session);
                }
            }),
            vscode.window.onDidChangeVisibleTextEditors(() => this.#mark()),
        );
    }

    /** Asks why a tag holds what it holds, and shows it. */
    async ask(tag: string): Promise<void> {
        const session = this.#simulation.current;
        const why = await this.#simulation.why(tag);
        if (session && why) {
            this.#show(session, whyRow(why.reason));
            await vscode.commands.executeCommand('ladder.why.focus', { preserveFocus: true });
            if (this.#root) {
                await this.#view.reveal(this.#root, { select: true, focus: true, expand: 2 });
            }
        }
    }

    /** Shows where a reason is. */
    async open(row: WhyRow): Promise<void> {
        if (row.range && this.#session) {
            const uri = row.uri === undefined ? this.#session.document.uri : vscode.Uri.parse(row.uri);
            await vscode.window.showTextDocument(uri, { selection: toRange(row.range), preserveFocus: true });
        }
    }

    #show(session: Session | undefined, root: WhyRow | undefined): void {
        this.#session = session;
        this.#root = root;
        this.#stopping = root ? stoppingBlocks(root) : [];
        this.#parents.clear();
        this.#changed.fire(undefined);
        this.#mark();
    }

    /** What lets power through by now is not marked any more. */
    #follow(session: Session): void {
        const still = stillStopping(this.#stopping, ({ start }) => session.power.get(start.line)?.get(start.character));
        if (still.length < this.#stopping.length) {
            this.#stopping = still;
            this.#mark();
        }
    }

    #mark(): void {
        const ranges = this.#stopping.map(toRange);
        for (const editor of vscode.window.visibleTextEditors) {
            editor.setDecorations(this.#stops, editor.document === this.#session?.document ? ranges : []);
        }
    }

    getParent(row: WhyRow): WhyRow | undefined {
        return this.#parents.get(row);
    }

    getChildren(row?: WhyRow): WhyRow[] {
        const children = row ? [...row.children] : this.#root ? [this.#root] : [];
        if (row) {
            for (const child of children) {
                this.#parents.set(child, row);
            }
        }
        return children;
    }

    getTreeItem(row: WhyRow): vscode.TreeItem {
        const { None, Expanded } = vscode.TreeItemCollapsibleState;
        const item = new vscode.TreeItem(row.label, row.children.length > 0 ? Expanded : None);
        item.tooltip = row.tooltip;
        item.iconPath = new vscode.ThemeIcon(row.icon);
        item.accessibilityInformation = { label: `${row.label}. ${row.tooltip}` };
        if (row.range) {
            item.command = { command: 'ladder.simulation.why.open', title: 'Show in the Program', arguments: [row] };
        }
        return item;
    }

    dispose(): void {
        this.#subscriptions.dispose();
    }
}
