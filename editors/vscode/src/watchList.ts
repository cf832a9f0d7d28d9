// The tags of each program that a person watches, kept with the workspace.
import type * as vscode from 'vscode';

export class WatchList {
    readonly #kept: vscode.Memento;

    constructor(kept: vscode.Memento) {
        this.#kept = kept;
    }

    /** The names of a program, in the order in which they were added. */
    of(program: vscode.Uri): readonly string[] {
        return this.#kept.get<readonly string[]>(keyOf(program), []);
    }

    /** Adds a tag at the end, or takes it away. */
    async set(program: vscode.Uri, tag: string, isWanted: boolean): Promise<void> {
        const others = this.of(program).filter((name) => name !== tag);
        await this.#kept.update(keyOf(program), isWanted ? [...others, tag] : others);
    }
}

function keyOf(program: vscode.Uri): string {
    return `ladder.watched ${program.toString()}`;
}
