// The program `ladder` with a hand on it: a run of the scenarios of a file can be held back, as if it took long.
import { chmodSync, existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

/** How long a run is held, in seconds. */
const HELD = 3;

/**
 * Writes the program into a folder.
 *
 * @param ladder the program that does the work
 * @param scenarios the file whose runs are held
 */
export function heldTest(folder, ladder, scenarios) {
    const program = join(folder, 'ladder');
    const [next, ends] = [join(folder, 'hold-next'), join(folder, 'test-ends')];
    const lines = [
        '#!/bin/sh',
        `case "$*" in test*/${scenarios}) ;; *) exec "${ladder}" "$@" ;; esac`,
        'held=0',
        `rm "${next}" 2>/dev/null && held=${HELD}`,
        `said=$("${ladder}" "$@")`,
        'status=$?',
        'sleep $held',
        'printf "%s" "$said"',
        `echo >>"${ends}"`,
        'exit $status',
    ];
    writeFileSync(program, `${lines.join('\n')}\n`);
    chmodSync(program, 0o755);
    return {
        program,
        /** Holds the next run. */
        holdTest() {
            writeFileSync(ends, '');
            writeFileSync(next, '');
            return { hasBegun: () => !existsSync(next), ended: () => readFileSync(ends, 'utf8').length };
        },
    };
}
