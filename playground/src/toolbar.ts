// The buttons and keys that move the simulation, and what it is doing.
import { Pace } from '../../panels/pace.ts';
import { element, setText } from './element.ts';
import type { Simulation } from './simulation.ts';

/** Nobody reads more often how far the program is. In milliseconds. */
const UPDATE_EVERY = 200;

interface Action {
    readonly label: string;
    readonly title: string;
    /** The outlines of its icon, in a square of 16. */
    readonly icon: string;
    readonly act: (simulation: Simulation) => Promise<void>;
    readonly isFor: (simulation: Simulation) => boolean;
    readonly key: (event: KeyboardEvent) => boolean;
}

const plain = (key: string) => (event: KeyboardEvent) => event.key === key && !event.shiftKey && !event.altKey;
const shifted = (key: string) => (event: KeyboardEvent) => event.key === key && event.shiftKey && !event.altKey;
const isThere = ({ session }: Simulation) => session !== undefined;
const rests = (simulation: Simulation) => !simulation.isRunning;

const actions: readonly Action[] = [
    { label: 'Run', title: 'Run (F5)', icon: 'M4 3 L13 8 L4 13 Z', act: (it) => it.run(), isFor: rests, key: plain('F5') },
    { label: 'Pause', title: 'Pause (F6)', icon: 'M4 3 H7 V13 H4 Z M9 3 H12 V13 H9 Z', act: (it) => it.pause(), isFor: (it) => it.isRunning, key: plain('F6') },
    { label: 'Scan', title: 'One scan (F10)', icon: 'M3 3 L9 8 L3 13 Z M10 3 H12 V13 H10 Z', act: (it) => it.move('step'), isFor: rests, key: plain('F10') },
    {
        label: 'Back',
        title: 'Back one scan (Alt+F10)',
        icon: 'M13 3 L7 8 L13 13 Z M4 3 H6 V13 H4 Z',
        act: (it) => it.move('back'),
        isFor: (it) => isThere(it) && rests(it),
        key: (event) => event.key === 'F10' && event.altKey,
    },
    { label: 'Block', title: 'One block (F11)', icon: 'M2 4 H8 V12 H2 Z M9 7 H12 V4 L15 8 L12 12 V9 H9 Z', act: (it) => it.move('stepBlock'), isFor: rests, key: plain('F11') },
    { label: 'Rung', title: 'One rung (Shift+F11)', icon: 'M2 3 H4 V13 H2 Z M12 3 H14 V13 H12 Z M4 7 H12 V9 H4 Z', act: (it) => it.move('stepRung'), isFor: rests, key: shifted('F11') },
    { label: 'Restart', title: 'From the beginning: a cold start', icon: 'M8 2 A6 6 0 1 0 14 8 H12 A4 4 0 1 1 8 4 V7 L13 3 L8 -1 Z', act: (it) => it.command('reset', {}), isFor: isThere, key: () => false },
    { label: 'Stop', title: 'Stop (Shift+F5)', icon: 'M4 4 H12 V12 H4 Z', act: (it) => it.stop(), isFor: isThere, key: shifted('F5') },
];

const SVG = 'http://www.w3.org/2000/svg';

function icon(outline: string): SVGSVGElement {
    const svg = document.createElementNS(SVG, 'svg');
    svg.setAttribute('viewBox', '0 0 16 16');
    svg.setAttribute('aria-hidden', 'true');
    const path = document.createElementNS(SVG, 'path');
    path.setAttribute('d', outline);
    svg.append(path);
    return svg;
}

export class Toolbar {
    readonly #simulation: Simulation;
    readonly #say: (text: string) => void;
    readonly #buttons: readonly { readonly action: Action; readonly button: HTMLButtonElement }[];
    readonly #standing = element('span', { class: 'standing' });
    readonly #pace = new Pace(UPDATE_EVERY, () => this.#tell());
    #status: string | undefined;

    constructor(node: HTMLElement, simulation: Simulation, say: (text: string) => void) {
        this.#simulation = simulation;
        this.#say = say;
        this.#buttons = actions.map((action) => {
            const button = element(
                'button',
                { type: 'button', title: action.title, class: `act-${action.label.toLowerCase()}`, onclick: () => void (action.isFor(simulation) && action.act(simulation)) },
                icon(action.icon),
                element('span', {}, action.label),
            );
            return { action, button };
        });
        const speeds = [['0.1', '0.1×'], ['1', '1×'], ['10', '10×'], ['100', '100×'], ['max', 'As fast as it goes']] as const;
        const speed = element('select', { 'aria-label': 'Speed', onchange: () => void simulation.go(speed.value === 'max' ? { realTime: false } : { speed: Number(speed.value) }) },
            ...speeds.map(([value, text]) => element('option', { value, selected: value === '1' }, text)));
        node.append(...this.#buttons.map(({ button }) => button), speed, this.#standing);
        this.show();
    }

    show(): void {
        for (const { action, button } of this.#buttons) {
            // Not `disabled`: a button that is must not lose the focus.
            button.setAttribute('aria-disabled', String(!action.isFor(this.#simulation)));
        }
        this.#pace.changed(this.#simulation.isRunning);
    }

    #tell(): void {
        const state = this.#simulation.session?.state;
        setText(this.#standing, state?.text ?? 'at rest');
        this.#standing.className = `standing ${state?.status ?? 'rest'}`;
        if (state?.status !== this.#status) {
            const isFirst = this.#status === undefined && !state;
            this.#status = state?.status;
            if (!isFirst && (state?.status !== 'paused' || !state.hit)) {
                this.#say(`Simulation ${state?.text ?? 'at rest'}.`);
            }
        }
        for (const fault of (state?.faults ?? []).slice(-1)) {
            if (state?.status === 'faulted') {
                this.#say(`Fault in scan ${fault.scan}: ${fault.message}`);
            }
        }
    }
}

/** What a key does is done wherever the focus is. */
export function simulationKeys(simulation: Simulation, { toggle, why }: { toggle: () => Promise<void>; why: () => Promise<void> }): void {
    document.addEventListener('keydown', (event) => {
        const action = actions.find(({ key }) => key(event));
        const other = plain('F4')(event) ? toggle : shifted('F4')(event) ? why : undefined;
        if (action?.isFor(simulation)) {
            event.preventDefault();
            void action.act(simulation);
        } else if (action) {
            event.preventDefault();
        } else if (other && simulation.session) {
            event.preventDefault();
            void other();
        }
    });
}
