// The client of the protocol, which says of a short text, too, what has changed in it. The package sends such a text as a whole,
// and the server would not know where in it a person types.
import { LSPClient } from '@codemirror/lsp-client';

import type { Range } from '../../panels/protocol.ts';

interface Change {
    readonly range?: Range;
    readonly text: string;
}

/** The one stretch of a text that another one replaces. */
export function changeOf(before: string, after: string): Change {
    const most = Math.min(before.length, after.length);
    let start = 0;
    while (start < most && before[start] === after[start]) {
        start += 1;
    }
    let end = 0;
    while (end < most - start && before[before.length - 1 - end] === after[after.length - 1 - end]) {
        end += 1;
    }
    const place = (offset: number) => {
        const lines = before.slice(0, offset).split('\n');
        return { line: lines.length - 1, character: lines.at(-1)?.length ?? 0 };
    };
    return { range: { start: place(start), end: place(before.length - end) }, text: after.slice(start, after.length - end) };
}

interface Params {
    readonly textDocument: { readonly uri: string; readonly text?: string };
    readonly contentChanges?: readonly Change[];
}

export class Client extends LSPClient {
    /** What the server was sent whole, and has still. */
    readonly #sent = new Map<string, string>();

    override notification<Given>(method: string, given: Given): void {
        super.notification(method, method === 'textDocument/didChange' || method === 'textDocument/didOpen' ? this.#shorter(given as Params) : given);
    }

    #shorter(params: Params): Params {
        const { uri, text } = params.textDocument;
        const [first, ...others] = params.contentChanges ?? [];
        const whole = text ?? (first && !first.range && others.length === 0 ? first.text : undefined);
        const before = this.#sent.get(uri);
        if (whole === undefined) {
            this.#sent.delete(uri);
            return params;
        }
        this.#sent.set(uri, whole);
        return text !== undefined || before === undefined ? params : { ...params, contentChanges: [changeOf(before, whole)] };
    }
}
