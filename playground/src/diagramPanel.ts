// The live diagram next to the text: the page of the VS Code panel, in a frame.
import type { ViewUpdate } from '@codemirror/view';

import type { FromPage, LineChange, ToPage } from '../../panels/diagram/messages.ts';
import { Teller } from '../../panels/diagram/teller.ts';
import { Frame } from './frame.ts';
import type { OpenText } from './openText.ts';
import { reasonOf, type Server } from './server.ts';
import type { Simulation } from './simulation.ts';

export interface DiagramEvents {
    why(tag: string): void;
    command(name: Extract<FromPage, { type: 'command' }>['name']): void;
}

export class DiagramPanel {
    readonly frame: Frame<ToPage, FromPage>;
    readonly #program: OpenText;
    readonly #server: Server;
    readonly #simulation: Simulation;
    readonly #events: DiagramEvents;
    readonly #teller: Teller;
    #isReady = false;
    /** The page itself moves the cursor of the text. */
    #isRevealing = false;

    constructor(parent: HTMLElement, program: OpenText, server: Server, simulation: Simulation, events: DiagramEvents) {
        this.#program = program;
        this.#server = server;
        this.#simulation = simulation;
        this.#events = events;
        this.frame = new Frame(parent, 'diagram.html', 'Diagram', (message) => void this.#receive(message));
        this.#teller = new Teller((message) => this.frame.send(message), () => simulation.session, () => this.frame.isSeen);
        simulation.onChange(() => this.#teller.tell());
        simulation.showsLines(() => (this.frame.isSeen ? this.#teller.lines : undefined));
    }

    /** Another program is in the editor, or the page begins. */
    open(): void {
        if (this.#isReady) {
            const { view, version, name } = this.#program;
            const line = view.state.doc.lineAt(view.viewport.from).number - 1;
            this.frame.send({ type: 'open', name, version, lineCount: view.state.doc.lines, line });
            this.#teller.begin();
        }
    }

    /** The panel is in sight again. */
    appear(): void {
        this.#simulation.look();
        this.#teller.tell();
    }

    /** The text has changed, or its cursor has moved. */
    followed({ docChanged, changes, startState, state, selectionSet }: ViewUpdate): void {
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

    async #receive(message: FromPage): Promise<void> {
        const simulation = this.#simulation;
        switch (message.type) {
            case 'ready':
                this.#isReady = true;
                this.open();
                break;
            case 'ask':
                await this.#draw(message);
                break;
            case 'sees':
                this.#teller.lines = message.lines;
                simulation.look();
                this.#teller.tell();
                break;
            case 'painted':
                this.#teller.painted();
                break;
            case 'reveal':
                this.#isRevealing = true;
                this.#program.select({ start: message.from, end: message.to }, message.focus);
                this.#isRevealing = false;
                break;
            case 'command':
                this.#events.command(message.name);
                break;
            case 'why':
                this.#events.why(message.tag);
                break;
            case 'toggle':
                await simulation.toggle(message.tag);
                break;
            case 'set':
            case 'force':
                await simulation.command(message.type, 'text' in message ? { tag: message.tag, text: message.text } : { tag: message.tag, value: message.value });
                break;
            case 'pulse':
            case 'unforce':
                await simulation.command(message.type, { tag: message.tag });
        }
    }

    async #draw({ lines, rail, known }: Extract<FromPage, { type: 'ask' }>): Promise<void> {
        const { uri, version } = this.#program;
        try {
            this.frame.send({ type: 'drawn', drawn: await this.#server.execute('ladder.diagram', { uri, lines, rail, known }) });
        } catch (error) {
            this.frame.send({ type: 'failed', version, message: reasonOf(error) });
        }
    }
}
