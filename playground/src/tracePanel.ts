// Chosen tags over time: the page of the VS Code panel, in a frame.
import { answer, type Side, tell } from '../../panels/trace/answer.ts';
import { added, atFirst, MOST, picked } from '../../panels/trace/chosenTags.ts';
import type { FromPage, ToPage } from '../../panels/trace/messages.ts';
import { byId, element } from './element.ts';
import { Frame } from './frame.ts';
import type { Simulation } from './simulation.ts';

export class TracePanel {
    readonly frame: Frame<ToPage, FromPage>;
    readonly #simulation: Simulation;
    readonly #side: Side;
    /** Of the program, as long as it is that one. */
    #chosen: readonly string[] | undefined;

    constructor(parent: HTMLElement, simulation: Simulation) {
        this.#simulation = simulation;
        this.frame = new Frame(parent, 'trace.html', 'Traces', (message) => void answer(message, this.#side));
        this.#side = {
            send: (message) => this.frame.send(message),
            isSeen: () => this.frame.isSeen,
            session: () => simulation.session,
            tags: () => this.tags(),
            choose: (_, tags) => this.#show(tags),
            pick: () => this.#pick(),
            goTo: (scan) => simulation.command('goTo', { scan }),
            run: () => simulation.run(),
            pause: () => simulation.pause(),
        };
        simulation.onChange(() => void this.tell());
    }

    /** Another program has other tags. */
    forget(): void {
        this.#chosen = undefined;
    }

    async add(tag: string): Promise<void> {
        await this.#show(added(await this.tags(), tag));
    }

    /** Those that are shown. */
    async tags(): Promise<readonly string[]> {
        this.#chosen ??= this.#simulation.session && atFirst(await this.#simulation.allTags());
        return this.#chosen ?? [];
    }

    /** Says how the simulation is. */
    async tell(): Promise<void> {
        await tell(this.#side);
    }

    async #show(tags: readonly string[]): Promise<void> {
        this.#chosen = tags.slice(0, MOST);
        await this.tell();
    }

    /** Asks which tags are to be shown. */
    async #pick(): Promise<void> {
        const before = await this.tags();
        const names = new Set(before.map((name) => name.toLowerCase()));
        const boxes = (await this.#simulation.allTags()).map(({ name, type }) => {
            const box = element('input', { type: 'checkbox', value: name, checked: names.has(name.toLowerCase()) });
            return { box, row: element('label', {}, box, ` ${name} `, element('span', { class: 'quiet' }, type)) };
        });
        const dialog = byId('choice') as HTMLDialogElement;
        const done = element('button', { value: 'done' }, 'Show');
        const title = element('h2', {}, 'Tags of the trace');
        dialog.replaceChildren(element('form', { method: 'dialog' }, title, element('div', { class: 'choices' }, ...boxes.map(({ row }) => row)), done));
        dialog.returnValue = '';
        dialog.addEventListener(
            'close',
            () => {
                if (dialog.returnValue === 'done') {
                    void this.#show(picked(before, boxes.filter(({ box }) => box.checked).map(({ box }) => box.value)));
                }
            },
            { once: true },
        );
        dialog.showModal();
    }
}
