// Names of files that are not there yet.

/** The name, with a number before its ending if there is a file of that name. */
export function freshName(name: string, there: ReadonlySet<string>): string {
    const dot = name.lastIndexOf('.');
    const [stem, ending] = dot < 0 ? [name, ''] : [name.slice(0, dot), name.slice(dot)];
    let fresh = name;
    for (let number = 2; there.has(fresh); number += 1) {
        fresh = `${stem}-${number}${ending}`;
    }
    return fresh;
}
