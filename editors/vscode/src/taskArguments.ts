// What a task starts the program `ladder` with.
import { isAbsolute, join } from 'node:path';

export type Work = 'check' | 'test' | 'format';

/** @param path what is checked, tested or aligned, seen from the folder; without it the folder */
export function taskArguments(work: Work, folder: string, path?: string): string[] {
    const whole = path === undefined || path === '' ? folder : isAbsolute(path) ? path : join(folder, path);
    const words = { check: ['check', '--format', 'concise'], test: ['test'], format: ['fmt'] }[work];
    return [...words, '--', whole];
}
