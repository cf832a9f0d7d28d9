// The languages of this book that its highlighter does not know. It colours a page as soon as it is there, so they are told to it the
// moment that it comes.
'use strict';

(() => {
    const clad = () => ({
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
    });
    const scenarios = () => ({
        keywords: 'program plant connect step interval scenario property assume set never always after possible',
        contains: [
            { className: 'comment', begin: /#/, end: /#|$/ },
            { className: 'string', begin: /"/, end: /"/ },
        ],
    });
    /** Shown as it is. */
    const plain = () => ({});
    Object.defineProperty(window, 'hljs', {
        configurable: true,
        set(highlighter) {
            Object.defineProperty(window, 'hljs', { value: highlighter, writable: true });
            highlighter.registerLanguage('clad', clad);
            highlighter.registerLanguage('ladder-test', scenarios);
            for (const code of document.querySelectorAll('code[class*="language-"]')) {
                const name = /language-([\w-]+)/.exec(code.className)[1];
                if (!highlighter.getLanguage(name)) {
                    highlighter.registerLanguage(name, plain);
                }
            }
        },
    });
})();
