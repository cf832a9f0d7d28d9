// Ladder text in the book: a link that opens it in the playground.
'use strict';

(() => {
    // mdBook says on each page where the first one is.
    const playground = `${path_to_root}playground/index.html`;
    const link = (title, address) => {
        const node = document.createElement('a');
        node.textContent = title;
        node.href = address;
        return node;
    };
    for (const code of document.querySelectorAll('pre > code.language-clad')) {
        const name = [...code.classList].find((word) => word.startsWith('file='))?.slice('file='.length) ?? 'program.clad';
        const tryIt = link('Try it', `${playground}#name=${encodeURIComponent(name)}&text=${encodeURIComponent(code.textContent)}`);
        tryIt.className = 'try-it';
        tryIt.title = 'Opens this program in the playground';
        code.parentElement.after(tryIt);
    }
    document.querySelector('#mdbook-menu-bar .right-buttons, #menu-bar .right-buttons')?.prepend(link('Playground', playground));
})();
