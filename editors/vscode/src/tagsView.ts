// The view "Tags": every tag with its value; a click on a BOOL inverts it. Only what is unfolded is kept up to date.
import * as vscode from 'vscode';

import type { Tag } from '../../../panels/protocol.ts';
import { filtered, opened, partsOf, type Row, rowId, type TagGroup, tagGroups, tagRow, unfoldedGroup, watchedGroup, watchedRows } from '../../../panels/tagTree.ts';
import type { Session } from './session.ts';
import type { Simulation } from './simulation.ts';
import type { WatchList } from './watchList.ts';

type Node = TagGroup | Row;

/**
 * In milliseconds. The editor waits until a view has been quiet for 200 before it draws it again: one that changes more
 * often would be still.
 */
const REFRESH_EVERY = 300;

function isGroup(node: Node): node is TagGroup {
    return 'tags' in node;
}

class TagsProvider implements vscode.TreeDataProvider<Node>, vscode.Disposable {
    readonly #changed = new vscode.EventEmitter<Node[] | undefined>();
    readonly #simulation: Simulation;
    readonly #watchList: WatchList;
    readonly #open = new Set<string>();
    /** What the tags that were unfolded open into. */
    readonly #parts = new Map<string, readonly Row[]>();
    #session: Session | undefined;
    /** Which of its programs the tags are of. */
    #program = 0;
    /** Every tag of the session, as it was when it was listed. A row stays the same row from state to state. */
    #groups: readonly TagGroup[] = [];
    #all: readonly Tag[] = [];
    #watched: readonly Row[] = [];
    #wanted = '';
    /** What each row showed when it was drawn. */
    readonly #drawn = new Map<string, string>();
    #later: NodeJS.Timeout | undefined;
    #refreshed = 0;
    isVisible = false;

    readonly onDidChangeTreeData = this.#changed.event;

    constructor(simulation: Simulation, watchList: WatchList) {
        this.#simulation = simulation;
        this.#watchList = watchList;
    }

    /** Draws again what has changed: at once, but no more often than the editor can. */
    refresh(): void {
        if (this.#later !== undefined || !this.isVisible) {
            return;
        }
        const wait = Math.max(REFRESH_EVERY - (Date.now() - this.#refreshed), 0);
        this.#later = setTimeout(() => {
            this.#later = undefined;
            this.#refreshed = Date.now();
            void this.#draw();
        }, wait);
    }

    async #draw(): Promise<void> {
        const session = this.#simulation.current;
        const program = session?.state.program ?? 0;
        if (session !== this.#session || program !== this.#program) {
            if (session !== this.#session) {
                this.#drawn.clear();
                this.#open.clear();
                this.#groups = [];
                this.#all = [];
                this.#watched = [];
            }
            this.#session = session;
            this.#program = program;
            this.#parts.clear();
            const tags = session ? await this.#simulation.partsOf('') : [];
            if (this.#session !== session || this.#program !== program) {
                return;
            }
            this.#all = tags;
            await this.watchedAgain();
            return;
        }
        const changed = this.#shown().filter((row) => this.#drawn.has(rowId(row)) && this.#drawn.get(rowId(row)) !== this.#text(row));
        if (changed.length > 0) {
            this.#changed.fire(changed);
        }
    }

    /** Lists the tags again, with those that are watched now. */
    async watchedAgain(): Promise<void> {
        const session = this.#session;
        const names = session ? this.#watchList.of(session.document.uri) : [];
        const tags = await this.#simulation.named(names);
        if (this.#session === session) {
            this.#watched = watchedRows(tags);
            this.#list();
        }
    }

    get wanted(): string {
        return this.#wanted;
    }

    /** Leaves only the tags that are looked for. */
    filter(wanted: string): void {
        this.#wanted = wanted;
        this.#list();
    }

    #list(): void {
        this.#groups = [...watchedGroup(this.#watched), ...tagGroups(filtered(this.#all, this.#wanted))];
        this.#changed.fire(undefined);
        this.#simulation.look();
    }

    #now(row: Row): Row {
        const now = this.#session?.tag(row.name);
        return now ? { ...row, ...now } : row;
    }

    #text(row: Row): string {
        const now = this.#now(row);
        return `${now.text} ${now.forced}`;
    }

    /** The tags that are unfolded. */
    #shown(): Row[] {
        const isOpen = (id: string) => this.#open.has(id);
        return this.#groups.filter(({ id }) => isOpen(id)).flatMap((group) => unfoldedGroup(group, isOpen, this.#parts));
    }

    shownNames(): readonly string[] {
        return this.isVisible && this.#session === this.#simulation.current ? this.#shown().map(({ name }) => name) : [];
    }

    fold(node: Node, open: boolean): void {
        const { id } = isGroup(node) ? node : opened(node, []);
        if (open) {
            this.#open.add(id);
        } else {
            this.#open.delete(id);
        }
        this.#simulation.look();
    }

    async getChildren(node?: Node): Promise<Node[]> {
        if (!node) {
            return [...this.#groups];
        }
        const group = isGroup(node) ? node : await this.#opened(node);
        const parts = partsOf(group);
        return parts.length > 0 ? parts : [...group.tags];
    }

    /** What a tag opens into, asked for when it is unfolded for the first time. */
    async #opened(row: Row): Promise<TagGroup> {
        if (row.parts !== undefined && !this.#parts.has(rowId(row))) {
            const session = this.#session;
            const tags = await this.#simulation.partsOf(row.name);
            if (this.#session === session) {
                this.#parts.set(rowId(row), row.watched ? watchedRows(tags) : tags);
                this.#simulation.look();
            }
        }
        return opened(row, this.#parts.get(rowId(row)) ?? []);
    }

    getTreeItem(node: Node): vscode.TreeItem {
        if (isGroup(node)) {
            // The editor does not say so of what begins unfolded.
            const { Expanded, Collapsed } = vscode.TreeItemCollapsibleState;
            if (node.open && !this.#drawn.has(`group ${node.id}`)) {
                this.#drawn.set(`group ${node.id}`, '');
                this.#open.add(node.id);
            }
            const item = new vscode.TreeItem(node.title, node.open ? Expanded : Collapsed);
            item.id = `group ${node.id}`;
            item.contextValue = 'group';
            return item;
        }
        const row = tagRow(this.#now(node));
        this.#drawn.set(rowId(node), this.#text(node));
        const { Collapsed, None } = vscode.TreeItemCollapsibleState;
        const item = new vscode.TreeItem(row.label, node.parts === undefined ? None : Collapsed);
        item.id = rowId(node);
        item.description = row.description;
        item.tooltip = row.tooltip;
        item.iconPath = new vscode.ThemeIcon(row.icon);
        item.contextValue = row.context;
        if (row.toggles) {
            item.command = { command: 'ladder.simulation.toggle', title: 'Toggle', arguments: [node] };
        }
        return item;
    }

    dispose(): void {
        clearTimeout(this.#later);
        this.#changed.dispose();
    }
}

export function showTags(simulation: Simulation, watchList: WatchList): vscode.Disposable {
    const provider = new TagsProvider(simulation, watchList);
    const view = vscode.window.createTreeView('ladder.tags', { treeDataProvider: provider });
    simulation.listTags(() => provider.shownNames());
    const appear = () => {
        provider.isVisible = view.visible;
        provider.refresh();
        simulation.look();
    };
    appear();
    const filter = async () => {
        const placeHolder = 'Part of a name or type; nothing shows all tags';
        const wanted = await vscode.window.showInputBox({ title: 'Filter the Tags', value: provider.wanted, placeHolder });
        if (wanted !== undefined) {
            provider.filter(wanted);
            view.description = wanted;
        }
    };
    /** Of a row in the view, or of the operand at the cursor. */
    const watch = async (isWanted: boolean, row?: Row) => {
        const session = simulation.current;
        const name = row?.name ?? simulation.operandHere()?.tags[0];
        if (session && name !== undefined) {
            await watchList.set(session.document.uri, name, isWanted);
            await provider.watchedAgain();
        }
    };
    return vscode.Disposable.from(
        provider,
        view,
        vscode.commands.registerCommand('ladder.tags.filter', filter),
        vscode.commands.registerCommand('ladder.tags.watch', (row?: Row) => watch(true, row)),
        vscode.commands.registerCommand('ladder.tags.unwatch', (row?: Row) => watch(false, row)),
        view.onDidChangeVisibility(appear),
        view.onDidExpandElement(({ element }) => provider.fold(element, true)),
        view.onDidCollapseElement(({ element }) => provider.fold(element, false)),
        simulation.onDidChange(() => provider.refresh()),
    );
}
