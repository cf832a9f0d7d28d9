// The strip above the diagram: what the simulation is doing, and the buttons that move it.
import type { FromPage, LiveUpdate } from './messages.ts';
import { Pace } from '../pace.ts';

/** Nobody reads more often how far the program is. In milliseconds. */
const UPDATE_EVERY = 200;

const SVG = 'http://www.w3.org/2000/svg';

type Name = Extract<FromPage, { type: 'command' }>['name'];

interface Action {
    readonly name: Name;
    readonly label: string;
    readonly title: string;
    /** The outlines of its icon, in a square of 16. */
    readonly icon: string;
    readonly isFor: (state: LiveUpdate | undefined) => boolean;
}

const isPaused = (state: LiveUpdate | undefined) => state?.status === 'paused';
const isRunning = (state: LiveUpdate | undefined) => state?.status === 'running';

const actions: readonly Action[] = [
    { name: 'start', label: 'Start Simulation', title: 'Start a simulation of the program', icon: 'M4 3 L13 8 L4 13 Z', isFor: (state) => !state },
    { name: 'run', label: 'Run', title: 'Run (F5)', icon: 'M4 3 L13 8 L4 13 Z', isFor: (state) => isPaused(state) },
    { name: 'pause', label: 'Pause', title: 'Pause (F6)', icon: 'M4 3 H7 V13 H4 Z M9 3 H12 V13 H9 Z', isFor: isRunning },
    { name: 'step', label: 'Step', title: 'Step one scan (F10)', icon: 'M3 3 L9 8 L3 13 Z M10 3 H12 V13 H10 Z', isFor: (state) => isPaused(state) },
    { name: 'back', label: 'Back', title: 'Step back one scan (Alt+F10)', icon: 'M13 3 L7 8 L13 13 Z M4 3 H6 V13 H4 Z', isFor: (state) => isPaused(state) },
    { name: 'stop', label: 'Stop', title: 'Stop the simulation (Shift+F5)', icon: 'M4 4 H12 V12 H4 Z', isFor: (state) => state !== undefined },
];

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
    readonly #buttons = new Map<Name, HTMLButtonElement>();
    readonly #standing = document.createElement('span');
    readonly #zoom = document.createElement('button');
    #state: LiveUpdate | undefined;
    readonly #pace = new Pace(UPDATE_EVERY, () => this.#tell());

    constructor(node: HTMLElement, send: (message: FromPage) => void, zoom: (factor: number | undefined) => void) {
        node.setAttribute('role', 'toolbar');
        node.setAttribute('aria-label', 'Simulation');
        for (const { name, label, title, icon: outline } of actions) {
            const button = document.createElement('button');
            button.type = 'button';
            button.className = `action ${name}`;
            button.title = title;
            const text = document.createElement('span');
            text.textContent = label;
            button.append(icon(outline), text);
            button.addEventListener('click', () => send({ type: 'command', name }));
            this.#buttons.set(name, button);
            node.append(button);
        }
        this.#standing.className = 'standing';
        const sizes = document.createElement('span');
        sizes.className = 'sizes';
        const size = (label: string, title: string, factor: number) => {
            const button = document.createElement('button');
            button.type = 'button';
            button.textContent = label;
            button.title = title;
            button.setAttribute('aria-label', title);
            button.addEventListener('click', () => zoom(factor));
            return button;
        };
        this.#zoom.type = 'button';
        this.#zoom.title = 'Fit to the width';
        this.#zoom.addEventListener('click', () => zoom(undefined));
        sizes.append(size('−', 'Smaller', 1 / 1.1), this.#zoom, size('+', 'Larger', 1.1));
        node.append(this.#standing, sizes);
        this.show(undefined);
        this.scale(1);
    }

    show(state: LiveUpdate | undefined): void {
        const focused = document.activeElement;
        for (const { name, isFor } of actions) {
            const button = this.#buttons.get(name);
            if (button && button.hidden === isFor(state)) {
                button.hidden = !isFor(state);
            }
        }
        // The button that was pressed may have made room for another one.
        if (focused instanceof HTMLButtonElement && focused.hidden && focused.classList.contains('action')) {
            [...this.#buttons.values()].find((button) => !button.hidden)?.focus();
        }
        this.#state = state;
        this.#pace.changed(state?.status === 'running');
    }

    #tell(): void {
        const text = this.#state?.text ?? 'at rest';
        if (this.#standing.textContent !== text) {
            this.#standing.textContent = text;
        }
        const name = `standing ${this.#state?.status ?? 'rest'}`;
        if (this.#standing.className !== name) {
            this.#standing.className = name;
        }
    }

    scale(scale: number): void {
        this.#zoom.textContent = `${Math.round(scale * 100)} %`;
    }
}
