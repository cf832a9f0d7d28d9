// What is said of an element.
import type { Tag } from '../protocol.ts';
import type { Power } from './live.ts';

/** An element of the drawing, in words. */
export interface Spoken {
    readonly kind: string;
    /** As the table of instructions calls it: "Open contact". */
    readonly name: string;
    /** The operands as they are written. */
    readonly operands: readonly string[];
}

function powerInWords(kind: string, power: Power): string[] {
    const flows = power.on ? 'power flows' : 'no power';
    switch (power.does) {
        case 'closed':
            return ['lets power through', flows];
        case 'blocks':
            return ['blocks the power that comes'];
        case 'open':
            return ['does not let power through', flows];
        case 'flickers':
            return ['changes faster than can be followed'];
        case 'unknown':
            return ['it is not known whether power flows'];
        case undefined:
            return [kind === 'coil' && power.on ? 'has power' : flows];
    }
}

export function valueInWords(tag: Tag): string {
    return `${tag.name} is ${tag.text}${tag.forced ? ', forced' : ''}`;
}

/** @returns what is to be said, from what matters most to what matters least */
export function describe({ kind, name, operands }: Spoken, power: Power | undefined, tags: readonly Tag[]): string {
    const what = [name, ...operands].join(' ');
    return [what, ...(power ? powerInWords(kind, power) : []), ...tags.slice(0, 3).map(valueInWords)].join(', ');
}
