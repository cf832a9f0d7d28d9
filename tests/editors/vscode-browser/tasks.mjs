// The tasks of the extension: what they start is run, and what it writes is read as VS Code's problem matchers read it.
// The session runs them in a terminal.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { cpSync, readFileSync, writeFileSync } from 'node:fs';
import { homedir } from 'node:os';
import { join } from 'node:path';
import { stripVTControlCharacters } from 'node:util';

import { taskArguments } from '../../../editors/vscode/src/taskArguments.ts';
import { removeScratch, scratchFolder } from './codeServer.mjs';
import { failures, step } from './steps.mjs';

const { LADDER_BIN, LADDER_FIXTURES, LADDER_ROOT } = process.env;
const manifest = JSON.parse(readFileSync(join(LADDER_ROOT, 'editors/vscode/package.json'), 'utf8'));

/** What a matcher finds: one pattern for each of lines that follow each other, as VS Code has it. */
function found(name, lines) {
    const { pattern } = manifest.contributes.problemMatchers.find((matcher) => `$${matcher.name}` === name);
    const patterns = [pattern].flat();
    return lines.flatMap((_, first) => {
        const problem = {};
        for (const [index, { regexp, ...groups }] of patterns.entries()) {
            const match = new RegExp(regexp).exec(lines[first + index] ?? '');
            if (!match) {
                return [];
            }
            for (const [part, group] of Object.entries(groups)) {
                problem[part] = match[group];
            }
        }
        return [problem];
    });
}

/** Runs a task as on a terminal, with colours, which VS Code takes out. */
function run(work, folder, path) {
    const { stdout, stderr } = spawnSync(LADDER_BIN, taskArguments(work, folder, path), {
        cwd: homedir(),
        encoding: 'utf8',
        env: { ...process.env, CLICOLOR_FORCE: '1' },
    });
    return stripVTControlCharacters(stdout + stderr).split('\n');
}

const scratch = scratchFolder();
const project = join(scratch, 'project');
cpSync(LADDER_FIXTURES, project, { recursive: true });
writeFileSync(join(project, 'ladder.toml'), '');
writeFileSync(join(project, 'slips.ladder-test'), 'program motor.clad\nscenario "slips"\nstrat _-\nrun => _-\n');

await step('the task that checks: its findings have their places', () => {
    const problems = found('$ladder', run('check', project));
    const unpaired = problems.find(({ code }) => code === 'unpaired-connector');
    assert.deepEqual([unpaired?.file, unpaired?.line, unpaired?.severity], [join(project, 'unpaired.clad'), '2', 'error']);
    const text = readFileSync(unpaired.file, 'utf8').split('\n')[1];
    assert.equal(text[unpaired.column - 1], '/');
});
await step('the task that tests: scenarios that fail, and those with errors, have their places', () => {
    const lines = run('test', project);
    const [failed, ...more] = found('$ladder-test', lines);
    assert.deepEqual(more, []);
    assert.deepEqual([failed.file, failed.line, failed.column], [join(project, 'motor.ladder-test'), '10', '12']);
    assert.match(failed.message, /^run is FALSE in step 3 /);
    const [error] = found('$ladder-scenario-error', lines);
    assert.deepEqual([error.file, error.line, error.column], [join(project, 'slips.ladder-test'), '3', '1']);
    assert.deepEqual([error.severity, error.code], ['error', 'bad-scenario']);
});
await step('the task that aligns, of one file of the folder', () => {
    const crooked = join(project, 'crooked.clad');
    const before = readFileSync(crooked, 'utf8');
    run('format', project, 'crooked.clad');
    assert.notEqual(readFileSync(crooked, 'utf8'), before);
});

removeScratch(scratch);
process.exit(failures() === 0 ? 0 : 1);
