// The simulation of the program: what a person does with it, and what its views are told.
import type { Lines } from '../../panels/diagram/messages.ts';
import { operandAt } from '../../panels/operands.ts';
import type { Commands, DebuggerMessage, Given, History, Operand, Range, Speed, State, Tag, Why } from '../../panels/protocol.ts';
import { reasonOf } from '../../panels/reason.ts';
import { type Send, Session } from '../../panels/session.ts';
import type { OpenText } from './openText.ts';
import type { Server } from './server.ts';

/** So many lines above and below what the editor shows are kept ready for scrolling. */
const MARGIN = 5;

type Named = 'step' | 'stepBlock' | 'stepRung' | 'back' | 'goTo' | 'run' | 'speed' | 'set' | 'pulse' | 'force' | 'unforce' | 'reset' | 'warmRestart';

export interface SimulationEvents {
    /** A sentence for people. */
    message(text: string): void;
    /** Something stopped a run: the place where. */
    stopped(range: Range): void;
}

/** So many states of sessions that are not known yet are kept. */
const MOST_EARLY = 4;

export class Simulation {
    session: Session<OpenText> | undefined;
    /** The lines with a breakpoint, from 0. */
    breakpoints: readonly number[] = [];
    readonly #server: Server;
    readonly #program: OpenText;
    readonly #events: SimulationEvents;
    readonly #listeners = new Set<() => void>();
    readonly #lines = new Set<() => Lines | undefined>();
    readonly #tags = new Set<() => readonly string[]>();
    readonly #send: Send = (name, argument) => this.#server.simulate(name, argument);
    #speed: Speed = { speed: 1 };
    #isAnnounced = false;
    /** States that came before the answer that tells of their session. */
    #early: readonly State[] = [];

    constructor(server: Server, program: OpenText, events: SimulationEvents) {
        this.#server = server;
        this.#program = program;
        this.#events = events;
    }

    /** Called after each change: another state, an edit, the end. */
    onChange(listener: () => void): void {
        this.#listeners.add(listener);
    }

    /** A view shows these lines, or none. */
    showsLines(lines: () => Lines | undefined): void {
        this.#lines.add(lines);
    }

    /** A view shows these tags. */
    showsTags(tags: () => readonly string[]): void {
        this.#tags.add(tags);
    }

    get isRunning(): boolean {
        return this.session?.state.status === 'running';
    }

    /** Starts the program from the beginning, and lets it run. */
    async start(isPaused = false): Promise<void> {
        await this.stop();
        const program = this.#program;
        const session = await this.#tell(Session.start(program, this.#shown(), this.#send));
        if (!session) {
            return;
        }
        this.#begin(session);
        session.notes.forEach((note) => this.#events.message(note));
        await this.#sendBreakpoints();
        this.look();
        if (!isPaused) {
            await this.run();
        }
    }

    /** Plays a scenario that is in no file, and stays where a property of the file is violated, else at its end. */
    async play(files: Readonly<Record<string, string>>, file: string, scenario: string): Promise<void> {
        await this.stop();
        this.#server.files(files);
        const [launch, shown] = [{ scenarioFile: decodeURIComponent(new URL(file).pathname), scenarioText: scenario }, this.#shown()];
        const started = await this.#tell(this.#server.simulate('debug', { launch, options: { show: shown } }));
        if (!started) {
            return;
        }
        this.#begin(new Session(this.#program, started, shown, this.#send));
        this.look();
        const { session } = started;
        this.#server.debug(session, 1, 'initialize', { adapterID: 'ladder' });
        this.#server.debug(session, 2, 'launch', launch);
        this.#server.debug(session, 3, 'configurationDone');
    }

    /** Shows a session. The server sends no more of it until the state that came first is on the screen. */
    #begin(session: Session<OpenText>): void {
        this.session = session;
        this.#announce();
        const early = this.#early.filter((state) => state.session === session.id);
        this.#early = [];
        early.forEach((state) => this.receive(state));
    }

    /** The debugger that plays a scenario has come to its end: the simulation stays where it is. */
    receiveOfDebugger({ session, message }: DebuggerMessage): void {
        const { event, body } = message as { event?: string; body?: { category?: string; output?: string } };
        if (event === 'output' && body?.category === 'stderr' && session === this.session?.id) {
            this.#events.message((body.output ?? '').trim());
        } else if (event === 'stopped' || event === 'terminated') {
            this.#server.debug(session, 4, 'disconnect');
        }
    }

    async run(): Promise<void> {
        await (this.session ? this.command('run', this.#speed) : this.start());
    }

    /** A run goes on as fast as this. */
    async go(speed: Speed): Promise<void> {
        this.#speed = speed;
        if (this.session) {
            await this.command('speed', speed);
        }
    }

    async pause(): Promise<void> {
        const { session } = this;
        const state = session && (await this.#tell(session.urgent('pause', {})));
        if (state) {
            this.#take(session, state);
        }
    }

    async stop(): Promise<void> {
        const { session } = this;
        this.session = undefined;
        if (session) {
            this.#announce();
            // Whatever the server says: for this side the session is over.
            await session.urgent('stop', {}).catch(() => undefined);
        }
    }

    /** The server has ended, and the session with it. */
    drop(): void {
        this.session = undefined;
        this.#announce();
    }

    /** A simulation is started, paused, where there is none to be moved. */
    async move(name: 'step' | 'stepBlock' | 'stepRung' | 'back'): Promise<void> {
        if (!this.session) {
            await this.start(true);
        }
        await (name === 'step' || name === 'back' ? this.command(name, { scans: 1 }) : this.command(name, {}));
    }

    async command<Name extends Named>(name: Name, argument: Commands[Name]['argument']): Promise<void> {
        const { session } = this;
        const state = session && (await this.#tell<State>(session.command(name, argument) as Promise<State>));
        if (session && state) {
            this.#take(session, state);
        }
    }

    /** What is held stays held, at the other value. */
    async toggle(name: string): Promise<void> {
        const tag = this.session?.tag(name);
        if (typeof tag?.value === 'boolean' && tag.readOnly !== true) {
            await this.command(tag.forced ? 'force' : 'set', { tag: tag.name, value: !tag.value });
        }
    }

    async give(tag: string, given: Given): Promise<void> {
        await this.command(this.session?.tag(tag)?.forced ? 'force' : 'set', { tag, ...given });
    }

    async why(tag: string): Promise<Why | undefined> {
        return this.session && this.#tell(this.session.command('why', { tag }));
    }

    async history(tags: readonly string[], scans: number): Promise<History | undefined> {
        return this.session && this.#tell(this.session.command('history', { tags, scans }));
    }

    /** What tags of the program there are; with a name what that tag opens into. */
    async tags(of?: string): Promise<readonly Tag[]> {
        // Without a name the tags that open are listed as one, as those with an empty one are.
        const found = this.session && (await this.session.urgent('tags', { of: of ?? '' }).catch(() => undefined));
        return found?.tags ?? [];
    }

    /** Every tag that holds a value. */
    async allTags(): Promise<readonly Tag[]> {
        const found = this.session && (await this.session.urgent('tags', {}).catch(() => undefined));
        return found?.tags ?? [];
    }

    /** The operand at a place of the text. */
    operandAt(place: Range['start']): Operand | undefined {
        const { session } = this;
        return !session || session.stale ? undefined : operandAt(session.operands.get(place.line) ?? [], place);
    }

    setBreakpoints(lines: readonly number[]): void {
        if (lines.join() !== this.breakpoints.join()) {
            this.breakpoints = lines;
            void this.#sendBreakpoints();
        }
    }

    /** Tells the server what is shown now, if that is something else. */
    look(): void {
        this.session?.show(this.#shown());
    }

    /** The text has changed: places are about an older one until the server has seen it. */
    edited(): void {
        this.session?.edited();
    }

    receive(state: State): void {
        const { session } = this;
        if (session?.id !== state.session) {
            this.#early = [...this.#early.slice(1 - MOST_EARLY), state];
            return;
        }
        session.seen = state.commands ?? 0;
        this.#take(session, state);
        if (state.delta !== true) {
            // Other lines of the new text may be in sight.
            this.look();
        }
        // The next state comes when this one is on the screen.
        const shown = () => this.#server.hasShown(session.id);
        if (document.hidden) {
            setTimeout(shown, 500);
        } else {
            requestAnimationFrame(() => setTimeout(shown));
        }
    }

    #take(session: Session<OpenText>, state: State): void {
        if (session !== this.session) {
            return;
        }
        const before = session.state.change?.number;
        session.take(state);
        // The same hit comes with an answer and with a notification, and with one that comes late once more.
        if (state.hit && state.hit.number > session.hits) {
            session.hits = state.hit.number;
            this.#events.message(`${state.hit.message}.`);
            if (state.hit.range) {
                this.#events.stopped(state.hit.range);
            }
        }
        if (state.change && state.change.number !== before) {
            state.change.lost?.forEach(({ message }) => this.#events.message(`${message}.`));
        }
        this.#announce();
    }

    /** Views draw once for whatever came together. */
    #announce(): void {
        if (!this.#isAnnounced) {
            this.#isAnnounced = true;
            setTimeout(() => {
                this.#isAnnounced = false;
                this.#listeners.forEach((listener) => listener());
            });
        }
    }

    #shown() {
        const { view } = this.#program;
        const { doc } = view.state;
        const first = doc.lineAt(view.viewport.from).number - 1;
        const last = doc.lineAt(view.viewport.to).number - 1;
        const text = { first: Math.max(first - MARGIN, 0), last: Math.min(last + MARGIN, doc.lines - 1) };
        return { lines: [text, ...[...this.#lines].flatMap((lines) => lines() ?? [])], tags: [...this.#tags].flatMap((tags) => tags()) };
    }

    async #sendBreakpoints(): Promise<void> {
        const { session } = this;
        if (session) {
            const state = await this.#tell(session.command('breakpoints', { lines: [...this.breakpoints], tags: [...session.watchedTags] }));
            if (state) {
                this.#take(session, state);
            }
        }
    }

    /** A run stops after the block that changes the tag, or no longer does. */
    async toggleBreakOnChange(tag: string): Promise<void> {
        const { session } = this;
        if (session) {
            const { watchedTags } = session;
            session.watchedTags = watchedTags.includes(tag) ? watchedTags.filter((it) => it !== tag) : [...watchedTags, tag];
            await this.#sendBreakpoints();
        }
    }

    /** Says what the server refused, in its own words. */
    async #tell<T>(answer: Promise<T>): Promise<T | undefined> {
        try {
            return await answer;
        } catch (error) {
            this.#events.message(reasonOf(error));
            return undefined;
        }
    }
}
