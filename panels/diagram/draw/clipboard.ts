// Elements are copied as the text that they are, and moved by taking them up and putting them down.
import type { Range } from '../../protocol.ts';
import type { Pen } from './pen.ts';

export class Clipboard {
    readonly #pen: Pen;
    /** What is to be moved, the text of what is selected, and what was taken last. */
    #held: readonly Range[] = [];
    #copied = '';
    #taken: Promise<string> = Promise.resolve('');

    constructor(pen: Pen) {
        this.#pen = pen;
    }

    /** Something has the focus now: the clipboard takes what is there at once, so its text is asked for before. */
    async focused(): Promise<void> {
        const what = this.#pen.selection.ranges;
        this.#copied = '';
        if (what.length > 0) {
            this.#copied = (await this.#pen.look({ what }))?.text ?? '';
        }
    }

    /** Copies what is selected, or takes it up. */
    copied(isCut: boolean, clipboard: DataTransfer | null): void {
        clipboard?.setData('text/plain', this.#copied);
        this.#taken = Promise.resolve(this.#copied);
        this.#hold(isCut, this.#pen.selection.ranges);
    }

    #hold(isCut: boolean, what: readonly Range[]): void {
        this.#held = isCut ? what : [];
        if (isCut && what.length > 0) {
            this.#pen.voice.said(`${what.length === 1 ? 'One element is' : `${what.length} elements are`} taken up: paste where it goes`);
        }
    }

    /** By the menu, which has no clipboard event of its own. */
    async take(isCut: boolean): Promise<void> {
        const what = this.#pen.selection.ranges;
        this.#hold(isCut, what);
        // Whoever is quick is elsewhere before there is an answer.
        this.#taken = this.#pen.look({ what }).then((offer) => offer?.text ?? '');
        await navigator.clipboard?.writeText(await this.#taken).catch(() => undefined);
    }

    putDown(): void {
        this.#held = [];
    }

    /** Puts down what was taken up, or draws a text. */
    async paste(given?: string): Promise<void> {
        const { here } = this.#pen.selection;
        const text = given ?? (await this.#taken);
        if (/^\s*\+/m.test(text)) {
            await this.#pen.edit({ op: 'network', ...(here && { network: here.drawing.first }), place: 'below', text, copied: true });
            return;
        }
        const at = here && (await this.#pen.placeOf(here));
        if (!at) {
            return;
        }
        const held = this.#held;
        this.#held = [];
        await this.#pen.edit(held.length > 0 ? { op: 'move', what: held, to: { at } } : { op: 'insert', at, text, copied: true });
    }
}
