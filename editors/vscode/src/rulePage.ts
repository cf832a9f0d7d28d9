// The pages of rules, which findings link: the server has their text, so that they open without a network.

/** The scheme of the addresses that findings link. */
export const SCHEME = 'ladder-rule';

/** @returns the rule whose page is at a path: `/double-coil.md` */
export function ruleOf(path: string): string {
    return path.replace(/^.*\//, '').replace(/\.md$/, '');
}
