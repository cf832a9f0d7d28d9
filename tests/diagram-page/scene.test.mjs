// A scene: what moves in it, what hands do, who does not see it or does not want motion, and what an attacker may try.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { after, test } from 'node:test';

import { openBrowser, until } from './host.mjs';
import { openScene } from './sceneHost.mjs';

const browser = await openBrowser();
after(() => browser.close());
const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const MACHINE = join(process.env.LADDER_ROOT, 'playground/machines/water_tank');
const tank = Object.fromEntries(readdirSync(MACHINE).map((name) => [name, readFileSync(join(MACHINE, name), 'utf8')]));

/** A test with a scene that is open. */
function scene(title, files, name, options, body) {
    test(title, async () => {
        const it = await openScene(browser, files, name, options);
        try {
            await body(it);
            assert.deepEqual(it.host.errors, []);
        } finally {
            await it.end();
        }
    });
}

const PROGRAM = 'VAR_INPUT a, b : BOOL; END_VAR\nVAR_OUTPUT y : BOOL; END_VAR\nVAR n : INT; END_VAR\n+--[ ]( a )--( )( y )--+\n+--[P]( b )--[ADD]( n, n, 1 )--+\n';
const svg = (inside) => `<svg xmlns="http://www.w3.org/2000/svg" xmlns:l="https://ladder.example/scene" viewBox="0 0 200 100"><title>t</title><desc>d</desc>${inside}</svg>`;
const files = (inside) => ({ 'main.clad': PROGRAM, 'main.scene.svg': svg(inside) });
const button = (what, alt) => `<g ${what} l:alt="${alt}"><rect x="10" y="10" width="80" height="40" fill="#eee"/></g>`;

scene('the water rises while the program runs, and the table tells the same', tank, 'water_tank.scene.svg', {}, async ({ page }) => {
    const water = page.locator('[aria-label="water"]');
    const height = () => water.evaluate((node) => Number(/scale\(1 ([\d.]+)\)/.exec(node.getAttribute('transform') ?? '')?.[1]));
    assert.equal(await height(), 0.45);
    await page.getByRole('button', { name: 'Run' }).click();
    await until('the pump', async () => (await page.locator('[aria-label="pump, on"]').count()) === 1);
    const low = await height();
    await until('the water', async () => (await height()) > low);
    await page.getByRole('button', { name: 'Table' }).click();
    await page.getByRole('button', { name: 'Pause' }).click();
    await page.getByRole('button', { name: 'Run' }).waitFor();
    const row = page.locator('tr', { hasText: 'l:scale-y' });
    await until('the row', async () => Math.abs(Number(await row.locator('.value').innerText()) - (await height())) < 0.001);
    assert.match(await row.innerText(), /^water/);
});

scene('a button holds its tag while it is pressed, by mouse and by key', files(button('l:press="a"', 'start')), 'main.scene.svg', {}, async ({ page, start, tag }) => {
    await start();
    const start_ = page.getByRole('button', { name: 'start' });
    await start_.hover();
    await page.mouse.down();
    await until('a', async () => (await tag('a')) === true);
    await page.mouse.up();
    await until('not a', async () => (await tag('a')) === false);
    await start_.focus();
    await page.keyboard.down('Space');
    await until('a by key', async () => (await tag('a')) === true);
    // Who goes away lets go.
    await page.keyboard.press('Tab');
    await until('not a without the focus', async () => (await tag('a')) === false);
    await page.keyboard.up('Space');
});

scene('a switch and a value, with their state for screen readers', files(button('l:toggle="a"', 'valve') + `<g l:set="n := n + 5" l:alt="five more"><rect x="110" y="10" width="80" height="40"/></g>`), 'main.scene.svg', {}, async ({ page, start, command, tag }) => {
    await start();
    const valve = page.getByRole('switch', { name: 'valve' });
    assert.equal(await valve.getAttribute('aria-checked'), 'false');
    await valve.click();
    await command('step', { scans: 1 });
    await until('on', async () => (await valve.getAttribute('aria-checked')) === 'true');
    await page.getByRole('button', { name: 'five more' }).focus();
    await page.keyboard.press('Enter');
    await until('n', async () => (await tag('n')) === 5);
});

scene('only what has changed is touched, at most once in a frame', files('<rect l:move-x="n"/>' + '<rect l:show="b"/>'.repeat(50)), 'main.scene.svg', {}, async ({ page, host, start, command }) => {
    await start();
    // At rest, and as it runs.
    await until('the scene', () => host.messages.filter(({ kind, shown }) => kind === 'scene' && shown.slots.length === 102).length === 2);
    await page.evaluate(() => new Promise((done) => setTimeout(done, 100)));
    await page.evaluate(() => {
        window.touched = [];
        new MutationObserver((changes) => window.touched.push(...changes.map(({ attributeName }) => attributeName))).observe(document.querySelector('svg'), { attributes: true, subtree: true });
    });
    await command('set', { tag: 'n', value: 7 });
    await until('the change', () => page.evaluate(() => window.touched.length > 0));
    assert.deepEqual(await page.evaluate(() => window.touched), ['transform']);
});

scene('without a simulation a press says what to do', files(button('l:press="a"', 'start')), 'main.scene.svg', {}, async ({ page }) => {
    await page.getByRole('button', { name: 'start' }).click();
    await page.getByText('Run the program first').waitFor();
});

scene('an alarm is said when it comes', files('<g l:show="a" role="alert" l:alt="too hot"><rect width="9" height="9"/></g>'), 'main.scene.svg', {}, async ({ page, start, command }) => {
    await start();
    await command('set', { tag: 'a', value: true });
    await until('the words', async () => (await page.locator('[aria-live="assertive"]').innerText()) === 'too hot');
});

scene('an alarm that comes with the picture is said, and only once', files('<g l:show="not a" role="alert" l:alt="too cold"><rect width="9" height="9"/></g>'), 'main.scene.svg', {}, async ({ page, teller, start }) => {
    const words = () => page.locator('[aria-live="assertive"]').innerText();
    assert.equal(await words(), '');
    await start();
    await until('the words', async () => (await words()) === 'too cold');
    await page.evaluate(() => {
        window.announced = 0;
        new MutationObserver(() => (window.announced += 1)).observe(document.querySelector('[aria-live="assertive"]'), { childList: true, characterData: true, subtree: true });
    });
    const drawn = await page.locator('.picture svg').elementHandle();
    await teller.open();
    await until('the picture again', () => drawn.evaluate((svg) => !svg.isConnected));
    assert.equal(await page.evaluate(() => window.announced), 0);
});

const blinking = files('<g l:show="not a" l:blink="500ms" l:alt="lamp"><rect width="9" height="9"/></g>');
const animated = (page) => page.evaluate(() => document.getAnimations().length);
scene('it blinks', blinking, 'main.scene.svg', { context: { reducedMotion: 'no-preference' } }, async ({ page }) => assert.equal(await animated(page), 1));
scene('it stands still for those who ask for less motion', blinking, 'main.scene.svg', {}, async ({ page }) => assert.equal(await animated(page), 0));

for (const colorScheme of ['light', 'dark']) {
    scene(`axe finds nothing, ${colorScheme}`, tank, 'water_tank.scene.svg', { context: { colorScheme } }, async ({ page }) => {
        await page.getByRole('button', { name: 'Table' }).click();
        await page.evaluate(axe);
        const found = await page.evaluate(async () => {
            const { violations } = await window.axe.run(document, { runOnly: ['wcag2a', 'wcag2aa', 'wcag21aa', 'wcag22aa', 'best-practice'], rules: { region: { enabled: false }, 'page-has-heading-one': { enabled: false }, 'landmark-one-main': { enabled: false } } });
            return violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html.slice(0, 160)).join(' | ')}`);
        });
        assert.deepEqual(found, []);
    });
}

const ATTACK = [
    '<script>window.hacked = 1</script>', '<rect onload="window.hacked = 1" onclick="window.hacked = 1" width="200" height="100"/>',
    '<image href="http://evil.test/a.png"/>', '<use href="http://evil.test/a.svg#x"/>', '<a href="javascript:window.hacked=1"><rect width="200" height="100"/></a>',
    '<foreignObject><iframe xmlns="http://www.w3.org/1999/xhtml" src="http://evil.test/"/></foreignObject>', '<animate attributeName="href" to="javascript:window.hacked=1"/>',
    '<rect fill="url(http://evil.test/a.svg#x)"/>', '<rect style="fill:url(http://evil.test/b.svg#x)"/>', '<style>@import url(http://evil.test/a.css); body { display: none }</style>',
    '<text l:text="name">x</text>',
].join('');
const attacked = { 'main.clad': `VAR name : STRING := '<img src=x onerror=window.hacked=1>'; END_VAR\n${PROGRAM}`, 'main.scene.svg': svg(ATTACK) };
scene('nothing in a file runs, loads or leads anywhere', attacked, 'main.scene.svg', {}, async ({ page, host, start }) => {
    await start();
    await until('the text', async () => (await page.locator('svg text').textContent()).includes('<img'));
    await page.mouse.click(400, 300);
    assert.equal(await page.evaluate(() => window.hacked), undefined);
    assert.deepEqual([...new Set(host.requests)], ['http://page.test/']);
    const names = await page.evaluate(() => [...new Set([...document.querySelectorAll('svg, svg *')].map((node) => node.localName))].sort());
    assert.deepEqual(names, ['desc', 'rect', 'svg', 'text', 'title', 'use']);
    const attributes = await page.evaluate(() => [...document.querySelectorAll('svg, svg *')].flatMap((node) => node.getAttributeNames()).filter((name) => /^on|href|style/.test(name)));
    assert.deepEqual(attributes, []);
    await page.getByText(/^Findings/).waitFor();
});

/** What builds the page writes no markup. */
test('no page takes markup for a scene', () => {
    const folder = join(process.env.LADDER_ROOT, 'panels/scene');
    for (const name of readdirSync(folder)) {
        assert.doesNotMatch(readFileSync(join(folder, name), 'utf8'), /innerHTML|outerHTML|insertAdjacentHTML|DOMParser|document\.write|eval\(/, name);
    }
});
