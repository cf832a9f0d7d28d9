// How fast it is, and how large. What a machine decides is printed; what must hold anywhere is checked.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { cpus, loadavg } from 'node:os';
import { join } from 'node:path';
import { brotliCompressSync } from 'node:zlib';

import { Playground } from './page.mjs';
import { step } from './steps.mjs';

/** In bytes, compressed. */
const MOST = 1_750_000;
const kB = (bytes) => `${Math.round(bytes / 1000)} kB`;
const rungs = (count) => Array.from({ length: count }, (_, at) => `+--[ ]( in${at} )--[/]( off${at % 50} )${'-'.repeat(30)}( )( out${at} )--+\n`).join('');

const print = (words) => console.log(`      ${words}`);

/** Opens a long program, and waits until it has been drawn. */
async function put(it, name, text) {
    await it.page.locator('#file').setInputFiles({ name: `${name}.clad`, mimeType: 'text/plain', buffer: Buffer.from(text) });
    await it.page.locator('#tab-program', { hasText: name }).waitFor();
    await it.diagram.locator('g.element text', { hasText: /^out0$/ }).waitFor();
    await it.page.locator('#program .cm-content').focus();
}

export async function speed(site) {
    await step('what the page loads up to its first diagnostics is small', async () => {
        const it = await Playground.open(site, { text: '+--[ ]( go )--\n' });
        await it.page.locator('.cm-lintRange').first().waitFor({ state: 'attached' });
        const names = new Set(it.requested.filter((url) => url.startsWith(site)).map((url) => new URL(url).pathname.split('/').at(-1)));
        await it.close();
        const sizes = [...names].map((name) => [name, brotliCompressSync(readFileSync(join(process.env.LADDER_SITE, 'playground', name))).length]);
        const sum = sizes.reduce((before, [, size]) => before + size, 0);
        print(`${kB(sum)} of brotli: ${sizes.map(([name, size]) => `${name} ${kB(size)}`).join(', ')}`);
        assert.ok(sum < MOST, `${sum} bytes`);
    });
    await step('the first diagnostics are there within a second', async () => {
        const times = [];
        for (let turn = 0; turn < 5; turn += 1) {
            const it = await Playground.open(site, { text: '+--[ ]( go )--\n' });
            await it.page.locator('.cm-lintRange').first().waitFor({ state: 'attached' });
            times.push(Math.round(await it.page.evaluate(() => performance.now())));
            await it.close();
        }
        print(`${times.join(', ')} ms after the page was asked for`);
        // A machine that has other work to do takes longer by so much.
        const busy = Math.max(loadavg()[0] / cpus().length, 1);
        assert.ok(Math.min(...times) < 1000 * busy, `${times.join()} at ${busy}`);
    });
    const it = await Playground.open(site, { text: '' });
    await step('keys typed into 1,000 rungs', async () => {
        await put(it, 'thousand', rungs(1000));
        await it.page.keyboard.press('Control+Home');
        await it.page.keyboard.press('End');
        await it.page.evaluate(() => {
            window.frames_ = [];
            const watch = (now) => {
                window.frames_.push(now);
                window.watching = requestAnimationFrame(watch);
            };
            requestAnimationFrame(watch);
        });
        await it.type('\n[ ]( a )--[/]( b )--[TON]( t, T#1s )--( )( c )--+\n', 40);
        const frames = await it.page.evaluate(() => {
            cancelAnimationFrame(window.watching);
            return window.frames_.slice(1).map((at, index) => at - window.frames_[index]);
        });
        const late = frames.filter((time) => time > 34).length;
        print(`${frames.length} frames, ${late} later than two, the longest ${Math.round(Math.max(...frames))} ms`);
        await it.picture('1000 rungs');
    });
    await step('Enter and a fast first key keep the rail of the rung, in 1,000 rungs', async () => {
        for (const delay of [30, 70, 130]) {
            await it.page.keyboard.press('Control+Home');
            await it.page.keyboard.press('End');
            await it.type(`\n[ ]( key${delay} )--( )( fast${delay} )--+`, delay);
            const rung = new RegExp(`^\\+--\\[ \\]\\( key${delay} \\)-+\\( \\)\\( fast${delay} \\)--\\+$`);
            await it.until(`the aligned rung at ${delay} ms a key`, async () => rung.test((await it.lines())[1]));
        }
    }, (name) => it.picture(`failed ${name}`));
    await step('1,000 rungs run as fast as they go', async () => {
        await it.page.locator('#simulation select').selectOption('max');
        await it.page.keyboard.press('F5');
        await it.standing('running');
        const scan = async () => Number(/scan ([\d,]+)/.exec(await it.page.locator('#simulation .standing').textContent())[1].replaceAll(',', ''));
        await it.page.waitForTimeout(1000);
        const [before, began] = [await scan(), Date.now()];
        await it.page.waitForTimeout(3000);
        const scans = (await scan()) - before;
        print(`${((Date.now() - began) * 1000 / scans).toFixed(1)} us a scan, with what the page draws of it`);
        await it.page.keyboard.press('Shift+F5');
        await it.standing('at rest');
        assert.ok(scans > 0);
    });
    await step('10,000 rungs are opened and scrolled through', async () => {
        const began = Date.now();
        await put(it, 'ten_thousand', rungs(10_000));
        print(`${Date.now() - began} ms to its first diagram`);
        await it.page.keyboard.press('Control+End');
        await it.page.locator('#program .cm-line', { hasText: 'out9999 ' }).waitFor();
        await it.page.keyboard.press('F5');
        await it.standing('running');
        await it.page.locator('#program .power').first().waitFor();
        await it.diagram.locator('g.element text', { hasText: /^out9999$/ }).waitFor();
        print(`${Date.now() - began} ms to the end of it, running`);
        await it.picture('10000 rungs');
    }, (name) => it.picture(`failed ${name}`));
    await it.close().catch((error) => step('nothing strange happens', () => Promise.reject(error)));
}
