// What instructions are called in names and sentences: "Open contact", or "XIC" for those who know them by that.
import type { DrawableRow } from '../protocol.ts';
import type { Names } from './messages.ts';

export class Called {
    #names: Names = 'iec';
    /** The names in the United States, by those of the table of instructions; the longest of these first. */
    #us: readonly (readonly [title: string, us: string])[] = [];

    /** Whose names come first, from now on. */
    named(names: Names): void {
        this.#names = names;
    }

    /** These can be drawn. */
    know(rows: readonly DrawableRow[]): void {
        const pairs = rows.flatMap(({ title, us }) => (us === undefined ? [] : [[title, us] as const]));
        this.#us = pairs.sort(([a], [b]) => b.length - a.length);
    }

    /** The name of an instruction that the table calls so. */
    name(title: string): string {
        const known = this.#known(title);
        return known?.[0] === title ? known[1] : title;
    }

    /** A sentence that begins with the name of an instruction. */
    sentence(words: string): string {
        const [title, us] = this.#known(words) ?? ['', ''];
        return us + words.slice(title.length);
    }

    #known(words: string): readonly [string, string] | undefined {
        return this.#names === 'us' ? this.#us.find(([title]) => words === title || words.startsWith(`${title} `)) : undefined;
    }
}
