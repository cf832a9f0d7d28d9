// The page without a network: a service worker keeps its files, and the page says when all of them are there.

/** @param mark shown once the page works without a network */
export async function withoutNetwork(mark: HTMLElement, say: (text: string) => void): Promise<void> {
    // Pages that come without encryption have none.
    const workers = (navigator as Partial<Navigator>).serviceWorker;
    if (!workers) {
        return;
    }
    const isFirst = !workers.controller;
    workers.addEventListener('message', ({ data }: MessageEvent<{ isComplete?: boolean }>) => {
        if (data.isComplete === true && mark.hidden) {
            mark.hidden = false;
            if (isFirst) {
                say('The browser has kept this page: from now on it works without a network.');
            }
        }
    });
    try {
        await workers.register('service-worker.js', { updateViaCache: 'none' });
        (await workers.ready).active?.postMessage({ isComplete: true });
    } catch {
        // It works as before, with a network.
    }
}
