// The program that this tab has open, and those that were open before: all of them are kept, and Back brings the last one again.
import { claim } from './claims.ts';
import { stemOf } from './exports.ts';
import { type Kept, Shelf, type Store } from './kept.ts';
import type { Linked } from './link.ts';
import type { Opened } from './opened.ts';
import type { OpenText } from './openText.ts';

/** Of this tab: what it has open, and the address that this came from. */
const TAB = 'ladder.tab';
/** Of the browser: what was open last. */
const LAST = 'ladder.last';
const EARLIER = 'ladder.program';
/** What is typed is kept after so many milliseconds. */
const KEEP_AFTER = 1000;

interface Tab {
    readonly id: string;
    readonly fragment: string;
}

/** A browser may refuse to keep anything; then it lasts as long as the page. */
function storeOf(kind: 'localStorage' | 'sessionStorage'): Store {
    try {
        return window[kind];
    } catch {
        const all = new Map<string, string>();
        return {
            get length() {
                return all.size;
            },
            key: (at) => [...all.keys()][at] ?? null,
            getItem: (key) => all.get(key) ?? null,
            setItem: (key, value) => void all.set(key, value),
            removeItem: (key) => void all.delete(key),
        };
    }
}

const newId = () => `${Date.now().toString(36)}-${Math.random().toString(36).slice(2)}`;

export interface ProgramEvents {
    /** Another program is in the editor. */
    opened(): void;
    /** A sentence for people. */
    message(text: string): void;
}

export class Programs {
    readonly #program: OpenText;
    readonly #scenarios: OpenText;
    readonly #events: ProgramEvents;
    readonly #store = storeOf('localStorage');
    readonly #session = storeOf('sessionStorage');
    readonly #shelf = new Shelf(this.#store);
    /** The one that the address of the page holds. */
    #linked = '';
    #later: ReturnType<typeof setTimeout> | undefined;
    #isFull = false;

    constructor(program: OpenText, scenarios: OpenText, events: ProgramEvents) {
        this.#program = program;
        this.#scenarios = scenarios;
        this.#events = events;
        this.#takeOver();
        program.onOpen((before, text, now) => this.#opened(before, text, now));
        [program, scenarios].forEach((text) => text.onEdit(() => {
            clearTimeout(this.#later);
            this.#later = setTimeout(() => this.keep(), KEEP_AFTER);
        }));
        window.addEventListener('pagehide', () => this.keep());
        document.addEventListener('visibilitychange', () => document.hidden && this.keep());
    }

    get current(): Linked {
        const { files } = this;
        return { name: this.#program.name, text: this.#program.text, scenarios: this.#scenarios.text, ...(Object.keys(files).length > 0 ? { files } : {}) };
    }

    /** What is next to the program that is open. */
    get files(): Readonly<Record<string, string>> {
        return this.#shelf.get(this.#program.opened.id)?.files ?? {};
    }

    /** The one that Back brings again. */
    get before(): Linked | undefined {
        return this.#shelf.before(this.#program.opened.id);
    }

    /** Opens a program next to the one that is there. */
    open(linked: Linked): void {
        // It comes right after the one that is open, also where that was brought back.
        const at = Math.max(Date.now(), ...this.#shelf.all().map((kept) => kept.at)) + 1;
        const current = this.#shelf.get(this.#program.opened.id);
        if (current) {
            this.#put({ ...current, at });
        }
        const kept: Kept = { ...linked, id: newId(), at: at + 1, isOwn: false };
        void claim(kept.id);
        this.#put(kept);
        this.#show(kept);
    }

    /** Opens what the address of the page holds. */
    openLinked(linked: Linked): void {
        this.#linked = '';
        this.open(linked);
        this.isLinked();
    }

    async back(): Promise<void> {
        this.keep();
        const kept = this.#shelf.before(this.#program.opened.id);
        if (kept) {
            await this.#openKept(kept);
        }
    }

    /** @returns whether there was something to open: what this tab had open, else what was open last */
    async restore(onlyOfTab: boolean): Promise<boolean> {
        const tab = this.#tab();
        const isSame = tab?.fragment === location.hash;
        const kept = (tab && isSame && this.#shelf.get(tab.id)) || (onlyOfTab ? undefined : this.#shelf.get(this.#store.getItem(LAST) ?? ''));
        if (!kept) {
            return false;
        }
        this.#linked = isSame && location.hash !== '' ? kept.id : '';
        await this.#openKept(kept);
        return true;
    }

    /** The address of the page holds the program that is open. */
    isLinked(): void {
        this.#linked = this.#program.opened.id;
        this.#remember();
    }

    /** What was typed is there again when the page is. */
    keep(): void {
        this.#keep(this.#program.opened, this.#program.text);
        this.#remember();
    }

    async #openKept(kept: Kept): Promise<void> {
        if (await claim(kept.id)) {
            this.#show(kept);
        } else {
            // Another tab has it open, and goes on writing it.
            this.open(kept);
        }
    }

    #show({ id, name, text }: Kept): void {
        const isFirst = this.#program.opened.id === '';
        this.#program.open({ id, name }, text);
        if (isFirst) {
            this.#program.forget();
        }
    }

    /** Also after an Undo that has crossed a change of program. */
    #opened(before: Opened, text: string, now: Opened): void {
        this.#keep(before, text);
        this.#scenarios.open({ ...now, name: `${stemOf(now.name)}.ladder-test` }, this.#shelf.get(now.id)?.scenarios ?? '');
        this.#scenarios.forget();
        if (location.hash !== '' && this.#linked !== now.id && this.#linked !== '') {
            history.replaceState(null, '', location.pathname + location.search);
        }
        this.#remember();
        this.#events.opened();
    }

    #keep({ id, name }: Opened, text: string): void {
        const was = this.#shelf.get(id);
        const scenarios = this.#scenarios.text;
        if (was && (was.text !== text || (was.scenarios ?? '') !== scenarios)) {
            this.#put({ ...was, name, text, scenarios, isOwn: true });
        }
    }

    #put(kept: Kept): void {
        try {
            this.#shelf.put(kept);
            this.#isFull = false;
        } catch (error) {
            if (!this.#isFull) {
                this.#isFull = true;
                this.#events.message((error as Error).message);
            }
        }
    }

    /** An earlier page kept one program, under a key that all tabs had in common. */
    #takeOver(): void {
        const earlier = this.#store.getItem(EARLIER);
        if (earlier !== null) {
            this.#store.setItem(`${EARLIER}.first`, earlier);
            this.#store.setItem(LAST, 'first');
            this.#store.removeItem(EARLIER);
        }
    }

    #tab(): Tab | undefined {
        try {
            return (JSON.parse(this.#session.getItem(TAB) ?? 'null') as Tab | null) ?? undefined;
        } catch {
            return undefined;
        }
    }

    #remember(): void {
        const { id } = this.#program.opened;
        try {
            this.#session.setItem(TAB, JSON.stringify({ id, fragment: location.hash } satisfies Tab));
            this.#store.setItem(LAST, id);
        } catch {
            // There is no room, which was said of the program itself.
        }
    }
}
