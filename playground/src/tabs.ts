// Tabs: one of several panels is shown; arrow keys go from tab to tab.
import { element } from './element.ts';

export class Tabs {
    readonly #tabs = new Map<string, { readonly tab: HTMLButtonElement; readonly panel: HTMLElement }>();
    readonly #list: HTMLElement;
    readonly #shown: (id: string) => void;
    chosen = '';

    constructor(list: HTMLElement, label: string, shown: (id: string) => void) {
        this.#list = list;
        this.#shown = shown;
        list.setAttribute('role', 'tablist');
        list.setAttribute('aria-label', label);
        list.addEventListener('keydown', (event) => this.#key(event));
    }

    /** The first one is shown. */
    add(id: string, title: string, panel: HTMLElement): void {
        const tab = element('button', { type: 'button', role: 'tab', id: `tab-${id}`, 'aria-controls': panel.id, onclick: () => this.choose(id) }, title);
        panel.setAttribute('role', 'tabpanel');
        panel.setAttribute('aria-labelledby', tab.id);
        this.#tabs.set(id, { tab, panel });
        this.#list.append(tab);
        if (this.chosen === '') {
            this.choose(id);
        } else {
            this.#put();
        }
    }

    choose(id: string): void {
        if (this.chosen !== id && this.#tabs.has(id)) {
            this.chosen = id;
            this.#put();
            this.#shown(id);
        }
    }

    /** A tab that there is not always. */
    offer(id: string, isOffered: boolean, instead: string): void {
        const tab = this.#tabs.get(id)?.tab;
        if (tab) {
            tab.hidden = !isOffered;
        }
        if (!isOffered && this.chosen === id) {
            this.choose(instead);
        }
    }

    title(id: string, title: string): void {
        const tab = this.#tabs.get(id)?.tab;
        if (tab && tab.textContent !== title) {
            tab.textContent = title;
        }
    }

    #put(): void {
        for (const [id, { tab, panel }] of this.#tabs) {
            const isChosen = id === this.chosen;
            tab.setAttribute('aria-selected', String(isChosen));
            tab.tabIndex = isChosen ? 0 : -1;
            panel.hidden = !isChosen;
        }
    }

    #key(event: KeyboardEvent): void {
        const ids = [...this.#tabs].filter(([, { tab }]) => !tab.hidden).map(([id]) => id);
        const at = ids.indexOf(this.chosen);
        const to = { ArrowLeft: at - 1, ArrowRight: at + 1, Home: 0, End: ids.length - 1 }[event.key];
        const id = to === undefined ? undefined : ids.at(to % ids.length);
        if (id !== undefined) {
            event.preventDefault();
            this.choose(id);
            this.#tabs.get(id)?.tab.focus();
        }
    }
}
