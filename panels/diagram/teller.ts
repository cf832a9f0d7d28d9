// When a diagram's page is told how the program is: never while it paints, and values no more often than they are read.
import type { LiveUpdate, Lines, ToPage } from './messages.ts';
import { Feed, type Source } from './feed.ts';

/** Nobody reads values and the number of scans more often. In milliseconds. */
const VALUES_EVERY = 200;

/** A session, as far as its page is told of it. */
export type Told = Source & { isDrawing: boolean };

function isNews({ whole, power, operands, tags }: LiveUpdate): boolean {
    return whole || power.length > 0 || operands.length > 0 || tags.length > 0;
}

export class Teller {
    /** The lines that the page shows. */
    lines: Lines | undefined;
    readonly #feed = new Feed();
    readonly #send: (message: ToPage) => void;
    readonly #session: () => Told | undefined;
    readonly #isSeen: () => boolean;
    #isReady = false;
    /** The page has something to paint, and says when it has. */
    #isPainting = false;
    #owes = false;
    #soon: ReturnType<typeof setTimeout> | undefined;
    /** When values were sent last. */
    #valued = 0;

    /**
     * @param session the one of the program that the page shows
     * @param isSeen whether anybody sees the page
     */
    constructor(send: (message: ToPage) => void, session: () => Told | undefined, isSeen: () => boolean) {
        this.#send = send;
        this.#session = session;
        this.#isSeen = isSeen;
    }

    /** The page begins, and knows nothing. */
    begin(): void {
        this.#isReady = true;
        this.#feed.forget();
        this.#isPainting = false;
        this.tell();
    }

    /** The page has painted what it was told. */
    painted(): void {
        this.#isPainting = false;
        if (this.#owes) {
            this.tell();
        }
    }

    /** Tells the page how the program is: the next time when it has painted the last one. */
    tell(): void {
        if (!this.#isReady) {
            return;
        }
        if (this.#isPainting || !this.#isSeen()) {
            this.#owes = true;
            return;
        }
        this.#owes = false;
        const session = this.#session();
        if (!session) {
            this.#feed.forget();
            this.#send({ type: 'live', update: undefined });
        } else if (!session.stale) {
            const wait = session.state.status === 'running' ? VALUES_EVERY - (Date.now() - this.#valued) : 0;
            const update = this.#feed.changes(session, this.lines ?? { first: 0, last: -1 }, wait <= 0);
            if (wait > 0) {
                this.#soon ??= setTimeout(() => {
                    this.#soon = undefined;
                    this.tell();
                }, wait);
                if (!isNews(update)) {
                    return;
                }
            } else {
                clearTimeout(this.#soon);
                this.#soon = undefined;
                this.#valued = Date.now();
            }
            session.isDrawing = true;
            this.#send({ type: 'live', update });
        } else {
            // Of a text that is newer than what is known nothing is sent until the server has seen it.
            return;
        }
        this.#isPainting = true;
    }

    dispose(): void {
        this.#isReady = false;
        clearTimeout(this.#soon);
    }
}
