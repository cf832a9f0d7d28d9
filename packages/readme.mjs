// The README as it is read away from the project, on PyPI, on npm and in the documents of a package: every link and picture leads to the release.
//
//   node packages/readme.mjs VERSION >FILE
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { ROOT } from './dependencies.mjs';

const PICTURE = /\.(svg|png|webp|gif)$/;

/**
 * @param text Markdown with addresses that are relative to the root of the project
 * @param repository where the project is, such as `https://github.com/somebody/ladder`
 */
export function absolute(text, repository, version) {
    const address = (path) => {
        if (/^([a-z]+:|#)/.test(path)) {
            return path;
        }
        if (!existsSync(join(ROOT, path.split('#')[0]))) {
            throw new Error(`README.md: ${path} leads nowhere`);
        }
        // A page about a picture is not the picture.
        return PICTURE.test(path)
            ? `${repository.replace('https://github.com/', 'https://raw.githubusercontent.com/')}/v${version}/${path}`
            : `${repository}/blob/v${version}/${path}`;
    };
    return text
        .replaceAll(/\]\(([^)\s]+)\)/g, (_, path) => `](${address(path)})`)
        .replaceAll(/\b(src|srcset|href)="([^"]+)"/g, (_, name, path) => `${name}="${address(path)}"`);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
    const valueOf = (name) => execFileSync('bash', ['packages/project', name], { cwd: ROOT, encoding: 'utf8' }).trim();
    process.stdout.write(absolute(readFileSync(join(ROOT, 'README.md'), 'utf8'), valueOf('repository'), process.argv[2]));
    // By which the registry of tools for assistants knows that packages/server.json is about the package on PyPI.
    process.stdout.write(`\n<!-- mcp-name: io.github.${valueOf('owner')}/ladder -->\n`);
}
