// Starts a program of the package for this platform, which npm has installed as an optional dependency.
'use strict';
const { spawn } = require('node:child_process');
const { constants } = require('node:os');

// Whose packages hold the programs.
const SCOPE = '@ladder-logic';

/** Where the program is; undefined if there is no package for this platform, or npm was told to leave it out. */
function find(program) {
    const file = process.platform === 'win32' ? `${program}.exe` : program;
    try {
        return require.resolve(`${SCOPE}/${process.platform}-${process.arch}/bin/${file}`);
    } catch {
        return undefined;
    }
}

function fail(message) {
    console.error(`error: ${message}`);
    process.exit(2);
}

exports.start = function start(program) {
    const path = find(program);
    if (path === undefined) {
        fail(
            `the package ${SCOPE}/${process.platform}-${process.arch} is not installed. If it exists, install again without ` +
                '`--omit=optional`; else build the programs with Rust: `cargo install ladder-cli`.',
        );
    }
    const child = spawn(path, process.argv.slice(2), { stdio: 'inherit' });
    child.on('error', (error) => fail(`${path} does not start: ${error.message}`));
    // Ctrl-C reaches both; what it means the program decides. The others are sent to this process alone.
    process.on('SIGINT', () => {});
    for (const signal of ['SIGTERM', 'SIGHUP']) {
        process.on(signal, () => child.kill(signal));
    }
    child.on('exit', (status, signal) => process.exit(status ?? 128 + constants.signals[signal]));
};
