// The live diagram next to the text: the page of the VS Code panel, in a frame.
import { isolateHistory, redo, undo } from '@codemirror/commands';
import type { ViewUpdate } from '@codemirror/view';

import { answer, type Side } from '../../panels/diagram/answer.ts';
import { answerOf } from '../../panels/diagram/draw/asker.ts';
import type { Edited } from '../../panels/diagram/draw/requests.ts';
import type { FromPage, LineChange, ToPage } from '../../panels/diagram/messages.ts';
import { Teller } from '../../panels/diagram/teller.ts';
import { actionsAt, changesOf, type Finding, fix } from './findings.ts';
import { Frame } from './frame.ts';
import { opensAnother } from './opened.ts';
import type { OpenText } from './openText.ts';
import type { Server } from './server.ts';
import type { Simulation } from './simulation.ts';

const SEVERITIES = { 1: 'error', 2: 'warning', 3: 'info', 4: 'info' } as const;

export type DiagramEvents = Pick<Side, 'why' | 'command'>;

export class DiagramPanel {
    readonly frame: Frame<ToPage, FromPage>;
    readonly #program: OpenText;
    readonly #simulation: Simulation;
    readonly #teller: Teller;
    #isReady = false;
    #found: readonly Finding[] = [];
    /** The page itself moves the cursor of the text. */
    #isRevealing = false;

    constructor(parent: HTMLElement, program: OpenText, server: Server, simulation: Simulation, events: DiagramEvents) {
        this.#program = program;
        this.#simulation = simulation;
        const side: Side = {
            send: (message) => this.frame.send(message),
            begin: () => {
                this.#isReady = true;
                this.open();
            },
            version: () => program.version,
            draw: ({ lines, rail, known }) => server.execute('ladder.diagram', { uri: program.uri, lines, rail, known }),
            look: () => simulation.look(),
            reveal: (start, end, focus) => {
                this.#isRevealing = true;
                program.select({ start, end }, focus);
                this.#isRevealing = false;
            },
            request: (question) =>
                answerOf(question, program.uri, {
                    execute: (command, argument) => server.execute(command, argument),
                    make: (edited) => this.#make(edited),
                    fixes: async (range) => (await actionsAt(program.view, range, ['quickfix'])).map(({ title }) => title),
                    fix: (range, title) => fix(program.view, range, title),
                }),
            history: (step) => void (step === 'undo' ? undo : redo)(program.view),
            command: (name) => events.command(name),
            why: (tag) => events.why(tag),
            toggle: (tag) => simulation.toggle(tag),
            change: (name, argument) => simulation.command(name, argument),
        };
        this.frame = new Frame(parent, 'diagram.html', 'Diagram', (message) => void answer(message, this.#teller, side));
        this.#teller = new Teller((message) => this.frame.send(message), () => simulation.session, () => this.frame.isSeen);
        simulation.onChange(() => this.#teller.tell());
        simulation.showsLines(() => (this.frame.isSeen ? this.#teller.lines : undefined));
    }

    /** Makes the edits of a change of the drawing, as a step of their own to go back. */
    async #make({ version, edits }: Edited): Promise<number> {
        const program = this.#program;
        if (program.version !== version) {
            throw new Error('The text has changed meanwhile: try again');
        }
        const changes = changesOf(program.view.state.doc, edits);
        program.view.dispatch({ changes, annotations: isolateHistory.of('full'), userEvent: 'input.draw' });
        return program.version;
    }

    /** Another program is in the editor, or the page begins. */
    open(): void {
        if (this.#isReady) {
            const { view, version, name } = this.#program;
            const line = view.state.doc.lineAt(view.viewport.from).number - 1;
            this.frame.send({ type: 'open', name, version, lineCount: view.state.doc.lines, line });
            this.#teller.begin();
            this.#report();
        }
    }

    /** What the server finds in a text. */
    report(uri: string, found: readonly Finding[]): void {
        if (uri === this.#program.uri) {
            this.#found = found;
            this.#report();
        }
    }

    #report(): void {
        const findings = this.#found.map(({ range: { start, end }, severity = 1, message }) => ({ from: start, to: end, severity: SEVERITIES[severity], message }));
        if (this.#isReady) {
            this.frame.send({ type: 'findings', version: this.#program.version, findings });
        }
    }

    /** The panel is in sight again. */
    appear(): void {
        this.#simulation.look();
        this.#teller.tell();
    }

    /** The text has changed, or its cursor has moved. */
    followed({ docChanged, changes, startState, state, selectionSet, transactions }: ViewUpdate): void {
        if (transactions.some(opensAnother)) {
            return;
        }
        if (docChanged) {
            const lines: LineChange[] = [];
            changes.iterChanges((from, to, _from, _to, inserted) => {
                lines.push({ first: startState.doc.lineAt(from).number - 1, last: startState.doc.lineAt(to).number - 1, count: inserted.lines });
            });
            const lineCount = state.doc.lines;
            // From the end of the text to its start, so that none moves another. The version is known once the server is sent it.
            const send = () => this.frame.send({ type: 'edited', version: this.#program.version, lineCount, changes: lines.reverse() });
            queueMicrotask(() => queueMicrotask(send));
        }
        if (selectionSet && !this.#isRevealing) {
            this.frame.send({ type: 'cursor', place: this.#program.place(state.selection.main.head) });
        }
    }
}
