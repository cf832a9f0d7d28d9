// Programs are drawn from nothing by keys alone; each change is one edit, and one undo.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { ACTIONS, actionOf } from '../../panels/diagram/draw/actions.ts';
import { diagrams, railed, until } from './drawn.mjs';

const open = diagrams();

export const STARTER = `+--\\--[ ]( start )--\\--[/]( stop )---------------------------------( )( run )--+
|  /--[ ]( run )----/                                                          |
`;

test('no key means two things about the same', () => {
    const seen = new Set();
    for (const { keys, on } of ACTIONS) {
        for (const key of keys.flatMap((key) => on.map((about) => `${key} on ${about}`))) {
            assert.ok(!seen.has(key), key);
            seen.add(key);
        }
    }
    assert.equal(actionOf('/', 'element')?.title, 'Open or closed');
    assert.equal(actionOf('/', 'point')?.title, 'End the branch');
    assert.equal(actionOf('C', 'nothing'), undefined);
});

test('a motor starter', async () => {
    const { press, write, becomes, focusOn, page, host } = await open('');
    await page.locator('.view').focus();
    await press('n');
    await write('XIC start XIO stop OTE run');
    await focusOn('Open contact start');
    await press('b');
    await write('run');
    await becomes(STARTER);
    assert.equal(host.edits, 2);
    await focusOn('Open contact run');
    await press('Control+z');
    await becomes('+--[ ]( start )--[/]( stop )---------------------------------------( )( run )--+\n');
    await focusOn('Open contact start');
    await press('Control+y');
    await becomes(STARTER);
    assert.deepEqual(host.errors, []);
});

test('a garage door', async () => {
    const { press, write, becomes, focusOn, page } = await open('');
    await page.locator('.view').focus();
    await press('n');
    await write('[ ]( up_button )--[/]( top )--[/]( down )--( )( up )');
    await focusOn('Open contact up_button');
    await press('b');
    await write('up');
    await focusOn('Open contact up');
    await press('n');
    await write('XIC down_button XIO bottom XIO beam XIO up OTE down');
    await focusOn('Open contact down_button');
    await press('b');
    await write('down');
    await focusOn('Open contact down');
    await press('#');
    await write('Down, unless somebody is in the way.');
    await becomes(`+--\\--[ ]( up_button )--\\--[/]( top )--[/]( down )------------------( )( up )--+
|  /--[ ]( up )---------/                                                      |

# Down, unless somebody is in the way. #
+--\\--[ ]( down_button )--\\--[/]( bottom )--[/]( beam )--[/]( up )--------------------( )( down )--+
|  /--[ ]( down )---------/                                                                        |
`);
});

test('whoever knows XIC finds it first', async () => {
    for (const [names, first, otherwise] of [['iec', 'Open contact', /^XIC, /], ['us', 'XIC', /^Open contact, /]]) {
        const { page } = await open('', { names });
        await page.getByRole('button', { name: first, exact: true }).waitFor();
        await page.locator('.palette input').fill('xic');
        const row = page.locator('.palette .row').first();
        await row.waitFor();
        assert.equal(await row.locator('span').first().textContent(), first);
        assert.match(await row.locator('.elsewhere').textContent(), otherwise);
    }
});

test('whoever knows XIC hears it', async () => {
    const { page, press, write, focusOn, element } = await open(railed('+--[ ]( a )--', '( )( y )'), { names: 'us' });
    await element('contact', 'a').focus();
    await focusOn('XIC a');
    await press('Shift+c');
    await page.locator('.field input[aria-label="XIO"]').waitFor();
    await write('b');
    await focusOn('XIO b');
    assert.match(await page.locator('.spoken').innerText(), /^XIO b added/);
});

test('two pumps that take turns, with a block of the library', async () => {
    const { press, write, focusOn, page, host } = await open('');
    await page.locator('.view').focus();
    await press('n');
    await write('XIC float OTE demand');
    await focusOn('Open contact float');
    await press('f');
    await page.keyboard.type('take turns');
    await press('Escape');
    await press('n');
    await write('XIC demand OTE pump_1');
    await focusOn('Open contact demand');
    await press('f');
    await page.keyboard.type('alternate');
    await page.locator('.palette .row[aria-selected="true"]', { hasText: '[$Alternate]' }).waitFor();
    await press('Enter');
    await write('turns, 1, 2, 1, 16#FF, pump_1, pump_2');
    await until('the block', () => host.text.includes('[$Alternate]( turns, 1, 2, 1, 16#FF, pump_1, pump_2 )'));
    assert.equal(host.edits, 3);
});

test('an end of a branch moves, elements move, a branch begins and ends', async () => {
    const { press, write, becomes, focusOn, wire, page, element } = await open('+--[ ]( a )--[ ]( b )--[ ]( c )------------------------------------( )( y )--+\n');
    await wire('between the left and a').focus();
    await press('\\');
    await wire('between a and b').focus();
    await press('/');
    await write('d');
    const branched = `+--\\--[ ]( a )--\\--[ ]( b )--[ ]( c )--------------------------------( )( y )--+
|  /--[ ]( d )--/                                                              |
`;
    await becomes(branched);
    await focusOn('Open contact d');
    await page.locator('g.element.join').last().focus();
    await press('Alt+ArrowRight');
    await becomes(`+--\\--[ ]( a )--[ ]( b )--\\--[ ]( c )--------------------------------( )( y )--+
|  /--[ ]( d )------------/                                                    |
`);
    await press('Control+z');
    await becomes(branched);
    await element('contact', 'b').focus();
    await press('Alt+ArrowRight');
    await becomes(`+--\\--[ ]( a )--\\--[ ]( c )--[ ]( b )--------------------------------( )( y )--+
|  /--[ ]( d )--/                                                              |
`);
    await focusOn('Open contact b');
    await press('Shift+Delete');
    await becomes('');
});

test('kinds, groups, networks and what cannot be done', async () => {
    const { press, becomes, focusOn, page, element, refusal } = await open(STARTER);
    await element('contact', 'start').focus();
    await press('/');
    await becomes(STARTER.replace('[ ]( start )', '[/]( start )'));
    await focusOn('Closed contact start');
    await press('e');
    await becomes(STARTER.replace('[ ]( start )', '[P]( start )'));
    await element('coil', 'run').focus();
    await press('s');
    await becomes(STARTER.replace('[ ]( start )', '[P]( start )').replace('( )( run )', '(S)( run )'));
    await focusOn('Set coil run');
    await element('contact', 'run').focus();
    await press('k');
    await until('a reason', refusal);
    await press('y');
    await until('two networks', async () => (await page.locator('.piece.network').count()) === 2);
    await press('?');
    assert.equal(await page.locator('dialog.keys[open]').count(), 1);
    await press('Escape');
    await until('the list closed', async () => (await page.locator('dialog.keys').count()) === 0);
});

test('a group is selected with all its branches, and goes as one', async () => {
    const { press, becomes, focusOn, page, element } = await open(STARTER);
    await element('contact', 'start').focus();
    await focusOn('Open contact start');
    await press('a');
    await until('the group', async () => (await page.locator('g.element.chosen').count()) === 2);
    await press('Delete');
    await becomes('+--[/]( stop )-----------------------------------------------------( )( run )--+\n');
});

test('a comment is selected, changed and deleted', async () => {
    const { press, write, becomes, focusOn, page } = await open(`# Starts it. #\n${STARTER}`);
    await page.locator('g.element.note').focus();
    await press('Enter');
    await write('Starts the motor.');
    await becomes(`# Starts the motor. #\n${STARTER}`);
    await page.locator('g.element.note').focus();
    await press('Delete');
    await becomes(STARTER);
    await press('n');
    await write('XIC a OTE b');
    await focusOn('Open contact a');
    await press('#');
    await write('The second.');
    // What is new has the focus, and the keys go on from there.
    await focusOn('Comment The second.');
    await press('ArrowDown');
    await focusOn('Open contact a');
});

test('a comment of several lines is written, changed and deleted', async () => {
    const { page, press, write, becomes, element, host } = await open(STARTER);
    await element('contact', 'start').focus();
    await press('#');
    const field = page.locator('.field textarea');
    await field.waitFor();
    await page.keyboard.type('Starts it,');
    await press('Shift+Enter');
    await page.keyboard.type('and holds it.');
    await press('Enter');
    await becomes(`# Starts it, #\n# and holds it. #\n${STARTER}`);
    assert.equal(host.edits, 1);
    // Comments that follow one another are one for who edits them.
    await page.locator('g.element.note').focus();
    await press('Enter');
    assert.equal(await field.inputValue(), 'Starts it,\nand holds it.');
    await write('Starts it.');
    await becomes(`# Starts it. #\n${STARTER}`);
    assert.equal(host.edits, 2);
});

test('one comment on several lines is changed and deleted', async () => {
    const { page, press, write, becomes } = await open(`# Starts it,\n  and holds it. #\n${STARTER}`);
    await page.locator('g.element.note').focus();
    await press('Enter');
    assert.equal(await page.locator('.field textarea').inputValue(), 'Starts it,\nand holds it.');
    await write('Starts it.');
    await becomes(`# Starts it. #\n${STARTER}`);
    await page.locator('g.element.note').focus();
    await press('Delete');
    await becomes(STARTER);
});

test('after an undo the focus is on what is nearest to what is gone', async () => {
    const more = `${STARTER}\n${railed('+--[ ]( run )--', '( )( lamp )')}`;
    const { press, becomes, focusOn, element, host, change } = await open(STARTER);
    // Somebody writes in the text.
    host.past.push(host.text);
    await change(more);
    await element('coil', 'lamp').waitFor({ state: 'attached' });
    await element('coil', 'lamp').focus();
    await press('Control+z');
    await becomes(STARTER);
    await focusOn('Open contact run');
    await press('Delete');
    await becomes(railed('+--[ ]( start )--[/]( stop )--', '( )( run )'));
    await press('Control+z');
    await becomes(STARTER);
    await focusOn('Open contact run');
});

test('what is pressed while a change is drawn keeps the focus', async () => {
    const { page, host, focusOn, element, settled } = await open(STARTER);
    await element('contact', 'stop').focus();
    let draw;
    host.held = new Promise((done) => (draw = done));
    await page.keyboard.press('/');
    await until('the change', () => host.text === STARTER.replace('[/]( stop )', '[ ]( stop )'));
    await element('contact', 'start').locator('.hit').click();
    draw();
    await settled();
    await focusOn('Open contact start');
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(done)));
    await focusOn('Open contact start');
});
