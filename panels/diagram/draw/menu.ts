// A menu next to what is selected: all that can be done with it, by single clicks; what cannot be done says why.

/** A line of a menu. */
export interface MenuItem {
    readonly title: string;
    /** The keys that do the same. */
    readonly keys?: string;
    /** Why it cannot be done. */
    readonly why?: string | undefined;
    /** The items before it are of another kind. */
    readonly begins?: boolean;
    run(): void;
}

/** What is left free between a menu and the edge of the window, in pixels. */
const EDGE = 4;

export class Menu {
    readonly #parent: HTMLElement;
    readonly #refused: (why: string) => void;
    #close: (() => void) | undefined;

    constructor(parent: HTMLElement, refused: (why: string) => void) {
        this.#parent = parent;
        this.#refused = refused;
    }

    /** Shows a menu. @param spot from the upper left corner of the page */
    open(label: string, items: readonly MenuItem[], spot: { readonly x: number; readonly y: number }): void {
        this.#close?.();
        const before = document.activeElement;
        const node = document.createElement('div');
        node.className = 'menu';
        node.setAttribute('role', 'menu');
        node.setAttribute('aria-label', label);
        const close = () => {
            this.#close = undefined;
            node.remove();
            if (before instanceof SVGElement || before instanceof HTMLElement) {
                before.focus({ preventScroll: true });
            }
        };
        this.#close = close;
        const buttons = items.map(({ title, keys, why, begins, run }) => {
            const button = document.createElement('button');
            button.type = 'button';
            button.tabIndex = -1;
            button.setAttribute('role', 'menuitem');
            button.classList.toggle('begins', begins === true);
            const name = document.createElement('span');
            name.textContent = title;
            const key = document.createElement('kbd');
            key.textContent = keys ?? '';
            button.append(name, key);
            if (why !== undefined) {
                button.setAttribute('aria-disabled', 'true');
                button.title = why;
                button.setAttribute('aria-description', why);
            }
            button.addEventListener('click', () => {
                close();
                if (why === undefined) {
                    run();
                } else {
                    this.#refused(why);
                }
            });
            return button;
        });
        node.append(...buttons);
        const go = (by: number) => {
            const at = buttons.indexOf(document.activeElement as HTMLButtonElement);
            buttons[(at + by + buttons.length) % buttons.length]?.focus();
        };
        node.addEventListener('keydown', (event) => {
            event.stopPropagation();
            const letter = event.key.toLowerCase();
            if (event.key === 'Escape' || event.key === 'Tab') {
                close();
            } else if (event.key === 'ArrowDown' || event.key === 'ArrowUp') {
                go(event.key === 'ArrowDown' ? 1 : -1);
            } else if (event.key === 'Home' || event.key === 'End') {
                buttons.at(event.key === 'Home' ? 0 : -1)?.focus();
            } else if (letter.length === 1 && letter !== ' ') {
                const at = buttons.indexOf(document.activeElement as HTMLButtonElement);
                const next = [...buttons.slice(at + 1), ...buttons].find((button) => button.textContent?.toLowerCase().startsWith(letter));
                next?.focus();
            } else {
                return;
            }
            event.preventDefault();
        });
        node.addEventListener('focusout', ({ relatedTarget }) => {
            if (!(relatedTarget instanceof Node && node.contains(relatedTarget)) && document.hasFocus() && this.#close === close) {
                this.#close = undefined;
                node.remove();
            }
        });
        this.#parent.append(node);
        // What is higher than the window is in columns, as far as they have room.
        const columns = Math.min(Math.ceil(node.scrollHeight / (window.innerHeight - 2 * EDGE)), Math.floor(window.innerWidth / node.offsetWidth));
        if (columns > 1) {
            node.style.display = 'grid';
            node.style.gridTemplateRows = `repeat(${Math.ceil(items.length / columns)}, auto)`;
        }
        const [width, height] = [node.offsetWidth, node.offsetHeight];
        node.style.left = `${Math.max(EDGE, Math.min(spot.x, window.innerWidth - width - EDGE))}px`;
        node.style.top = `${Math.max(EDGE, Math.min(spot.y, window.innerHeight - height - EDGE))}px`;
        buttons[0]?.focus();
    }
}
