// The switch between operating a program and drawing it: nothing is drawn in the one, and nothing operated in the other.
export type Mode = 'operate' | 'draw';

export class ModeSwitch {
    readonly node = document.createElement('span');
    readonly #buttons = new Map<Mode, HTMLButtonElement>();
    readonly #changed: (mode: Mode) => void;
    #mode: Mode = 'operate';

    constructor(changed: (mode: Mode) => void) {
        this.#changed = changed;
        this.node.className = 'modes';
        this.node.setAttribute('role', 'group');
        this.node.setAttribute('aria-label', 'What the mouse and keys do');
        for (const [mode, label, title] of [
            ['operate', 'Operate', 'Switches, forces and values of the simulated program (D)'],
            ['draw', 'Draw', 'Change the program by mouse and keys (D)'],
        ] as const) {
            const button = document.createElement('button');
            button.type = 'button';
            button.textContent = label;
            button.title = title;
            button.addEventListener('click', () => this.set(mode));
            this.#buttons.set(mode, button);
            this.node.append(button);
        }
        this.#show();
    }

    get isDraw(): boolean {
        return this.#mode === 'draw';
    }

    set(mode: Mode): void {
        if (mode !== this.#mode) {
            this.#mode = mode;
            this.#show();
            this.#changed(mode);
        }
    }

    toggle(): void {
        this.set(this.isDraw ? 'operate' : 'draw');
    }

    #show(): void {
        this.#buttons.forEach((button, mode) => button.setAttribute('aria-pressed', String(mode === this.#mode)));
    }
}
