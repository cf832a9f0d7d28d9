// Ladder text in the fences of a Markdown document, as the preview shows it: coloured, and drawn.
//
// The preview wants its page at once, and the server takes a moment. So a fence is shown as plain text at first; when the
// server has answered, the preview is asked to show its page again, and this time the answer is there.
import type { DrawnFence } from '../../../../panels/protocol.ts';

/** As much of markdown-it as is used. */
export interface Markdown {
    renderer: { rules: { fence?: Rule | undefined } };
    utils: { escapeHtml(text: string): string };
}

interface Fenced {
    info: string;
    content: string;
}

type Rule = (tokens: Fenced[], index: number, ...rest: unknown[]) => string;

/** So many fences are kept; a page of documentation has a few. */
const KEPT = 500;
/** Milliseconds in which answers are gathered before the preview is shown again. */
const GATHER = 100;

/** Asks for the colours and the picture of a text. */
export type Ask = (text: string) => Promise<DrawnFence>;

export class Fences {
    /** By text, the oldest first. One that is asked for, or could not be drawn, has nothing. */
    readonly #drawn = new Map<string, DrawnFence | undefined>();
    readonly #ask: Ask;
    readonly #refresh: () => void;
    #soon: ReturnType<typeof setTimeout> | undefined;

    /** @param refresh shows the preview again */
    constructor(ask: Ask, refresh: () => void) {
        this.#ask = ask;
        this.#refresh = refresh;
    }

    /** A plugin of markdown-it. */
    readonly plugin = (markdown: Markdown): Markdown => {
        const others = markdown.renderer.rules.fence;
        markdown.renderer.rules.fence = (tokens, index, ...rest) => {
            const token = tokens[index];
            const language = token && /^\s*(clad|ladder)(?![-\w])/i.exec(token.info);
            if (!token || !language) {
                return others?.(tokens, index, ...rest) ?? '';
            }
            return html(token.content, this.#of(token.content), markdown.utils.escapeHtml);
        };
        return markdown;
    };

    /** What could not be drawn before may be now: the server runs. */
    begin(): void {
        const plain = [...this.#drawn].filter(([, drawn]) => !drawn);
        plain.forEach(([text]) => this.#drawn.delete(text));
        // Where nothing was shown the preview is not woken.
        if (plain.length > 0) {
            this.#showAgain();
        }
    }

    dispose(): void {
        clearTimeout(this.#soon);
    }

    #of(text: string): DrawnFence | undefined {
        if (this.#drawn.has(text)) {
            return this.#drawn.get(text);
        }
        this.#keep(text, undefined);
        this.#ask(text).then(
            (drawn) => {
                this.#keep(text, drawn);
                this.#showAgain();
            },
            // Without a server, or for a text that is too large, it stays as it is.
            () => undefined,
        );
        return undefined;
    }

    #keep(text: string, drawn: DrawnFence | undefined): void {
        this.#drawn.delete(text);
        this.#drawn.set(text, drawn);
        for (const oldest of this.#drawn.keys()) {
            if (this.#drawn.size <= KEPT) {
                return;
            }
            this.#drawn.delete(oldest);
        }
    }

    #showAgain(): void {
        clearTimeout(this.#soon);
        this.#soon = setTimeout(this.#refresh, GATHER);
    }
}

/** The fence as a page shows it. The pictures are images: nothing in them is run, and nothing is loaded. */
export function html(text: string, drawn: DrawnFence | undefined, escape: (text: string) => string): string {
    const words = drawn?.words ?? [{ text }];
    const code = words.map(({ text: word, kind }) => {
        const written = escape(word);
        return kind && /^[A-Za-z]+$/.test(kind) ? `<span class="ladder-${kind}">${written}</span>` : written;
    });
    const image = (theme: 'light' | 'dark', svg: string) =>
        `<img class="ladder-picture ladder-${theme}" alt="Ladder diagram" src="data:image/svg+xml;base64,${Buffer.from(svg).toString('base64')}">`;
    const picture = drawn?.picture ? `${image('light', drawn.picture.light)}${image('dark', drawn.picture.dark)}` : '';
    return `<div class="ladder-fence"><pre><code>${code.join('')}</code></pre>${picture}</div>\n`;
}
