// What changes faster than anybody can follow while a program runs. It has a look of its own, which stays as it is: drawn
// with each state it would show chance, since most scans lie between two states, and the editor makes a line again for each
// change of it, under the pointer too, which it then takes for having left.
import type { Power } from './protocol.ts';

/** So many changes within a second are too many to follow. */
const MANY = 6;
const SECOND = 1000;
/** What has not changed for this long can be followed again, in milliseconds. */
const STILL = 700;

interface Element {
    power: Power;
    /** When it changed last, the latest first. */
    readonly changes: number[];
    flickers: boolean;
}

export class Flicker {
    readonly #elements = new Map<string, Element>();

    /**
     * @param power what is in sight now
     * @param isRunning where nothing runs, everything can be followed
     * @param now in milliseconds
     * @returns those that change too fast
     */
    among(power: readonly Power[], isRunning: boolean, now: number): ReadonlySet<Power> {
        const flickering = new Set<Power>();
        if (!isRunning) {
            this.#elements.clear();
            return flickering;
        }
        const places = new Set<string>();
        for (const element of power) {
            const place = `${element.range.start.line}:${element.range.start.character}`;
            places.add(place);
            const known = this.#elements.get(place);
            if (!known) {
                this.#elements.set(place, { power: element, changes: [], flickers: false });
                continue;
            }
            if (known.power.on !== element.on || known.power.contact !== element.contact) {
                known.changes.unshift(now);
                known.changes.length = Math.min(known.changes.length, MANY);
            }
            known.power = element;
            const earliest = known.changes[MANY - 1] ?? -Infinity;
            known.flickers = now - earliest < SECOND || (known.flickers && now - (known.changes[0] ?? -Infinity) < STILL);
            if (known.flickers) {
                flickering.add(element);
            }
        }
        for (const place of [...this.#elements.keys()].filter((place) => !places.has(place))) {
            this.#elements.delete(place);
        }
        return flickering;
    }
}
