// The licences of all packages that the programs are built from, as one text.
//
//   node packages/licences.mjs [TARGET] >FILE
import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { shipped } from './dependencies.mjs';

/** The package's own licence files; some packages have none, and only name a licence. */
function licence({ name, version, license, manifest_path: manifest }) {
    const folder = dirname(manifest);
    const files = readdirSync(folder).filter((file) => /^(licen[cs]e|copying|notice|unlicense)/i.test(file));
    const texts = files.flatMap((file) => {
        try {
            return [readFileSync(join(folder, file), 'utf8').trim()];
        } catch {
            // A folder of licences, say.
            return [];
        }
    });
    return `${name} ${version} (${license ?? 'see below'})\n\n${texts.join('\n\n')}`.trimEnd();
}

/** One piece of text for each package that is not the project's own. */
export function licences(target) {
    const foreign = shipped(target).others.filter(({ source }) => source !== null);
    return `${foreign.map(licence).join(`\n\n${'-'.repeat(80)}\n\n`)}\n`;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
    process.stdout.write(licences(process.argv[2]));
}
