import assert from 'node:assert/strict';
import { test } from 'node:test';

import { cannotStart, findServer, type Surroundings } from '../src/serverPath.ts';

function find(changes: Partial<Surroundings>) {
    return findServer({ setting: '', extensionPath: '/ext', home: '/home/me', platform: 'linux', isFile: () => false, ...changes });
}

test('the setting goes first, even if it names nothing', () => {
    assert.deepEqual(find({ setting: '/opt/ladder', isFile: () => true }), { path: '/opt/ladder', from: 'setting' });
    assert.deepEqual(find({ setting: ' ~/bin/ladder ' }), { path: '/home/me/bin/ladder', from: 'setting' });
});

test('then the program that came with the extension', () => {
    const isFile = (path: string) => path === '/ext/server/ladder';
    assert.deepEqual(find({ isFile }), { path: '/ext/server/ladder', from: 'extension' });
});

test('then the PATH', () => {
    assert.deepEqual(find({}), { path: 'ladder', from: 'PATH' });
    assert.deepEqual(find({ platform: 'win32' }), { path: 'ladder.exe', from: 'PATH' });
});

test('the message says what to do', () => {
    assert.match(cannotStart({ path: 'ladder', from: 'PATH' }, 'ENOENT'), /Install it, or name its place/);
    assert.match(cannotStart({ path: '/x', from: 'setting' }, 'ENOENT'), /"ladder.server.path" names "\/x".*ENOENT/);
});
