// What the mouse and the keyboard do with the elements of the diagram: while somebody draws the pen has the word.
import type { FromPage } from './messages.ts';
import type { Tag } from '../protocol.ts';
import { isSwitch, type Live, toggles } from './live.ts';
import type { Drag } from './draw/drag.ts';
import { CONTACT } from './draw/palette.ts';
import { rangeOf, type Pen } from './draw/pen.ts';
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

/** What draws, and when. */
export interface Drawing {
    readonly pen: Pen;
    readonly drag: Drag;
    readonly mode: { readonly isDraw: boolean; toggle(): void };
    /** The number of what is drawn often was pressed. @returns whether there is one */
    favourite(number: number): boolean;
}

export class Hands {
    readonly #page: Page;
    readonly #live: Live;
    readonly #send: (message: FromPage) => void;
    readonly #selected: () => void;
    readonly #drawing: Drawing;

    constructor(view: HTMLElement, page: Page, live: Live, send: (message: FromPage) => void, selected: () => void, drawing: Drawing) {
        this.#page = page;
        this.#drawing = drawing;
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
                if (drawing.mode.isDraw) {
                    void drawing.pen.focused();
                }
            }
        });
        for (const type of ['copy', 'cut', 'paste'] as const) {
            document.addEventListener(type, (event) => this.#clipboard(type, event));
        }
    }

    #mainTag({ drawing, part }: Found): Tag | undefined {
        return drawing.tagsOf(part, this.#live)[0];
    }

    /** Shows an element, or one of its operands, in the text. */
    #reveal({ drawing, part }: Found, node: EventTarget | null, focus: boolean, isQuiet = false): void {
        const operand = part.operands.find((operand) => operand.node === node);
        const [line, character] = operand?.place ?? part.at;
        const [lastLine, end] = operand ? [line, character + operand.text.length] : part.end;
        const from = { line: drawing.first + line, character };
        this.#send({ type: 'reveal', from, to: { line: drawing.first + lastLine, character: end }, focus, ...(isQuiet && { isQuiet }) });
    }

    #press(event: PointerEvent): void {
        const found = this.#page.find(event.target);
        if (!found || event.button !== 0) {
            return;
        }
        event.preventDefault();
        if (this.#drawing.mode.isDraw) {
            this.#take(event, found);
            return;
        }
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

    /** Something is selected, or dragged. */
    #take(event: PointerEvent, found: Found): void {
        const { pen, drag } = this.#drawing;
        if (event.shiftKey) {
            pen.extend(found);
        } else if (!pen.selected.some(({ part }) => part === found.part)) {
            pen.forget();
        }
        this.#page.select(found, false);
        if (found.part.kind === 'point') {
            return;
        }
        const what = pen.selected.map(rangeOf);
        const shown = pen.selected.map(({ part }) => part.operands[0]?.text ?? part.name).join(', ');
        drag.begin(event, shown, ({ target, isCopy }) => void pen.drop(what, target, isCopy), () => this.#reveal(found, event.target, false, true));
    }

    #double(event: MouseEvent): void {
        const found = this.#page.find(event.target);
        if (this.#drawing.mode.isDraw) {
            const index = found?.part.operands.findIndex(({ node }) => node === event.target) ?? -1;
            if (found?.part.kind === 'point') {
                void this.#drawing.pen.draw(CONTACT, found);
            } else if (found) {
                void this.#drawing.pen.operand(found, Math.max(index, 0));
            }
            return;
        }
        const isName = found?.part.operands.some(({ node }) => node === event.target) === true;
        if (found && (isName || !isSwitch(found.part.kind, this.#mainTag(found)))) {
            this.#reveal(found, event.target, true);
        }
    }

    #clipboard(type: 'copy' | 'cut' | 'paste', event: ClipboardEvent): void {
        const { pen, mode } = this.#drawing;
        if (!mode.isDraw || event.target instanceof HTMLInputElement) {
            return;
        }
        event.preventDefault();
        if (type === 'paste') {
            void pen.paste(event.clipboardData?.getData('text/plain') ?? '');
        } else {
            pen.copied(type === 'cut', event.clipboardData);
        }
    }

    #key(event: KeyboardEvent): void {
        const { pen, mode } = this.#drawing;
        if (event.target instanceof HTMLInputElement) {
            return;
        }
        const isPlain = !(event.ctrlKey || event.metaKey || event.altKey);
        if (isPlain && event.key.toLowerCase() === 'd') {
            event.preventDefault();
            mode.toggle();
            return;
        }
        if (mode.isDraw && ((isPlain && this.#drawing.favourite(Number(event.key))) || pen.key(event))) {
            event.preventDefault();
            return;
        }
        if (event.ctrlKey || event.metaKey || event.altKey) {
            return;
        }
        const found = this.#page.find(document.activeElement);
        const direction = arrows[event.key];
        if (direction) {
            event.preventDefault();
            if (mode.isDraw && event.shiftKey && found) {
                pen.extend(found);
            } else if (mode.isDraw) {
                pen.forget();
            }
            this.#go(direction);
        } else if (mode.isDraw) {
            if (event.key === 't' || event.key === 'T') {
                event.preventDefault();
                if (found) {
                    this.#reveal(found, null, true);
                }
            } else if (found && (event.key === 'Home' || event.key === 'End')) {
                event.preventDefault();
                this.#act(event.key, event.shiftKey, found);
            }
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
