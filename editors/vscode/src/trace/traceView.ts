// The view "Trace": chosen tags over time, drawn by the page in `webview/trace`, which asks for what it shows.
import { randomBytes } from 'node:crypto';

import * as vscode from 'vscode';

import { answer, type Side, tell } from '../../../../panels/trace/answer.ts';
import { added, atFirst, MOST, picked } from '../../../../panels/trace/chosenTags.ts';
import type { FromPage } from '../../../../panels/trace/messages.ts';
import { page } from '../../../../panels/trace/page.ts';
import type { Session } from '../session.ts';
import type { Simulation } from '../simulation.ts';

export class TraceView implements vscode.WebviewViewProvider, vscode.Disposable {
    readonly #simulation: Simulation;
    readonly #context: vscode.ExtensionContext;
    readonly #side: Side;
    readonly #subscriptions: vscode.Disposable;
    #view: vscode.WebviewView | undefined;
    /** The tags of programs for which none were chosen. */
    readonly #atFirst = new WeakMap<Session, readonly string[]>();

    constructor(simulation: Simulation, context: vscode.ExtensionContext) {
        this.#simulation = simulation;
        this.#context = context;
        this.#side = {
            send: (message) => void this.#view?.webview.postMessage(message),
            isSeen: () => this.#view?.visible === true,
            session: () => simulation.current,
            tags: (session: Session) => this.#tags(session),
            choose: (session: Session, tags) => this.#choose(session, tags),
            pick: () => this.pick(),
            goTo: (scan) => simulation.command('goTo', { scan }),
            run: () => simulation.run(),
            pause: () => simulation.pause(),
        };
        this.#subscriptions = vscode.Disposable.from(
            vscode.window.registerWebviewViewProvider('ladder.trace', this),
            simulation.onDidChange(() => tell(this.#side)),
        );
    }

    resolveWebviewView(view: vscode.WebviewView): void {
        this.#view = view;
        const { webview } = view;
        const folder = vscode.Uri.joinPath(this.#context.extensionUri, 'dist', 'webview');
        webview.options = { enableScripts: true, localResourceRoots: [folder] };
        const served = (name: string) => webview.asWebviewUri(vscode.Uri.joinPath(folder, name)).toString();
        const subscriptions = vscode.Disposable.from(
            webview.onDidReceiveMessage((message: FromPage) => answer(message, this.#side)),
            view.onDidChangeVisibility(() => tell(this.#side)),
            view.onDidDispose(() => {
                this.#view = undefined;
                subscriptions.dispose();
            }),
        );
        const nonce = randomBytes(16).toString('base64');
        webview.html = page({
            script: served('trace.js'),
            style: served('trace.style.css'),
            styles: webview.cspSource,
            scripts: `'nonce-${nonce}'`,
            nonce,
        });
    }

    /** Shows a tag in the trace as well, and the trace. */
    async add(tag: string): Promise<void> {
        const session = this.#simulation.current;
        if (session) {
            this.#choose(session, added(await this.#tags(session), tag));
            await this.show();
        }
    }

    async show(): Promise<void> {
        await vscode.commands.executeCommand('ladder.trace.focus', { preserveFocus: true });
    }

    /** Asks which tags are to be shown. */
    async pick(): Promise<void> {
        const session = this.#simulation.current;
        if (!session) {
            return;
        }
        const before = await this.#tags(session);
        const names = new Set(before.map((name) => name.toLowerCase()));
        const items = (await this.#simulation.allTags()).map((tag) => ({
            label: tag.name,
            description: `${tag.text}  ${tag.type}, ${tag.role}`,
            picked: names.has(tag.name.toLowerCase()),
        }));
        const chosen = await vscode.window.showQuickPick(items, {
            title: 'Tags of the Trace',
            placeHolder: `Up to ${MOST} tags`,
            canPickMany: true,
            matchOnDescription: true,
        });
        if (chosen) {
            this.#choose(session, picked(before, chosen.map(({ label }) => label)));
        }
    }

    #key(session: Session): string {
        return `ladder.trace ${session.document.uri.toString()}`;
    }

    async #tags(session: Session): Promise<readonly string[]> {
        const chosen = this.#context.workspaceState.get<readonly string[]>(this.#key(session));
        if (chosen) {
            return chosen;
        }
        const known = this.#atFirst.get(session) ?? atFirst(await this.#simulation.allTags());
        this.#atFirst.set(session, known);
        return known;
    }

    #choose(session: Session, tags: readonly string[]): void {
        if (tags.length > MOST) {
            void vscode.window.showWarningMessage(`Ladder: a trace shows up to ${MOST} tags; the first of them are kept.`);
        }
        void this.#context.workspaceState.update(this.#key(session), tags.slice(0, MOST)).then(() => tell(this.#side));
    }

    dispose(): void {
        this.#subscriptions.dispose();
    }
}
