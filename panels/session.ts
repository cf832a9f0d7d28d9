// One simulation of one document's text: sends its commands in order, and keeps what is known of what is shown.
import type { Commands, Label, Operand, Power, Range, Shown, Started, State, Tag } from './protocol.ts';

/** Sends `ladder.simulate.<name>` with one object. */
export type Send = <Name extends keyof Commands>(
    name: Name,
    argument: Commands[Name]['argument'] & { session?: string },
) => Promise<Commands[Name]['answer']>;

/** The text that is simulated, as its editor keeps it. */
export interface SimulatedText {
    readonly uri: { toString(): string };
    readonly version: number;
}

/** Something that a person did to a simulation, and after how many scans. */
export interface Deed {
    readonly scan: number;
    readonly name: 'set' | 'force' | 'unforce' | 'pulse';
    readonly argument: object;
}

export class Session<Document extends SimulatedText = SimulatedText> {
    readonly document: Document;
    /** The last one; of the drawing it tells only what has changed. */
    state: State;
    /** What is known of tags, by their names in lower case. */
    readonly tags = new Map<string, Tag>();
    /** What is known of elements, by line and column. */
    readonly power = new Map<number, Map<number, Power>>();
    /** Those of the lines that are shown, by line. */
    readonly operands = new Map<number, readonly Operand[]>();
    /** Where values are shown. */
    labels: readonly Label[] = [];
    /** What has changed in scenes since their pages were told, by address. */
    readonly scenes = new Map<string, { readonly values: Map<number, string>; again: boolean }>();
    /** Grows whenever what is known of power changes. */
    powerChanges = 0;
    /** How many commands had taken effect in the last picture; an answer comes before the picture of it. */
    seen = 0;
    /** The number of the last hit that was reported. */
    hits = 0;
    /** The editor was given something of it to draw, and has not said yet that it has taken that. */
    isDrawing = false;
    shown: Shown;
    /** The text is newer than what the server has answered about: its places are about an older one. */
    stale = false;
    /** Grows whenever what is known is about another text. */
    texts = 0;
    /** Tags whose change stops a run. */
    watchedTags: readonly string[] = [];
    /** What the server had to say at the start. */
    readonly notes: readonly string[];
    /** Where the first rung was at the start. */
    readonly first: Range | undefined;
    /** Breakpoints are the debugger's. */
    isDebugged = false;
    /** What was done since the start, in its order: with it a simulation can be made again as it was. */
    deeds: readonly Deed[] = [];

    readonly #send: Send;
    #last: Promise<unknown> = Promise.resolve();

    /** One that the server has started. */
    constructor(document: Document, { state, first, notes = [] }: Started, shown: Shown, send: Send) {
        this.document = document;
        this.state = state;
        this.first = first;
        this.notes = notes;
        this.shown = shown;
        this.#send = send;
        this.take(state);
    }

    /** @param online whether the controller is shown that runs it, in the place of a simulation */
    static async start<Document extends SimulatedText>(
        document: Document,
        shown: Shown,
        send: Send,
        online = false,
    ): Promise<Session<Document>> {
        const options = { show: shown, ...(online && { online }) };
        const started = await send('start', { uri: document.uri.toString(), options });
        return new Session(document, started, shown, send);
    }

    get id(): string {
        return this.state.session;
    }

    tag(name: string): Tag | undefined {
        return this.tags.get(name.toLowerCase());
    }

    /** Takes in a state. @returns whether it tells anything of the drawing */
    take(state: State): boolean {
        this.state = state;
        // What the server says first of a new text is all that there is to show.
        const whole = state.delta !== true;
        if (whole) {
            this.stale = state.version < this.document.version;
            this.tags.clear();
            this.power.clear();
            this.operands.clear();
            this.labels = [];
            this.texts += 1;
        }
        for (const tag of state.tags) {
            this.tags.set(tag.name.toLowerCase(), tag);
        }
        if (whole || state.power.length > 0) {
            this.powerChanges += 1;
        }
        for (const element of state.power) {
            const { line, character } = element.range.start;
            const elements = this.power.get(line) ?? new Map<number, Power>();
            elements.set(character, element);
            this.power.set(line, elements);
        }
        // The operands of a line come together.
        const byLine = new Map<number, Operand[]>();
        for (const operand of state.operands ?? []) {
            const { line } = operand.block.start;
            byLine.set(line, [...(byLine.get(line) ?? []), operand]);
        }
        for (const [line, operands] of byLine) {
            this.operands.set(line, operands);
        }
        this.labels = state.labels ?? this.labels;
        for (const { uri, values = [], again = false } of state.scenes ?? []) {
            const scene = this.scenes.get(uri) ?? { values: new Map<number, string>(), again: false };
            values.forEach(([slot, value]) => scene.values.set(slot, value));
            scene.again ||= again;
            this.scenes.set(uri, scene);
        }
        return whole || state.tags.length > 0 || state.power.length > 0 || byLine.size > 0 || state.labels !== undefined;
    }

    /** @returns whether something else is shown now */
    show(shown: Shown): boolean {
        if (JSON.stringify(shown) === JSON.stringify(this.shown)) {
            return false;
        }
        this.shown = shown;
        const isShown = (line: number) => shown.lines.some(({ first, last }) => first <= line && line <= last);
        for (const lines of [this.power, this.operands]) {
            for (const line of [...lines.keys()].filter((line) => !isShown(line))) {
                lines.delete(line);
            }
        }
        this.powerChanges += 1;
        void this.urgent('show', shown).catch(() => undefined);
        return true;
    }

    /** Sent once the commands before it are answered: the server may work on several at once. */
    command<Name extends keyof Commands>(name: Name, argument: Commands[Name]['argument']): Promise<Commands[Name]['answer']> {
        const sent = this.#last.then(() => this.#send(name, { ...argument, session: this.id }));
        this.#last = sent.then(
            (answer) => this.#note(name, argument, answer),
            () => undefined,
        );
        return sent;
    }

    #note(name: keyof Commands, argument: object, answer: object): void {
        if (name === 'reset' || name === 'warmRestart') {
            this.deeds = [];
        } else if ('scan' in answer && typeof answer.scan === 'number') {
            const { scan } = answer;
            // What was stepped back over is done no more.
            const deeds = this.deeds.filter((deed) => deed.scan <= scan);
            const isDeed = name === 'set' || name === 'force' || name === 'unforce' || name === 'pulse';
            this.deeds = isDeed ? [...deeds, { scan, name, argument }] : deeds;
        }
    }

    /** Does again what was done in another simulation of the text, and goes on to a scan. @returns the last state */
    async repeat(deeds: readonly Deed[], scan: number): Promise<State> {
        const stepTo = async (to: number): Promise<void> => {
            if (to > this.state.scan) {
                this.state = await this.command('step', { scans: to - this.state.scan });
            }
        };
        for (const deed of deeds) {
            await stepTo(deed.scan);
            await this.command(deed.name, deed.argument as Commands['set']['argument']);
        }
        await stepTo(scan);
        return this.state;
    }

    /** As `command`, but at once: a pause must not wait for the end of what it pauses. */
    urgent<Name extends keyof Commands>(name: Name, argument: Commands[Name]['argument']): Promise<Commands[Name]['answer']> {
        return this.#send(name, { ...argument, session: this.id });
    }

    /** What is drawn moves with the text until the server tells of the new one. */
    edited(): void {
        this.stale = true;
    }
}
