// What a picture consists of, and how it gets onto the page: of what is there already only that is touched which is another.

const SVG = 'http://www.w3.org/2000/svg';

/** An element of a picture: its name, its attributes, its text, and what is said of it where a pointer rests. */
export interface Shape {
    readonly name: keyof SVGElementTagNameMap;
    readonly attributes: Readonly<Record<string, string | number>>;
    readonly text?: string | undefined;
    readonly title?: string;
}

export function shape(name: Shape['name'], attributes: Shape['attributes'], text?: string): Shape {
    return { name, attributes, text };
}

/** Gives an element an attribute, unless it has it: the page lays out and paints again whatever is given something. */
export function put(element: Element, name: string, value: string | number): void {
    const text = String(value);
    if (element.getAttribute(name) !== text) {
        element.setAttribute(name, text);
    }
}

export function setText(element: Element, text: string): void {
    if (element.textContent !== text) {
        element.textContent = text;
    }
}

function make(name: string): SVGElement {
    return document.createElementNS(SVG, name) as SVGElement;
}

function dress(element: Element, { attributes, text, title }: Shape): void {
    for (const name of element.getAttributeNames()) {
        if (!(name in attributes)) {
            element.removeAttribute(name);
        }
    }
    for (const [name, value] of Object.entries(attributes)) {
        put(element, name, value);
    }
    if (title === undefined) {
        setText(element, text ?? '');
    } else if (element.textContent !== title) {
        const said = make('title');
        said.textContent = title;
        element.replaceChildren(said);
    }
}

/** Shows these shapes in a picture, and nothing else. */
export function draw(picture: Element, shapes: readonly Shape[]): void {
    const known = [...picture.children];
    shapes.forEach((shape, index) => {
        const before = known[index];
        const element = before?.tagName === shape.name ? before : make(shape.name);
        dress(element, shape);
        if (!before) {
            picture.append(element);
        } else if (element !== before) {
            before.replaceWith(element);
        }
    });
    for (const element of known.slice(shapes.length)) {
        element.remove();
    }
}
