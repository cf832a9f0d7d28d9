// Networks are put in another order by dragging their line numbers.
import type { Found, Page } from '../page.ts';
import { follow } from './follow.ts';
import type { Pen } from './pen.ts';

/** Who moves less only presses, in pixels. */
const LEAST = 5;

/** Follows what was pressed in the margin of a network. */
export function beginReorder(event: PointerEvent, { drawing }: Pick<Found, 'drawing'>, page: Page, canvas: HTMLElement, pen: Pen): void {
    const bar = document.createElement('div');
    bar.className = 'between';
    bar.setAttribute('aria-hidden', 'true');
    let before: number | null | undefined;
    const move = ({ clientY }: PointerEvent) => {
        if (!bar.isConnected && Math.abs(clientY - event.clientY) < LEAST) {
            return;
        }
        const y = clientY - canvas.getBoundingClientRect().top;
        const { segments, scale, height } = page.layout;
        const below = segments.find(({ top, piece }) => piece?.kind === 'network' && top + (piece.height * scale) / 2 > y);
        before = below?.first ?? null;
        bar.style.top = `${(below?.top ?? height) - 8}px`;
        canvas.append(bar);
    };
    const end = (released?: PointerEvent) => {
        bar.remove();
        const networks = page.networks();
        const next = networks[networks.indexOf(drawing.first) + 1] ?? null;
        if (released && before !== undefined && before !== drawing.first && before !== next) {
            void pen.edit({ op: 'moveNetwork', network: drawing.first, before });
        }
    };
    follow({ move, end });
}
