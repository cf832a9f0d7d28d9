// Power and values drawn over the text; nothing is ever put between its characters.
import { StateEffect, StateField, type Extension, type Range as Marked } from '@codemirror/state';
import { Decoration, type DecorationSet, EditorView, layer, type LayerMarker } from '@codemirror/view';

import { toggles } from '../../panels/diagram/live.ts';
import { Flicker } from '../../panels/flicker.ts';
import { Pace } from '../../panels/pace.ts';
import { type Look, powerRanges } from '../../panels/powerRanges.ts';
import type { Label, Range, Tag } from '../../panels/protocol.ts';
import type { Session } from '../../panels/session.ts';
import type { OpenText } from './openText.ts';
import type { Simulation } from './simulation.ts';

/** Nobody reads a value that changes more often. In milliseconds. */
const VALUES_EVERY = 200;
/** A letter of a value is as much smaller than one of the text. */
const SIZE = 0.9;

const setPower = StateEffect.define<DecorationSet>();

const powerField = StateField.define<DecorationSet>({
    create: () => Decoration.none,
    update(value, { changes, effects, docChanged }) {
        const moved = docChanged ? value.map(changes) : value;
        return effects.reduce((now, effect) => (effect.is(setPower) ? effect.value : now), moved);
    },
    provide: (field) => EditorView.decorations.from(field),
});

const looks: Readonly<Record<Look, Decoration>> = {
    on: Decoration.mark({ class: 'power on' }),
    off: Decoration.mark({ class: 'power off' }),
    closedOn: Decoration.mark({ class: 'power on closed' }),
    closed: Decoration.mark({ class: 'power closed' }),
    blocks: Decoration.mark({ class: 'power blocks' }),
    flickers: Decoration.mark({ class: 'power flickers' }),
};
const next = Decoration.mark({ class: 'next' });
const stops = Decoration.mark({ class: 'stops' });
const pressed = Decoration.mark({ class: 'switch', attributes: { title: 'Click to switch it' } });

interface Value {
    readonly label: Label;
    readonly tag: Tag;
}

const setValues = StateEffect.define<readonly Value[]>();

const valuesField = StateField.define<readonly Value[]>({
    create: () => [],
    update(value, { effects }) {
        return effects.reduce((now, effect) => (effect.is(setValues) ? effect.value : now), value);
    },
});

/** A value, at a place of the drawing. */
class ValueMarker implements LayerMarker {
    readonly #text: string;
    readonly #className: string;
    readonly #left: number;
    readonly #top: number;

    constructor(text: string, className: string, left: number, top: number) {
        this.#text = text;
        this.#className = className;
        this.#left = left;
        this.#top = top;
    }

    eq(other: ValueMarker): boolean {
        return this.#text === other.#text && this.#className === other.#className && this.#left === other.#left && this.#top === other.#top;
    }

    draw(): HTMLElement {
        const node = document.createElement('div');
        this.#put(node);
        return node;
    }

    update(node: HTMLElement): boolean {
        this.#put(node);
        return true;
    }

    #put(node: HTMLElement): void {
        node.className = this.#className;
        node.textContent = this.#text;
        node.style.left = `${this.#left}px`;
        node.style.top = `${this.#top}px`;
    }
}

function marker(view: EditorView, { label: { tag: name, index = '', at, side, column, after }, tag }: Value): ValueMarker[] {
    const { doc } = view.state;
    if (at.line >= doc.lines) {
        return [];
    }
    const isAfter = side === 'between' || side === 'after';
    const before = { above: index, below: `↑${index}`, between: `${name}: `, after: index }[side];
    const line = at.line + 1 + { above: -1, below: 1, between: 0, after: 0 }[side];
    const block = view.lineBlockAt(doc.line(Math.min(Math.max(line, 1), doc.lines)).from);
    const content = view.contentDOM.getBoundingClientRect();
    const scroller = view.scrollDOM.getBoundingClientRect();
    const left = content.left - scroller.left + view.scrollDOM.scrollLeft + 6;
    const letters = isAfter ? (after ?? column) : column;
    const top = line < 1 ? view.documentPadding.top - view.defaultLineHeight : block.top + view.documentPadding.top;
    const className = `value ${tag.forced ? 'forced' : tag.value === true ? 'on' : ''}`;
    return [new ValueMarker(`${before}${tag.text}${tag.forced ? '!' : ''}`, className, left + letters * view.defaultCharacterWidth, top)];
}

const values = layer({
    above: true,
    class: 'values',
    update: ({ docChanged, geometryChanged, transactions }) =>
        docChanged || geometryChanged || transactions.some(({ effects }) => effects.some((effect) => effect.is(setValues))),
    markers: (view) => view.state.field(valuesField).flatMap((value) => marker(view, value)),
});

/** The contact of an input is a switch: the part in front of its operand. */
function switches(session: Session, text: OpenText): Marked<Decoration>[] {
    const found: Marked<Decoration>[] = [];
    for (const operands of session.operands.values()) {
        for (const { range, block, tags } of operands) {
            const tag = session.tag(tags[0] ?? '');
            const isContact = session.power.get(block.start.line)?.get(block.start.character)?.contact !== undefined;
            const [from, to] = [text.offset(block.start), text.offset(range.start)];
            if (isContact && toggles(tag) && tag.role === 'input' && from < to && range.start.line === block.start.line) {
                found.push(pressed.range(from, to));
            }
        }
    }
    return found;
}

/** What keeps power from a tag, as a person has asked. */
export interface Stopping {
    readonly ranges: () => readonly Range[];
}

export function showPower(text: OpenText, simulation: Simulation, stopping: Stopping): void {
    let flicker = new Flicker();
    let drawn = '';
    let shownValues = '';
    const range = (decoration: Decoration, { start, end }: Range): Marked<Decoration>[] => {
        const [from, to] = [text.offset(start), text.offset(end)];
        return from < to ? [decoration.range(from, to)] : [];
    };
    const draw = (withValues: boolean) => {
        const { session } = simulation;
        if (session?.stale) {
            // The editor moves what is drawn with its text; values are where they were.
            return;
        }
        const effects: StateEffect<unknown>[] = [];
        const elements = session ? [...session.power.values()].flatMap((line) => [...line.values()]) : [];
        const flickering = flicker.among(elements, simulation.isRunning, Date.now());
        const ranges = powerRanges(elements, flickering);
        const following = session?.state.next ? [session.state.next] : [];
        const marks = [
            ...Object.entries(ranges).flatMap(([look, all]) => all.flatMap((it) => range(looks[look as Look], it))),
            ...following.flatMap((it) => range(next, it)),
            ...(session ? stopping.ranges() : []).flatMap((it) => range(stops, it)),
            ...(session ? switches(session, text) : []),
        ];
        const key = `${session?.texts} ${marks.map(({ from, to, value }) => `${from}-${to} ${String(value.spec.class)}`).join()}`;
        if (key !== drawn) {
            drawn = key;
            effects.push(setPower.of(Decoration.set(marks, true)));
        }
        if (withValues || !session) {
            const all = (session?.labels ?? []).flatMap((label) => {
                const tag = session?.tag(label.tag);
                return tag ? [{ label, tag }] : [];
            });
            const valueKey = all.map(({ label, tag }) => `${label.at.line}:${label.column} ${label.side} ${label.index} ${tag.text} ${tag.forced}`).join();
            if (valueKey !== shownValues) {
                shownValues = valueKey;
                effects.push(setValues.of(all));
            }
        }
        if (effects.length > 0) {
            text.view.dispatch({ effects });
        }
        if (!session) {
            flicker = new Flicker();
        }
    };
    const pace = new Pace(VALUES_EVERY, () => draw(true));
    simulation.onChange(() => {
        if (!pace.changed(simulation.isRunning)) {
            draw(false);
        }
    });
}

/** What is drawn of power is the editor's own. */
export function powerIn(simulation: () => Simulation, place: (offset: number) => Range['start']): Extension {
    return [
        powerField,
        valuesField,
        values,
        EditorView.updateListener.of(({ docChanged, viewportChanged }) => {
            if (docChanged) {
                simulation().edited();
            } else if (viewportChanged) {
                simulation().look();
            }
        }),
        EditorView.domEventHandlers({
            // Not a click: the editor may make the line again between the press and its end.
            mousedown(event, view) {
                const isPlain = event.button === 0 && !event.shiftKey && !event.ctrlKey && !event.metaKey && !event.altKey;
                const isSwitch = isPlain && event.target instanceof Element && event.target.closest('.switch') !== null;
                const offset = isSwitch ? view.posAtCoords(event) : null;
                const tag = offset === null ? undefined : simulation().operandAt(place(offset))?.tags[0];
                if (tag === undefined) {
                    return false;
                }
                void simulation().toggle(tag);
                return true;
            },
        }),
        EditorView.theme({
            '.values': { pointerEvents: 'none' },
            '.value': { position: 'absolute', whiteSpace: 'pre', fontSize: `${SIZE}em`, color: 'var(--value)' },
            '.value.on': { color: 'var(--on)' },
            '.value.forced': { color: 'var(--forced)', fontWeight: 'bold' },
            '.power.on, .power.on *': { color: 'var(--on)', fontWeight: 'bold' },
            '.power.off, .power.off *': { color: 'var(--off)' },
            '.power.closed, .power.closed *': { color: 'var(--on)' },
            '.power.closed': { textDecoration: 'underline', textUnderlineOffset: '3px' },
            '.power.blocks, .power.blocks *': { color: 'var(--blocks)' },
            '.power.flickers, .power.flickers *': { color: 'var(--on)' },
            '.power.flickers': { textDecoration: 'underline dotted' },
            '.next': { outline: '1px solid var(--focus)', backgroundColor: 'var(--next)' },
            '.stops': { outline: '1px dashed var(--blocks)' },
            '.switch': { cursor: 'pointer', backgroundColor: 'var(--switch)', borderRadius: '3px', boxShadow: 'inset 0 0 0 1px var(--edge)' },
        }),
    ];
}
