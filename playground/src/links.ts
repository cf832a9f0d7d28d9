// Links in hovers and in the documentation of proposals: they lead to a line of the text that they name.
import type { OpenText } from './openText.ts';

/** @param show puts a text in front of a person */
export function followLinks(texts: readonly OpenText[], show: (text: OpenText) => void): void {
    document.addEventListener('click', (event) => {
        const link = event.target instanceof Element ? event.target.closest('a[href^="file:"]') : null;
        const [address = '', line] = link?.getAttribute('href')?.split('#L') ?? [];
        const text = texts.find(({ uri }) => decodeURIComponent(uri) === decodeURIComponent(address));
        if (link) {
            event.preventDefault();
        }
        if (text && line) {
            const place = { line: Number.parseInt(line, 10) - 1, character: 0 };
            show(text);
            text.select({ start: place, end: place }, true);
        }
    });
}
