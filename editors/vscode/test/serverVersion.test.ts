import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

import { fit, misfit } from '../src/serverVersion.ts';

const verdict = (server: string, extension: string) => {
    const found = fit(`ladder ${server}\n`, extension);
    return found.fits ? 'fits' : found.why;
};

test('versions are compared as Cargo compares them', () => {
    const cases = [
        ['0.1.0', '0.1.0', 'fits'],
        ['0.1.7', '0.1.0', 'fits'],
        ['0.1.0', '0.1.2', 'older'],
        ['0.2.0', '0.1.9', 'newer'],
        ['0.1.9', '0.2.0', 'older'],
        ['0.9.0', '1.0.0', 'older'],
        ['1.4.0', '1.2.3', 'fits'],
        ['1.2.2', '1.2.3', 'older'],
        ['2.0.0', '1.9.9', 'newer'],
        ['1.2.3-rc.1', '1.2.3', 'fits'],
        ['0.0.2', '0.0.1', 'newer'],
    ] as const;
    for (const [server, extension, expected] of cases) {
        assert.equal(verdict(server, extension), expected, `${server} under ${extension}`);
    }
});

test('what has no version of ladder is another program', () => {
    for (const printed of ['', 'GNU ladder 3\n', 'ladder\n', 'ladder two\n', 'ladder 0.1\n', 'usage: ladder\nfile']) {
        const found = fit(printed, '0.1.0');
        assert.ok(!found.fits && found.why === 'other-program', printed);
    }
    assert.equal(
        misfit(fit('snakes 1.0\nand more', '0.1.0'), '/bin/ladder'),
        '"/bin/ladder" is not the language server: asked for its version it says "snakes 1.0".',
    );
});

test('the message says what to update', () => {
    assert.match(misfit(fit('ladder 0.0.9', '0.1.0'), '/x'), /"\/x" has version 0\.0\.9, this extension 0\.1\.0\..*until the server is updated/);
    assert.match(misfit(fit('ladder 0.2.0', '0.1.0'), '/x'), /until the extension is updated/);
    assert.equal(misfit(fit('ladder 0.1.0', '0.1.0'), '/x'), '');
    assert.equal(misfit(fit('ladder 0.1.0 (afd4a9480, x86_64-unknown-linux-gnu)', '0.1.0'), '/x'), '');
});

test('the extension has the version of the server that it is released with', () => {
    const manifest = JSON.parse(readFileSync(new URL('../package.json', import.meta.url), 'utf8'));
    const workspace = readFileSync(new URL('../../../Cargo.toml', import.meta.url), 'utf8');
    assert.equal(/\[workspace\.package\]\nversion = "(.+)"/.exec(workspace)?.[1], manifest.version);
});
