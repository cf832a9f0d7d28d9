// A button that opens a list of things to do.
import { element } from './element.ts';

export interface Item {
    readonly title: string;
    readonly act: () => void;
}

/** @param items asked for whenever the list is opened */
export function menu(button: HTMLButtonElement, items: () => Promise<readonly Item[]>): void {
    const list = element('div', { class: 'menu', popover: 'auto', role: 'menu', 'aria-label': button.textContent ?? '' });
    button.after(list);
    button.setAttribute('aria-haspopup', 'menu');
    button.setAttribute('aria-expanded', 'false');
    const open = async () => {
        const made = (await items()).map(({ title, act }) =>
            element('button', {
                type: 'button',
                role: 'menuitem',
                tabindex: '-1',
                onclick: () => {
                    list.hidePopover();
                    act();
                },
            }, title),
        );
        list.replaceChildren(...made);
        const { left, bottom } = button.getBoundingClientRect();
        list.showPopover();
        list.style.top = `${bottom + 2}px`;
        list.style.left = `${Math.max(Math.min(left, document.documentElement.clientWidth - list.offsetWidth - 8), 8)}px`;
        made[0]?.focus();
    };
    button.addEventListener('click', () => void (list.matches(':popover-open') ? list.hidePopover() : open()));
    list.addEventListener('toggle', (event) => button.setAttribute('aria-expanded', String((event as ToggleEvent).newState === 'open')));
    list.addEventListener('keydown', (event) => {
        const all = [...list.querySelectorAll('button')];
        const at = all.indexOf(document.activeElement as HTMLButtonElement);
        const to = { ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: all.length - 1 }[event.key];
        if (to !== undefined) {
            event.preventDefault();
            all.at(to % all.length)?.focus();
        }
    });
}
