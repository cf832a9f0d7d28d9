// Asking for what is in the parentheses of a block: the tags that may be meant, and what a new name would be.
import type { Page } from '../page.ts';
import type { Ask } from './asker.ts';
import type { Choice, Field, Wanted, Written } from './field.ts';
import type { Asked, Requests } from './requests.ts';

/** How many letters the head of a contact or coil has: those have one tag, of type BOOL. */
export const HEAD = 3;

export class Operands {
    readonly #page: Page;
    readonly #field: Field;
    readonly #ask: Ask;
    /** The tags that there were when the field was opened. */
    #known: Promise<Requests['tags']['answer']> | undefined;

    constructor(page: Page, field: Field, ask: Ask) {
        this.#page = page;
        this.#field = field;
        this.#ask = ask;
    }

    /** Asks for the operands of a new block with this head. */
    async ofNew(head: string, asked: Asked, wanted: Pick<Wanted, 'label' | 'text' | 'spot' | 'again'>): Promise<Written | undefined> {
        const isBool = head.length === HEAD;
        this.#known = undefined;
        return this.#field.ask({
            ...wanted,
            kind: isBool ? 'line' : 'operands',
            placeholder: isBool ? 'tag' : '',
            choices: (before) => this.#tags(before, isBool),
            note: (text) => this.#news(text, head, asked),
        });
    }

    /** Asks for another operand in the place of one that is there. */
    async another(old: string, isBool: boolean, asked: Asked, wanted: Pick<Wanted, 'label' | 'spot' | 'again'>): Promise<Written | undefined> {
        this.#known = undefined;
        return this.#field.ask({
            ...wanted,
            text: old,
            choices: (before) => this.#tags(before, isBool),
            note: (text) => this.#news(isBool && text !== old ? text : '', '[ ]', asked),
        });
    }

    /** The tags that may be meant in ladder text, where its last parenthesis is open. */
    async within(before: string): Promise<Choice[]> {
        const isBool = /[[(].[\])]\( [\w.]*$/.test(before);
        return isBool || /\( [^()]*$/.test(before) ? this.#tags(before, isBool) : [];
    }

    /** The tags that may be meant, those that begin so first. */
    async #tags(text: string, isBool: boolean): Promise<Choice[]> {
        const word = /[\w.]*$/.exec(text)?.[0].toLowerCase() ?? '';
        const before = text.slice(0, text.length - word.length);
        // Each letter narrows the same tags.
        this.#known ??= this.#ask('tags', {}).catch((error: unknown) => {
            this.#known = undefined;
            throw error;
        });
        const { tags } = await this.#known;
        const fitting = tags.filter(({ name, type }) => name.toLowerCase().includes(word) && (!isBool || type === 'BOOL'));
        const rank = (name: string) => (name.toLowerCase().startsWith(word) ? 0 : 1);
        return fitting
            .sort((a, b) => rank(a.name) - rank(b.name) || a.name.localeCompare(b.name))
            .map(({ name, type, kind, comment }) => ({ text: before + name, shown: name, about: [`${type}, ${kind}`, comment].filter(Boolean).join('  ') }));
    }

    /** Which names of a text are new, and what they would be. */
    async #news(text: string, head: string, asked: Asked): Promise<string> {
        if (!text) {
            return '';
        }
        const { declares = [] } = await this.#ask('offer', { version: this.#page.layout.version, ...asked, text: `${head}( ${text} )` });
        return declares.map(({ name, type, section }) => `${name} is new: ${type} in ${section}`).join(', ');
    }
}
