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
    await step('"Try it" opens the program, to the letter', async () => {
        await it.page.goto(`${site}/guide/first-program.html`);
        const wanted = await it.page.locator('pre > code.language-clad').nth(2).textContent();
        await it.page.locator('a.try-it').nth(2).click();
        await it.page.waitForURL(/playground/);
        await it.until('the program', async () => `${(await it.lines()).join('\n')}` === wanted);
        await it.picture('tried');
    });
    it.strange.length = 0;
    await it.close();
}
