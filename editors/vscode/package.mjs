// Packages the extension with the server of the platform it is packaged on: ladder-linux-x64.vsix and the like.
//
//   npm run package                       builds the server, optimised, and packs it
//   npm run package -- --server PROGRAM   packs a program that is built already
//   npm run package -- --target alpine-x64 --server PROGRAM    for another platform that can start it here: a static program
//   npm run package -- --no-server        packs none: ladder.vsix, for every platform; it looks for one on the PATH
import { execFileSync } from 'node:child_process';
import { chmodSync, copyFileSync, mkdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';

import { licences } from '../../packages/licences.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const root = join(here, '../..');
const { version } = JSON.parse(readFileSync(join(here, 'package.json'), 'utf8'));
// As `vsce` names them; an Alpine Linux has a C library of its own, and so its own target.
const TARGETS = ['win32-x64', 'win32-arm64', 'linux-x64', 'linux-arm64', 'linux-armhf', 'alpine-x64', 'alpine-arm64', 'darwin-x64', 'darwin-arm64'];

function fail(message) {
    console.error(`package: ${message}`);
    process.exit(1);
}

/** The platform this runs on. */
function platform() {
    const isAlpine = process.platform === 'linux' && process.report.getReport().header.glibcVersionRuntime === undefined;
    const target = `${isAlpine ? 'alpine' : process.platform}-${process.arch === 'arm' ? 'armhf' : process.arch}`;
    if (!TARGETS.includes(target)) {
        fail(`VS Code has no packages for ${target}; "npm run package -- --no-server" makes one for every platform.`);
    }
    return target;
}

/** Builds the server, and returns where it is. */
function build() {
    const cargo = ['build', '--release', '--locked', '--package', 'ladder-cli', '--bin', 'ladder', '--message-format', 'json-render-diagnostics'];
    const said = execFileSync('cargo', cargo, { cwd: root, encoding: 'utf8', stdio: ['ignore', 'pipe', 'inherit'], maxBuffer: 1 << 28 });
    const built = said.split('\n').filter(Boolean).map((line) => JSON.parse(line));
    return built.findLast(({ executable }) => executable)?.executable ?? fail('cargo built no program.');
}

/** A package with a server of another version would warn on its first start. */
function checkVersion(program) {
    let said;
    try {
        said = execFileSync(program, ['--version'], { encoding: 'utf8' }).trim();
    } catch (error) {
        fail(`${program} does not start: ${error.message}`);
    }
    // What is after the number says which build it is.
    if (said.split(' (')[0] !== `ladder ${version}`) {
        fail(`${program} says "${said}", and this is the extension ${version}: they must be of one version.`);
    }
}

function vsce(...options) {
    const program = join(here, 'node_modules/@vscode/vsce/vsce');
    // Its page on the marketplace is at another place than its files.
    // By the name of the shell: Windows starts no script.
    const place = execFileSync('bash', ['packages/project', 'repository'], { cwd: root, encoding: 'utf8' }).trim();
    const links = ['--baseContentUrl', `${place}/blob/v${version}/editors/vscode`, '--baseImagesUrl', `${place}/raw/v${version}/editors/vscode`];
    execFileSync(process.execPath, [program, 'package', '--no-dependencies', ...links, ...options], { cwd: here, stdio: 'inherit' });
}

const { values } = parseArgs({ options: { server: { type: 'string' }, target: { type: 'string' }, 'no-server': { type: 'boolean' }, out: { type: 'string' } } });
const folder = join(here, 'server');
// What an earlier call left there is of an earlier version.
rmSync(folder, { recursive: true, force: true });
if (values['no-server']) {
    vsce('--out', values.out ?? 'ladder.vsix');
} else {
    const target = values.target ?? platform();
    if (!TARGETS.includes(target)) {
        fail(`VS Code has no packages for ${target}; it has them for ${TARGETS.join(', ')}.`);
    }
    const program = values.server ?? build();
    if (!statSync(program, { throwIfNoEntry: false })?.isFile()) {
        fail(`there is no program ${program}.`);
    }
    checkVersion(program);
    const copy = join(folder, target.startsWith('win32') ? 'ladder.exe' : 'ladder');
    mkdirSync(folder);
    try {
        copyFileSync(program, copy);
        chmodSync(copy, 0o755);
        // The licences of what the server is built from ask to go with every copy of it.
        writeFileSync(join(folder, 'LICENSES-OF-SERVER.txt'), licences());
        vsce('--target', target, '--out', values.out ?? `ladder-${target}.vsix`);
    } finally {
        // Else the next package without a server would have this one.
        rmSync(folder, { recursive: true, force: true });
    }
}
