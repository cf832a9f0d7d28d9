// What the tests of the page share: a browser for each file of tests, and hands for its page.
import { after, afterEach, before } from 'node:test';

import { openBrowser, openDiagram, until } from './host.mjs';

export { until };

/** A line of a network in 80 columns, with its outputs at the right rail. */
export function railed(left, right = '') {
    const [fill, end] = left.startsWith('+') ? ['-', '--+'] : [' ', '  |'];
    return `${left}${fill.repeat(80 - left.length - right.length - end.length)}${right}${end}\n`;
}

/** A browser as long as the tests of a file run. @returns opens a diagram in it, with hands */
export function diagrams() {
    let browser;
    before(async () => {
        browser = await openBrowser();
    });
    const opened = [];
    afterEach(() => Promise.all(opened.splice(0).map((diagram) => diagram.end())));
    after(() => browser.close());
    return async (text, options) => {
        const diagram = await openDiagram(browser, text, options);
        diagram.page.setDefaultTimeout(10_000);
        opened.push(diagram);
        return handsOf(diagram);
    };
}

function handsOf(diagram) {
    const { page } = diagram;
    const field = page.locator('.field :is(input, textarea)');
    const element = (kind, name) => page.locator(`g.element.${kind}`, { hasText: name }).first();
    return {
        ...diagram,
        /** Presses keys, one after the other. */
        press: async (...keys) => {
            for (const key of keys) {
                await page.keyboard.press(key);
            }
        },
        /** Writes into the field that something has opened. */
        write: async (words, key = 'Enter') => {
            await field.waitFor();
            await field.fill(words);
            await field.press(key);
            await field.waitFor({ state: 'detached' });
        },
        element,
        /** The text is this, and it is drawn. */
        becomes: async (wanted) => {
            await diagram.becomes(wanted);
            await diagram.settled();
        },
        /** The place in a wire by its words, as in `between start and stop`. */
        wire: (words) => page.locator(`g.element.point[aria-label*="${words}"]`).first(),
        focusOn: async (words) => until(`the focus on ${words}`, async () => (await diagram.focused()).startsWith(words)),
        menu: async (item) => {
            await page.locator('.menu').waitFor();
            await page.getByRole('menuitem', { name: item, exact: false }).first().click();
        },
        /** Drags with the mouse. */
        drag: async (from, to, { dy = 0, keys = [] } = {}) => {
            // What is above the drawing comes with answers, and moves it.
            await diagram.quiet();
            const boxes = async () => [await from.boundingBox(), await to.boundingBox()];
            let [a, b] = await boxes();
            await until('what is dragged to stay', async () => {
                const before = JSON.stringify([a, b]);
                [a, b] = await boxes();
                return a && b && JSON.stringify([a, b]) === before;
            });
            await page.mouse.move(a.x + a.width / 2, a.y + a.height / 2);
            await page.mouse.down();
            for (const key of keys) {
                await page.keyboard.down(key);
            }
            await page.mouse.move(b.x + b.width / 2, b.y + b.height / 2 + dy, { steps: 5 });
            await page.mouse.up();
            for (const key of keys) {
                await page.keyboard.up(key);
            }
        },
    };
}
