// Where a text has a name.

/** The first place of a whole name, or -1: `function_1` is neither in `function_10` nor in `$function_1`. */
export function placeOfName(text: string, name: string): number {
    const written = name.replaceAll(/[$]/g, '\\$&');
    return text.search(new RegExp(`(?<![\\w$])${written}(?!\\w)`));
}
