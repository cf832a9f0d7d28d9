// The book: each of its programs opens in the playground.
import assert from 'node:assert/strict';

import { Playground } from './page.mjs';
import { step } from './steps.mjs';

export async function book(site) {
    const it = await Playground.open(site, { text: '' });
    await step('every program of the book has "Try it"', async () => {
        for (const page of ['introduction.html', 'guide/first-program.html', 'rules/no-output.html', 'language/instructions/state.html']) {
            await it.page.goto(`${site}/${page}`);
            const [programs, links] = [await it.page.locator('pre > code.language-clad').count(), await it.page.locator('a.try-it').count()];
            assert.ok(programs > 0 && programs === links, `${page}: ${programs} programs, ${links} links`);
        }
    });
    await step('what is about a word is found first', async () => {
        await it.page.goto(`${site}/introduction.html`);
        for (const [words, page] of [['L5X', 'systems/logix.html'], ['OTE', 'systems/logix.html'], ['TON', 'language/instructions/state.html']]) {
            if (!(await it.page.locator('#mdbook-searchbar').isVisible())) {
                await it.page.locator('#mdbook-search-toggle').click();
            }
            await it.page.locator('#mdbook-searchbar').fill('');
            await it.page.locator('#mdbook-searchbar').pressSequentially(words);
            await it.page.locator('#mdbook-searchresults-header', { hasText: `'${words}'` }).waitFor();
            await it.until(`the page about ${words}`, async () => (await it.page.locator('#mdbook-searchresults a').first().getAttribute('href')).includes(page));
        }
        await it.picture('search');
    }, (name) => it.picture(`failed ${name}`));
    await step('programs that read find every page of the book', async () => {
        const [list, all, first] = await Promise.all(['llms.txt', 'llms-full.txt', 'introduction.md'].map(async (name) => (await fetch(`${site}/${name}`)).text()));
        const pages = [...list.matchAll(/^- \[.+?\]\((.+?)\): .+\.$/gm)].map(([, address]) => address);
        const base = pages[0].slice(0, -'introduction.md'.length);
        assert.ok(pages.length > 100 && pages.every((page) => page.startsWith(base)), `${pages.length} pages`);
        for (const page of pages) {
            const text = await (await fetch(`${site}/${page.slice(base.length)}`)).text();
            assert.ok(text.startsWith('# ') && all.includes(text.trim()), `${page} is not what it is in llms-full.txt`);
        }
        assert.ok(first.startsWith('# Ladder'));
    });
    await step('the front page shows a program that runs', async () => {
        await it.page.goto(`${site}/index.html`);
        const picture = it.page.locator('main picture img').first();
        await it.until('the picture', () => picture.evaluate((image) => image.complete && image.naturalWidth > 0));
        await it.picture('front page');
    });
    await step('the highlighter has nothing to complain about', async () => {
        for (const page of ['guide/proving.html', 'guide/other-editors.html', 'systems/logix.html', 'systems/click-csv.html', 'guide/git.html']) {
            await it.page.goto(`${site}/${page}`);
            await it.page.locator('code.hljs').first().waitFor();
        }
        assert.deepEqual(it.strange, []);
    });
    await step('"Try it" opens the program, to the letter', async () => {
        await it.page.goto(`${site}/guide/first-program.html`);
        const wanted = await it.page.locator('pre > code.language-clad').nth(2).textContent();
        await it.page.locator('a.try-it').nth(2).click();
        await it.page.waitForURL(/playground/);
        await it.until('the program', async () => `${(await it.lines()).join('\n')}` === wanted);
        await it.picture('tried');
    });
    await it.close().catch((error) => step('nothing strange happens in the book', () => Promise.reject(error)));
}
