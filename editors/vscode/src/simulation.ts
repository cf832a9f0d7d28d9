// The simulations that are open, at most one a document, and the commands about them.
import * as vscode from 'vscode';

import type { Lines } from '../../../panels/diagram/messages.ts';
import { operandAt } from '../../../panels/operands.ts';
import { withTheRest } from '../../../panels/pace.ts';
import type { Commands, Operand, Recorded, Shown, State, Tag, Why } from '../../../panels/protocol.ts';
import { reasonOf } from '../../../panels/reason.ts';
import { runsItself } from './foreignProgram.ts';
import type { Server } from './server.ts';
import { breakpointLines, toggled } from './breakpoints.ts';
import { Session } from './session.ts';

/** So many lines above and below an editor's part of the text are kept ready for scrolling. */
const MARGIN = 5;

/** An editor that keeps up takes a state in less, in milliseconds. */
const FRAME = 33;
/** In milliseconds. */
const LONGEST_REST = 250;
/** So many states are kept of sessions that are only just starting: the server sends each of them one, and waits. */
const MOST_EARLY = 4;

/** So many of the ways in which a controller differs are told in one message; the status bar has all. */
const MOST_TOLD = 3;

export class Simulation implements vscode.Disposable {
    readonly #sessions = new Map<string, Session>();
    readonly #context = new Map<string, boolean>();
    /** States of sessions that are not known here, the last of them. */
    #early: readonly State[] = [];
    readonly #shownElsewhere = new Set<(document: vscode.TextDocument) => Lines | undefined>();
    readonly #server: Server;
    readonly #changed = new vscode.EventEmitter<vscode.TextDocument>();
    readonly #subscriptions: vscode.Disposable;
    /** Tags that a view shows besides. */
    #listedTags: () => readonly string[] = () => [];
    /** The document that commands are about while another kind of editor, or a view, has the focus. */
    #lastDocument: vscode.TextDocument | undefined;

    /** After each change of a document's session: a new state, an edit, its end. */
    readonly onDidChange = this.#changed.event;

    constructor(server: Server) {
        this.#server = server;
        this.#subscriptions = vscode.Disposable.from(
            this.#changed,
            server.onDidReceiveState((state) => this.#receive(state)),
            server.onDidStop(() => this.#dropAll()),
            vscode.workspace.onDidChangeTextDocument((event) => this.#edited(event)),
            vscode.workspace.onDidCloseTextDocument((document) => void this.#closed(document)),
            vscode.window.onDidChangeActiveTextEditor((editor) => this.#focus(editor)),
            vscode.window.onDidChangeTextEditorVisibleRanges(() => this.look()),
            vscode.window.onDidChangeVisibleTextEditors(() => this.look()),
            vscode.debug.onDidChangeBreakpoints(() => this.#breakpointsChanged()),
        );
        this.#focus(vscode.window.activeTextEditor);
    }

    of(document: vscode.TextDocument): Session | undefined {
        return this.#sessions.get(document.uri.toString());
    }

    /** The session of the ladder document that was shown last. */
    get current(): Session | undefined {
        return this.#lastDocument && this.of(this.#lastDocument);
    }

    /**
     * Starts a simulation of the document's text as it is now, else of the active one's, and lets it run; one that was there
     * is ended.
     *
     * @param prepare what is done before, and says whether it runs then; else the settings do
     */
    async start(given?: vscode.TextDocument, prepare?: (session: Session) => Promise<boolean>): Promise<void> {
        const session = await this.#begin(given, false);
        if (!session) {
            return;
        }
        const paused = vscode.workspace.getConfiguration('ladder.start', session.document.uri).get<boolean>('paused', false);
        if (await (prepare?.(session) ?? !paused)) {
            const state = await this.#tell(session.command('run', {}));
            if (state) {
                this.#show(session, state);
            }
        }
    }

    /** Shows what the controller does that ladder.toml names, in the place of a simulation. */
    async goOnline(): Promise<void> {
        await this.#begin(undefined, true);
    }

    async #begin(given: vscode.TextDocument | undefined, online: boolean): Promise<Session | undefined> {
        const document = given ?? this.#lastDocument;
        this.#lastDocument = document;
        if (!document) {
            void vscode.window.showWarningMessage('Open a ladder program (.clad) or Structured Text (.st) to simulate it.');
            return undefined;
        }
        await this.#end(document);
        const { version } = document;
        const send: Parameters<typeof Session.start>[2] = (name, argument) => this.#server.simulate(name, argument);
        const session = await this.#tell(Session.start(document, this.#shown(document), send, online));
        if (!session) {
            return undefined;
        }
        this.#enter(session);
        await this.#sendBreakpoints(session, true);
        if (document.version !== version) {
            session.edited();
        }
        this.#announce(document);
        this.look();
        return session;
    }

    /** A session is there: what it has to say, and where it begins. */
    #enter(session: Session): void {
        const { document, first, notes } = session;
        this.#sessions.set(document.uri.toString(), session);
        for (const note of notes) {
            void vscode.window.showWarningMessage(`Ladder: ${note}`);
        }
        const range = first && toRange(first);
        for (const editor of vscode.window.visibleTextEditors) {
            const isAbove = editor.visibleRanges.every(({ end }) => range && end.line <= range.start.line);
            if (range && isAbove && editor.document === document) {
                editor.revealRange(range, vscode.TextEditorRevealType.InCenter);
            }
        }
        const early = this.#early.filter((state) => state.session === session.id);
        this.#early = this.#early.filter((state) => state.session !== session.id);
        early.forEach((state) => this.#receive(state));
    }

    /**
     * A simulation for a debugger: the one that runs, or another one. It is shown like any other.
     *
     * @returns the session, and whether it was there before
     */
    async debug(launch: vscode.DebugConfiguration): Promise<{ session: Session; isJoined: boolean }> {
        // The text of the editor counts, so that what is typed is followed.
        const program: unknown = launch['program'];
        const isProgram = typeof program === 'string' && /\.(?:clad|st)$/i.test(program);
        const named = isProgram ? await vscode.workspace.openTextDocument(program) : undefined;
        const shown: Shown = named ? this.#shown(named) : { lines: [], tags: [] };
        const started = await this.#server.simulate('debug', { launch, options: { show: shown } });
        const document = await vscode.workspace.openTextDocument(vscode.Uri.parse(started.state.uri));
        const joined = this.of(document);
        if (started.joined && joined?.id === started.session) {
            joined.isDebugged = true;
            this.#show(joined, started.state);
            return { session: joined, isJoined: true };
        }
        await this.#end(document);
        const send: Parameters<typeof Session.start>[2] = (name, argument) => this.#server.simulate(name, argument);
        const session = new Session(document, started, shown, send);
        session.isDebugged = true;
        this.#lastDocument = document;
        this.#enter(session);
        this.#announce(document);
        this.look();
        return { session, isJoined: false };
    }

    /** The debugger of a session has left. */
    async undebug(session: Session, isJoined: boolean): Promise<void> {
        session.isDebugged = false;
        if (this.of(session.document) !== session) {
            return;
        }
        if (isJoined) {
            await this.#sendBreakpoints(session, true);
        } else {
            await this.#end(session.document);
        }
    }

    /** Tells the server what is shown now, if that is something else. */
    look(): void {
        for (const session of this.#sessions.values()) {
            session.show(this.#shown(session.document));
        }
    }

    /** A view shows these tags besides. */
    listTags(names: () => readonly string[]): void {
        this.#listedTags = names;
    }

    /** Another view shows lines of documents, until that ends. */
    alsoShows(lines: (document: vscode.TextDocument) => Lines | undefined): vscode.Disposable {
        this.#shownElsewhere.add(lines);
        return new vscode.Disposable(() => this.#shownElsewhere.delete(lines));
    }

    /** From now on commands are about this document. */
    lookAt(document: vscode.TextDocument): void {
        if (runsItself(document) && document !== this.#lastDocument) {
            this.#lastDocument = document;
            this.#announce(document);
        }
    }

    #shown(document: vscode.TextDocument): Shown {
        const editors = vscode.window.visibleTextEditors.filter((editor) => editor.document === document);
        const lines = editors.flatMap(({ visibleRanges }) =>
            visibleRanges.map(({ start, end }) => ({
                first: Math.max(start.line - MARGIN, 0),
                last: Math.min(end.line + MARGIN, document.lineCount - 1),
            })),
        );
        const elsewhere = [...this.#shownElsewhere].flatMap((shown) => shown(document) ?? []);
        return { lines: [...lines, ...elsewhere], tags: this.#lastDocument === document ? this.#listedTags() : [] };
    }

    /** The operand at the cursor, if the program that is simulated has the focus. */
    operandHere(): Operand | undefined {
        const session = this.current;
        const editor = vscode.window.activeTextEditor;
        if (!session || session.stale || editor?.document !== session.document) {
            return undefined;
        }
        const { line, character } = editor.selection.active;
        return operandAt(session.operands.get(line) ?? [], { line, character });
    }

    /** Every tag of the current program with its value. */
    async allTags(): Promise<readonly Tag[]> {
        const session = this.current;
        const found = session && (await this.#tell(session.urgent('tags', {})));
        return found?.tags ?? [];
    }

    /** What a tag opens into; of no name the tags of the program, of which those that open are listed as one. */
    async partsOf(name: string): Promise<readonly Tag[]> {
        const session = this.current;
        const found = session && (await this.#tell(session.urgent('tags', { of: name })));
        return found?.tags ?? [];
    }

    /** The tags of these names, without those that the program does not have. */
    async named(names: readonly string[]): Promise<readonly Tag[]> {
        const session = names.length > 0 ? this.current : undefined;
        const found = session && (await this.#tell(session.urgent('tags', { names })));
        return found?.tags ?? [];
    }

    async run(): Promise<void> {
        await this.command('run', {});
    }

    async command<Name extends 'step' | 'stepBlock' | 'stepRung' | 'back' | 'goTo' | 'run' | 'speed' | 'set' | 'pulse' | 'force' | 'unforce' | 'serve' | 'reset' | 'warmRestart'>(
        name: Name,
        argument: Commands[Name]['argument'],
    ): Promise<void> {
        const session = this.current;
        const state = session && (await this.#tell(session.command(name, argument)));
        if (state) {
            this.#show(session, state);
        }
    }

    /** Serves tags to clients on this computer, or no more. */
    async toggleServing(): Promise<void> {
        await this.command('serve', { on: this.current?.state.served === undefined });
        const served = this.current?.state.served;
        if (served) {
            void vscode.window.showInformationMessage(`Ladder: ${served}. Only programs on this computer reach it.`);
        }
    }

    /** What was done so far, as a scenario that expects something of these tags. */
    async record(outputs?: readonly string[]): Promise<Recorded | undefined> {
        const session = this.current;
        return session && (await this.#tell(session.command('record', { ...(outputs && { outputs }) })));
    }

    /** Why a tag holds what it holds, in words. */
    async why(tag: string): Promise<Why | undefined> {
        const session = this.current;
        return session && (await this.#tell(session.command('why', { tag })));
    }

    /** A run stops after the block that changes the tag, or no longer does. */
    async toggleBreakOnChange(tag: string): Promise<void> {
        const session = this.current;
        if (session?.isDebugged) {
            void vscode.window.showInformationMessage(
                'Ladder: while the program is debugged, use "Break on Value Change" in the menu of a variable.',
            );
        } else if (session) {
            session.watchedTags = toggled(session.watchedTags, tag);
            await this.#sendBreakpoints(session, false);
        }
    }

    /** The gutter's breakpoints are the editor's own. Without any there is nothing to tell at the start. */
    async #sendBreakpoints(session: Session, atStart: boolean): Promise<void> {
        const lines = breakpointLines(vscode.debug.breakpoints, session.document.uri.toString());
        const tags = [...session.watchedTags];
        if (session.isDebugged || session.state.controller || (atStart && lines.length === 0)) {
            return;
        }
        const state = await this.#tell(session.command('breakpoints', { lines, tags }));
        if (state) {
            this.#show(session, state);
        }
    }

    #breakpointsChanged(): void {
        for (const session of this.#sessions.values()) {
            void this.#sendBreakpoints(session, false);
        }
    }

    async pause(): Promise<void> {
        const session = this.current;
        const state = session && (await this.#tell(session.urgent('pause', {})));
        if (state) {
            this.#show(session, state);
        }
    }

    async stop(): Promise<void> {
        if (this.#lastDocument) {
            await this.#end(this.#lastDocument);
        }
    }

    /** What is held stays held, at the other value. */
    async toggle(tag: Tag): Promise<void> {
        const now = this.current?.tag(tag.name) ?? tag;
        if (typeof now.value === 'boolean') {
            await this.command(now.forced ? 'force' : 'set', { tag: now.name, value: !now.value });
        }
    }

    dispose(): void {
        this.#dropAll();
        this.#subscriptions.dispose();
    }

    /** Shows what the server refused, in its own words. */
    async #tell<T>(answer: Promise<T>): Promise<T | undefined> {
        try {
            return await answer;
        } catch (error) {
            void vscode.window.showErrorMessage(`Ladder: ${reasonOf(error)}`);
            return undefined;
        }
    }

    #show(session: Session, state: State): void {
        if (this.of(session.document) === session) {
            // The same hit comes with an answer and with a notification, and with one that comes late once more.
            if (state.hit && state.hit.number > session.hits) {
                session.hits = state.hit.number;
                void vscode.window.showInformationMessage(`Ladder: ${state.hit.message}.`);
            }
            const before = session.state.change?.number;
            const known = session.state.controller?.differences?.length ?? 0;
            session.take(state);
            const differences = state.controller?.differences ?? [];
            if (known === 0 && differences.length > 0) {
                const more = differences.length > MOST_TOLD ? ` And ${differences.length - MOST_TOLD} more.` : '';
                void vscode.window.showWarningMessage(`Ladder: ${differences.slice(0, MOST_TOLD).join('. ')}.${more}`);
            }
            if (state.change && state.change.number !== before) {
                for (const { message } of state.change.lost ?? []) {
                    void vscode.window.showInformationMessage(`Ladder: ${message}.`);
                }
            }
            this.#announce(session.document);
        }
    }

    #receive(state: State): void {
        const session = [...this.#sessions.values()].find(({ id }) => id === state.session);
        if (!session) {
            // Of one that is only just starting: the server waits until it is shown.
            this.#early = [...this.#early.slice(1 - MOST_EARLY), state];
            return;
        }
        try {
            session.seen = state.commands ?? 0;
            this.#show(session, state);
        } finally {
            void this.#hasShown(session);
            if (state.delta !== true) {
                // Other lines of the new text may be in sight.
                this.look();
            }
        }
    }

    /**
     * The server sends the next state when the editor has taken this one: what is drawn waits in front of a command that
     * does nothing. An editor that is slow with it gets as much time again, for keys and the pointer. A state that looks
     * like the one before needs no word from the page, which costs it as much as a small drawing.
     */
    async #hasShown(session: Session): Promise<void> {
        const began = Date.now();
        try {
            await new Promise<void>((resolve) => withTheRest(resolve));
            if (session.isDrawing) {
                session.isDrawing = false;
                await vscode.commands.executeCommand('noop');
                const taken = Date.now() - began;
                if (taken > FRAME) {
                    await new Promise((resolve) => setTimeout(resolve, Math.min(taken, LONGEST_REST)));
                }
            }
        } finally {
            this.#server.hasShown(session.id);
        }
    }

    #edited({ document, contentChanges }: vscode.TextDocumentChangeEvent): void {
        const session = contentChanges.length > 0 ? this.of(document) : undefined;
        session?.edited();
    }

    #focus(editor: vscode.TextEditor | undefined): void {
        if (editor && runsItself(editor.document)) {
            this.#lastDocument = editor.document;
            this.#announce(editor.document);
        }
    }

    #announce(document: vscode.TextDocument): void {
        const session = this.current;
        this.#setContext('ladder.open', this.#lastDocument !== undefined);
        this.#setContext('ladder.simulating', session !== undefined && !session.state.controller);
        this.#setContext('ladder.online', session?.state.controller !== undefined);
        this.#setContext('ladder.running', session?.state.status === 'running');
        this.#changed.fire(document);
    }

    /** Thirty times a second nothing has changed here: the editor is notified only when something has. */
    #setContext(name: string, value: boolean): void {
        if (this.#context.get(name) !== value) {
            this.#context.set(name, value);
            void vscode.commands.executeCommand('setContext', name, value);
        }
    }

    async #closed(document: vscode.TextDocument): Promise<void> {
        await this.#end(document);
        if (document === this.#lastDocument) {
            this.#lastDocument = undefined;
            this.#announce(document);
        }
    }

    async #end(document: vscode.TextDocument): Promise<void> {
        const session = this.of(document);
        if (session) {
            this.#sessions.delete(document.uri.toString());
            this.#announce(document);
            // Whatever the server says: for this side the session is over.
            await session.urgent('stop', {}).catch(() => undefined);
        }
    }

    /** The server has ended, and with it what it simulated: each can be had again as it was. */
    #dropAll(): void {
        const lost = [...this.#sessions.values()];
        this.#sessions.clear();
        for (const session of lost) {
            this.#announce(session.document);
            void this.#offerAgain(session);
        }
    }

    async #offerAgain({ document, state, deeds, isDebugged }: Session): Promise<void> {
        if (state.controller) {
            void vscode.window.showWarningMessage(`Ladder: the language server has ended, and nothing is seen of ${state.controller.name} any more.`);
            return;
        }
        const again = 'Start It Again as It Was';
        const name = vscode.workspace.asRelativePath(document.uri);
        const message = `Ladder: the language server has ended, and the simulation of ${name} with it, after ${state.scan} scans.`;
        const chosen = await vscode.window.showWarningMessage(message, ...(isDebugged ? [] : [again]));
        if (chosen !== again) {
            return;
        }
        await this.#server.whenRunning();
        await this.start(document, async (session) => {
            const repeated = await this.#tell(session.repeat(deeds, state.scan));
            if (repeated) {
                this.#show(session, repeated);
            }
            return state.status === 'running';
        });
    }
}

/** The protocol's range as the editor's; both count UTF-16 units from 0. */
export function toRange({ start, end }: State['power'][number]['range']): vscode.Range {
    return new vscode.Range(start.line, start.character, end.line, end.character);
}
