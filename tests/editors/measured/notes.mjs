// What the tap has written down, and what the threads of processes have worked.
import { readFileSync, readdirSync } from 'node:fs';

/** The notes since a moment. */
export function notesSince(file, moment) {
    const lines = readFileSync(file, 'utf8').split('\n').filter(Boolean);
    return lines.map((line) => JSON.parse(line)).filter(({ at }) => at >= moment);
}

/** A tick is a hundredth of a second on every Linux. */
const TICK = 10;

function ticks(file) {
    // After the name, which may have blanks and brackets in it.
    const fields = readFileSync(file, 'utf8').replace(/^.*\) /s, '').split(' ');
    return (Number(fields[11]) + Number(fields[12])) * TICK;
}

/** How long the main thread of a process has worked, in milliseconds. */
export function mainThread(process) {
    return ticks(`/proc/${process}/task/${process}/stat`);
}

/** How long all threads of a process have worked, in milliseconds. */
export function allThreads(process) {
    return ticks(`/proc/${process}/stat`);
}

/** The process below another one whose command line has this text. */
export function descendant(ancestor, text) {
    const parents = new Map();
    for (const name of readdirSync('/proc').filter((name) => /^\d+$/.test(name))) {
        try {
            const stat = readFileSync(`/proc/${name}/stat`, 'utf8').replace(/^.*\) /s, '').split(' ');
            parents.set(Number(name), Number(stat[1]));
        } catch {
            // It has ended.
        }
    }
    const isBelow = (id) => {
        for (let at = id; at > 1; at = parents.get(at) ?? 0) {
            if (at === ancestor) {
                return true;
            }
        }
        return false;
    };
    const line = (id) => readFileSync(`/proc/${id}/cmdline`, 'utf8').replaceAll('\0', ' ');
    return [...parents.keys()].filter((id) => id !== ancestor && isBelow(id)).find((id) => line(id).includes(text));
}

export function median(values) {
    const sorted = [...values].sort((a, b) => a - b);
    return sorted[Math.floor(sorted.length / 2)] ?? NaN;
}
