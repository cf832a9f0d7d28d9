import assert from 'node:assert/strict';
import { test } from 'node:test';

import { fromFragment, nameOf, toFragment } from '../src/link.ts';

test('a link holds the program and its scenarios, whatever letters they have', async () => {
    const linked = { name: 'motor.clad', text: '# ü 漢 " & + % #\n+--[ ]( a )--( )( b )--+\n', scenarios: 'program motor.clad\n' };
    const fragment = await toFragment(linked);
    assert.match(fragment, /^#program=[-\w]+$/);
    assert.deepEqual(await fromFragment(fragment), linked);
});

test('a link is shorter than its program', async () => {
    const text = '+--[ ]( start )--------------( )( run )--+\n'.repeat(100);
    assert.ok((await toFragment({ name: 'long.clad', text })).length < 300);
});

test('a text that is not compressed may hold a plus sign as it is', async () => {
    assert.deepEqual(await fromFragment('#name=a.clad&text=+--[%20]( a )--+%0A'), { name: 'a.clad', text: '+--[ ]( a )--+\n' });
});

test('a fragment without a program is none', async () => {
    assert.equal(await fromFragment(''), undefined);
    assert.equal(await fromFragment('#run'), undefined);
});

test('what is no program is an error', async () => {
    for (const fragment of ['#program=', '#program=%%', '#program=AAAA', (await toFragment({ name: 'a', text: 1 as unknown as string }))]) {
        await assert.rejects(fromFragment(fragment), fragment);
    }
});

test('a link that unfolds to more than a program is refused', async () => {
    const fragment = await toFragment({ name: 'a.clad', text: ' '.repeat(8 << 20) });
    assert.ok(fragment.length < 20_000);
    await assert.rejects(fromFragment(fragment), /too long/);
});

test('a name is one that a file may have', () => {
    assert.equal(nameOf('motor.clad'), 'motor.clad');
    assert.equal(nameOf('../../etc/passwd'), '_.._etc_passwd.clad');
    assert.equal(nameOf('motor'), 'motor.clad');
    assert.equal(nameOf(''), 'program.clad');
    assert.equal(nameOf(undefined), 'program.clad');
});

test('a link holds what is next to the program, but no other names', async () => {
    const linked = { name: 'tank.clad', text: '', files: { 'machine.clad': 'a', 'tank.scene.svg': '<svg/>', 'ladder.toml': '' } };
    assert.deepEqual(await fromFragment(await toFragment(linked)), linked);
    const odd = { ...linked, files: { '../a.clad': '', 'a/b.clad': '', 'page.html': '', '.clad': '', 'm.clad': 1 as unknown as string } };
    assert.deepEqual(await fromFragment(await toFragment(odd)), { name: 'tank.clad', text: '' });
});
