// What is about a word comes first. The search of the book counts how often a word is in a section and how long that is, so that a
// remark on it comes before the page about it.
'use strict';

(() => {
    const { Index } = window.elasticlunr ?? {};
    if (!Index) {
        return;
    }
    const load = Index.load;
    /** The reference of an instruction begins with it, a title names it, a page is about the system that has it; then all others. */
    const tier = ({ ref, doc: { title, body } }, word) => {
        const address = window.search.doc_urls[ref] ?? '';
        const begins = body.search(word) >= 0 && body.search(word) <= 2;
        if (address.startsWith('language/instructions/') && begins) {
            return 0;
        }
        return word.test(title) ? 1 : address.startsWith('systems/') && word.test(body) ? 2 : 3;
    };
    const sorted = (found, words) => {
        const name = words.trim();
        if (!/^[\w-]+$/.test(name)) {
            return found;
        }
        const word = new RegExp(`(?<![\\w$])${name}(?!\\w)`, 'i');
        /** Where a section comes to the word; the beginning of a page before all others. */
        const place = ({ title, breadcrumbs, body }) => (breadcrumbs.endsWith(`${title} » ${title}`) ? -1 : body.search(word));
        const keys = new Map(found.map((one) => [one, { tier: tier(one, word), place: place(one.doc) }]));
        return [...found].sort((a, b) => {
            const [first, second] = [keys.get(a), keys.get(b)];
            return first.tier - second.tier || (first.tier === 2 ? first.place - second.place : b.score - a.score);
        });
    };
    Index.load = function (dump) {
        const index = load.call(Index, dump);
        const search = index.search.bind(index);
        index.search = (words, options) => sorted(search(words, options), words);
        return index;
    };
})();
