// How often something is shown that changes with every state of a program.

/**
 * Draws a moment later, when the editor's status bar sends its text, too. What is sent to the page together costs it
 * one message and one frame.
 */
export function withTheRest(draw: () => void): void {
    setTimeout(draw);
}

/** A state of a program that runs comes sooner than this, in milliseconds. */
const NEXT_STATE = 100;

/**
 * Shows something no more often than a user can read it: together with a state that comes anyway, so that the editor
 * draws both at once. If no state comes it is shown a little later by itself.
 */
export class Pace {
    readonly #every: number;
    readonly #show: () => void;
    #shown = 0;
    #later: ReturnType<typeof setTimeout> | undefined;

    /** @param every in milliseconds */
    constructor(every: number, show: () => void) {
        this.#every = every;
        this.#show = show;
    }

    /**
     * There is something new.
     *
     * @param isHurried whether more will come soon, as from a program that runs; otherwise it is shown at once
     * @returns whether it is shown now
     */
    changed(isHurried: boolean): boolean {
        const wait = isHurried ? this.#every - (Date.now() - this.#shown) : 0;
        if (wait <= 0) {
            this.now();
            return true;
        }
        this.#later ??= setTimeout(() => this.now(), wait + NEXT_STATE);
        return false;
    }

    /** Shows it, however recently that was done. */
    now(): void {
        this.dispose();
        this.#shown = Date.now();
        this.#show();
    }

    /** Shows nothing any more that was put off. */
    dispose(): void {
        clearTimeout(this.#later);
        this.#later = undefined;
    }
}
