// What the server says in Markdown may hold what a program's comments hold: only what formats a text is let through.

const ALLOWED = new Set([
    'A', 'B', 'BLOCKQUOTE', 'BR', 'CODE', 'DEL', 'EM', 'H1', 'H2', 'H3', 'H4', 'HR', 'I', 'LI', 'OL', 'P', 'PRE', 'SPAN', 'STRONG',
    'TABLE', 'TBODY', 'TD', 'TH', 'THEAD', 'TR', 'UL',
]);
/** Classes of colours are the editor's own. */
const ATTRIBUTES = new Set(['class', 'href']);
/** Addresses on the web, and places in the program. */
const LINKS = /^(https?:\/\/|file:\/\/\/work\/)/;

export function sanitized(html: string): string {
    const { body } = new DOMParser().parseFromString(html, 'text/html');
    for (const node of [...body.querySelectorAll('*')]) {
        if (!ALLOWED.has(node.tagName)) {
            // Its text stays.
            node.replaceWith(document.createTextNode(node.textContent ?? ''));
            continue;
        }
        for (const { name, value } of [...node.attributes]) {
            if (!ATTRIBUTES.has(name) || (name === 'href' && !LINKS.test(value))) {
                node.removeAttribute(name);
            }
        }
        if (node.getAttribute('href')?.startsWith('http')) {
            node.setAttribute('target', '_blank');
            node.setAttribute('rel', 'noreferrer');
        }
    }
    return body.innerHTML;
}
