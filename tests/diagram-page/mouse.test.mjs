// Programs are drawn with the mouse; names are typed, or taken from lists. What a drag does a single click can do, too.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { diagrams, railed, until } from './drawn.mjs';

const open = diagrams();
const LINE = railed('+--[ ]( a )--[ ]( b )--[ ]( c )--', '( )( y )');

test('a motor starter from nothing', async () => {
    const { page, write, becomes, element, drag } = await open('');
    await page.getByRole('button', { name: 'New network' }).click();
    await page.locator('.field li', { hasText: 'A contact and a coil' }).click();
    await page.locator('.field .take').click();
    await page.locator('.field .take').click();
    await becomes(railed('+--[ ]( contact_1 )--', '( )( coil_1 )'));
    await page.locator('text', { hasText: 'contact_1' }).dblclick();
    await write('start');
    await element('coil', 'coil_1').locator('text').dblclick();
    await write('run');
    await becomes('+--[ ]( start )----------------------------------------------------( )( run )--+\n');
    await element('contact', 'start').waitFor({ state: 'attached' });
    await drag(page.locator('.favourites button', { hasText: '[/]' }), page.locator('g.element.point[aria-label*="start and run"] .ring'));
    await write('stop');
    await becomes('+--[ ]( start )--[/]( stop )---------------------------------------( )( run )--+\n');
    await element('contact', 'stop').waitFor({ state: 'attached' });
    await drag(page.locator('.favourites button', { hasText: '[ ]' }), element('contact', 'start').locator('.hit'), { dy: 22 });
    await write('run');
    await becomes(`+--\\--[ ]( start )--\\--[/]( stop )---------------------------------( )( run )--+
|  /--[ ]( run )----/                                                          |
`);
});

test('a second press shows what can be done, and why the rest cannot', async () => {
    const { page, write, becomes, element, menu, refusal } = await open(LINE);
    const b = element('contact', 'b').locator('.hit');
    await b.click();
    await b.click();
    await menu('Contact in parallel, below');
    await write('d');
    await becomes(railed('+--[ ]( a )--\\--[ ]( b )--\\--[ ]( c )--', '( )( y )') + railed('|            /--[ ]( d )--/'));
    const d = element('contact', 'd').locator('.hit');
    await d.waitFor({ state: 'attached' });
    await d.click({ button: 'right' });
    const join = page.getByRole('menuitem', { name: 'Join with the network below' });
    assert.equal(await join.getAttribute('aria-disabled'), 'true');
    assert.ok(await join.getAttribute('title'));
    await join.click({ force: true });
    await until('the reason', refusal);
    await d.click({ button: 'right' });
    await menu('Delete');
    await becomes(LINE);
});

test('a menu that is not waited for does not come', async () => {
    const { page, press, write, becomes, element } = await open(LINE);
    await element('contact', 'b').focus();
    await page.clock.install();
    await element('contact', 'b').locator('.hit').click();
    await press('c');
    await page.locator('.field input').waitFor();
    // As long as the second press of a double one may come.
    await page.clock.fastForward(400);
    await write('d');
    await becomes(railed('+--[ ]( a )--[ ]( b )--[ ]( d )--[ ]( c )--', '( )( y )'));
});

test('what is taken up is put down elsewhere by single clicks', async () => {
    const { becomes, element, menu, wire } = await open(LINE);
    await element('contact', 'c').locator('.hit').click({ button: 'right' });
    await menu('Take up, or cut');
    await wire('between the left and a').locator('.hit').click({ button: 'right' });
    await menu('Put down, or paste');
    await becomes(railed('+--[ ]( c )--[ ]( a )--[ ]( b )--', '( )( y )'));
});

test('what is copied by the menu is pasted by the menu', async () => {
    const { becomes, element, menu, wire } = await open(LINE);
    await element('contact', 'c').locator('.hit').click({ button: 'right' });
    await menu('Copy');
    await wire('between the left and a').locator('.hit').click({ button: 'right' });
    await menu('Put down, or paste');
    await becomes(railed('+--[ ]( c )--[ ]( a )--[ ]( b )--[ ]( c )--', '( )( y )'));
});

test('elements, ends of branches and networks are dragged', async () => {
    const two = `${railed('+--\\--[ ]( a )--\\--[ ]( b )--', '( )( y )')}${railed('|  /--[ ]( c )--/')}\n${railed('+--[ ]( d )--', '( )( z )')}`;
    const { page, becomes, settled, element, drag, host } = await open(two);
    await drag(page.locator('g.element.join').last().locator('.hit'), page.locator('g.element.point[aria-label*="b and y"] .ring'));
    await until('the end moved', () => host.text.startsWith('+--\\--[ ]( a )--[ ]( b )--\\--'));
    await settled();
    await page.keyboard.press('Control+z');
    await becomes(two);
    await until('the diagram', async () => (await page.locator('.piece.network').count()) === 2);
    await drag(element('contact', 'b').locator('.hit'), page.locator('g.element.point[aria-label*="d and z"] .ring'));
    await until('b moved', () => host.text.includes('[ ]( d )--[ ]( b )'));
    await until('both as they are now', async () => (await page.locator('g.element.contact', { hasText: 'b' }).count()) === 1);
    await drag(page.locator('.piece.network .gutter').last(), page.locator('.piece.network .gutter').first(), { dy: -4 });
    await until('the networks in another order', () => host.text.indexOf('( z )') < host.text.indexOf('( y )'));
});

test('a rubber band selects, and what is selected goes together', async () => {
    const { page, becomes, element } = await open(LINE);
    const [a, b] = [await element('contact', 'a').boundingBox(), await element('contact', 'b').boundingBox()];
    await page.mouse.move(a.x - 30, b.y + b.height + 40);
    await page.mouse.down();
    await page.mouse.move(b.x + b.width - 4, b.y + 10, { steps: 5 });
    await page.mouse.up();
    assert.equal(await page.locator('g.element.chosen').count(), 2);
    await page.keyboard.press('Delete');
    await becomes(railed('+--[ ]( c )--', '( )( y )'));
});

test('by a finger: the first press selects, the second shows what can be done', async () => {
    const { page, menu, write, becomes, element } = await open(LINE, { context: { hasTouch: true } });
    await element('contact', 'c').locator('.hit').tap();
    assert.equal(await page.locator('.menu').count(), 0);
    await element('contact', 'c').locator('.hit').tap();
    await menu('Open contact before it');
    await write('x');
    await becomes(railed('+--[ ]( a )--[ ]( b )--[ ]( x )--[ ]( c )--', '( )( y )'));
});

test('more networks come by the sign below one', async () => {
    const { page, write, host } = await open(LINE);
    await page.locator('.add').first().click();
    await write('XIC e OTE f');
    await until('the network', () => host.text.includes('[ ]( e )'));
});
