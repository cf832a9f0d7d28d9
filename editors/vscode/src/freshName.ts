// Names of files that are not there yet.

/**
 * The name, with a number before its ending if there is a file of that name. Names that differ only in case are one name: they are
 * one file on the discs of Windows and macOS, and writing to it would lose what it holds.
 */
export function freshName(name: string, there: Iterable<string>): string {
    const taken = new Set(Array.from(there, (other) => other.toLowerCase()));
    const dot = name.lastIndexOf('.');
    const [stem, ending] = dot < 0 ? [name, ''] : [name.slice(0, dot), name.slice(dot)];
    let fresh = name;
    for (let number = 2; taken.has(fresh.toLowerCase()); number += 1) {
        fresh = `${stem}-${number}${ending}`;
    }
    return fresh;
}
