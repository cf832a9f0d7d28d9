// What a diagram's page is sent of a session: what has changed of what it shows, and never what it knows.
import { Flicker } from '../flicker.ts';
import type { Session } from '../session.ts';
import type { Lines, LiveUpdate, OperandAt, PowerAt } from './messages.ts';

/** As much of a session as a page is sent. */
export type Source = Pick<Session, 'state' | 'power' | 'operands' | 'texts' | 'stale' | 'tag'>;

export class Feed {
    #sent = new Map<string, string>();
    #source: Source | undefined;
    #texts = -1;
    #flicker = new Flicker();

    /** The page knows nothing, as when it begins. */
    forget(): void {
        this.#source = undefined;
    }

    /**
     * @param withValues whether values that the page knows by others are sent now; otherwise they wait
     * @param now in milliseconds
     * @returns what to tell the page that shows these lines
     */
    changes(source: Source, lines: Lines, withValues = true, now = Date.now()): LiveUpdate {
        const whole = this.#source !== source || this.#texts !== source.texts;
        if (whole) {
            this.#source = source;
            this.#texts = source.texts;
            this.#sent = new Map();
            this.#flicker = new Flicker();
        }
        const power: PowerAt[] = [];
        const operands: OperandAt[] = [];
        const names = new Set<string>();
        const sent = new Map<string, string>();
        /** Whether it is another one than the page knows. What it does not show any more it may be sent again. */
        const isNews = (key: string, value: string): boolean => {
            sent.set(key, value);
            return this.#sent.get(key) !== value;
        };
        const numbers = Array.from({ length: Math.max(lines.last - lines.first + 1, 0) }, (_, at) => lines.first + at);
        const elements = numbers.flatMap((line) => [...(source.power.get(line)?.values() ?? [])]);
        const flickering = this.#flicker.among(elements, source.state.status === 'running', now);
        for (const element of elements) {
            const { line, character } = element.range.start;
            const does = flickering.has(element) ? 'flickers' : element.unknown ? 'unknown' : element.contact;
            if (isNews(`${line}:${character}`, does === 'flickers' ? does : `${element.on} ${does}`)) {
                power.push(does ? [line, character, element.on, does] : [line, character, element.on]);
            }
        }
        for (const line of numbers) {
            for (const { range, tags, drawn } of source.operands.get(line) ?? []) {
                const { character } = range.start;
                tags.forEach((name) => names.add(name));
                if (isNews(`operand ${range.start.line}:${character}`, tags.join(' '))) {
                    operands.push([range.start.line, character, tags, drawn === true]);
                }
            }
        }
        const tags = [...names].flatMap((name) => {
            const tag = source.tag(name);
            const key = `tag ${name}`;
            const known = withValues ? undefined : this.#sent.get(key);
            if (known !== undefined) {
                sent.set(key, known);
                return [];
            }
            return tag && isNews(key, `${tag.value} ${tag.forced}`) ? [tag] : [];
        });
        this.#sent = sent;
        const { status, text } = source.state;
        return { whole, status, text, power, operands, tags };
    }
}
