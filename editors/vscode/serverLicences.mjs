// The licences of all packages that the server's program is built from, as one text.
import { execFileSync } from 'node:child_process';
import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';

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

/**
 * @param root the folder of the Rust workspace
 * @returns one piece of text for each package that is not the project's own
 */
export function licencesOf(root) {
    const [, platform] = /^host: (.+)$/m.exec(execFileSync('rustc', ['-vV'], { encoding: 'utf8' }));
    const options = ['metadata', '--format-version', '1', '--locked', '--filter-platform', platform];
    const metadata = JSON.parse(execFileSync('cargo', options, { cwd: root, encoding: 'utf8', maxBuffer: 1 << 28 }));
    const nodes = new Map(metadata.resolve.nodes.map((node) => [node.id, node]));
    const packages = new Map(metadata.packages.map((item) => [item.id, item]));
    const reached = new Set();
    const open = [metadata.packages.find(({ name, source }) => name === 'ladder-cli' && source === null).id];
    while (open.length > 0) {
        const id = open.pop();
        if (reached.has(id)) {
            continue;
        }
        reached.add(id);
        const isShipped = ({ dep_kinds: kinds }) => kinds.some(({ kind }) => kind === null);
        open.push(...nodes.get(id).deps.filter(isShipped).map(({ pkg }) => pkg));
    }
    const foreign = [...reached].map((id) => packages.get(id)).filter(({ source }) => source !== null);
    foreign.sort((one, other) => one.name.localeCompare(other.name));
    return `${foreign.map(licence).join(`\n\n${'-'.repeat(80)}\n\n`)}\n`;
}
