// What is reported about the program: said in a strip below when its element has the focus, visited by keys, put right by a menu.
import type { Finding, Place } from '../messages.ts';
import type { Found, Page } from '../page.ts';
import type { Ask } from './asker.ts';
import type { Menu } from './menu.ts';
import type { Voice } from './pen.ts';
import { rangeOf } from './selection.ts';

const WORDS = { error: 'Error', warning: 'Warning', info: 'Note' } as const;

export class Findings {
    readonly node = document.createElement('div');
    readonly #page: Page;
    readonly #ask: Ask;
    readonly #menu: Menu;
    readonly #voice: Voice;
    readonly #inTable: (finding: Finding) => boolean;
    /** Where the last one was. */
    #visited: Place | undefined;

    /** @param inTable focuses the declaration that a finding is about, and returns whether there is one */
    constructor(page: Page, ask: Ask, menu: Menu, voice: Voice, inTable: (finding: Finding) => boolean) {
        this.#inTable = inTable;
        this.#page = page;
        this.#ask = ask;
        this.#menu = menu;
        this.#voice = voice;
        this.node.className = 'findings';
        this.node.setAttribute('role', 'group');
        this.node.setAttribute('aria-label', 'What is reported here');
        this.node.hidden = true;
    }

    /** The strip is about this element. */
    show(found: Found | undefined): void {
        const findings = found?.part.findings ?? [];
        this.node.hidden = findings.length === 0;
        this.node.replaceChildren(
            ...findings.map(({ severity, message }) => {
                const line = document.createElement('p');
                line.className = severity;
                const word = document.createElement('strong');
                word.textContent = WORDS[severity];
                line.append(word, ` ${message}`);
                return line;
            }),
        );
        if (found && findings.length > 0) {
            const button = document.createElement('button');
            button.type = 'button';
            button.textContent = 'Fix…';
            button.title = 'Fixes of what is reported here (Ctrl+.)';
            button.addEventListener('click', () => void this.menu(found));
            this.node.append(button);
        }
    }

    /** Goes to the next finding, or the one before. */
    async go(by: 1 | -1): Promise<void> {
        const { findings, selected, layout } = this.#page;
        const isInTable = document.activeElement?.closest('.declarations') !== null;
        const here = (isInTable ? this.#visited : selected) ?? { line: -1, character: 0 };
        const isAfter = ({ from }: Finding) => from.line > here.line || (from.line === here.line && from.character > here.character);
        const isBefore = ({ from }: Finding) => from.line < here.line || (from.line === here.line && from.character < here.character);
        const next = by > 0 ? (findings.find(isAfter) ?? findings[0]) : (findings.findLast(isBefore) ?? findings.at(-1));
        if (!next) {
            this.#voice.said('Nothing is reported in this program');
            return;
        }
        this.#visited = next.from;
        if (!this.#inTable(next)) {
            if (document.activeElement instanceof HTMLElement) {
                // A field that has the focus would keep it.
                document.activeElement.blur();
            }
            this.#page.cursorAt(next.from);
            await this.#page.focusSoon({ places: [next.from], version: layout.version });
        }
        this.#voice.said(`${WORDS[next.severity]}: ${next.message}`);
    }

    /** The fixes of what is reported about an element. */
    async menu(found: Found): Promise<void> {
        const { start, end } = rangeOf(found);
        const [first] = found.part.findings;
        const range = first ? { start: first.from, end: first.to } : { start, end };
        const titles = await this.#ask('fixes', { range }).catch(() => []);
        if (titles.length === 0) {
            this.#voice.refused(first ? 'There is no fix for this: it has to be drawn in another way' : 'Nothing is reported here');
            return;
        }
        const box = found.part.node.getBoundingClientRect();
        const fix = (title: string) => {
            this.#ask('fix', { range, title }).then(
                () => this.#voice.said(`${title}: done`),
                (error: unknown) => this.#voice.refused(String(error)),
            );
        };
        this.#menu.open('Fixes', titles.map((title) => ({ title, run: () => fix(title) })), { x: box.left, y: box.bottom + 4 });
    }
}
