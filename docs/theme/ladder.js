// Ladder text in the book: a link that opens it in the playground, and its colours.
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

// The highlighter of mdBook knows no ladder and has run already when this file is read.
(() => {
    const highlighter = window.hljs;
    if (!highlighter) {
        return;
    }
    // The page is drawn from the text itself, never from its mark-up: what an example holds is only ever text.
    highlighter.registerLanguage('clad', () => ({
        case_insensitive: true,
        keywords: {
            keyword:
                'VAR VAR_INPUT VAR_OUTPUT VAR_IN_OUT VAR_GLOBAL VAR_EXTERNAL END_VAR RETAIN CONSTANT AT ARRAY OF ' +
                'FUNCTION_BLOCK END_FUNCTION_BLOCK',
            type:
                'BOOL BYTE WORD DWORD LWORD SINT INT DINT LINT USINT UINT UDINT ULINT REAL LREAL TIME DATE TOD DT ' +
                'STRING TON TOF TP RTO RTOF CTU CTD CTUD CTC SR RS',
            literal: 'TRUE FALSE',
        },
        contains: [
            { className: 'number', begin: /\b[A-Za-z0-9]+#[-+\w.:]+/ },
            { className: 'comment', begin: /#/, end: /#/ },
            { className: 'string', begin: /'/, end: /'/ },
            { className: 'built_in', begin: /\[[^\]\n]*\]|<[A-Za-z]+>|\((?:[ /]|[SRPNMsrpnm]|SM|RM|RES)\)(?=\()/ },
            { className: 'number', begin: /\b\d[\d_.]*(?:ns|us|ms|[dhms])?\b/ },
        ],
    }));
    for (const code of document.querySelectorAll('code.language-clad')) {
        const text = code.textContent;
        code.textContent = text;
        highlighter.highlightBlock(code);
    }
})();
