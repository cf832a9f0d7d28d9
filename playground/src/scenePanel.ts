// The machine of the program: the page of the VS Code panel, in a frame.
import type { FromPage, ToPage } from '../../panels/scene/messages.ts';
import { SceneTeller } from '../../panels/scene/teller.ts';
import { Frame } from './frame.ts';
import { FOLDER, type Server } from './server.ts';
import type { Simulation } from './simulation.ts';

const ENDING = '.scene.svg';

export class ScenePanel {
    readonly frame: Frame<ToPage, FromPage>;
    readonly #teller: SceneTeller;
    #uri = '';

    constructor(parent: HTMLElement, server: Server, simulation: Simulation) {
        this.#teller = new SceneTeller(
            {
                send: (message) => this.frame.send(message),
                scene: (session) => server.execute('ladder.scene', { uri: this.#uri, ...(session !== undefined && { session }) }),
                session: () => simulation.session,
                give: (tag, given) => simulation.command('set', { tag, ...given }),
                run: () => simulation.run(),
                pause: () => simulation.pause(),
            },
            () => this.#uri,
        );
        this.frame = new Frame(parent, 'scene.html', 'Scene', (message) => void this.#answer(message));
        simulation.onChange(() => this.tell());
    }

    /** Shows the scene among these files. @returns whether there is one */
    open(files: Readonly<Record<string, string>>): boolean {
        const name = Object.keys(files).find((name) => name.endsWith(ENDING));
        this.#uri = name === undefined ? '' : `${FOLDER}/${encodeURIComponent(name)}`;
        if (name !== undefined) {
            void this.#teller.open();
        }
        return name !== undefined;
    }

    /** Says how the simulation is. */
    tell(): void {
        if (this.#uri !== '') {
            this.#teller.tell();
        }
    }

    async #answer(message: FromPage): Promise<void> {
        if (message.kind === 'ready' && this.#uri === '') {
            this.#teller.isReady = true;
            return;
        }
        await this.#teller.answer(message);
    }
}
