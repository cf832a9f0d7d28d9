// The view "Tags": every tag with its value; a click on a BOOL inverts it. Only what is unfolded is kept up to date.
import * as vscode from 'vscode';

import type { Tag } from './protocol.ts';
import type { Session } from './session.ts';
import type { Simulation } from './simulation.ts';
import { filtered, opened, partsOf, type TagGroup, tagGroups, tagRow, unfoldedGroup } from './tagTree.ts';

type Node = TagGroup | Tag;

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
    readonly #open = new Set<string>();
    /** What the tags that were unfolded open into. */
    readonly #parts = new Map<string, readonly Tag[]>();
    #session: Session | undefined;
    /** Which of its programs the tags are of. */
    #program = 0;
    /** Every tag of the session, as it was when it was listed. A row stays the same row from state to state. */
    #groups: readonly TagGroup[] = [];
    #all: readonly Tag[] = [];
    #wanted = '';
    /** What each row showed when it was drawn. */
    readonly #drawn = new Map<string, string>();
    #later: NodeJS.Timeout | undefined;
    #refreshed = 0;
    isVisible = false;

    readonly onDidChangeTreeData = this.#changed.event;

    constructor(simulation: Simulation) {
        this.#simulation = simulation;
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
            }
            this.#session = session;
            this.#program = program;
            this.#parts.clear();
            const tags = session ? await this.#simulation.partsOf('') : [];
            if (this.#session !== session || this.#program !== program) {
                return;
            }
            this.#all = tags;
            this.#list();
            return;
        }
        const changed = this.#shown().filter((tag) => this.#drawn.has(tag.name) && this.#drawn.get(tag.name) !== this.#text(tag));
        if (changed.length > 0) {
            this.#changed.fire(changed);
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
        this.#groups = tagGroups(filtered(this.#all, this.#wanted));
        this.#changed.fire(undefined);
        this.#simulation.look();
    }

    #now(tag: Tag): Tag {
        return this.#session?.tag(tag.name) ?? tag;
    }

    #text(tag: Tag): string {
        const now = this.#now(tag);
        return `${now.text} ${now.forced}`;
    }

    /** The tags that are unfolded. */
    #shown(): Tag[] {
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
    async #opened(tag: Tag): Promise<TagGroup> {
        if (tag.parts !== undefined && !this.#parts.has(tag.name)) {
            const session = this.#session;
            const tags = await this.#simulation.partsOf(tag.name);
            if (this.#session === session) {
                this.#parts.set(tag.name, tags);
                this.#simulation.look();
            }
        }
        return opened(tag, this.#parts.get(tag.name) ?? []);
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
        this.#drawn.set(node.name, this.#text(node));
        const { Collapsed, None } = vscode.TreeItemCollapsibleState;
        const item = new vscode.TreeItem(row.label, node.parts === undefined ? None : Collapsed);
        item.id = node.name;
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

export function showTags(simulation: Simulation): vscode.Disposable {
    const provider = new TagsProvider(simulation);
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
    return vscode.Disposable.from(
        provider,
        view,
        vscode.commands.registerCommand('ladder.tags.filter', filter),
        view.onDidChangeVisibility(appear),
        view.onDidExpandElement(({ element }) => provider.fold(element, true)),
        view.onDidCollapseElement(({ element }) => provider.fold(element, false)),
        simulation.onDidChange(() => provider.refresh()),
    );
}
