// The view "Tags": every tag with its value; a click on an input inverts it.
import * as vscode from 'vscode';

import type { State, Tag } from './protocol.ts';
import type { Simulation } from './simulation.ts';
import { changedTags, type TagGroup, tagGroups, tagRow } from './tagTree.ts';

type Node = TagGroup | Tag;

function isGroup(node: Node): node is TagGroup {
    return 'tags' in node;
}

class TagsProvider implements vscode.TreeDataProvider<Node> {
    readonly #changed = new vscode.EventEmitter<Node[] | undefined>();
    readonly #simulation: Simulation;
    /** By name, so that a row stays the same row from state to state. */
    #nodes = new Map<string, Tag>();
    #shown: State | undefined;

    readonly onDidChangeTreeData = this.#changed.event;

    constructor(simulation: Simulation) {
        this.#simulation = simulation;
    }

    refresh(): void {
        const state = this.#simulation.current?.state;
        const before = this.#shown;
        this.#shown = state;
        const changed = before && state && before.session === state.session ? changedTags(before.tags, state.tags) : undefined;
        if (!changed) {
            this.#nodes.clear();
            this.#changed.fire(undefined);
        } else if (changed.length > 0) {
            this.#changed.fire(changed.flatMap(({ name }) => this.#nodes.get(name) ?? []));
        }
    }

    getChildren(node?: Node): Node[] {
        if (!node) {
            return this.#shown ? tagGroups(this.#shown) : [];
        }
        if (!isGroup(node)) {
            return [];
        }
        return node.tags.map((tag) => {
            const known = this.#nodes.get(tag.name) ?? tag;
            this.#nodes.set(tag.name, known);
            return known;
        });
    }

    getTreeItem(node: Node): vscode.TreeItem {
        if (isGroup(node)) {
            const item = new vscode.TreeItem(node.title, vscode.TreeItemCollapsibleState.Expanded);
            item.id = `group ${node.role}`;
            return item;
        }
        const tag = this.#shown?.tags.find(({ name }) => name === node.name) ?? node;
        const row = tagRow(tag);
        const item = new vscode.TreeItem(row.label);
        item.id = tag.name;
        item.description = row.description;
        item.tooltip = row.tooltip;
        item.iconPath = new vscode.ThemeIcon(row.icon);
        item.contextValue = row.context;
        if (row.toggles) {
            item.command = { command: 'ladder.simulation.toggle', title: 'Toggle', arguments: [tag] };
        }
        return item;
    }
}

export function showTags(simulation: Simulation): vscode.Disposable {
    const provider = new TagsProvider(simulation);
    return vscode.Disposable.from(
        vscode.window.createTreeView('ladder.tags', { treeDataProvider: provider }),
        simulation.onDidChange(() => provider.refresh()),
    );
}
