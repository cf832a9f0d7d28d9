// How long it takes from a key that draws to the picture, in programs of several sizes. Prints a table.
import { openBrowser, openDiagram, until } from './host.mjs';

const TIMES = 40;

function program(networks) {
    const lines = ['VAR_INPUT', '    start, stop : BOOL;', 'END_VAR', ''];
    for (let number = 0; number < networks; number += 1) {
        lines.push(`+--\\--[ ]( start )----------\\--[/]( stop )---------------------( )( run_${String(number).padStart(5, '0')} )--+`);
        lines.push(`|  /--[ ]( run_${String(number).padStart(5, '0')} )--/                                                             |`, '');
    }
    return lines.join('\n');
}

const at = (sorted, part) => sorted[Math.min(Math.floor(sorted.length * part), sorted.length - 1)].toFixed(0).padStart(6);

const browser = await openBrowser();
console.log('networks  median    p95    max  (ms from the key to the picture)  redrawn');
for (const networks of [100, 1000, 10_000]) {
    const { page, host, settled, end } = await openDiagram(browser, program(networks));
    await settled();
    await page.evaluate(() => {
        const view = document.querySelector('.view');
        view.scrollTop = view.scrollHeight / 2;
    });
    await new Promise((done) => setTimeout(done, 1500));
    await page.evaluate(() => {
        const view = document.querySelector('.view').getBoundingClientRect();
        const inSight = [...document.querySelectorAll('g.element.contact')].find((node) => node.getBoundingClientRect().top > view.top + view.height / 2);
        inSight.focus();
        window.times = [];
        window.redrawn = [];
        window.jumps = [];
        let since;
        document.addEventListener('keydown', (event) => (since = event.timeStamp), true);
        new MutationObserver((records) => {
            const added = records.flatMap(({ addedNodes }) => [...addedNodes]).filter((node) => node.classList?.contains('piece'));
            if (added.length > 0 && since !== undefined) {
                const began = since;
                since = undefined;
                window.redrawn.push(added.length);
                requestAnimationFrame(() => setTimeout(() => window.times.push(performance.now() - began)));
            }
        }).observe(document.querySelector('.canvas'), { childList: true });
    });
    for (let count = 0; count < TIMES; count += 1) {
        const { version } = host;
        const top = await page.evaluate(() => document.querySelector('.view').scrollTop);
        await page.keyboard.press('/');
        await until('the change', () => host.version > version);
        await until('the picture', () => page.evaluate((count) => window.times.length > count, count));
        if (Math.abs((await page.evaluate(() => document.querySelector('.view').scrollTop)) - top) > 1) {
            console.log('  the page has jumped');
        }
    }
    const times = (await page.evaluate(() => window.times)).sort((a, b) => a - b);
    const redrawn = await page.evaluate(() => Math.max(...window.redrawn));
    console.log(`${String(networks).padStart(8)}  ${at(times, 0.5)} ${at(times, 0.95)} ${at(times, 1)}${' '.repeat(36)}${redrawn}`);
    await end();
}
await browser.close();
process.exit(0);
