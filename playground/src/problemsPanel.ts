// All that is found in the texts that are open, each with its place, its fixes and the page of its rule.
import { type Finding, fix } from './findings.ts';
import { element } from './element.ts';
import type { OpenText } from './openText.ts';

const words = { 1: 'Error', 2: 'Warning', 3: 'Note', 4: 'Hint' } as const;
/** More nobody reads. */
const MOST = 200;

export class ProblemsPanel {
    readonly #texts: readonly OpenText[];
    readonly #list = element('ul', { class: 'problems' });
    readonly #found = new Map<string, readonly Finding[]>();
    readonly #show: (text: OpenText) => void;
    readonly #counted: (count: number) => void;

    constructor(panel: HTMLElement, texts: readonly OpenText[], show: (text: OpenText) => void, counted: (count: number) => void) {
        this.#texts = texts;
        this.#show = show;
        this.#counted = counted;
        panel.append(this.#list);
        this.#put();
    }

    take(uri: string, found: readonly Finding[]): void {
        this.#found.set(uri, found);
        this.#put();
    }

    /** How many errors there are in a text. */
    errors(uri: string): number {
        return (this.#found.get(uri) ?? []).filter(({ severity = 1 }) => severity === 1).length;
    }

    #put(): void {
        const all = this.#texts.flatMap((text) => (this.#found.get(text.uri) ?? []).map((finding) => ({ text, finding })));
        this.#counted(all.length);
        const rows = all.slice(0, MOST).map(({ text, finding }) => this.#row(text, finding));
        this.#list.replaceChildren(...(rows.length > 0 ? rows : [element('li', { class: 'hint' }, 'Nothing is found in this program.')]));
    }

    #row(text: OpenText, { range, severity = 1, code, codeDescription, message, data }: Finding): HTMLElement {
        const go = () => {
            this.#show(text);
            text.select(range, true);
        };
        const place = `${text.name}, line ${range.start.line + 1}`;
        const fixes = (data?.fixes ?? []).map((title) => element('button', { type: 'button', onclick: () => void fix(text.view, range, title) }, title));
        const page = /^ladder-rule:\/([a-z-]+)\.md$/.exec(codeDescription?.href ?? '')?.[1];
        const rule = page === undefined ? [code ?? ''] : [element('a', { href: `../rules/${page}.html`, target: '_blank' }, page)];
        return element(
            'li',
            { class: `severity-${severity}` },
            element('button', { type: 'button', class: 'link', onclick: go }, element('strong', {}, words[severity]), ` ${message}`),
            element('p', { class: 'quiet' }, `${place} `, ...rule),
            ...(fixes.length > 0 ? [element('div', { class: 'fixes' }, ...fixes)] : []),
        );
    }
}
