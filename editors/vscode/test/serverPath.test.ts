import assert from 'node:assert/strict';
import { test } from 'node:test';

import { cannotStart, findCargo, findServer, type Surroundings } from '../src/serverPath.ts';

function find(changes: Partial<Surroundings>) {
    return findServer({
        setting: '',
        extensionPath: '/ext',
        home: '/home/me',
        platform: 'linux',
        searchPath: '/usr/bin:/bin',
        folders: ['/plant'],
        isFile: () => false,
        ...changes,
    });
}

function among(...files: string[]) {
    return (path: string) => files.includes(path);
}

test('the setting goes first, even if it names nothing', () => {
    assert.deepEqual(find({ setting: '/opt/ladder', isFile: () => true }), { path: '/opt/ladder', from: 'setting' });
    assert.deepEqual(find({ setting: ' ~/bin/ladder ' }), { path: '/home/me/bin/ladder', from: 'setting' });
    const isFile = among('/bin/ladder-2');
    assert.equal(find({ setting: 'ladder-2', isFile }).path, '/bin/ladder-2');
});

test('a setting that is seen from a folder is not a program', () => {
    for (const setting of ['./ladder', 'bin/ladder', '../ladder', 'bin\\ladder']) {
        const place = find({ setting, isFile: () => true });
        assert.deepEqual(place, { path: undefined, from: 'setting', setting });
        assert.match(cannotStart(place, ''), /write the whole path/);
    }
});

test('then the program that came with the extension', () => {
    const isFile = among('/ext/server/ladder', '/usr/bin/ladder');
    assert.deepEqual(find({ isFile }), { path: '/ext/server/ladder', from: 'extension' });
});

test('then the PATH', () => {
    assert.deepEqual(find({}), { path: undefined, from: 'PATH' });
    assert.deepEqual(find({ isFile: among('/bin/ladder') }), { path: '/bin/ladder', from: 'PATH' });
    const windows = { platform: 'win32' as const, searchPath: 'C:\\Windows;"D:\\my tools"', folders: ['C:\\plant'] };
    assert.equal(find({ ...windows, isFile: among('D:\\my tools\\ladder.exe') }).path, 'D:\\my tools\\ladder.exe');
});

test('then the folder of Cargo', () => {
    const isFile = among('/home/me/.cargo/bin/ladder', '/opt/cargo/bin/ladder');
    assert.deepEqual(find({ isFile }), { path: '/home/me/.cargo/bin/ladder', from: 'cargo' });
    assert.equal(find({ isFile, cargoHome: '/opt/cargo' }).path, '/opt/cargo/bin/ladder');
    assert.equal(find({ isFile: among('/bin/ladder', '/home/me/.cargo/bin/ladder') }).from, 'PATH');
    for (const folders of [['/home/me'], ['/home/me/.cargo/bin']]) {
        assert.equal(find({ isFile, folders }).path, undefined, 'the open folder holds it');
    }
    const windows = { platform: 'win32' as const, home: 'C:\\Users\\me', searchPath: '', folders: ['C:\\plant'] };
    const there = 'C:\\Users\\me\\.cargo\\bin\\ladder.exe';
    assert.deepEqual(find({ ...windows, isFile: among(there) }), { path: there, from: 'cargo' });
});

test('Cargo itself is found in the same way', () => {
    const there = { setting: '', extensionPath: '/ext', home: '/home/me', platform: 'linux' as const, searchPath: '/bin', folders: [] };
    assert.equal(findCargo({ ...there, isFile: among('/bin/cargo') }), '/bin/cargo');
    assert.equal(findCargo({ ...there, isFile: among('/home/me/.cargo/bin/cargo') }), '/home/me/.cargo/bin/cargo');
    assert.equal(findCargo({ ...there, isFile: () => false }), undefined);
});

test('no program is taken from the folder that is open, wherever the PATH leads', () => {
    const notShipped = (path: string) => !path.startsWith('/ext') && !path.includes('.cargo');
    for (const searchPath of ['', '.', ':', 'bin', './bin:', '/plant', '/plant/bin', '/other/../plant/bin']) {
        assert.equal(find({ searchPath, isFile: notShipped }).path, undefined, searchPath);
    }
    assert.equal(find({ searchPath: '.:/plant-tools', isFile: notShipped }).path, '/plant-tools/ladder');
    const windows = { platform: 'win32' as const, folders: ['C:\\Plant'], isFile: notShipped };
    for (const searchPath of ['', '.', ';', 'bin', 'c:\\plant\\bin', 'C:bin']) {
        assert.equal(find({ ...windows, searchPath }).path, undefined, searchPath);
    }
});

test('the message says what to do', () => {
    assert.match(cannotStart({ path: undefined, from: 'PATH' }, ''), /Install it, or choose its file/);
    assert.match(cannotStart({ path: '/x', from: 'cargo' }, 'EACCES'), /"\/x" does not start: EACCES/);
    assert.match(cannotStart({ path: '/x', from: 'setting' }, 'ENOENT'), /"ladder.server.path" names "\/x".*ENOENT/);
});
