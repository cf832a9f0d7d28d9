// What a drawing has besides its elements for those who draw: places in wires, lines where branches begin and end, comments.
// Each has room enough for a finger.
const SVG = 'http://www.w3.org/2000/svg';

/** No target is smaller, in pixels of the drawing. */
const LEAST = 24;
/** How far the end of a branch is from the line above and the one below: lines are so near that it reaches over their places. */
export const BESIDE_JOIN = 9.5;
/** How wide a letter of a comment is, and how high, in pixels of the drawing. */
const LETTER = [8, 16] as const;
/** How far the lines of a comment are apart, in pixels of the drawing. */
const LINE = 17;

/** What such a node is: somewhere to put something in, the end of branches, a comment. */
type Kind = 'point' | 'join' | 'note';

interface Box {
    readonly x: number;
    readonly y: number;
    readonly width: number;
    readonly height: number;
}

function numbers(node: Element, ...names: string[]): number[] {
    return names.map((name) => Number(node.getAttribute(name)));
}

function shape(name: string, attributes: Readonly<Record<string, string | number>>): SVGElement {
    const node = document.createElementNS(SVG, name);
    for (const [name, value] of Object.entries(attributes)) {
        node.setAttribute(name, String(value));
    }
    return node;
}

/** A node like those of elements. */
function nodeOf(kind: Kind, name: string, [at, end]: readonly [string, string], box: Box): SVGGElement {
    const node = document.createElementNS(SVG, 'g');
    node.setAttribute('class', `element ${kind}`);
    node.setAttribute('data-at', at);
    node.setAttribute('data-end', end);
    node.setAttribute('data-name', name);
    node.append(shape('rect', { ...box, rx: 3, class: 'hit' }));
    return node;
}

/** A box around a place that is as large as a target is at least. */
function around(x: number, y: number, width = LEAST): Box {
    return { x: x - Math.max(width, LEAST) / 2, y: y - LEAST / 2, width: Math.max(width, LEAST), height: LEAST };
}

function point(at: string, x: number, y: number, width?: number): SVGGElement {
    const node = nodeOf('point', 'Wire', [at, at], around(x, y, width));
    node.append(shape('circle', { cx: x, cy: y, r: 6, class: 'ring' }));
    return node;
}

/** Places in the horizontal wires outside of elements, in the longest piece of each. */
function wires(drawing: Element): SVGGElement[] {
    const found = new Map<string, { left: number; right: number; y: number }>();
    for (const line of drawing.querySelectorAll('line[data-point]')) {
        const at = line.getAttribute('data-point') ?? '';
        const [x1 = 0, x2 = 0, y = 0] = numbers(line, 'x1', 'x2', 'y1');
        const wire = { left: Math.min(x1, x2), right: Math.max(x1, x2), y };
        const known = found.get(at);
        if (!line.closest('g.element') && (!known || known.right - known.left < wire.right - wire.left)) {
            found.set(at, wire);
        }
    }
    return [...found].map(([at, { left, right, y }]) => point(at, (left + right) / 2, y, right - left));
}

/** The lines from rung to rung, and the places on them that have no wire: those are at their upper ends. */
function joins(drawing: Element): SVGGElement[] {
    return [...drawing.querySelectorAll('line[data-joins]')].flatMap((line) => {
        const [x = 0, top = 0, bottom = 0] = numbers(line, 'x1', 'y1', 'y2');
        const at = line.getAttribute('data-joins')?.split(/[ ,]/)[0] ?? '';
        const tight = line.getAttribute('data-tight')?.split(' ') ?? [];
        const box = { x: x - LEAST / 2, y: top + BESIDE_JOIN, width: LEAST, height: Math.max(bottom - top - 2 * BESIDE_JOIN, LEAST) };
        const join = nodeOf('join', 'End of a branch', [at, at], box);
        join.append(shape('path', { d: `M ${x} ${box.y} V ${box.y + box.height}`, class: 'grip' }));
        return [join, ...tight.map((at) => point(at, x, top))];
    });
}

/** The comments in wires, as what can be selected. */
function comments(drawing: Element): SVGGElement[] {
    return [...drawing.querySelectorAll('text.comment[data-at]')].map((text) => {
        const [x = 0, y = 0] = numbers(text, 'x', 'y');
        const [at, end] = [text.getAttribute('data-at') ?? '', text.getAttribute('data-end') ?? ''];
        const words = text.textContent ?? '';
        const box = around(x, y - LETTER[1] / 4, words.length * LETTER[0]);
        return nodeOf('note', `Comment ${words}`, [at, end], box);
    });
}

/** The lines of what a comment says that a piece of the diagram is. */
export function commentLines(drawing: Element): string[] {
    const lines: string[] = [];
    for (const text of drawing.querySelectorAll('text')) {
        lines[Math.round((numbers(text, 'y')[0] ?? 0) / LINE) - 1] = text.textContent ?? '';
    }
    // A blank line has no text.
    return Array.from(lines, (line) => line ?? '');
}

/** The comment that a piece of the diagram is, as what can be selected. @param last the last of its lines, from 0 */
export function addComment(drawing: Element, last: number): SVGGElement[] {
    const [width = 0, height = 0] = numbers(drawing, 'width', 'height');
    const words = commentLines(drawing).join(' ');
    const node = nodeOf('note', `Comment ${words}`, ['0:0', `${last}:1`], { x: 8, y: 0, width: Math.max(width - 8, LEAST), height });
    drawing.prepend(node);
    return [node];
}

/** Adds them to the drawing of a network, under its elements. */
export function addPoints(drawing: Element): SVGGElement[] {
    const nodes = [...wires(drawing), ...joins(drawing), ...comments(drawing)];
    drawing.prepend(...nodes);
    return nodes;
}
