// How things look and are typed in the page: scenarios with the help of the server, colours by what a word means in each
// kind of theme, the preview of a Markdown document, the walkthrough, and the rules in the settings page.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { openBrowser, removeScratch, scratchFolder, serve, until } from './codeServer.mjs';
import { command, open } from './palette.mjs';
import { failures, step } from './steps.mjs';

const { LADDER_BIN, LADDER_PACKAGES, LADDER_SCREENSHOTS } = process.env;
const scratch = scratchFolder();
const project = (name) => join(scratch, 'project', name);

const PROGRAM = `VAR_INPUT
    start, stop : BOOL;
END_VAR
VAR_OUTPUT
    run : BOOL;
END_VAR
VAR
    warmup : TON;
    warm   : BOOL;
END_VAR

+--\\--[ ]( start )--\\--[/]( stop )-------------( )( run )--+
|  /--[ ]( run )----/                                      |

+--[ ]( run )----------[TON]( warmup, T#5s )--(S)( warm )--+
`;
const SCENARIOS = 'program motor.clad\nstep 100ms\n\nscenario "it starts"\nstart _-_\nrun => _--\n';
const MARKDOWN = '# Motor\n\nThis starts it:\n\n```clad\n+--[ ]( start )----------( )( <b>run</b> )--+\n\n+--[ ]( start )----------( )( run )--+\n```\n';

const settings = { 'ladder.server.path': LADDER_BIN, 'workbench.colorTheme': 'Default Dark Modern' };

function prepare() {
    writeFileSync(project('ladder.toml'), '');
    writeFileSync(project('motor.clad'), PROGRAM);
    writeFileSync(project('motor.ladder-test'), SCENARIOS);
    writeFileSync(project('notes.md'), MARKDOWN);
}

async function screenshot(page, name) {
    if (LADDER_SCREENSHOTS) {
        await page.screenshot({ path: join(LADDER_SCREENSHOTS, `looks-${name}.png`) });
    }
}

const blank = (text) => text.replaceAll('\u00a0', ' ');

/** The lines of the editor, as the page shows them. */
async function lines(page) {
    return (await page.locator('.editor-instance .view-line').allTextContents()).map(blank);
}

async function scenarioFile(page) {
    const label = page.locator('.suggest-widget.visible .monaco-list-row');
    await step('a scenario file has an icon of its own', async () => {
        // The list of files is made when the folder is read.
        await page.locator('.explorer-folders-view').getByText('motor.ladder-test').dblclick();
        await page.locator('.tab.active', { hasText: 'motor.ladder-test' }).waitFor();
        const icon = page.locator('.tab.active .ladder-test-lang-file-icon, .tab.active .monaco-icon-label').first();
        await icon.waitFor();
        await page.locator('.breadcrumbs-below-tabs, .monaco-breadcrumbs').getByText('…').first().waitFor();
        await until('the icon', async () => /ladder-test-lang-file-icon/.test(await icon.getAttribute('class')));
    });
    await step('a tag is proposed at the beginning of a row, and levels after it', async () => {
        await page.locator('.editor-instance .view-line').last().click();
        await page.keyboard.press('Control+End');
        await page.keyboard.type('sto');
        await label.filter({ hasText: 'stop' }).first().waitFor();
        await screenshot(page, 'completion');
        await page.keyboard.press('Tab');
        await page.keyboard.press('Control+Space');
        await label.filter({ hasText: '___' }).first().waitFor();
        await label.filter({ hasText: '___' }).first().click();
        await until('the row', async () => (await lines(page)).some((line) => /^stop +___$/.test(line)));
    });
    await step('Enter aligns the scenario', async () => {
        await page.keyboard.press('Enter');
        await until('columns', async () => {
            const shown = await lines(page);
            return shown.includes('start    _-_') && shown.includes('run   => _--') && shown.includes('stop     ___');
        });
        await page.keyboard.press('Backspace');
    });
    await step('the pointer shows the declaration of a tag', async () => {
        await page.locator('.editor-instance .view-line', { hasText: 'run' }).first().getByText('run', { exact: false }).first().hover();
        await page.locator('.monaco-hover', { hasText: 'VAR_OUTPUT' }).first().waitFor();
        await screenshot(page, 'hover');
        await page.keyboard.press('Escape');
    });
    await step('a tag that is not there is marked', async () => {
        await page.keyboard.press('Control+End');
        await page.keyboard.press('Enter');
        await page.keyboard.type('runn => ___');
        await page.keyboard.press('Escape');
        await page.locator('.editor-instance .squiggly-error').first().waitFor();
        await page.keyboard.press('Home');
        await page.keyboard.press('Shift+End');
        await page.keyboard.press('Delete');
        await page.keyboard.press('Backspace');
    });
    await step('a name follows into the program', async () => {
        await page.keyboard.press('Control+s');
        await until('the file', () => readFileSync(project('motor.ladder-test'), 'utf8').includes('run   => _--'));
        await page.locator('.editor-instance .view-line', { hasText: 'run' }).first().getByText('run', { exact: false }).first().click({ position: { x: 6, y: 8 } });
        await page.keyboard.press('F2');
        await page.locator('.rename-box input').waitFor();
        await page.locator('.rename-box input').fill('motor_runs');
        await page.keyboard.press('Enter');
        await until('the row', async () => (await lines(page)).some((line) => /^motor_runs +=> _--$/.test(line)));
        await command(page, 'File: Save All Files');
        await until('the program', () => readFileSync(project('motor.clad'), 'utf8').includes('motor_runs : BOOL'));
        writeFileSync(project('motor.clad'), PROGRAM);
        writeFileSync(project('motor.ladder-test'), SCENARIOS);
    });
}

/** The colour of the first character that a text has in the editor. */
function colour(page, line, text) {
    return page.evaluate(([wanted, part]) => {
        const all = [...document.querySelectorAll('.editor-instance .view-line')];
        const found = all.find((it) => it.textContent.replaceAll('\u00a0', ' ').startsWith(wanted));
        const spans = [...(found?.querySelectorAll('span > span') ?? [])];
        const span = spans.find((it) => it.textContent.replaceAll('\u00a0', ' ').trim().startsWith(part));
        return span && getComputedStyle(span).color;
    }, [line, text]);
}

async function colours(page, theme, name) {
    await step(`roles and shapes have colours of their own in ${theme}`, async () => {
        writeFileSync(join(scratch, 'data/Machine/settings.json'), JSON.stringify({ ...settings, 'workbench.colorTheme': theme, 'workbench.startupEditor': 'none' }));
        await open(page, 'motor.clad');
        const looked = async () => ({
            input: await colour(page, '+--\\', 'start'),
            output: await colour(page, '+--\\', 'run'),
            internal: await colour(page, '+--[ ]( run )-', 'warmup'),
            contact: await colour(page, '+--\\', '['),
            coil: await colour(page, '+--[ ]( run )-', 'S'),
            block: await colour(page, '+--[ ]( run )-', 'TON'),
        });
        let found;
        try {
            await until('six colours', async () => {
                found = await looked();
                return Object.values(found).every(Boolean) && new Set(Object.values(found)).size === 6;
            });
        } catch (error) {
            throw new Error(`${error.message}: ${JSON.stringify(found)}`);
        }
        await screenshot(page, name);
    });
}

async function preview(page) {
    await step('the preview of a document colours ladder text and draws it, and runs nothing', async () => {
        await open(page, 'notes.md');
        await command(page, 'Markdown: Open Preview to the Side');
        const frame = page.frameLocator('iframe.webview.ready').last().frameLocator('#active-frame');
        await frame.locator('img.ladder-picture').first().waitFor({ state: 'attached' });
        const shown = await frame.locator('img.ladder-picture').evaluateAll((images) => images.map((it) => [it.className, getComputedStyle(it).display, it.naturalWidth]));
        const visible = shown.filter(([, display]) => display !== 'none');
        assert.equal(visible.length, 1, JSON.stringify(shown));
        assert.ok(visible[0][2] > 100, JSON.stringify(shown));
        assert.equal(await frame.locator('.ladder-fence b').count(), 0);
        assert.equal(await frame.locator('.ladder-input').first().textContent(), 'start');
        await screenshot(page, 'preview');
        await command(page, 'View: Close All Editors');
    });
}

async function walkthrough(page) {
    await step('the walkthrough leads to an example that runs', async () => {
        await command(page, 'Welcome: Open Walkthrough...');
        await page.keyboard.type('Ladder diagrams as text');
        await page.locator('.quick-input-list .monaco-list-row', { hasText: 'Ladder diagrams as text' }).first().click();
        await page.locator('.gettingStartedContainer', { hasText: 'Open an example' }).waitFor();
        await page.locator('.gettingStartedContainer .getting-started-media img, .gettingStartedContainer .step-list-container + * img').first().waitFor().catch(() => {});
        await screenshot(page, 'walkthrough');
        await page.getByRole('button', { name: 'Open the Example' }).first().click();
        await page.locator('.editor-instance .view-line', { hasText: 'A motor starter' }).first().waitFor();
        await command(page, 'Ladder: Start Simulation');
        await page.getByText('Ladder: paused, scan 0').waitFor();
        await command(page, 'Ladder: Stop Simulation');
    });
}

async function settingsPage(page) {
    await step('rules are set in the settings page', async () => {
        await command(page, 'Preferences: Open Settings (UI)');
        await page.locator('.settings-editor .suggest-input-container').click();
        await page.keyboard.type('ladder.lint');
        const setting = page.locator('.settings-editor .setting-item', { hasText: 'findings of a rule' }).first();
        await setting.waitFor();
        await screenshot(page, 'settings');
        assert.ok(await setting.locator('select, .monaco-select-box, .setting-list-object-widget, .setting-list-new-row').count() > 0, await setting.textContent());
    });
}

const { server, address } = await (async () => {
    prepare();
    const extensions = [join(LADDER_PACKAGES, 'ladder.vsix')];
    return serve(scratch, { extensions, settings, env: { ...process.env, HOME: join(scratch, 'home') } });
})();
let browser;
try {
    const opened = await openBrowser(scratch, address);
    browser = opened.browser;
    const { page } = opened;
    await page.locator('.monaco-workbench').waitFor();
    await scenarioFile(page);
    await preview(page);
    await walkthrough(page);
    await colours(page, 'Default Dark Modern', 'dark');
    await colours(page, 'Default Light Modern', 'light');
    await colours(page, 'Default High Contrast', 'contrast-dark');
    await colours(page, 'Default High Contrast Light', 'contrast-light');
    await settingsPage(page);
} finally {
    await browser?.close();
    server.kill();
    removeScratch(scratch);
}
process.exit(failures() ? 1 : 0);
