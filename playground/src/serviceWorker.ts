// Keeps the files of the page, so that it works without a network. What the page begins with comes first; what it loads when it is
// asked for, afterwards. Another version of the page waits until no tab has this one open: its files belong together.

interface Kept {
    readonly version: string;
    readonly first: readonly string[];
    readonly later: readonly string[];
}

interface Waiting extends Event {
    waitUntil(work: Promise<unknown>): void;
}

interface Fetching extends Event {
    readonly request: Request;
    respondWith(answer: Promise<Response>): void;
}

interface Asked extends Waiting {
    readonly source: { postMessage(message: object): void } | null;
}

declare const KEPT: Kept;
const worker = self as unknown as {
    readonly clients: { claim(): Promise<void> };
    readonly registration: { readonly scope: string };
    addEventListener(type: 'install' | 'activate', listener: (event: Waiting) => void): void;
    addEventListener(type: 'fetch', listener: (event: Fetching) => void): void;
    addEventListener(type: 'message', listener: (event: Asked) => void): void;
};

const PREFIX = `ladder ${worker.registration.scope} `;
const NAME = PREFIX + KEPT.version;

/** Past the browser's own cache, which may hold files of another version. */
const keep = async (files: readonly string[]) => (await caches.open(NAME)).addAll(files.map((file) => new Request(file, { cache: 'no-cache' })));

worker.addEventListener('install', (event) => event.waitUntil(keep(KEPT.first)));

worker.addEventListener('activate', (event) => {
    const old = async () => (await caches.keys()).filter((name) => name.startsWith(PREFIX) && name !== NAME);
    event.waitUntil(old().then((names) => Promise.all(names.map((name) => caches.delete(name)))).then(() => worker.clients.claim()));
});

/** Whether all files are there; those that are missing are loaded. */
async function isComplete(): Promise<boolean> {
    const cache = await caches.open(NAME);
    const there = await Promise.all(KEPT.later.map((file) => cache.match(file)));
    try {
        await keep(KEPT.later.filter((_, at) => !there[at]));
        return true;
    } catch {
        return false;
    }
}

worker.addEventListener('message', (event) => {
    event.waitUntil(isComplete().then((answer) => event.source?.postMessage({ isComplete: answer })));
});

worker.addEventListener('fetch', (event) => {
    const { request } = event;
    const address = new URL(request.url);
    const file = address.pathname.slice(new URL(worker.registration.scope).pathname.length) || 'index.html';
    const isKept = request.method === 'GET' && request.url.startsWith(worker.registration.scope) && [...KEPT.first, ...KEPT.later].includes(file);
    if (isKept) {
        event.respondWith(caches.open(NAME).then((cache) => cache.match(file)).then((kept) => kept ?? fetch(request)));
    }
});
