// What a diagram's page is sent of a session: what has changed of what it shows, and never what it knows.
import type { Session } from '../session.ts';
import { showDuration } from '../value.ts';
import type { Lines, LiveUpdate, OperandAt, PowerAt } from './messages.ts';

/** As much of a session as a page is sent. */
export type Source = Pick<Session, 'state' | 'power' | 'operands' | 'texts' | 'stale' | 'tag'>;

export class Feed {
    #sent = new Map<string, string>();
    #source: Source | undefined;
    #texts = -1;

    /** The page knows nothing, as when it begins. */
    forget(): void {
        this.#source = undefined;
    }

    /**
     * @param withValues whether values that the page knows by others are sent now; otherwise they wait
     * @returns what to tell the page that shows these lines
     */
    news(source: Source, lines: Lines, withValues = true): LiveUpdate {
        const whole = this.#source !== source || this.#texts !== source.texts;
        if (whole) {
            this.#source = source;
            this.#texts = source.texts;
            this.#sent = new Map();
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
        for (let line = lines.first; line <= lines.last; line += 1) {
            for (const [character, { on, contact }] of source.power.get(line) ?? []) {
                if (isNews(`${line}:${character}`, `${on} ${contact}`)) {
                    power.push(contact ? [line, character, on, contact] : [line, character, on]);
                }
            }
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
        const { status, scan, timeMs, forced, faults, stale } = source.state;
        const time = showDuration(timeMs);
        return { whole, status, scan, time, forced, faults: faults.length, stale, power, operands, tags };
    }
}
