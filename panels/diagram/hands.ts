// What the mouse and the keyboard do with the elements of the diagram: while somebody draws the pen has the word.
import type { FromPage } from './messages.ts';
import type { Tag } from '../protocol.ts';
import { isSwitch, type Live, toggles } from './live.ts';
import type { Drag } from './draw/drag.ts';
import { CONTACT } from './draw/palette.ts';
import { actionOf, type Tools } from './draw/actions.ts';
import type { Band } from './draw/band.ts';
import { isField } from './draw/field.ts';
import { keyOf } from './draw/keyOf.ts';
import { aboutOf } from './draw/selection.ts';
import { type Direction, neighbour } from './neighbours.ts';
import type { Found, Page } from './page.ts';

/** Who presses longer than this holds a button, which springs back. In milliseconds. */
const HOLD = 350;
/** The second press of a double one comes sooner. In milliseconds. */
const DOUBLE = 350;

const arrows: Readonly<Record<string, Direction>> = {
    ArrowLeft: 'left',
    ArrowRight: 'right',
    ArrowUp: 'up',
    ArrowDown: 'down',
};

/** What draws, and when. */
export interface Drawing {
    readonly tools: Tools;
    readonly drag: Drag;
    readonly band: Band;
    /** The margin of a network is pressed. */
    reorder(event: PointerEvent, drawing: Found['drawing']): void;
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
    /** The menu of what was pressed again. */
    #later: ReturnType<typeof setTimeout> | undefined;
    /** What was pressed last was pressed by a finger. */
    #isTouch = false;
    /** What keys have asked for so far. */
    #done: Promise<void> = Promise.resolve();

    constructor(view: HTMLElement, page: Page, live: Live, send: (message: FromPage) => void, selected: () => void, drawing: Drawing) {
        this.#page = page;
        this.#drawing = drawing;
        this.#live = live;
        this.#send = send;
        this.#selected = selected;
        for (const type of ['pointerdown', 'keydown']) {
            // Who does something else wants no menu any more.
            window.addEventListener(type, () => clearTimeout(this.#later), true);
        }
        view.addEventListener('pointerdown', (event) => this.#press(event));
        view.addEventListener('contextmenu', (event) => this.#menu(event));
        view.addEventListener('dblclick', (event) => this.#double(event));
        // While a drawing is replaced nothing has the focus for a moment: keys are meant for the drawing then, too.
        document.addEventListener('keydown', (event) => {
            if (event.target === document.body || (event.target instanceof Node && view.contains(event.target))) {
                this.#key(event);
            }
        });
        view.addEventListener('focusin', (event) => {
            const found = page.find(event.target);
            if (found) {
                page.hasFocus(found);
                selected();
                if (drawing.mode.isDraw) {
                    void drawing.tools.clipboard.focused();
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
            if (this.#drawing.mode.isDraw && event.button === 0) {
                this.#pressBeside(event);
            }
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

    /** What is beside the elements: the margin of a network, and the paper. */
    #pressBeside(event: PointerEvent): void {
        const { tools, band, reorder } = this.#drawing;
        const drawing = this.#page.drawingOf(event.target);
        const [beside] = drawing?.points ?? [];
        const isOn = (name: string) => event.target instanceof Element && event.target.classList.contains(name);
        if (drawing && beside && isOn('add')) {
            event.preventDefault();
            void tools.pen.entry({ drawing, part: beside }, 'below');
        } else if (drawing && isOn('gutter')) {
            event.preventDefault();
            reorder(event, drawing);
        } else if (event.pointerType !== 'touch') {
            tools.pen.selection.forget();
            band.begin(event);
        }
    }

    /** Something is selected, or dragged; what was selected already shows its menu. */
    #take(event: PointerEvent, found: Found): void {
        const { drag, tools } = this.#drawing;
        const { pen } = tools;
        this.#isTouch = event.pointerType === 'touch';
        const wasHere = document.activeElement === found.part.node && !event.shiftKey;
        if (event.shiftKey) {
            pen.selection.extend(found);
        } else if (!pen.selection.has(found)) {
            pen.selection.forget();
        }
        this.#page.select(found, false);
        const isName = found.part.operands.some(({ node }) => node === event.target);
        const pressed = () => {
            if (!found.part.node.isConnected) {
                // What was written meanwhile has changed the drawing.
                return;
            }
            if (wasHere && (!isName || this.#isTouch)) {
                // The second press of a double one draws, and is no menu.
                this.#later = setTimeout(() => tools.menu(found), this.#isTouch ? 0 : DOUBLE);
            } else {
                this.#reveal(found, event.target, false, true);
            }
        };
        clearTimeout(this.#later);
        const about = aboutOf(found);
        const what = about === 'join' ? [found] : pen.selection.all;
        if (about === 'point') {
            window.addEventListener('pointerup', pressed, { once: true });
            return;
        }
        const shown = what.map(({ part }) => part.operands[0]?.text ?? part.name).join(', ');
        drag.begin(event, shown, ({ target, isCopy }) => void pen.drop(what, target, isCopy), pressed, about === 'join');
    }

    #menu(event: MouseEvent): void {
        const found = this.#page.find(event.target);
        if (found && this.#drawing.mode.isDraw) {
            event.preventDefault();
            event.stopPropagation();
            if (!this.#drawing.tools.pen.selection.has(found)) {
                this.#drawing.tools.pen.selection.forget();
            }
            this.#page.select(found, false);
            this.#drawing.tools.menu(found);
        }
    }

    #double(event: MouseEvent): void {
        const found = this.#page.find(event.target);
        if (this.#drawing.mode.isDraw) {
            const { tools } = this.#drawing;
            if (this.#isTouch) {
                // Two presses of a finger are two.
                return;
            }
            clearTimeout(this.#later);
            if (found && event.ctrlKey) {
                this.#reveal(found, event.target, true);
                return;
            }
            const index = found?.part.operands.findIndex(({ node }) => node === event.target) ?? -1;
            if (found?.part.kind === 'point') {
                void tools.pen.draw(CONTACT, found);
            } else if (found && aboutOf(found) === 'element') {
                void tools.pen.operand(found, Math.max(index, 0));
            } else if (found) {
                void actionOf('Enter', aboutOf(found))?.run(tools, found);
            }
            return;
        }
        const isName = found?.part.operands.some(({ node }) => node === event.target) === true;
        if (found && (isName || !isSwitch(found.part.kind, this.#mainTag(found)))) {
            this.#reveal(found, event.target, true);
        }
    }

    #clipboard(type: 'copy' | 'cut' | 'paste', event: ClipboardEvent): void {
        const { tools, mode } = this.#drawing;
        if (!mode.isDraw || isField(event.target)) {
            return;
        }
        event.preventDefault();
        if (type === 'paste') {
            void tools.clipboard.paste(event.clipboardData?.getData('text/plain') ?? '');
        } else {
            tools.clipboard.copied(type === 'cut', event.clipboardData);
        }
    }

    #key(event: KeyboardEvent): void {
        const { tools, mode } = this.#drawing;
        if (isField(event.target)) {
            return;
        }
        const isPlain = !(event.ctrlKey || event.metaKey || event.altKey);
        if (isPlain && event.key.toLowerCase() === 'd') {
            event.preventDefault();
            mode.toggle();
            return;
        }
        if (mode.isDraw) {
            const here = tools.pen.selection.here;
            const action = actionOf(keyOf(event), here ? aboutOf(here) : 'nothing');
            // Copying, cutting and pasting are events of their own, which have the clipboard.
            const isAction = action && action.group !== 'Clipboard';
            if (isAction) {
                // Who types faster than the text changes means the text as it is then.
                this.#done = this.#done.then(() => action.run(tools, tools.pen.selection.here as Found, true));
            }
            if (isAction || (isPlain && this.#drawing.favourite(Number(event.key)))) {
                event.preventDefault();
                return;
            }
        }
        if (!isPlain) {
            return;
        }
        const found = this.#page.find(document.activeElement);
        const direction = arrows[event.key];
        if (direction) {
            event.preventDefault();
            if (mode.isDraw) {
                this.#done = this.#done.then(() => this.#goAlong(direction, event.shiftKey));
            } else {
                this.#go(direction);
            }
        } else if (mode.isDraw) {
            if (found && (event.key === 'Home' || event.key === 'End')) {
                event.preventDefault();
                this.#act(event.key, event.shiftKey, found);
            }
        } else if (found && this.#act(event.key, event.shiftKey, found)) {
            event.preventDefault();
        }
    }

    /** Goes on while somebody draws, with what was selected or without it. */
    #goAlong(direction: Direction, isExtended: boolean): void {
        const { selection } = this.#drawing.tools.pen;
        const found = this.#page.find(document.activeElement);
        if (isExtended && found) {
            selection.extend(found);
        } else {
            selection.forget();
        }
        this.#go(direction);
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
            case 'End':
                this.#page.select(this.#page.endOfLine(found, key === 'Home' ? -1 : 1));
                this.#selected();
                return true;
            default:
                return false;
        }
    }
}
