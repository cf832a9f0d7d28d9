// A panel's page in a frame of this page: messages to it and from it, its theme, and keys that are about the simulation.
import { element } from './element.ts';

/** What a frame says of itself, next to what its page says. */
export interface FrameKey {
    readonly frame: 'key';
    readonly key: string;
    readonly shiftKey: boolean;
    readonly altKey: boolean;
}

export class Frame<To, From> {
    readonly #frame: HTMLIFrameElement;

    constructor(parent: HTMLElement, source: string, title: string, receive: (message: From) => void) {
        this.#frame = element('iframe', { src: source, title });
        window.addEventListener('message', ({ source: from, data }: MessageEvent<From | FrameKey>) => {
            if (from !== this.#frame.contentWindow || typeof data !== 'object' || data === null) {
                return;
            }
            if ('frame' in data) {
                const { key, shiftKey, altKey } = data;
                document.dispatchEvent(new KeyboardEvent('keydown', { key, shiftKey, altKey, cancelable: true }));
            } else {
                receive(data);
            }
        });
        parent.append(this.#frame);
    }

    get isSeen(): boolean {
        return this.#frame.offsetParent !== null && !document.hidden;
    }

    send(message: To): void {
        this.#frame.contentWindow?.postMessage(message, location.origin);
    }

    /** The frame is as light or dark as the page. */
    set theme(theme: string) {
        this.#frame.contentWindow?.postMessage({ theme }, location.origin);
    }
}
