// What the page knows of the running program, by places in the text.
import type { Does, LineChange, LiveUpdate } from './messages.ts';
import type { Tag } from '../protocol.ts';
import { moved } from './layout.ts';

/** The power of an element, and what it does with it if it is a contact, or changes too fast to follow. */
export interface Power {
    readonly on: boolean;
    readonly does: Does | undefined;
}

/** The tags of an operand, the most telling one first. */
export interface Operand {
    readonly tags: readonly string[];
    /** The drawing shows the value already. */
    readonly drawn: boolean;
}

type ByPlace<T> = Map<number, Map<number, T>>;

function put<T>(map: ByPlace<T>, line: number, character: number, value: T): void {
    const here = map.get(line) ?? new Map<number, T>();
    here.set(character, value);
    map.set(line, here);
}

function shift<T>(map: ByPlace<T>, changes: readonly LineChange[]): ByPlace<T> {
    return new Map([...map].map(([line, here]) => [moved(line, changes), here]));
}

/** What an update has changed: all, or something in these lines or of these tags, by their names in lower case. */
export interface Changed {
    readonly whole: boolean;
    readonly lines: ReadonlySet<number>;
    readonly tags: ReadonlySet<string>;
}

export class Live {
    /** The last update, or none if nothing runs. */
    state: LiveUpdate | undefined;
    #power: ByPlace<Power> = new Map();
    #operands: ByPlace<Operand> = new Map();
    readonly #tags = new Map<string, Tag>();

    /** @returns what is another one now */
    take(update: LiveUpdate | undefined): Changed {
        const whole = !update || update.whole || !this.state;
        this.state = update;
        if (!update || update.whole) {
            this.#power.clear();
            this.#operands.clear();
            this.#tags.clear();
        }
        const changed = {
            whole,
            lines: new Set([...(update?.power ?? []), ...(update?.operands ?? [])].map(([line]) => line)),
            tags: new Set((update?.tags ?? []).map(({ name }) => name.toLowerCase())),
        };
        for (const [line, character, on, does] of update?.power ?? []) {
            put(this.#power, line, character, { on, does });
        }
        for (const [line, character, tags, drawn] of update?.operands ?? []) {
            put(this.#operands, line, character, { tags, drawn });
        }
        for (const tag of update?.tags ?? []) {
            this.#tags.set(tag.name.toLowerCase(), tag);
        }
        return changed;
    }

    /** The text has changed: what is known moves with its lines until the server tells of the new ones. */
    edit(changes: readonly LineChange[]): void {
        this.#power = shift(this.#power, changes);
        this.#operands = shift(this.#operands, changes);
    }

    power(line: number, character: number): Power | undefined {
        return this.#power.get(line)?.get(character);
    }

    operand(line: number, character: number): Operand | undefined {
        return this.#operands.get(line)?.get(character);
    }

    tag(name: string): Tag | undefined {
        return this.#tags.get(name.toLowerCase());
    }

    /** The tags of some operands that are known. */
    tagsOf(operands: readonly (readonly [line: number, character: number])[]): Tag[] {
        const names = operands.flatMap(([line, character]) => this.operand(line, character)?.tags ?? []);
        return [...new Set(names)].flatMap((name) => this.tag(name) ?? []);
    }
}

/** Whether a click inverts a tag: the rule of "Toggle Tag". */
export function toggles(tag: Tag | undefined): tag is Tag & { value: boolean } {
    return tag !== undefined && typeof tag.value === 'boolean' && tag.readOnly !== true;
}

/** The contact of an input is a switch: a click on it inverts the tag. Anything else leads to the text. */
export function isSwitch(kind: string, tag: Tag | undefined): boolean {
    return kind === 'contact' && toggles(tag) && tag.role === 'input';
}
