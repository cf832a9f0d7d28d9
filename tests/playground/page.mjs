// A page of the playground in a browser of its own, and what every part of the tests does with it.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';

import { chromium } from 'playwright-core';

const { LADDER_BROWSER, LADDER_SCREENSHOTS } = process.env;
const QUIET = ['--headless', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync'];

let browser;

export async function begin() {
    browser = await chromium.launch({ executablePath: LADDER_BROWSER, args: QUIET });
}

export async function end() {
    await browser.close();
}

export class Playground {
    /** What must not happen on any page: errors, breaches of its policy, words to other hosts. */
    strange = [];
    /** The addresses of all that it has loaded. */
    requested = [];

    static async open(site, { fragment = '', text, viewport = { width: 1400, height: 850 }, colorScheme = 'light', serviceWorkers = 'block', hasTouch = false } = {}) {
        // What a service worker loads is not seen here, so there is none but where it is tested.
        const context = await browser.newContext({ viewport, colorScheme, serviceWorkers, hasTouch, acceptDownloads: true, permissions: ['clipboard-read', 'clipboard-write'] });
        const playground = new Playground();
        playground.context = context;
        playground.page = await context.newPage();
        playground.page.setDefaultTimeout(10_000);
        playground.watch(playground.page, site);
        const hash = text === undefined ? fragment : `#name=test.clad&text=${encodeURIComponent(text)}`;
        await playground.page.goto(`${site}/playground/index.html${hash}`);
        await playground.page.locator('#program .cm-line').first().waitFor();
        return playground;
    }

    /** The playground in another tab of the same browser. */
    async another(site) {
        const playground = new Playground();
        playground.context = this.context;
        playground.page = await this.context.newPage();
        playground.page.setDefaultTimeout(10_000);
        playground.strange = this.strange;
        playground.watch(playground.page, site);
        await playground.page.goto(`${site}/playground/index.html`);
        await playground.page.locator('#program .cm-line').first().waitFor();
        return playground;
    }

    watch(page, site) {
        const { strange, requested } = this;
        page.on('pageerror', (error) => strange.push(`error: ${error.message}`));
        const isStrange = (message) => ['error', 'warning'].includes(message.type()) && !message.text().includes('blocked by Playwright');
        page.on('console', (message) => isStrange(message) && strange.push(`console: ${message.text()}`));
        page.on('request', (request) => {
            const url = request.url();
            requested.push(url);
            if (!url.startsWith(site) && !/^(data|blob):/.test(url)) {
                strange.push(`request: ${url}`);
            }
            if (request.method() !== 'GET') {
                strange.push(`${request.method()} ${url}`);
            }
        });
    }

    /** The lines of the program, as far as they are in sight. */
    lines(where = '#program') {
        return this.page.locator(`${where} .cm-line`).allTextContents();
    }

    async until(what, holds, seconds = 10) {
        const limit = Date.now() + seconds * 1000;
        let error;
        while (Date.now() < limit) {
            try {
                if (await holds()) {
                    return;
                }
            } catch (thrown) {
                error = thrown;
            }
            await new Promise((resolve) => setTimeout(resolve, 40));
        }
        throw new Error(`waited ${seconds} s in vain for ${what}${error ? `: ${error.message}` : ''}`);
    }

    get diagram() {
        return this.page.frameLocator('#diagram iframe');
    }

    get traces() {
        return this.page.frameLocator('#traces iframe');
    }

    tab(id) {
        return this.page.locator(`#tab-${id}`).click();
    }

    /** Types key by key, as a person does. */
    async type(text, delay = 25) {
        for (const letter of text) {
            await this.page.keyboard.press(letter === '\n' ? 'Enter' : letter === ' ' ? 'Space' : letter);
            await this.page.waitForTimeout(delay);
        }
    }

    /** Puts the cursor in a line, counted from 1, after so many letters. */
    async cursor(line, after) {
        await this.page.locator('#program .cm-content').focus();
        await this.page.keyboard.press('Control+Home');
        for (let at = 1; at < line; at += 1) {
            await this.page.keyboard.press('ArrowDown');
        }
        await this.page.keyboard.press('Home');
        for (let at = 0; at < after; at += 1) {
            await this.page.keyboard.press('ArrowRight');
        }
    }

    standing(words) {
        return this.page.locator('#simulation .standing', { hasText: words }).waitFor({ timeout: 10_000 });
    }

    async picture(name) {
        if (LADDER_SCREENSHOTS) {
            mkdirSync(LADDER_SCREENSHOTS, { recursive: true });
            await this.page.waitForTimeout(250);
            await this.page.screenshot({ path: join(LADDER_SCREENSHOTS, `site-${name.replaceAll(/\W+/g, '-')}.png`) });
        }
    }

    async close() {
        await this.context.close();
        assert.deepEqual(this.strange, []);
    }
}
