// What a configuration says of a launch: the file of retentive tags, the time from one scan to the next, and the speed.
import assert from 'node:assert/strict';
import { copyFileSync, existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, test } from 'node:test';

import { atEntry, client, leaveAdapter, lineOf, program, startAdapter, stopsAfter, value } from './client.mjs';

/** A folder of its own for each test, with a program that counts its scans in a retentive tag. */
let folder, own, kept;

beforeEach(() => {
    folder = mkdtempSync(join(tmpdir(), 'ladder-dap-'));
    own = join(folder, 'own.clad');
    kept = join(folder, 'kept');
    writeFileSync(own, 'VAR RETAIN n : INT; END_VAR\nVAR t : RTO; END_VAR\n+--[ADD]( n, n, 1 )--[RTO]( t, T#1h )--+\n');
    writeFileSync(join(folder, 'ladder.toml'), '');
});

afterEach(() => rmSync(folder, { recursive: true }));

/** Launches the program, up to before its first scan. */
async function launch(more) {
    const [, , stopped] = await Promise.all([
        client.configurationSequence(),
        client.launch({ program: own, stopOnEntry: true, ...more }),
        client.waitForEvent('stopped'),
    ]);
    assert.equal(stopped.body.reason, 'entry');
}

/** What the adapter writes into the console from now on. */
function written() {
    const lines = [];
    client.on('output', ({ body }) => lines.push(body.output));
    return lines;
}

const scan = () => stopsAfter('step', client.stepOutRequest({ threadId: 1 }));

/** Another session, as an editor begins one. */
async function another() {
    await leaveAdapter();
    await startAdapter();
}

test('what is retentive comes back in the next session, however the last one ended', async () => {
    const ends = {
        terminate: () => Promise.all([client.waitForEvent('terminated'), client.terminateRequest()]),
        disconnect: () => client.disconnectRequest({}),
        'the client is gone': leaveAdapter,
    };
    let scans = 0;
    for (const [how, end] of Object.entries(ends)) {
        await launch({ retain: 'kept' });
        assert.equal(await value('n'), String(scans), how);
        await scan();
        await scan();
        scans += 2;
        await end();
        await another();
    }
    assert.match(readFileSync(kept, 'utf8'), /^ladder-retain 1\nprogram own\.clad\nn\tINT\t6\nend [0-9a-f]{8}\n$/);
    assert.deepEqual(readdirSync(folder).sort(), ['kept', 'ladder.toml', 'own.clad']);
    // By its whole path, and by the settings of the folder.
    await launch({ retain: kept });
    assert.equal(await value('n'), '6');
    await another();
    writeFileSync(join(folder, 'ladder.toml'), '[simulate]\nretain = "kept"\n');
    await launch();
    assert.equal(await value('n'), '6');
});

test('a restart goes on with what is retentive, and steps back are not kept', async () => {
    await launch({ retain: 'kept' });
    await scan();
    await scan();
    await scan();
    await stopsAfter('step', client.stepBackRequest({ threadId: 1 }));
    await stopsAfter('step', client.stepBackRequest({ threadId: 1 }));
    await stopsAfter('entry', client.restartRequest({}));
    const again = Number(await value('n'));
    assert.match(readFileSync(kept, 'utf8'), new RegExp(`n\\tINT\\t${again}\\n`));
    assert.equal(await value('SYS.SCAN'), '0');
});

test('a file that is damaged is put aside, and the program starts cold', async () => {
    await launch({ retain: 'kept' });
    await scan();
    await client.disconnectRequest({});
    const whole = readFileSync(kept, 'utf8');
    for (const [damaged, aside] of [
        [whole.replace('\t1\n', '\t9\n'), 'kept.damaged'],
        [whole.slice(0, -12), 'kept.damaged.2'],
    ]) {
        await another();
        writeFileSync(kept, damaged);
        const lines = written();
        await launch({ retain: 'kept' });
        assert.equal(await value('n'), '0');
        assert.deepEqual(lines, [`${kept}: the file is damaged; the program starts cold, and the file is kept as ${join(folder, aside)}\n`]);
        assert.equal(readFileSync(join(folder, aside), 'utf8'), damaged);
        await client.disconnectRequest({});
    }
});

test('what was kept by another program is taken where it fits, and that is said', async () => {
    await launch({ retain: 'kept' });
    await scan();
    await client.disconnectRequest({});
    await another();
    const other = join(folder, 'other.clad');
    writeFileSync(other, readFileSync(own, 'utf8').replace('t : RTO;', 't : RTO; more : INT;'));
    const lines = written();
    await launch({ program: other, retain: 'kept' });
    assert.equal(await value('n'), '1');
    assert.deepEqual(lines, [`${kept}: the values were kept by own.clad; other.clad takes those that fit\n`]);
});

test('a file that cannot keep values is refused in words, and stays as it is', async () => {
    const notes = join(folder, 'notes.txt');
    writeFileSync(notes, 'call the electrician\n');
    mkdirSync(join(folder, 'sub'));
    await client.initializeRequest();
    for (const [retain, problem] of [
        ['notes.txt', /notes\.txt: this is not a file of retentive values, and it stays as it is/],
        ['own.clad', /own\.clad: this is not a file of retentive values/],
        ['sub', /sub: this is a folder/],
        ['none/kept', /none.kept: /],
        ['../elsewhere', /outside|out of the workspace/],
        [join(tmpdir(), 'elsewhere'), /outside/],
    ]) {
        await assert.rejects(client.launchRequest({ program: own, retain }), problem, retain);
    }
    assert.equal(readFileSync(notes, 'utf8'), 'call the electrician\n');
    assert.match(readFileSync(own, 'utf8'), /^VAR RETAIN/);
    assert.equal(existsSync(join(tmpdir(), 'elsewhere')), false);
    assert.deepEqual(readdirSync(folder).sort(), ['ladder.toml', 'notes.txt', 'own.clad', 'sub']);
    // The session is none the worse for it.
    await client.launchRequest({ program: own, stopOnEntry: true, retain: 'kept' });
    await stopsAfter('entry', client.configurationDoneRequest());
});

test('two sessions do not keep their values in one file', async () => {
    await launch({ retain: 'kept' });
    await startAdapter();
    await client.initializeRequest();
    await assert.rejects(client.launchRequest({ program: own, retain: 'kept' }), /kept: another run uses this file/);
});

test('a scenario starts cold, and keeps nothing', async () => {
    writeFileSync(join(folder, 'ladder.toml'), '[simulate]\nretain = "kept"\n');
    writeFileSync(join(folder, 'own.ladder-test'), 'program own.clad\n\nscenario "counts"\nn => 1 2\n');
    await launch();
    await scan();
    await client.disconnectRequest({});
    const before = readFileSync(kept, 'utf8');
    await another();
    await Promise.all([
        client.configurationSequence(),
        client.launch({ program: own, scenario: 'counts' }),
        client.assertOutput('stdout', 'scenario "counts" passed'),
    ]);
    assert.equal(readFileSync(kept, 'utf8'), before);
});

test('the time from one scan to the next is that of the configuration', async () => {
    writeFileSync(join(folder, 'ladder.toml'), '[simulate]\ninterval = "40ms"\n');
    for (const [cycle, then] of [
        [undefined, 'T#80ms'],
        ['25ms', 'T#50ms'],
        ['T#1m30s', 'T#3m'],
        [2.5, 'T#5ms'],
    ]) {
        await launch({ cycle });
        await scan();
        await scan();
        await scan();
        const what = `cycle ${cycle}`;
        // The first scan is at zero.
        assert.deepEqual([await value('t.ET'), await value('SYS.TIME'), await value('SYS.SCAN')], [then, then, '2'], what);
        await another();
    }
});

test('a run keeps to its speed', async () => {
    const source = { path: program };
    const line = lineOf('[GE]');
    // 20 s of the program at a thousand times their speed, and two days of it at full speed.
    for (const [cycle, speed, at] of [['1s', 1000, 20], ['1h', 'max', 50]]) {
        await atEntry({ cycle, speed });
        await client.setBreakpointsRequest({ source, breakpoints: [{ line, condition: `SYS.SCAN = ${at}` }] });
        await stopsAfter('breakpoint', client.continueRequest({ threadId: 1 }));
        assert.equal(await value('SYS.SCAN'), String(at), `${speed}`);
        await another();
    }
    // A scan is done at once; the next one is due in an hour, and a thousand hours.
    for (const more of [{ cycle: '1h' }, { cycle: '1h', speed: 0.001 }]) {
        await atEntry(more);
        await client.setBreakpointsRequest({ source, breakpoints: [{ line, logMessage: 'scan {SYS.SCAN}' }] });
        const lines = written();
        await Promise.all([client.assertOutput('console', 'scan 0'), client.continueRequest({ threadId: 1 })]);
        // What would come at once has come.
        await new Promise((resolve) => setTimeout(resolve, 50));
        await stopsAfter('pause', client.pauseRequest({ threadId: 1 }));
        assert.deepEqual(lines, ['scan 0\n']);
        assert.equal(await value('SYS.SCAN'), '0');
        await another();
    }
});

test('launches that cannot be are refused in words', async () => {
    await client.initializeRequest();
    const broken = join(folder, 'broken.clad');
    writeFileSync(broken, '+--[ ]( x --+\n');
    copyFileSync(program, join(folder, 'counter.txt'));
    for (const [more, problem] of [
        [{}, /`program` is missing/],
        [{ program: 'counter.clad' }, /whole path/],
        [{ program: join(folder, 'nothing.clad') }, /nothing.clad/],
        [{ program: join(folder, 'counter.txt') }, /\.clad or \.st file/],
        [{ program: broken }, /broken.clad:1: .*not run/],
        [{ program, inputs: { nobody: true } }, /nobody/],
        [{ program, inputs: { button: 7 } }, /button/],
        [{ program, inputs: '../../../../package.json' }, /inputs: .*package\.json/],
        [{ program, inputs: 'nothing.csv' }, /inputs: .*nothing\.csv/],
        [{ program, inputs: 'counter.clad' }, /inputs: .*counter\.clad/],
        [{ program, cycle: 'soon' }, /cycle/],
        [{ program, cycle: -5 }, /cycle/],
        [{ program, speed: 1e9 }, /speed/],
        [{ program, scenario: 'nobody wrote it' }, /nobody wrote it/],
    ]) {
        await assert.rejects(client.launchRequest(more), problem);
    }
});
