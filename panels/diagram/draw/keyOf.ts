// Keys by their names: those of the table of actions.

/** What is pressed. */
interface Pressed {
    readonly key: string;
    readonly shiftKey: boolean;
    readonly altKey: boolean;
    readonly ctrlKey: boolean;
    readonly metaKey: boolean;
}

/** The name of what is pressed: `Shift+C`, `Alt+ArrowUp`, `#`. */
export function keyOf({ key, shiftKey, altKey, ctrlKey, metaKey }: Pressed): string {
    const isLetter = /^[a-z]$/i.test(key);
    const name = key === ' ' ? 'Space' : isLetter ? key.toUpperCase() : key;
    // What is typed with Shift, as # is, is already another key.
    const isShifted = shiftKey && (isLetter || key.length > 1);
    return [ctrlKey || metaKey ? 'Ctrl+' : '', altKey ? 'Alt+' : '', isShifted ? 'Shift+' : '', name].join('');
}
