// The keys of the diagram while somebody draws, as a list.
import { ACTIONS } from './actions.ts';

/** As they are written on the keys. */
function shown(keys: string): string {
    return keys.replace('ArrowLeft', '←').replace('ArrowRight', '→').replace('ArrowUp', '↑').replace('ArrowDown', '↓');
}

/** The first key of each action, for menus. */
export function keysShown(keys: readonly string[]): string {
    return shown(keys[0] ?? '');
}

/** Shows the list until it is closed. */
export function showKeys(): void {
    const dialog = document.createElement('dialog');
    dialog.className = 'keys';
    dialog.setAttribute('aria-label', 'Keys that draw');
    const close = document.createElement('button');
    close.type = 'button';
    close.textContent = 'Close';
    close.addEventListener('click', () => dialog.close());
    const groups = [...new Set(ACTIONS.map(({ group }) => group))].map((group) => {
        const section = document.createElement('section');
        const heading = document.createElement('h2');
        heading.textContent = group;
        const list = document.createElement('dl');
        for (const { keys, title } of ACTIONS.filter((action) => action.group === group && action.keys.length > 0)) {
            const term = document.createElement('dt');
            term.textContent = keys.map(shown).join(', ');
            const said = document.createElement('dd');
            said.textContent = title.replace('…', '');
            list.append(term, said);
        }
        section.append(heading, list);
        return section;
    });
    const more = document.createElement('p');
    more.textContent = 'Arrows go from element to element and through the places in the wires; with Shift they select. Home and End go to the ends of a line, PageUp and PageDown to other networks. 1 to 9 draw what the buttons above show. D changes between Operate and Draw.';
    dialog.append(close, ...groups, more);
    dialog.addEventListener('close', () => dialog.remove());
    dialog.addEventListener('keydown', (event) => event.stopPropagation());
    document.body.append(dialog);
    dialog.showModal();
}
