// Whether a server and this extension are made for each other. They are released together, under one number.

export type Fit =
    | { readonly fits: true }
    /** What the program printed is not a version of Ladder: it is some other program. */
    | { readonly fits: false; readonly why: 'other-program'; readonly printed: string }
    | { readonly fits: false; readonly why: 'older' | 'newer'; readonly server: string; readonly extension: string };

/** The numbers of a version; what is after them (`-rc.1`) says nothing about what fits. */
function numbers(version: string): readonly [number, number, number] | undefined {
    const [, major, minor, patch] = /^(\d+)\.(\d+)\.(\d+)(?:[-+].*)?$/.exec(version) ?? [];
    return major === undefined ? undefined : [Number(major), Number(minor), Number(patch)];
}

/**
 * Compares versions as Cargo does: what is not to be broken is the first number that is not 0.
 *
 * @param printed what `ladder --version` prints: `ladder 0.1.0 (afd4a9480, x86_64-unknown-linux-gnu)`, or the numbers alone
 * @param extension the extension's own version
 */
export function fit(printed: string, extension: string): Fit {
    const server = /^ladder (\S+)(?: \(.*\))?\s*$/.exec(printed)?.[1];
    const [theirs, ours] = [numbers(server ?? ''), numbers(extension)];
    if (server === undefined || theirs === undefined || ours === undefined) {
        return { fits: false, why: 'other-program', printed: printed.trim().split('\n')[0] ?? '' };
    }
    const kept = ours.findIndex((number) => number > 0);
    // 0.0.0 is like nothing but itself.
    const last = kept === -1 ? ours.length - 1 : kept;
    for (const [index, number] of ours.entries()) {
        const difference = (theirs[index] ?? 0) - number;
        if (difference < 0) {
            return { fits: false, why: 'older', server, extension };
        }
        if (difference > 0) {
            return index <= last ? { fits: false, why: 'newer', server, extension } : { fits: true };
        }
    }
    return { fits: true };
}

/** What the user reads where they do not fit; empty where they do. */
export function misfit(found: Fit, path: string): string {
    if (found.fits) {
        return '';
    }
    switch (found.why) {
        case 'other-program':
            return `"${path}" is not the language server: asked for its version it says "${found.printed}".`;
        case 'older':
            return `The language server "${path}" has version ${found.server}, this extension ${found.extension}. Some things will not work until the server is updated.`;
        case 'newer':
            return `The language server "${path}" has version ${found.server}, this extension ${found.extension}. Some things will not work until the extension is updated.`;
    }
}
