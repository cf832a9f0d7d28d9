// Which lines of a text change often. The editor takes in all decorations of a kind again when one of them is another: those
// of lines that change with every state are of other kinds than those of lines that do not.

/** Between two changes of a line that changes often, in milliseconds. */
const OFTEN = 2000;

interface Line {
    look: string;
    changed: number;
    isRestless: boolean;
}

export class Restless {
    readonly #lines = new Map<number, Line>();

    /**
     * @param looks how lines look now, each by its number
     * @param now in milliseconds
     * @returns those of them that change often
     */
    among(looks: ReadonlyMap<number, string>, now: number): ReadonlySet<number> {
        for (const line of [...this.#lines.keys()].filter((line) => !looks.has(line))) {
            this.#lines.delete(line);
        }
        const restless = new Set<number>();
        for (const [number, look] of looks) {
            const line = this.#lines.get(number);
            if (!line) {
                this.#lines.set(number, { look, changed: -Infinity, isRestless: false });
                continue;
            }
            const isRecent = now - line.changed < OFTEN;
            if (line.look !== look) {
                line.look = look;
                line.changed = now;
                line.isRestless = isRecent;
            } else if (!isRecent) {
                line.isRestless = false;
            }
            if (line.isRestless) {
                restless.add(number);
            }
        }
        return restless;
    }
}
