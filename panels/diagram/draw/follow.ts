// Following the pointer while it is down.

/** What is done meanwhile, and at the end. */
export interface Followed {
    move(event: PointerEvent): void;
    /** It is let go, or given up: by Escape, or by the system. */
    end(released?: PointerEvent): void;
}

/** Follows the pointer until it is let go. @returns what stops that */
export function follow({ move, end }: Followed): () => void {
    const stop = (released?: PointerEvent) => {
        window.removeEventListener('pointermove', move);
        window.removeEventListener('pointerup', stop);
        window.removeEventListener('pointercancel', giveUp);
        window.removeEventListener('keydown', key, true);
        end(released);
    };
    const giveUp = () => stop();
    const key = (pressed: KeyboardEvent) => {
        if (pressed.key === 'Escape') {
            pressed.stopPropagation();
            stop();
        }
    };
    window.addEventListener('pointermove', move);
    window.addEventListener('pointerup', stop);
    window.addEventListener('pointercancel', giveUp);
    window.addEventListener('keydown', key, true);
    return giveUp;
}
