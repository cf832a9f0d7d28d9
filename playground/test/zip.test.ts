import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';

import { zip } from '../src/zip.ts';

const UNPACK = `
import json, sys, zipfile
archive = zipfile.ZipFile(sys.argv[1])
print(json.dumps([archive.testzip(), [[name, archive.read(name).decode()] for name in archive.namelist()]]))
`;

test('an archive is unpacked by others', async () => {
    const files = [['pump.c', '#include "pump.h"\n'], ['pump.h', ''], ['subroutines/Spülen.csv', 'ä\n'.repeat(5000)]] as const;
    const folder = mkdtempSync(join(tmpdir(), 'ladder-zip-'));
    const path = join(folder, 'pump.zip');
    writeFileSync(path, new Uint8Array(await zip(files.map(([name, text]) => ({ name, text }))).arrayBuffer()));
    const unpacked: unknown = JSON.parse(execFileSync('python3', ['-c', UNPACK, path], { encoding: 'utf8' }));
    rmSync(folder, { recursive: true });
    assert.deepEqual(unpacked, [null, files]);
});
