// Chosen tags over time: the page of the VS Code panel, in a frame.
import { added, atFirst, moved, MOST, picked, removed, renamed } from '../../panels/trace/chosenTags.ts';
import type { FromPage, ToPage, TraceAsked } from '../../panels/trace/messages.ts';
import type { Session } from '../../panels/session.ts';
import { byId, element } from './element.ts';
import { Frame } from './frame.ts';
import type { OpenText } from './openText.ts';
import type { Simulation } from './simulation.ts';

export class TracePanel {
    readonly frame: Frame<ToPage, FromPage>;
    readonly #simulation: Simulation;
    /** Of the program, as long as it is that one. */
    #chosen: readonly string[] | undefined;

    constructor(parent: HTMLElement, simulation: Simulation) {
        this.#simulation = simulation;
        this.frame = new Frame(parent, 'trace.html', 'Traces', (message) => void this.#receive(message));
        simulation.onChange(() => void this.tell());
    }

    /** Another program has other tags. */
    forget(): void {
        this.#chosen = undefined;
    }

    async add(tag: string): Promise<void> {
        this.#chosen = added(await this.tags(), tag).slice(0, MOST);
        await this.tell();
    }

    /** Those that are shown. */
    async tags(): Promise<readonly string[]> {
        this.#chosen ??= this.#simulation.session && atFirst(await this.#simulation.allTags());
        return this.#chosen ?? [];
    }

    /** Says how the simulation is: the page asks for what it shows of it. */
    async tell(): Promise<void> {
        if (!this.frame.isSeen) {
            return;
        }
        const { session, isRunning: running } = this.#simulation;
        const tags = session ? await this.tags() : [];
        if (session === this.#simulation.session) {
            this.frame.send({ kind: 'situation', situation: session ? { session: session.id, running, tags } : { running, tags } });
        }
    }

    async #receive(message: FromPage): Promise<void> {
        const { session } = this.#simulation;
        switch (message.kind) {
            case 'ready':
                await this.tell();
                break;
            case 'ask':
                await (session?.id === message.session ? this.#ask(session, message.asked) : this.#refuse());
                break;
            case 'goTo':
                await this.#simulation.command('goTo', { scan: message.scan });
                break;
            case 'choose':
                await this.#pick();
                break;
            case 'remove':
                await this.#show(removed(await this.tags(), message.tag));
                break;
            case 'move':
                await this.#show(moved(await this.tags(), message.tag, message.by));
                break;
            case 'runOrPause':
                await (this.#simulation.isRunning ? this.#simulation.pause() : this.#simulation.run());
        }
    }

    async #show(tags: readonly string[]): Promise<void> {
        this.#chosen = tags.slice(0, MOST);
        await this.tell();
    }

    async #ask(session: Session<OpenText>, asked: TraceAsked): Promise<void> {
        try {
            const tags = await this.tags();
            const traced = await session.urgent('trace', { ...asked, tags });
            this.#chosen = renamed(tags, traced.tags);
            this.frame.send({ kind: 'traced', session: session.id, asked, traced });
        } catch {
            // The simulation has ended meanwhile.
            this.frame.send({ kind: 'refused' });
        }
    }

    async #refuse(): Promise<void> {
        this.frame.send({ kind: 'refused' });
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
