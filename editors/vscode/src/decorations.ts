// Power flow and values drawn over the text; nothing is ever put between its characters.
import * as vscode from 'vscode';

import { Flicker } from '../../../panels/flicker.ts';
import { Pace, withTheRest } from '../../../panels/pace.ts';
import { type Look, type PowerRanges, powerRanges } from '../../../panels/powerRanges.ts';
import type { Label, Power, Tag } from '../../../panels/protocol.ts';
import { Restless } from '../../../panels/restless.ts';
import type { Session } from './session.ts';
import { type Simulation, toRange } from './simulation.ts';

/** Nobody reads a value that changes more often. In milliseconds. */
const VALUES_EVERY = 200;

function style(options: vscode.DecorationRenderOptions): vscode.TextEditorDecorationType {
    return vscode.window.createTextEditorDecorationType({
        rangeBehavior: vscode.DecorationRangeBehavior.ClosedClosed,
        ...options,
    });
}

const powered = { color: new vscode.ThemeColor('ladder.powerOn') };

/** The kinds of a look: of lines that change seldom, and of those that change often. */
interface Kinds {
    readonly calm: vscode.TextEditorDecorationType;
    readonly restless: vscode.TextEditorDecorationType;
}

function kindsOf(options: vscode.DecorationRenderOptions): Kinds {
    return { calm: style(options), restless: style(options) };
}

// Weight and line along with the colours, so that all is seen without colours too: what has power is bold, a contact that
// lets it through is underlined, one that does not is neither; what changes too fast to follow has a dotted line. Bold
// letters are as wide as others in a fixed font.
// The weight is in the style sheet next to the line: a decoration that names a weight itself makes the editor take the letters
// for such of many widths, and measure each of them on the page whenever it is drawn.
const BOLD = 'font-weight: bold';
const looks: Readonly<Record<Look, Kinds>> = {
    on: kindsOf({ ...powered, textDecoration: `none; ${BOLD}` }),
    off: kindsOf({ color: new vscode.ThemeColor('ladder.powerOff') }),
    closedOn: kindsOf({ ...powered, textDecoration: `underline; ${BOLD}` }),
    closed: kindsOf({ ...powered, textDecoration: 'underline' }),
    blocks: kindsOf({ color: new vscode.ThemeColor('ladder.blocks') }),
    flickers: kindsOf({ ...powered, textDecoration: 'underline dotted' }),
    unknown: kindsOf({ color: new vscode.ThemeColor('ladder.powerOff'), fontStyle: 'italic' }),
};
const next = style({
    border: '1px solid',
    borderColor: new vscode.ThemeColor('editor.findMatchHighlightBorder'),
    backgroundColor: new vscode.ThemeColor('editor.stackFrameHighlightBackground'),
});
const values = style({});

const kinds = [...Object.values(looks).flatMap(({ calm, restless }) => [calm, restless]), next, values];

/** What an editor shows of a session, so that nothing is drawn twice. */
interface Canvas {
    readonly session: Session;
    /** Of which of its texts. */
    readonly texts: number;
    readonly drawn: Map<vscode.TextEditorDecorationType, string>;
    powerChanges: number;
    readonly flicker: Flicker;
    /** Whether anything flickers: it may have come to rest without a word of it. */
    flickers: boolean;
    readonly restless: Restless;
}

const canvases = new WeakMap<vscode.TextEditor, Canvas>();

function canvasOf(editor: vscode.TextEditor, session: Session): Canvas {
    const known = canvases.get(editor);
    if (known?.session === session && known.texts === session.texts) {
        return known;
    }
    // Of another text nothing is where it was drawn.
    const canvas: Canvas = {
        session,
        texts: session.texts,
        drawn: new Map(),
        powerChanges: -1,
        flicker: new Flicker(),
        flickers: false,
        restless: new Restless(),
    };
    canvases.set(editor, canvas);
    return canvas;
}

function draw(
    editor: vscode.TextEditor,
    canvas: Canvas,
    kind: vscode.TextEditorDecorationType,
    options: readonly vscode.Range[] | readonly vscode.DecorationOptions[],
    key: string,
): void {
    if (canvas.drawn.get(kind) !== key) {
        canvas.drawn.set(kind, key);
        canvas.session.isDrawing = true;
        editor.setDecorations(kind, options as vscode.DecorationOptions[]);
    }
}

/**
 * The place in the text that a label hangs on, and where the label is from there. If it is shown on a blank line it hangs on
 * that: the editor makes the line again with each value, and takes one under the pointer for one that the pointer has left.
 */
function hangsOn(document: vscode.TextDocument, { at: { line, character }, side, column, after }: Label) {
    if (side === 'between' || side === 'after') {
        const end = document.lineAt(line).range.end;
        return { range: new vscode.Range(end, end), isApart: false, shift: (after ?? column) - end.character };
    }
    const other = line + { above: -1, below: 1 }[side];
    if (other < 0 || other >= document.lineCount || !document.lineAt(other).isEmptyOrWhitespace) {
        const start = new vscode.Position(line, character);
        return { range: new vscode.Range(start, start.translate(0, 1)), isApart: false, shift: column - character };
    }
    const start = document.lineAt(other).range.end;
    return { range: new vscode.Range(start, start), isApart: true, shift: column - start.character };
}

/** A label is over the text, out of its flow: it takes no room in its line. */
function labelOptions(session: Session, label: Label, tag: Tag): vscode.DecorationOptions {
    const { side } = label;
    const index = label.index ?? '';
    const before = { above: index, below: `↑${index}`, between: `${label.tag}: `, after: index }[side];
    const text = `${before}${tag.text}${tag.forced ? '!' : ''}`;
    const { range, isApart, shift } = hangsOn(session.document, label);
    // A cell of the label is as much smaller than one of the text.
    const size = 0.9;
    const place = {
        above: `top: ${isApart ? 0 : '-100%'}`,
        below: `top: ${isApart ? 0 : '100%'}`,
        between: 'top: 0',
        after: 'top: 0',
    }[side];
    const color = tag.forced ? 'ladder.forced' : tag.value === true ? 'ladder.powerOn' : 'ladder.value';
    return {
        range,
        renderOptions: {
            before: {
                // The page would make one blank of two. Below, it could be one of the next line.
                contentText: text.replaceAll(' ', '\u00a0'),
                color: new vscode.ThemeColor(color),
                fontWeight: 'normal',
                fontStyle: 'normal',
                margin: `0 0 0 ${shift / size}ch`,
                textDecoration: `none; position: absolute; z-index: 2; pointer-events: none; white-space: pre; font-size: ${size}em; ${place};`,
            },
        },
    };
}

function paintValues(editor: vscode.TextEditor, canvas: Canvas): void {
    const { session } = canvas;
    const shown = session.labels.flatMap((label) => {
        const tag = session.tag(label.tag);
        return tag ? [{ label, tag }] : [];
    });
    const key = shown.map(({ label: { index, at, side, column }, tag }) => `${at.line}:${at.character} ${side} ${column} ${index} ${tag.text} ${tag.forced}`);
    draw(editor, canvas, values, shown.map(({ label, tag }) => labelOptions(session, label, tag)), key.join(' '));
}

function clear(editor: vscode.TextEditor): void {
    if (canvases.delete(editor)) {
        for (const kind of kinds) {
            editor.setDecorations(kind, []);
        }
    }
}

/** How each line looks, as a text. */
function linesOf(shown: PowerRanges): Map<number, string> {
    const lines = new Map<number, string>();
    for (const [look, ranges] of Object.entries(shown)) {
        for (const { start, end } of ranges) {
            lines.set(start.line, `${lines.get(start.line) ?? ''} ${look} ${start.character}-${end.character}`);
        }
    }
    return lines;
}

function key(ranges: readonly vscode.Range[]): string {
    return ranges.map(({ start, end }) => `${start.line}:${start.character}-${end.character}`).join(' ');
}

function paint(editor: vscode.TextEditor, session: Session, withValues: boolean): void {
    // The editor moves what is drawn with its text.
    if (session.stale) {
        return;
    }
    const canvas = canvasOf(editor, session);
    if (canvas.powerChanges !== session.powerChanges || canvas.flickers) {
        canvas.powerChanges = session.powerChanges;
        const elements = [...session.power.values()].flatMap((line) => [...line.values()]);
        const flickering = canvas.flicker.among(elements, session.state.status === 'running', Date.now());
        canvas.flickers = flickering.size > 0;
        const shown = powerRanges(elements, flickering);
        const restless = canvas.restless.among(linesOf(shown), Date.now());
        for (const [look, ranges] of Object.entries(shown)) {
            const kinds = looks[look as Look];
            for (const kind of [kinds.calm, kinds.restless]) {
                const isOfKind = ({ start }: Power['range']) => restless.has(start.line) === (kind === kinds.restless);
                const places = ranges.filter(isOfKind).map(toRange);
                draw(editor, canvas, kind, places, key(places));
            }
        }
    }
    const following = session.state.next ? [toRange(session.state.next)] : [];
    draw(editor, canvas, next, following, key(following));
    if (withValues) {
        paintValues(editor, canvas);
    }
}

export function showPower(simulation: Simulation): vscode.Disposable {
    const update = (editors: readonly vscode.TextEditor[], withValues: boolean) => {
        for (const editor of editors) {
            const session = simulation.of(editor.document);
            if (session) {
                paint(editor, session, withValues);
            } else {
                clear(editor);
            }
        }
    };
    const all = new Pace(VALUES_EVERY, () => withTheRest(() => update(vscode.window.visibleTextEditors, true)));
    return vscode.Disposable.from(
        ...kinds,
        all,
        simulation.onDidChange((document) => {
            if (!all.changed(simulation.of(document)?.state.status === 'running')) {
                withTheRest(() => update(vscode.window.visibleTextEditors.filter((editor) => editor.document === document), false));
            }
        }),
        vscode.window.onDidChangeVisibleTextEditors(() => all.now()),
    );
}
