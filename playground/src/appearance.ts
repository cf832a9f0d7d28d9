// Light or dark, as the system has it or as a person has chosen; and how the editor looks.
import { EditorView } from '@codemirror/view';

import { byId } from './element.ts';

const KEY = 'ladder.theme';

/** @param changed called with `light`, `dark`, or nothing where the system decides */
export function theme(changed: (theme: string) => void): () => string {
    const select = byId('theme') as HTMLSelectElement;
    select.value = localStorage.getItem(KEY) ?? '';
    const put = () => {
        document.documentElement.dataset['theme'] = select.value;
        localStorage.setItem(KEY, select.value);
        changed(select.value);
    };
    select.addEventListener('change', put);
    put();
    return () => select.value;
}

export const look = EditorView.theme({
    '&': { height: '100%', fontSize: 'var(--letters)', backgroundColor: 'var(--paper)', color: 'var(--ink)' },
    '&.cm-focused': { outline: '2px solid var(--focus)', outlineOffset: '-2px' },
    '.cm-scroller': { fontFamily: 'var(--mono)', lineHeight: '1.45', fontVariantLigatures: 'none' },
    '.cm-content': { caretColor: 'var(--ink)' },
    '.cm-cursor': { borderLeftColor: 'var(--ink)' },
    '.cm-gutters': { backgroundColor: 'var(--paper)', color: 'var(--quiet)', border: 'none' },
    '.cm-activeLine, .cm-activeLineGutter': { backgroundColor: 'var(--line)' },
    '&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground': { background: 'var(--selection)' },
    '.cm-breakpoints': { width: '14px', cursor: 'pointer' },
    '.breakpoint': { display: 'inline-block', width: '10px', height: '10px', borderRadius: '50%', backgroundColor: 'var(--error)' },
    '.cm-tooltip': { backgroundColor: 'var(--raised)', color: 'var(--ink)', border: '1px solid var(--edge)', borderRadius: '4px', boxShadow: '0 4px 14px #0003' },
    '.cm-tooltip-hover': { maxWidth: 'min(46rem, 92vw)', maxHeight: '60vh', overflow: 'auto' },
    '.cm-lsp-documentation': { font: '14px/1.45 var(--sans)', padding: '4px 10px' },
    '.cm-lsp-documentation pre': { font: '13px/1.3 var(--mono)', overflow: 'auto' },
    '.cm-lsp-documentation code': { fontFamily: 'var(--mono)' },
    '.cm-tooltip-autocomplete > ul': { fontFamily: 'var(--mono)', maxHeight: '14em' },
    '.cm-tooltip-autocomplete > ul > li[aria-selected]': { backgroundColor: 'var(--accent)', color: 'var(--on-accent)' },
    '.cm-completionDetail': { color: 'var(--quiet)', fontStyle: 'normal' },
    'li[aria-selected] .cm-completionDetail': { color: 'inherit' },
    '.cm-panels': { backgroundColor: 'var(--raised)', color: 'var(--ink)' },
    '.cm-panels-bottom': { borderTop: '1px solid var(--edge)' },
    '.cm-placeholder': { color: 'var(--quiet)' },
    '.cm-textfield': { backgroundColor: 'var(--paper)', color: 'var(--ink)', border: '1px solid var(--edge)' },
    '.cm-button': { backgroundImage: 'none', backgroundColor: 'var(--raised)', color: 'var(--ink)', border: '1px solid var(--edge)' },
    '.cm-diagnostic': { borderLeftWidth: '4px', whiteSpace: 'pre-wrap' },
    '.cm-diagnosticAction': { backgroundColor: 'var(--accent)', color: 'var(--on-accent)' },
    '.cm-diagnosticSource': { opacity: '1', color: 'var(--quiet)' },
    '.cm-searchMatch': { backgroundColor: 'var(--next)' },
    '.cm-lsp-reference-panel .cm-lsp-reference[aria-selected]': { backgroundColor: 'var(--selection)' },
    '.cm-lsp-reference-panel .cm-lsp-reference-line': { opacity: '1', color: 'var(--quiet)' },
});
