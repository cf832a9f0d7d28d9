// The programs that the browser keeps: each under a key of its own, so that no tab writes what another one has open.
import { filesOf, type Linked, nameOf } from './link.ts';

export interface Kept extends Linked {
    readonly id: string;
    /** When it was opened, in milliseconds. */
    readonly at: number;
    /** Something was typed in it. */
    readonly isOwn: boolean;
}

const PREFIX = 'ladder.program.';
/** So many that were opened and never changed are kept. What a person has written is kept without end. */
const MOST_UNCHANGED = 20;

export type Store = Pick<Storage, 'getItem' | 'setItem' | 'removeItem' | 'key' | 'length'>;

export class Shelf {
    readonly #store: Store;

    constructor(store: Store) {
        this.#store = store;
    }

    /** All of them, those first that were opened first. */
    all(): readonly Kept[] {
        const keys = Array.from({ length: this.#store.length }, (_, at) => this.#store.key(at) ?? '');
        const found = keys.filter((key) => key.startsWith(PREFIX)).flatMap((key) => this.get(key.slice(PREFIX.length)) ?? []);
        return found.sort((a, b) => a.at - b.at);
    }

    get(id: string): Kept | undefined {
        try {
            const read = JSON.parse(this.#store.getItem(PREFIX + id) ?? 'null') as Partial<Kept> | null;
            if (typeof read?.text !== 'string') {
                return undefined;
            }
            const scenarios = typeof read.scenarios === 'string' ? { scenarios: read.scenarios } : {};
            return { id, name: nameOf(read.name), text: read.text, ...scenarios, ...filesOf(read), at: Number(read.at) || 0, isOwn: read.isOwn === true };
        } catch {
            return undefined;
        }
    }

    /** The one that was opened before another one. */
    before(id: string): Kept | undefined {
        const all = this.all();
        return all[all.findIndex((kept) => kept.id === id) - 1];
    }

    /**
     * Keeps a program. Where there is no room, programs go that were never changed.
     *
     * @throws where there is no room without them
     */
    put({ id, ...kept }: Kept): void {
        const unchanged = this.all().filter((other) => !other.isOwn && other.id !== id);
        unchanged.splice(0, unchanged.length - MOST_UNCHANGED).forEach((other) => this.remove(other.id));
        for (;;) {
            try {
                this.#store.setItem(PREFIX + id, JSON.stringify(kept));
                return;
            } catch {
                const oldest = unchanged.shift();
                if (!oldest) {
                    throw new Error('the browser has no room to keep this program: export it before you close the page.');
                }
                this.remove(oldest.id);
            }
        }
    }

    remove(id: string): void {
        this.#store.removeItem(PREFIX + id);
    }
}
