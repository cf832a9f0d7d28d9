// Programs that come and go: examples, steps of the book, links, files of other systems, and all that is exported.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';

import { Playground } from './page.mjs';
import { step } from './steps.mjs';

const { LADDER_ROOT } = process.env;

export async function sharing(site) {
    const it = await Playground.open(site);
    const failed = (name) => it.picture(`failed ${name}`);
    const text = async () => (await it.lines()).join('\n');
    await step('the first visit shows a machine that moves, and its buttons reach the program', async () => {
        await it.until('the example', async () => (await text()).includes('Water is taken from a tank'));
        const scene = it.page.frameLocator('#scene iframe');
        const height = () => scene.locator('[aria-label="water"]').getAttribute('transform');
        const first = await height();
        await it.until('the water to move', async () => (await height()) !== first);
        await it.until('the pump', async () => (await scene.locator('[aria-label="pump, on"]').count()) === 1, 20);
        await scene.getByRole('button', { name: 'stop the pump' }).press('Space', { delay: 500 });
        await it.until('no pump', async () => (await scene.locator('[aria-label="pump, off"]').count()) === 1);
        await it.picture('first visit');
    }, failed);
    await step('a program without a machine has no scene', async () => {
        await it.page.locator('#examples').selectOption({ label: 'Motor' });
        await it.until('the example', async () => (await text()).includes('A motor starter'));
        assert.equal(await it.page.locator('#tab-scene').isVisible(), false);
        assert.equal(await it.page.locator('#diagram').isVisible(), true);
    }, failed);
    await step('every example opens, and holds no error', async () => {
        const options = await it.page.locator('#examples optgroup[label="Examples"] option').evaluateAll((all) => all.map((option) => option.value));
        assert.ok(options.length >= 5);
        for (const value of options) {
            await it.page.locator('#examples').selectOption(value);
            await it.page.waitForTimeout(250);
            assert.equal(await it.page.locator('#program .cm-lintRange-error').count(), 0);
        }
    }, failed);
    await step('the steps of a chapter follow one another, each with its place in the book', async () => {
        await it.page.locator('#examples').selectOption({ label: '1. One rung' });
        await it.until('the first step', async () => (await text()).includes('+--[ ]( start )--( )( run )--+'));
        const link = it.page.locator('#step a');
        assert.match(await link.getAttribute('href'), /guide\/first-program\.html#one-rung$/);
        await it.page.locator('#step button', { hasText: 'Next' }).click();
        await it.until('the second step', async () => (await text()).startsWith('+-\\-[ ]( start )'));
        await it.picture('step');
    }, failed);
    await step('a link holds the program and its scenarios', async () => {
        await it.page.locator('#program .cm-content').click();
        await it.page.keyboard.press('Control+a');
        await it.page.keyboard.insertText('# ünïcode <b>& "quotes" + % # \n+--[ ]( a )--( )( b )--+\n');
        const before = await text();
        await it.page.locator('#share').click();
        await it.page.locator('#message', { hasText: 'The link is copied' }).waitFor();
        const link = await it.page.evaluate(() => navigator.clipboard.readText());
        assert.equal(link, it.page.url());
        const other = await Playground.open(site, { fragment: new URL(link).hash });
        await other.until('the program', async () => (await other.lines()).join('\n') === before);
        await other.close();
    }, failed);
    await step('a link that cannot be read says so, and one that unfolds without end is refused', async () => {
        for (const [fragment, words] of [['#program=%%%', 'cannot be read'], ['#program=AAAA', 'cannot be read']]) {
            const other = await Playground.open(site, { fragment });
            await other.page.locator('#message', { hasText: words }).waitFor();
            await other.close();
        }
        const bomb = await it.page.evaluate(async () => {
            const stream = new Blob([new Uint8Array(64 << 20)]).stream().pipeThrough(new CompressionStream('deflate-raw'));
            const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
            return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join('')).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
        });
        const other = await Playground.open(site, { fragment: `#program=${bomb}` });
        await other.page.locator('#message', { hasText: 'too long' }).waitFor();
        await other.close();
    }, failed);
    await step('what a linked program says is never markup, and no script but the page\'s own is run', async () => {
        const evil = '<img src=x onerror="window.strange=1"><script>window.strange=2</script>';
        const other = await Playground.open(site, { text: `# ${evil} #\nVAR_INPUT  go : BOOL;  # ${evil} #  END_VAR\n+--[ ]( go )--( )( b )--+\n` });
        await other.page.locator('#program .cm-line span', { hasText: /^go$/ }).last().hover();
        await other.page.locator('.cm-tooltip-hover').waitFor();
        await other.tab('problems');
        assert.equal(await other.page.locator('.cm-tooltip-hover img, .cm-tooltip-hover script, .problems img').count(), 0);
        const strange = await other.page.evaluate(async () => {
            const script = document.createElement('script');
            script.textContent = 'window.strange = 3';
            document.body.append(script);
            const plain = document.createElement('div');
            plain.setAttribute('onclick', 'window.strange = 4');
            document.body.append(plain);
            plain.click();
            const fetched = await fetch('https://example.org/').then(() => true, () => false);
            return { strange: window.strange, fetched };
        });
        assert.deepEqual(strange, { strange: undefined, fetched: false });
        // The browser says what it has refused.
        assert.ok(other.strange.every((words) => /Content Security Policy|violates/.test(words)), other.strange.join('\n'));
        other.strange.length = 0;
        await other.close();
    }, failed);
    await step('a file of another system that is dropped opens as ladder text', async () => {
        const content = readFileSync(join(LADDER_ROOT, 'tests/editors/fixtures/motor.rung'), 'utf8');
        const transfer = await it.page.evaluateHandle((words) => {
            const made = new DataTransfer();
            made.items.add(new File([words], 'motor.rung'));
            return made;
        }, content);
        await it.page.dispatchEvent('#program .cm-content', 'drop', { dataTransfer: transfer });
        await it.until('the program', async () => (await text()).includes('+--'));
        await it.page.locator('#message', { hasText: 'translated' }).waitFor();
        await it.page.locator('#tab-program', { hasText: 'motor.clad' }).waitFor();
        if (await it.page.locator('#choice').evaluate((dialog) => dialog.open)) {
            await it.picture('dropped');
            await it.page.locator('#choice button').click();
        }
    }, failed);
    await step('a report opens at its top, and its lines are wrapped', async () => {
        const rungs = Array.from({ length: 80 }, (_, at) => `SOR XIC I:1/${at % 16} MSG MG9:${at} EOR\n`).join('');
        await it.page.locator('#file').setInputFiles({ name: 'plant.slc', mimeType: 'text/plain', buffer: Buffer.from(rungs) });
        const report = it.page.locator('#choice pre');
        await report.waitFor();
        await it.picture('report');
        const { top, overflow, lines } = await report.evaluate((node) => ({ top: node.scrollTop, overflow: node.scrollWidth - node.clientWidth, lines: node.textContent.split('\n').length }));
        assert.ok(lines > 50, `${lines} lines`);
        assert.deepEqual({ top, overflow }, { top: 0, overflow: 0 });
        for (const part of ['h2', 'button']) {
            const box = await it.page.locator(`#choice ${part}`).boundingBox();
            assert.ok(box.y >= 0 && box.y + box.height <= 850, `${part} is out of sight`);
        }
        await it.page.locator('#choice button').click();
        await it.page.locator('#back').click();
        await it.until('the program before', async () => (await it.page.locator('#tab-program').textContent()).includes('motor.clad'));
    }, failed);
    const exported = async (title) => {
        await it.page.locator('#export').click();
        const [download] = await Promise.all([it.page.waitForEvent('download'), it.page.getByRole('menuitem', { name: title }).click()]);
        return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
    };
    await step('text, picture and trace are exported', async () => {
        await it.page.locator('#examples').selectOption({ label: 'Motor' });
        await it.until('the example', async () => (await text()).includes('A motor starter'));
        const program = await exported(/^Program/);
        assert.equal(program.name, 'motor.clad');
        assert.equal(program.bytes.toString(), readFileSync(join(LADDER_ROOT, 'examples/motor.clad'), 'utf8'));
        const svg = await exported('Picture (SVG)');
        assert.match(svg.bytes.toString(), /^<svg[^]*<\/svg>\s*$/);
        const png = await exported('Picture (PNG)');
        assert.equal(png.bytes.subarray(1, 4).toString(), 'PNG');
        assert.ok(png.bytes.length > 3000);
        await it.page.keyboard.press('F10');
        await it.page.keyboard.press('F10');
        await it.standing('scan 2');
        const csv = await exported('Trace of the simulation (CSV)');
        const rows = csv.bytes.toString().trimEnd().split('\n');
        assert.match(rows[0], /^scan,time_ms,start,stop,run,/);
        assert.ok(rows.length >= 3, rows.join('\n'));
        await it.page.keyboard.press('Shift+F5');
    }, failed);
    await step('a program is exported in another notation', async () => {
        const { name, bytes } = await exported('As Click program in Python');
        assert.equal(name, 'motor.py');
        assert.match(bytes.toString(), /def main/);
    }, failed);
    await step('what becomes several files is one archive', async () => {
        const { name, bytes } = await exported('As C library');
        assert.equal(name, 'motor.zip');
        const names = execFileSync('python3', ['-c', 'import io, sys, zipfile; print(*zipfile.ZipFile(io.BytesIO(sys.stdin.buffer.read())).namelist())'], { input: bytes, encoding: 'utf8' });
        assert.equal(names.trim(), 'motor.c motor.h');
    }, failed);
    await step('what was typed is there again on the next visit', async () => {
        await it.page.locator('#program .cm-content').click();
        await it.page.keyboard.press('Control+Home');
        await it.type('# kept # ');
        await it.page.goto(`${site}/playground/index.html`);
        await it.until('the text', async () => (await text()).startsWith('# kept #'));
    }, failed);
    await it.close().catch((error) => step('nothing leaves the browser', () => Promise.reject(error)));
}
