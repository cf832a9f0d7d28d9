// The sources of the library's blocks, to which a definition leads: the server has their text.

/** The scheme of their addresses. */
export const SCHEME = 'ladder-library';

/** @returns the block whose source is at a path: `/Debounce.clad` */
export function blockOf(path: string): string {
    return `$${path.replace(/^.*\//, '').replace(/\.clad$/, '')}`;
}
