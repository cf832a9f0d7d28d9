// Nodes of the page, made in one expression.

type Attributes = Readonly<Record<string, string | boolean | ((event: Event) => void)>>;

/** What begins with `on` is listened to; false leaves an attribute out, true has no value. */
export function element<Tag extends keyof HTMLElementTagNameMap>(
    tag: Tag,
    attributes: Attributes = {},
    ...children: readonly (Node | string)[]
): HTMLElementTagNameMap[Tag] {
    const node = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) {
        if (typeof value === 'function') {
            node.addEventListener(name.slice(2), value);
        } else if (value !== false) {
            node.setAttribute(name, value === true ? '' : value);
        }
    }
    node.append(...children);
    return node;
}

export function byId(id: string): HTMLElement {
    const node = document.getElementById(id);
    if (!node) {
        throw new Error(`the page has no element "${id}"`);
    }
    return node;
}

/** Sets a text only where it is another one: a reader is told of each change. */
export function setText(node: Node, text: string): void {
    if (node.textContent !== text) {
        node.textContent = text;
    }
}
