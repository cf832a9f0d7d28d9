// The places of a drawing where something can be put in: each wire is one, with room enough for a finger.
const SVG = 'http://www.w3.org/2000/svg';

/** No target is smaller, in pixels of the drawing. */
const LEAST = 24;

interface Wire {
    readonly at: string;
    readonly left: number;
    readonly right: number;
    readonly y: number;
}

/** The horizontal wires outside of elements, the longest piece of each. */
function wiresOf(drawing: Element): Wire[] {
    const wires = new Map<string, Wire>();
    for (const line of drawing.querySelectorAll('line[data-power]')) {
        const at = line.getAttribute('data-point') ?? line.getAttribute('data-power') ?? '';
        const [x1, x2, y1, y2] = ['x1', 'x2', 'y1', 'y2'].map((name) => Number(line.getAttribute(name)));
        if (x1 === undefined || x2 === undefined || y1 === undefined || y1 !== y2 || at.includes(' ') || line.closest('g.element')) {
            continue;
        }
        const wire = { at, left: Math.min(x1, x2), right: Math.max(x1, x2), y: y1 };
        const known = wires.get(at);
        if (!known || known.right - known.left < wire.right - wire.left) {
            wires.set(at, wire);
        }
    }
    return [...wires.values()];
}

/** Adds the places to a drawing, under its elements. @returns their nodes, which are like those of elements */
export function addPoints(drawing: Element): SVGGElement[] {
    const nodes = wiresOf(drawing).map(({ at, left, right, y }) => {
        const width = Math.max(right - left, LEAST);
        const node = document.createElementNS(SVG, 'g');
        node.setAttribute('class', 'element point');
        node.setAttribute('data-at', at);
        node.setAttribute('data-end', at);
        node.setAttribute('data-name', 'Wire');
        const hit = document.createElementNS(SVG, 'rect');
        const box = { x: (left + right - width) / 2, y: y - LEAST / 2, width, height: LEAST };
        for (const [name, value] of Object.entries({ ...box, rx: 3 })) {
            hit.setAttribute(name, String(value));
        }
        hit.setAttribute('class', 'hit');
        const ring = document.createElementNS(SVG, 'circle');
        for (const [name, value] of Object.entries({ cx: (left + right) / 2, cy: y, r: 6 })) {
            ring.setAttribute(name, String(value));
        }
        ring.setAttribute('class', 'ring');
        node.append(hit, ring);
        return node;
    });
    drawing.prepend(...nodes);
    return nodes;
}
