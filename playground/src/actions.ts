// What can be done at the cursor: fixes, and drawing something in another way.
import type { Extension } from '@codemirror/state';
import { LSPPlugin } from '@codemirror/lsp-client';
import { type Command, type EditorView, keymap } from '@codemirror/view';

import { actionsAt, make } from './findings.ts';
import { element } from './element.ts';

/** Lists what can be done, next to the cursor. */
async function list(view: EditorView): Promise<void> {
    const plugin = LSPPlugin.get(view);
    if (!plugin) {
        return;
    }
    const { doc, selection } = view.state;
    const range = { start: plugin.toPosition(selection.main.from), end: plugin.toPosition(selection.main.to) };
    const actions = (await actionsAt(view, range, ['quickfix', 'refactor'])).filter(({ edit }) => edit !== undefined);
    const menu = element('div', { class: 'menu', popover: 'auto', role: 'menu', 'aria-label': 'What can be done here' });
    const buttons = actions.map((action) =>
        element('button', {
            type: 'button',
            role: 'menuitem',
            onclick: () => {
                menu.hidePopover();
                view.focus();
                if (view.state.doc === doc) {
                    make(plugin.client, action);
                }
            },
        }, action.title),
    );
    menu.append(...(buttons.length > 0 ? buttons : [element('p', {}, 'Nothing can be done here.')]));
    menu.addEventListener('toggle', (event) => (event as ToggleEvent).newState === 'closed' && menu.remove());
    menu.addEventListener('keydown', (event) => {
        const at = buttons.indexOf(document.activeElement as HTMLButtonElement);
        const to = { ArrowDown: at + 1, ArrowUp: at - 1 }[event.key];
        if (to !== undefined && buttons.length > 0) {
            event.preventDefault();
            buttons.at(to % buttons.length)?.focus();
        }
    });
    document.body.append(menu);
    menu.showPopover();
    const at = view.coordsAtPos(selection.main.head);
    menu.style.left = `${Math.min(at?.left ?? 0, document.documentElement.clientWidth - menu.offsetWidth - 8)}px`;
    menu.style.top = `${Math.min((at?.bottom ?? 0) + 4, window.innerHeight - menu.offsetHeight - 8)}px`;
    buttons[0]?.focus();
}

const show: Command = (view) => {
    void list(view);
    return true;
};

export const actionKeymap: Extension = keymap.of([{ key: 'Mod-.', run: show, preventDefault: true }]);
