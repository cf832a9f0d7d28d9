// How it looks and sounds: light and dark, on a phone, by keyboard alone, and for a screen reader.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

import { Playground } from './page.mjs';
import { step } from './steps.mjs';

const axe = readFileSync(fileURLToPath(import.meta.resolve('axe-core/axe.min.js')), 'utf8');
const VIEWS = ['diagram', 'tags', 'traces', 'why', 'runs', 'problems'];
const PHONE = { width: 390, height: 844 };

/** What is about a page as a whole is not about its frames; a drawing is said in words that differ from the letters in it. */
const NOT_IN_FRAMES = ['landmark-one-main', 'page-has-heading-one', 'region', 'label-content-name-mismatch'];

/** What axe finds on the page and in its frames, in words. The page's policy lets no other script in: axe comes as the tools of a developer do. */
async function found(it) {
    const all = [];
    for (const frame of it.page.frames()) {
        if (frame !== it.page.mainFrame() && !(await (await frame.frameElement()).isVisible())) {
            continue;
        }
        await frame.evaluate(axe);
        const rules = frame === it.page.mainFrame() ? {} : Object.fromEntries(NOT_IN_FRAMES.map((rule) => [rule, { enabled: false }]));
        const violations = await frame.evaluate(
            (options) => axe.run(document, options).then((result) => result.violations),
            { resultTypes: ['violations'], iframes: false, rules },
        );
        all.push(...violations.flatMap(({ id, nodes }) => nodes.map((node) => `${id}: ${node.target.join(' ')}: ${node.failureSummary.split('\n').slice(1, 3).join(' ')}`)));
    }
    return all;
}

export async function looks(site) {
    for (const colorScheme of ['light', 'dark']) {
        const it = await Playground.open(site, { colorScheme });
        const failed = (name) => it.picture(`failed ${name}`);
        await it.page.locator('#simulation .act-run').click();
        await it.standing('running');
        await it.page.locator('.switch').first().click();
        await it.page.waitForTimeout(500);
        await it.page.keyboard.press('F6');
        await it.standing('paused');
        await it.tab('tags');
        await it.page.locator('#tags').getByRole('button', { name: 'Why run', exact: true }).click();
        for (const view of VIEWS) {
            await step(`axe finds nothing in ${view}, ${colorScheme}`, async () => {
                await it.tab(view);
                await it.page.waitForTimeout(300);
                await it.picture(`${colorScheme} ${view}`);
                assert.deepEqual(await found(it), []);
            }, failed);
        }
        await step(`axe finds nothing in the scenarios and the menus, ${colorScheme}`, async () => {
            await it.tab('scenarios');
            await it.page.locator('#export').click();
            await it.page.locator('.menu button').first().waitFor();
            assert.deepEqual(await found(it), []);
            await it.page.keyboard.press('Escape');
        }, failed);
        await it.close().catch((error) => step('nothing strange happens', () => Promise.reject(error)));
    }
    const it = await Playground.open(site, { viewport: PHONE });
    const failed = (name) => it.picture(`failed ${name}`);
    await step('on a phone all is in one column, and nothing is wider than the screen', async () => {
        await it.page.locator('#simulation .act-run').click();
        await it.standing('running');
        for (const view of VIEWS) {
            await it.tab(view);
            await it.page.waitForTimeout(300);
            await it.picture(`phone ${view}`);
            assert.equal(await it.page.evaluate(() => document.documentElement.scrollWidth), PHONE.width);
        }
        assert.deepEqual(await found(it), []);
    }, failed);
    const phone = await Playground.open(site, { viewport: PHONE, hasTouch: true });
    await step('on a phone a touch says what a tag holds and why, and the next one ends that', async () => {
        await phone.page.locator('#simulation .act-run').tap();
        await phone.standing('running');
        const live = phone.page.locator('.cm-tooltip-hover .live');
        await phone.page.locator('#program .switch').first().tap();
        await phone.page.waitForTimeout(700);
        assert.equal(await live.count(), 0, 'a switch is switched, and says nothing');
        await phone.page.locator('#program .cm-line span', { hasText: /^stop$/ }).last().tap();
        await live.waitFor();
        await phone.picture('phone hover');
        assert.equal(await phone.page.evaluate(() => document.documentElement.scrollWidth), PHONE.width);
        await phone.page.locator('h1 span').tap();
        await phone.until('it to go', async () => (await live.count()) === 0);
    }, (name) => phone.picture(`failed ${name}`));
    await phone.close().catch((error) => step('nothing strange happens where it is touched', () => Promise.reject(error)));
    await it.close().catch((error) => step('nothing strange happens on a phone', () => Promise.reject(error)));

    const keys = await Playground.open(site);
    await step('Tab reaches all that can be pressed, and all of it has a name', async () => {
        await keys.page.locator('h1 a').focus();
        const names = [];
        for (let press = 0; press < 40; press += 1) {
            const { name, isEditor } = await keys.page.evaluate(() => {
                const node = document.activeElement;
                const label = node.getAttribute('aria-label') ?? node.title ?? '';
                return { name: (label || node.textContent).trim(), isEditor: node.classList.contains('cm-content') };
            });
            names.push(name);
            if (isEditor) {
                // In a text Tab is a key of the text, but after Escape.
                await keys.page.keyboard.press('Escape');
            }
            await keys.page.keyboard.press('Tab');
        }
        assert.ok(names.every((name) => name !== ''), names.join(', '));
        for (const name of ['Open an example', 'Speed', 'Program', 'Light or dark']) {
            assert.ok(names.includes(name), `${name} is not reached: ${names.join(', ')}`);
        }
        for (const name of ['Open', 'Share', 'Run', 'Diagram']) {
            assert.ok(names.some((it) => it.includes(name)), `${name} is not reached: ${names.join(', ')}`);
        }
    }, (name) => keys.picture(`failed ${name}`));
    await step('tabs are chosen by the arrow keys', async () => {
        await keys.page.locator('#tab-diagram').focus();
        await keys.page.keyboard.press('ArrowRight');
        assert.equal(await keys.page.locator('#tab-tags').getAttribute('aria-selected'), 'true');
        assert.ok(await keys.page.locator('#tags').isVisible());
    });
    await step('what happens is said to a screen reader', async () => {
        await keys.page.keyboard.press('F5');
        await keys.page.locator('#status', { hasText: 'Simulation running' }).waitFor({ state: 'attached' });
        await keys.page.keyboard.press('F6');
        await keys.page.locator('#status', { hasText: 'Simulation paused' }).waitFor({ state: 'attached' });
    });
    await step('the switch for light and dark reaches the frames', async () => {
        await keys.tab('diagram');
        await keys.page.locator('#theme').selectOption('dark');
        const ground = () => keys.diagram.locator('body').evaluate((body) => getComputedStyle(body).backgroundColor);
        await keys.until('the dark ground', async () => (await ground()) === 'rgb(23, 25, 28)');
    });
    await keys.close().catch((error) => step('nothing strange happens', () => Promise.reject(error)));
}
