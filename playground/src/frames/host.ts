// In a frame: what VS Code is to a panel's page there, the page around it is here.

/** Keys that move the simulation, wherever the focus is. */
const KEYS = /^F(5|6|10|11)$/;

let state: unknown;

Object.assign(globalThis, {
    acquireVsCodeApi: () => ({
        postMessage: (message: unknown) => parent.postMessage(message, location.origin),
        getState: () => state,
        setState: (other: unknown) => {
            state = other;
        },
    }),
});

window.addEventListener(
    'message',
    (event: MessageEvent<unknown>) => {
        const { data, source } = event;
        if (source !== parent || typeof data !== 'object' || data === null) {
            // Only the page around is heard.
            event.stopImmediatePropagation();
        } else if ('theme' in data && typeof data.theme === 'string') {
            document.documentElement.dataset['theme'] = data.theme;
            event.stopImmediatePropagation();
        }
    },
    true,
);

window.addEventListener('keydown', (event) => {
    const { key, shiftKey, altKey } = event;
    if (KEYS.test(key)) {
        event.preventDefault();
        parent.postMessage({ frame: 'key', key, shiftKey, altKey }, location.origin);
    }
});
