// Tells the page of a scene what it shows: the drawing once, and after that what has changed.
import { reasonOf } from '../reason.ts';
import type { Session } from '../session.ts';
import type { Given } from '../protocol.ts';
import type { FromPage, SceneShown, ToPage } from './messages.ts';

/** The editor around the page. */
export interface SceneSide {
    send(message: ToPage): void;
    /** Asks the server for the scene, with the values of a simulation or at rest. */
    scene(session?: string): Promise<SceneShown>;
    /** The simulation of a program. */
    session(program: string | undefined): Session | undefined;
    give(tag: string, given: Given): unknown;
    /** Starts the program of the scene, or goes on with it. */
    run(program: string | undefined): unknown;
    pause(): unknown;
}

export class SceneTeller {
    readonly #side: SceneSide;
    readonly #uri: () => string;
    /** The page is there. */
    isReady = false;
    #shown: SceneShown | undefined;
    /** The session that the page has the values of. */
    #of: string | undefined;
    #isAsking = false;
    #isStale = false;

    constructor(side: SceneSide, uri: () => string) {
        this.#side = side;
        this.#uri = uri;
    }

    /** The address of the program, once it is known. */
    get program(): string | undefined {
        return this.#shown?.program;
    }

    async answer(message: FromPage): Promise<void> {
        switch (message.kind) {
            case 'ready':
                this.isReady = true;
                await this.open();
                return;
            case 'give':
                await this.#side.give(message.tag, message.given);
                return;
            case 'runOrPause':
                await (this.#session?.state.status === 'running' ? this.#side.pause() : this.#side.run(this.program));
        }
    }

    get #session(): Session | undefined {
        const session = this.#side.session(this.program);
        return session && session.state.status !== 'ended' ? session : undefined;
    }

    /** Shows the drawing, as it is written now. */
    async open(): Promise<void> {
        if (!this.isReady) {
            return;
        }
        if (this.#isAsking) {
            this.#isStale = true;
            return;
        }
        this.#isAsking = true;
        this.#isStale = false;
        const session = this.#session;
        try {
            const shown = await this.#side.scene(session?.id);
            this.#shown = shown;
            this.#of = session?.id;
            session?.scenes.delete(this.#uri());
            this.#side.send({ kind: 'scene', shown });
        } catch (error) {
            this.#of = session?.id;
            this.#side.send({ kind: 'failed', message: reasonOf(error) });
        } finally {
            this.#isAsking = false;
        }
        // What was at rest may have been started meanwhile, now that its program is known.
        if (this.#isStale || this.#session?.id !== this.#of) {
            await this.open();
        } else {
            this.tell();
        }
    }

    /** Says how the simulation is, and what has changed in the picture. */
    tell(): void {
        if (!this.isReady) {
            return;
        }
        const session = this.#session;
        const { running, text } = { running: session?.state.status === 'running', text: session?.state.text ?? 'not running' };
        this.#side.send({ kind: 'situation', situation: { live: session !== undefined, running, text } });
        if (session?.id !== this.#of) {
            void this.open();
            return;
        }
        const pending = session?.scenes.get(this.#uri());
        if (pending?.again === true) {
            session?.scenes.delete(this.#uri());
            void this.open();
        } else if (pending && !this.#isAsking) {
            session?.scenes.delete(this.#uri());
            this.#side.send({ kind: 'values', values: [...pending.values] });
        }
    }
}
