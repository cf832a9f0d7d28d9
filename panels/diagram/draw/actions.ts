// What can be done while somebody draws: one table for keys, for the menu of what is selected, and for the list of keys.
import type { Found } from '../page.ts';
import type { Clipboard } from './clipboard.ts';
import type { Findings } from './findings.ts';
import { CLOSED_CONTACT, CONTACT, type Palette } from './palette.ts';
import type { Pen } from './pen.ts';
import { commentLines } from './points.ts';
import { type About, rangeOf } from './selection.ts';

/** What draws. */
export interface Tools {
    readonly pen: Pen;
    readonly clipboard: Clipboard;
    readonly palette: Pick<Palette, 'open' | 'titleOf'>;
    readonly findings: Pick<Findings, 'go' | 'menu'>;
    /** Shows something in the text. */
    reveal(found: Found): void;
    /** Shows the menu of what is selected, and the list of keys. */
    menu(found: Found): void;
    help(): void;
}

export interface Action {
    /** As `keyOf` names them; the first is shown. */
    readonly keys: readonly string[];
    readonly title: string;
    /** What it is about; for the first network nothing has to be there. */
    readonly on: readonly (About | 'nothing')[];
    /** The heading in the list of keys, and the part of the menu. */
    readonly group: 'Draw' | 'Change' | 'Networks' | 'Clipboard' | 'Go';
    /** What the server calls it, if it may be impossible. */
    readonly offer?: string;
    /** Not in the menu. */
    readonly isHidden?: true;
    run(tools: Tools, found: Found, isKey?: boolean): Promise<void> | void;
}

/** The heads that one key makes of each other. */
const OPPOSITE: Readonly<Record<string, string>> = { '[ ]': '[/]', '[/]': '[ ]', '( )': '(/)', '(/)': '( )' };
/** The kinds that one key goes through. */
const KINDS: readonly (readonly string[])[] = [['[ ]', '[/]', '[P]', '[N]'], ['( )', '(/)', '(S)', '(R)', '(P)', '(N)']];

function nextKind(head: string): string | undefined {
    const kinds = KINDS.find((kinds) => kinds.includes(head));
    return kinds?.[(kinds.indexOf(head) + 1) % kinds.length];
}

/** What a contact or coil with this head can become. */
export function kindsOf(head: string): readonly string[] {
    return KINDS.find((kinds) => kinds.includes(head))?.filter((kind) => kind !== head) ?? [];
}

const isCoil = (head: string) => head.startsWith('(');
const PLACES = ['element', 'point', 'note'] as const;
const ALL = ['element', 'point', 'note', 'join'] as const;
const THINGS = ['element', 'note'] as const;

export const ACTIONS: readonly Action[] = [
    { keys: ['C'], title: 'Open contact', on: PLACES, group: 'Draw', offer: 'insert', run: ({ pen }, found) => pen.draw(CONTACT, found) },
    { keys: ['Shift+C'], title: 'Closed contact', on: PLACES, group: 'Draw', offer: 'insert', run: ({ pen }, found) => pen.draw(CLOSED_CONTACT, found) },
    {
        keys: [],
        title: 'Open contact before it',
        on: ['element'],
        group: 'Draw',
        offer: 'insert',
        run: async ({ pen }, found) => {
            const at = (await pen.offer({ what: [rangeOf(found)] }))?.points?.before;
            await (at && pen.draw(CONTACT, found, { at }));
        },
    },
    { keys: ['B'], title: 'Contact in parallel, below', on: ['element'], group: 'Draw', offer: 'parallelBelow', run: ({ pen }) => pen.branch(CONTACT, 'below') },
    { keys: ['Shift+B'], title: 'Contact in parallel, above', on: ['element'], group: 'Draw', offer: 'parallelAbove', run: ({ pen }) => pen.branch(CONTACT, 'above') },
    { keys: ['Q'], title: 'Coil at the end of the line', on: PLACES, group: 'Draw', run: ({ pen }, found) => pen.coil(found) },
    { keys: ['F'], title: 'Timer, counter or other block…', on: PLACES, group: 'Draw', offer: 'insert', run: ({ palette }) => palette.open() },
    { keys: ['I', 'Insert'], title: 'Quick entry…', on: PLACES, group: 'Draw', offer: 'insert', run: ({ pen }, found) => pen.entry(found, 'here') },
    { keys: ['\\'], title: 'Begin a branch', on: ['point'], group: 'Draw', run: ({ pen }, found) => pen.beginBranch(found) },
    { keys: ['/'], title: 'End the branch', on: ['point'], group: 'Draw', run: ({ pen }, found) => pen.closeBranch(found, CONTACT) },

    { keys: ['Enter'], title: 'Tag or operands…', on: ['element'], group: 'Change', offer: 'operand', run: ({ pen }, found) => pen.operand(found) },
    {
        keys: ['Enter'],
        title: 'Change the comment…',
        on: ['note'],
        group: 'Change',
        run: ({ pen }, found) => {
            const isInWire = found.drawing.piece.kind === 'network';
            const text = isInWire ? found.part.name.replace(/^Comment /, '') : commentLines(found.drawing.node).join('\n');
            return pen.line(found, { label: 'Comment', text, kind: isInWire ? 'line' : 'lines' }, (text) => ({ op: 'comment', what: rangeOf(found), text }));
        },
    },
    { keys: ['/'], title: 'Open or closed', on: ['element'], group: 'Change', offer: 'head', run: ({ pen }, found) => pen.head(found, (head) => OPPOSITE[head]) },
    { keys: ['E'], title: 'Next kind', on: ['element'], group: 'Change', offer: 'head', run: ({ pen }, found) => pen.head(found, nextKind) },
    { keys: ['Shift+E'], title: 'Open or closed', on: ['element'], group: 'Change', isHidden: true, run: ({ pen }, found) => pen.head(found, (head) => OPPOSITE[head]) },
    { keys: ['S'], title: 'Set coil', on: ['element'], group: 'Change', offer: 'head', run: ({ pen }, found) => pen.head(found, (head) => (isCoil(head) ? '(S)' : undefined)) },
    { keys: ['R'], title: 'Reset coil', on: ['element'], group: 'Change', offer: 'head', run: ({ pen }, found) => pen.head(found, (head) => (isCoil(head) ? '(R)' : undefined)) },
    {
        keys: ['F2'],
        title: 'Rename the tag everywhere…',
        on: ['element'],
        group: 'Change',
        run: ({ pen }, found) => {
            const [operand] = found.part.operands;
            const start = operand && { line: found.drawing.first + operand.place[0], character: operand.place[1] };
            return start && pen.line(found, { label: 'New name of the tag', text: operand.text }, (text) => ({ op: 'rename', what: { start, end: start }, text }));
        },
    },
    { keys: ['Alt+ArrowLeft'], title: 'Move to the left', on: THINGS, group: 'Change', isHidden: true, run: ({ pen }, found) => pen.step(found, 'left') },
    { keys: ['Alt+ArrowRight'], title: 'Move to the right', on: THINGS, group: 'Change', isHidden: true, run: ({ pen }, found) => pen.step(found, 'right') },
    { keys: ['Alt+ArrowUp'], title: 'Move up a line', on: THINGS, group: 'Change', isHidden: true, run: ({ pen }, found) => pen.step(found, 'up') },
    { keys: ['Alt+ArrowDown'], title: 'Move down a line', on: THINGS, group: 'Change', isHidden: true, run: ({ pen }, found) => pen.step(found, 'down') },
    { keys: ['Alt+ArrowLeft'], title: 'Move the end of the branch to the left', on: ['join'], group: 'Change', run: ({ pen }, found) => pen.step(found, 'left') },
    { keys: ['Alt+ArrowRight'], title: 'Move the end of the branch to the right', on: ['join'], group: 'Change', run: ({ pen }, found) => pen.step(found, 'right') },
    { keys: ['Delete', 'Backspace'], title: 'Delete', on: THINGS, group: 'Change', offer: 'delete', run: ({ pen }) => pen.remove() },

    { keys: ['Ctrl+X'], title: 'Take up, or cut', on: THINGS, group: 'Clipboard', offer: 'move', run: ({ clipboard }) => clipboard.take(true) },
    { keys: ['Ctrl+C'], title: 'Copy', on: THINGS, group: 'Clipboard', run: ({ clipboard }) => clipboard.take(false) },
    { keys: ['Ctrl+V'], title: 'Put down, or paste', on: PLACES, group: 'Clipboard', run: ({ clipboard }) => clipboard.paste() },

    { keys: ['N'], title: 'New network below…', on: [...ALL, 'nothing'], group: 'Networks', run: ({ pen }, found) => pen.entry(found, 'below') },
    { keys: ['Shift+N'], title: 'New network above…', on: [...ALL, 'nothing'], group: 'Networks', run: ({ pen }, found) => pen.entry(found, 'above') },
    { keys: ['#'], title: 'Comment above the network…', on: ALL, group: 'Networks', offer: 'comment', run: ({ pen }, found) => pen.line(found, { label: 'Comment above the network', kind: 'lines' }, (text) => ({ op: 'comment', network: found.drawing.first, text })) },
    { keys: ['K'], title: 'Split the network here', on: ['element', 'point'], group: 'Networks', offer: 'split', run: ({ pen }, found) => pen.placeOf(found).then((at) => at && pen.edit({ op: 'split', at })) },
    {
        keys: ['J'],
        title: 'Join with the network below',
        on: ALL,
        group: 'Networks',
        offer: 'merge',
        run: ({ pen }, { drawing: { first } }) => {
            const networks = pen.page.networks();
            const next = networks[networks.indexOf(first) + 1];
            return next === undefined ? pen.voice.refused('There is no network below this one') : pen.edit({ op: 'merge', networks: [first, next] });
        },
    },
    { keys: ['Y'], title: 'Duplicate the network', on: ALL, group: 'Networks', offer: 'duplicate', run: ({ pen }, { drawing }) => pen.edit({ op: 'duplicate', network: drawing.first }) },
    { keys: ['Alt+Shift+ArrowUp'], title: 'Move the network up', on: ALL, group: 'Networks', offer: 'moveUp', run: ({ pen }, found) => pen.moveNetwork(found, -1) },
    { keys: ['Alt+Shift+ArrowDown'], title: 'Move the network down', on: ALL, group: 'Networks', offer: 'moveDown', run: ({ pen }, found) => pen.moveNetwork(found, 1) },
    {
        keys: ['Shift+Delete', 'Shift+Backspace'],
        title: 'Delete the network',
        on: ALL,
        group: 'Networks',
        run: ({ pen }, { drawing }) => pen.edit({ op: 'delete', network: drawing.first }),
    },

    { keys: ['PageDown'], title: 'Next network', on: [...ALL, 'nothing'], group: 'Go', isHidden: true, run: ({ pen }) => pen.page.goToNetwork(1) },
    { keys: ['PageUp'], title: 'Previous network', on: [...ALL, 'nothing'], group: 'Go', isHidden: true, run: ({ pen }) => pen.page.goToNetwork(-1) },
    { keys: ['Ctrl+Home'], title: 'First network', on: [...ALL, 'nothing'], group: 'Go', isHidden: true, run: ({ pen }) => pen.page.goToNetwork(-Infinity) },
    { keys: ['Ctrl+End'], title: 'Last network', on: [...ALL, 'nothing'], group: 'Go', isHidden: true, run: ({ pen }) => pen.page.goToNetwork(Infinity) },
    { keys: ['A'], title: 'Select the next larger group', on: ['element'], group: 'Go', run: ({ pen }, found) => pen.larger(found) },
    { keys: ['Ctrl+A'], title: 'Select the network', on: ALL, group: 'Go', run: ({ pen }, { drawing }) => pen.selection.set(drawing.parts.map((part) => ({ drawing, part }))) },
    {
        keys: ['Escape'],
        title: 'Give up',
        on: ALL,
        group: 'Go',
        isHidden: true,
        run: ({ pen, clipboard }) => {
            clipboard.putDown();
            pen.endBranch();
            pen.selection.forget();
        },
    },
    { keys: ['Ctrl+Z'], title: 'Undo', on: [...ALL, 'nothing'], group: 'Go', run: ({ pen }, _, isKey = false) => pen.history('undo', isKey) },
    { keys: ['Ctrl+Y', 'Ctrl+Shift+Z'], title: 'Redo', on: [...ALL, 'nothing'], group: 'Go', run: ({ pen }, _, isKey = false) => pen.history('redo', isKey) },
    { keys: ['F8'], title: 'Next finding', on: [...ALL, 'nothing'], group: 'Go', run: ({ findings }) => findings.go(1) },
    { keys: ['Shift+F8'], title: 'Previous finding', on: [...ALL, 'nothing'], group: 'Go', run: ({ findings }) => findings.go(-1) },
    { keys: ['Ctrl+.'], title: 'Fixes…', on: ['element'], group: 'Go', run: ({ findings }, found) => findings.menu(found) },
    { keys: ['T'], title: 'Show in the text', on: ALL, group: 'Go', run: ({ reveal }, found) => reveal(found) },
    { keys: ['Space', 'Shift+F10', 'ContextMenu'], title: 'Menu of what is selected', on: ALL, group: 'Go', isHidden: true, run: ({ menu }, found) => menu(found) },
    { keys: ['?'], title: 'This list', on: [...ALL, 'nothing'], group: 'Go', isHidden: true, run: ({ help }) => help() },
];

/** The action of a key. */
export function actionOf(keys: string, about: About | 'nothing'): Action | undefined {
    return ACTIONS.find((action) => action.keys.includes(keys) && action.on.includes(about));
}
