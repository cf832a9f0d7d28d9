// The text of a program at HEAD, from the editor's own git extension: nothing else is run.
import * as vscode from 'vscode';

/** What is used of `vscode.git`, version 1 of its interface. */
interface Repository {
    readonly state: { readonly HEAD?: { readonly commit?: string }; readonly onDidChange: vscode.Event<void> };
    show(ref: string, path: string): Promise<string>;
}

interface Git {
    readonly onDidOpenRepository: vscode.Event<Repository>;
    readonly repositories: readonly Repository[];
    getRepository(uri: vscode.Uri): Repository | null;
}

interface GitExtension {
    readonly enabled: boolean;
    getAPI(version: 1): Git;
}

/** Why a program cannot be compared, for the person. */
export class NoBase extends Error {}

interface Known {
    readonly commit: string | undefined;
    readonly text: Promise<string>;
}

export class Head implements vscode.Disposable {
    readonly #moved = new vscode.EventEmitter<void>();
    readonly #texts = new Map<string, Known>();
    readonly #subscriptions: vscode.Disposable[] = [this.#moved];
    #git: Promise<Git> | undefined;

    /** A repository may be at another commit. */
    readonly onDidMove = this.#moved.event;

    async #open(): Promise<Git> {
        const extension = vscode.extensions.getExtension<GitExtension>('vscode.git');
        const found = await extension?.activate();
        if (!found?.enabled) {
            throw new NoBase('the git extension of the editor is switched off.');
        }
        const git = found.getAPI(1);
        const follow = (repository: Repository) => {
            let at = repository.state.HEAD?.commit;
            this.#subscriptions.push(
                repository.state.onDidChange(() => {
                    if (repository.state.HEAD?.commit !== at) {
                        at = repository.state.HEAD?.commit;
                        this.#moved.fire();
                    }
                }),
            );
        };
        git.repositories.forEach(follow);
        this.#subscriptions.push(
            git.onDidOpenRepository((repository) => {
                follow(repository);
                this.#moved.fire();
            }),
        );
        return git;
    }

    /**
     * The text of a file as the last commit has it.
     *
     * @throws NoBase if there is none
     */
    async text({ uri }: vscode.TextDocument): Promise<string> {
        if (!vscode.workspace.isTrusted) {
            throw new NoBase('nothing is run in a workspace that is not trusted.');
        }
        this.#git ??= this.#open();
        const repository = uri.scheme === 'file' ? (await this.#git).getRepository(uri) : null;
        const commit = repository?.state.HEAD?.commit;
        if (!repository || commit === undefined) {
            throw new NoBase('the file is in no git repository that has a commit.');
        }
        const known = this.#texts.get(uri.toString());
        if (known?.commit === commit) {
            return known.text;
        }
        const text = repository.show('HEAD', uri.fsPath).catch(() => {
            throw new NoBase('the last commit does not have the file.');
        });
        this.#texts.set(uri.toString(), { commit, text });
        return text;
    }

    dispose(): void {
        vscode.Disposable.from(...this.#subscriptions).dispose();
    }
}
