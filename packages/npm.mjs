// Makes packages for npm from what packages/stage laid out.
//
//   node packages/npm.mjs platform STAGED OUT     the programs of one platform
//   node packages/npm.mjs launcher STAGED OUT     ladder-logic, which starts those of the platform it is installed on
//
// The programs for Linux are static, so that there is one package for every C library.
import { execFileSync } from 'node:child_process';
import { chmodSync, cpSync, mkdirSync, mkdtempSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';

import { ROOT } from './dependencies.mjs';

const PLATFORMS = ['linux-x64', 'linux-arm64', 'darwin-x64', 'darwin-arm64', 'win32-x64', 'win32-arm64'];

const [what, staged, out] = process.argv.slice(2);
const scratch = mkdtempSync(join(tmpdir(), 'ladder-npm-'));

/** What packages/read-staged and packages/project print. */
function ask(script, ...options) {
    return execFileSync('bash', [`packages/${script}`, ...options], { cwd: ROOT, encoding: 'utf8' }).trim();
}

function copy(from, to, filter = () => true) {
    mkdirSync(join(scratch, to), { recursive: true });
    for (const name of readdirSync(from).filter(filter)) {
        cpSync(join(from, name), join(scratch, to, name), { recursive: true });
    }
}

const scope = ask('project', 'scope');
const version = ask('read-staged', 'version', resolve(staged));
const common = {
    version,
    license: 'MIT OR Apache-2.0',
    homepage: ask('project', 'site'),
    bugs: `${ask('project', 'repository')}/issues`,
    repository: { type: 'git', url: `git+${ask('project', 'repository')}.git` },
};
const documents = join(staged, 'share/doc/ladder-logic');

function platform() {
    const name = ask('read-staged', 'npm', resolve(staged));
    const [os, cpu] = name.split('-');
    if (os === 'linux' && ask('read-staged', 'libc', resolve(staged)) !== 'static') {
        console.error('npm: these programs are not static; the package works only where the C library is as new as here');
    }
    copy(join(staged, 'bin'), 'bin');
    copy(documents, '.', (file) => file.startsWith('LICENSE'));
    writeFileSync(join(scratch, 'README.md'), `# ${scope}/${name}\n\nThe programs of [ladder-logic](https://www.npmjs.com/package/ladder-logic) for ${name}. Install that.\n`);
    const description = `The programs of ladder-logic for ${name}`;
    // `preferUnplugged`: a program cannot be started from inside a zip file.
    return { name: `${scope}/${name}`, description, ...common, os: [os], cpu: [cpu], preferUnplugged: true };
}

function launcher() {
    copy(join(ROOT, 'packages/npm'), '.');
    copy(join(staged, 'share/man/man1'), 'man');
    for (const folder of ['bash-completion/completions', 'zsh/site-functions', 'fish/vendor_completions.d']) {
        copy(join(staged, 'share', folder), join('completions', folder.split(/[-/]/)[0]));
    }
    copy(join(documents, 'completions'), 'completions/powershell');
    copy(documents, '.', (file) => file.startsWith('LICENSE') || file === 'CHANGELOG.md' || file === 'README.md');
    return {
        name: 'ladder-logic',
        description: 'Ladder logic as plain text: checker, formatter, simulator and language server',
        // By which the registry of tools for assistants knows that packages/server.json is about this package.
        mcpName: `io.github.${ask('project', 'owner')}/ladder`,
        ...common,
        keywords: ['plc', 'ladder', 'iec61131', 'lsp', 'simulator'],
        // The last is what `npx ladder-logic` looks for.
        bin: { ladder: 'bin/ladder.cjs', ldfmt: 'bin/ldfmt.cjs', 'ladder-logic': 'bin/ladder.cjs' },
        man: readdirSync(join(scratch, 'man')).map((file) => `man/${file}`),
        engines: { node: '>=18' },
        optionalDependencies: Object.fromEntries(PLATFORMS.map((name) => [`${scope}/${name}`, version])),
    };
}

const MAKERS = { platform, launcher };
if (!Object.hasOwn(MAKERS, what)) {
    console.error('usage: node packages/npm.mjs platform|launcher STAGED OUT');
    process.exit(2);
}
try {
    writeFileSync(join(scratch, 'package.json'), `${JSON.stringify(MAKERS[what](), null, 2)}\n`);
    readdirSync(join(scratch, 'bin')).forEach((file) => chmodSync(join(scratch, 'bin', file), 0o755));
    mkdirSync(out, { recursive: true });
    const npm = process.platform === 'win32' ? 'npm.cmd' : 'npm';
    const options = { cwd: scratch, stdio: ['ignore', 'ignore', 'inherit'], shell: process.platform === 'win32' };
    execFileSync(npm, ['pack', '--silent', '--pack-destination', resolve(out)], options);
} finally {
    rmSync(scratch, { recursive: true });
}
