// What the programs are built from: the packages of Cargo's graph that end up in them, not those that only build or test.
import { execFileSync } from 'node:child_process';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const ROOT = join(dirname(fileURLToPath(import.meta.url)), '..');

function run(program, ...options) {
    return execFileSync(program, options, { cwd: ROOT, encoding: 'utf8', maxBuffer: 1 << 28 });
}

/**
 * @param target such as `x86_64-unknown-linux-gnu`; without it the one of this machine
 * @returns the project's own package of the programs, all others by name, and for each package's id the ids that it uses
 */
export function shipped(target = /^host: (.+)$/m.exec(run('rustc', '-vV'))[1]) {
    const metadata = JSON.parse(run('cargo', 'metadata', '--format-version', '1', '--locked', '--filter-platform', target));
    const nodes = new Map(metadata.resolve.nodes.map((node) => [node.id, node]));
    const uses = new Map();
    const program = metadata.packages.find(({ name, source }) => name === 'ladder-cli' && source === null);
    const open = [program.id];
    while (open.length > 0) {
        const id = open.pop();
        if (uses.has(id)) {
            continue;
        }
        const isShipped = ({ dep_kinds: kinds }) => kinds.some(({ kind }) => kind === null);
        uses.set(id, nodes.get(id).deps.filter(isShipped).map(({ pkg }) => pkg));
        open.push(...uses.get(id));
    }
    const others = metadata.packages.filter(({ id }) => uses.has(id) && id !== program.id);
    others.sort((one, other) => one.name.localeCompare(other.name) || one.version.localeCompare(other.version));
    return { program, others, uses };
}
