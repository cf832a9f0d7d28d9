// Which programs this tab has open, so that no other one writes them: for as long as the tab is there.

/** A tab that is loaded again may find its own claims for so long. In milliseconds. */
const PATIENCE = 400;

const held = new Set<string>();

/** @returns false where another tab has the program open */
export async function claim(id: string): Promise<boolean> {
    // Pages that come without encryption have no locks; there the last tab that writes wins.
    if (held.has(id) || !('locks' in navigator)) {
        return true;
    }
    const isHeld = await new Promise<boolean>((resolve) => {
        const hold = () => {
            resolve(true);
            return new Promise<never>(() => undefined);
        };
        navigator.locks.request(`ladder.${id}`, { signal: AbortSignal.timeout(PATIENCE) }, hold).catch(() => resolve(false));
    });
    if (isHeld) {
        held.add(id);
    }
    return isHeld;
}
