// VS Code where there is no language server: the message, and what it offers; the server is started once it is there.
// Then a package that brings a server of another version: that is said, and it is used all the same.
import assert from 'node:assert/strict';
import { chmodSync, existsSync, mkdirSync, readdirSync, readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { openBrowser, removeScratch, scratchFolder, serve, until } from './codeServer.mjs';
import { command, open } from './palette.mjs';
import { failures, step, tell } from './steps.mjs';

const { LADDER_BIN, LADDER_PACKAGES, LADDER_ROOT, LADDER_SCREENSHOTS } = process.env;

const UNPAIRED = '+--\\--[ ]( start )-----( )( run )--+\n|  |                              |\n|  /--[ ]( run )--                |\n';

/** An environment without `ladder` and Rust: an empty home, and all other programs of the system, which may have Rust's. */
function bare(scratch) {
    const { LADDER_BIN: _, CARGO_HOME: __, ...rest } = process.env;
    const programs = join(scratch, 'programs');
    mkdirSync(programs);
    for (const name of readdirSync('/usr/bin').filter((name) => !['cargo', 'ladder'].includes(name))) {
        symlinkSync(join('/usr/bin', name), join(programs, name));
    }
    // As if it was started from a terminal: VS Code takes no other PATH from the user's shell then.
    return { ...rest, HOME: join(scratch, 'home'), PATH: programs, VSCODE_CLI: '1' };
}

/** A project with one program. */
function project(scratch) {
    writeFileSync(join(scratch, 'project/unpaired.clad'), UNPAIRED);
    // What another user put there must not be run.
    mkdirSync(join(scratch, 'project/.vscode'));
    const evil = join(scratch, 'project/ladder');
    writeFileSync(evil, `#!/bin/sh\ntouch '${scratch}/was-run'\necho ladder 0.1.0\n`);
    chmodSync(evil, 0o755);
    writeFileSync(join(scratch, 'project/.vscode/settings.json'), JSON.stringify({ 'ladder.server.path': evil }));
}

const message = (page, text) => page.locator('.notification-toast', { hasText: text }).first();

async function session(extension, check, trust = true) {
    const scratch = scratchFolder();
    project(scratch);
    const { server, address } = await serve(scratch, { extensions: [join(LADDER_PACKAGES, extension)], settings: {}, env: bare(scratch), trust });
    const { browser, page } = await openBrowser(scratch, address);
    try {
        await page.locator('.monaco-workbench .explorer-folders-view').waitFor();
        await check(page, scratch);
    } catch (error) {
        if (LADDER_SCREENSHOTS) {
            await page.screenshot({ path: join(LADDER_SCREENSHOTS, 'failed.png') });
        }
        tell({ name: `the session with ${extension} runs`, ok: false, ms: 0, message: error.stack });
    } finally {
        await browser.close();
        server.kill();
        removeScratch(scratch);
    }
}

/** Marks in the text: there is a server. */
const squiggle = (page) => page.locator('.squiggly-error, .squiggly-warning').first();

await session('ladder.vsix', async (page, scratch) => {
    const missing = message(page, 'The language server was not found');
    await step('a missing server is said, with what can be done', async () => {
        await open(page, 'unpaired.clad');
        await missing.waitFor();
        for (const action of ['Install...', 'Choose File...', 'Open Setting', 'Show Log']) {
            assert.equal(await missing.getByRole('button', { name: action }).count(), 1, action);
        }
        if (LADDER_SCREENSHOTS) {
            await page.screenshot({ path: join(LADDER_SCREENSHOTS, 'missing.png') });
        }
    });
    await step('installing without Rust says where to get it', async () => {
        await missing.getByRole('button', { name: 'Install...' }).click();
        await message(page, 'there is no program "cargo" here').getByRole('button', { name: 'Get Rust' }).waitFor();
        await page.keyboard.press('Escape');
    });
    await step('with Rust it is built from the folder that is chosen, and started without a reload', async () => {
        assert.equal(await squiggle(page).count(), 0);
        const cargo = join(scratch, 'home/.cargo/bin');
        mkdirSync(cargo, { recursive: true });
        // It notes what it is asked for, and brings the program that was built.
        const lines = ['#!/bin/sh', `echo "$@" >'${scratch}/asked'`, `cp '${LADDER_BIN}' '${cargo}/ladder'`];
        writeFileSync(join(cargo, 'cargo'), `${lines.join('\n')}\n`);
        chmodSync(join(cargo, 'cargo'), 0o755);
        await command(page, 'Ladder: Restart Language Server');
        await missing.getByRole('button', { name: 'Install...' }).click();
        const folder = page.locator('.quick-input-widget input').first();
        // The dialog begins with the folder that is open, and would put that in front of what comes before it.
        await until('the dialog', async () => (await folder.inputValue()) === `${join(scratch, 'project')}/`);
        await folder.fill(`${LADDER_ROOT}/`);
        // The button does nothing while the dialog reads the folder.
        await page.locator('.quick-input-list .monaco-list-row', { hasText: 'analysis' }).first().waitFor();
        await page.locator('.quick-input-widget').getByRole('button', { name: 'Build and Install' }).click();
        await squiggle(page).waitFor();
        assert.equal(readFileSync(join(scratch, 'asked'), 'utf8'), `install --locked --path ${LADDER_ROOT}/cli\n`);
    });
    await step('the program that the folder names is not run', async () => {
        assert.ok(!existsSync(join(scratch, 'was-run')));
    });
    await step('a program that is something else is not taken for the server', async () => {
        const other = join(scratch, 'home/other');
        writeFileSync(other, '#!/bin/sh\necho snakes 1.0\n');
        chmodSync(other, 0o755);
        writeFileSync(join(scratch, 'data/Machine/settings.json'), JSON.stringify({ 'ladder.server.path': other }));
        await message(page, 'is not the language server: asked for its version it says "snakes 1.0"').waitFor();
    });
});

await session('old.vsix', async (page) => {
    await step('a server that comes with the extension is used, and another version is said', async () => {
        await open(page, 'unpaired.clad');
        await message(page, 'has version 0.0.9, this extension 0.1.0').waitFor();
        await squiggle(page).waitFor();
    });
});

await session(
    'old.vsix',
    async (page, scratch) => {
        await step('in a folder that is not trusted nothing is started, until it is', async () => {
            await open(page, 'unpaired.clad');
            await page.getByText('Restricted Mode').first().waitFor();
            // The extension is at work: the text has its language.
            await page.getByText('Ladder Logic', { exact: true }).waitFor();
            await page.getByText('Manage', { exact: true }).click();
            const trust = page.locator('.workspace-trust-editor').getByRole('button', { name: 'Trust', exact: true });
            await trust.waitFor();
            assert.equal(await squiggle(page).count(), 0);
            await trust.click();
            await page.keyboard.press('Escape');
            await squiggle(page).waitFor();
            assert.ok(!existsSync(join(scratch, 'was-run')));
        });
    },
    false,
);

process.exit(failures() === 0 ? 0 : 1);
