// What the mouse and the keyboard do with the elements of the diagram.
import type { FromPage } from './messages.ts';
import type { Tag } from '../protocol.ts';
import { isSwitch, type Live, toggles } from './live.ts';
import { type Direction, neighbour } from './neighbours.ts';
import type { Found, Page } from './page.ts';

/** Who presses longer than this holds a button, which springs back. In milliseconds. */
const HOLD = 350;

const arrows: Readonly<Record<string, Direction>> = {
    ArrowLeft: 'left',
    ArrowRight: 'right',
    ArrowUp: 'up',
    ArrowDown: 'down',
};

export class Hands {
    readonly #page: Page;
    readonly #live: Live;
    readonly #send: (message: FromPage) => void;
    readonly #selected: () => void;

    constructor(view: HTMLElement, page: Page, live: Live, send: (message: FromPage) => void, selected: () => void) {
        this.#page = page;
        this.#live = live;
        this.#send = send;
        this.#selected = selected;
        view.addEventListener('pointerdown', (event) => this.#press(event));
        view.addEventListener('dblclick', (event) => this.#double(event));
        view.addEventListener('keydown', (event) => this.#key(event));
        view.addEventListener('focusin', (event) => {
            const found = page.find(event.target);
            if (found) {
                page.hasFocus(found);
                selected();
            }
        });
    }

    #mainTag({ drawing, part }: Found): Tag | undefined {
        return drawing.tagsOf(part, this.#live)[0];
    }

    /** Shows an element, or one of its operands, in the text. */
    #reveal({ drawing, part }: Found, node: EventTarget | null, focus: boolean): void {
        const operand = part.operands.find((operand) => operand.node === node);
        const [line, character] = operand?.place ?? part.at;
        const [lastLine, end] = operand ? [line, character + operand.text.length] : part.end;
        const from = { line: drawing.first + line, character };
        this.#send({ type: 'reveal', from, to: { line: drawing.first + lastLine, character: end }, focus });
    }

    #press(event: PointerEvent): void {
        const found = this.#page.find(event.target);
        if (!found || event.button !== 0) {
            return;
        }
        event.preventDefault();
        this.#page.select(found, false);
        const tag = this.#mainTag(found);
        const isName = found.part.operands.some(({ node }) => node === event.target);
        if (isName || !isSwitch(found.part.kind, tag) || !toggles(tag)) {
            this.#reveal(found, event.target, false);
            return;
        }
        const { name, value, forced } = tag;
        // What is forced does not spring back.
        let isHeld = false;
        const later = forced
            ? undefined
            : setTimeout(() => {
                  isHeld = true;
                  found.part.node.classList.add('pressed');
                  this.#send({ type: 'set', tag: name, value: !value });
              }, HOLD);
        const end = (up: Event) => {
            clearTimeout(later);
            window.removeEventListener('pointerup', end);
            window.removeEventListener('pointercancel', end);
            window.removeEventListener('blur', end);
            found.part.node.classList.remove('pressed');
            if (isHeld) {
                this.#send({ type: 'set', tag: name, value });
            } else if (up.type === 'pointerup') {
                this.#send({ type: 'toggle', tag: name });
            }
        };
        window.addEventListener('pointerup', end);
        window.addEventListener('pointercancel', end);
        window.addEventListener('blur', end);
    }

    #double(event: MouseEvent): void {
        const found = this.#page.find(event.target);
        const isName = found?.part.operands.some(({ node }) => node === event.target) === true;
        if (found && (isName || !isSwitch(found.part.kind, this.#mainTag(found)))) {
            this.#reveal(found, event.target, true);
        }
    }

    #key(event: KeyboardEvent): void {
        if (event.ctrlKey || event.metaKey || event.altKey) {
            return;
        }
        const found = this.#page.find(document.activeElement);
        const direction = arrows[event.key];
        if (direction) {
            event.preventDefault();
            this.#go(direction);
        } else if (found && this.#act(event.key, event.shiftKey, found)) {
            event.preventDefault();
        }
    }

    #go(direction: Direction): void {
        const spots = this.#page.spots();
        const here = this.#page.selection;
        const from = spots.find(({ found }) => found.part === here?.part);
        const next = from ? spots[neighbour(spots, from, direction)] : spots[0];
        if (next) {
            this.#page.select(next.found);
            this.#selected();
        }
    }

    /** @returns whether the key means something */
    #act(key: string, isShifted: boolean, found: Found): boolean {
        const tag = this.#mainTag(found);
        const isWritable = tag !== undefined && tag.readOnly !== true;
        switch (key) {
            case 'Enter':
            case ' ':
                if (toggles(tag) && found.part.kind === 'contact') {
                    this.#send({ type: 'toggle', tag: tag.name });
                } else {
                    this.#reveal(found, null, false);
                }
                return true;
            case 'F4':
                if (isShifted && tag) {
                    this.#send({ type: 'why', tag: tag.name });
                } else if (toggles(tag)) {
                    this.#send({ type: 'toggle', tag: tag.name });
                }
                return true;
            case 'p':
            case 'P':
                if (toggles(tag)) {
                    this.#send({ type: 'pulse', tag: tag.name });
                }
                return true;
            case 'f':
            case 'F':
                if (isWritable) {
                    this.#send(tag.forced ? { type: 'unforce', tag: tag.name } : { type: 'force', tag: tag.name, value: tag.value });
                }
                return true;
            case 't':
            case 'T':
                this.#reveal(found, null, true);
                return true;
            case 'v':
            case 'V':
                document.querySelector<HTMLElement>('.inspector input[type="text"], .inspector button')?.focus();
                return true;
            case 'Home':
            case 'End': {
                const part = key === 'Home' ? found.drawing.parts[0] : found.drawing.parts.at(-1);
                if (part) {
                    this.#page.select({ drawing: found.drawing, part });
                    this.#selected();
                }
                return true;
            }
            default:
                return false;
        }
    }
}
