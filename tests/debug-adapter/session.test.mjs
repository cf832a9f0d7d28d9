// Holds `ladder dap` against the client that the makers of the protocol test their own adapters with.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';

import { atEntry, client, lineOf, list, program, scenarios, stopsAfter, text, textAt, value, variables } from './client.mjs';

test('capabilities are named, and what comes before them is refused', async () => {
    await assert.rejects(client.threadsRequest(), /initialize/);
    const { body } = await client.initializeRequest();
    assert.equal(body.supportsConfigurationDoneRequest, true);
    assert.equal(body.supportsStepBack, true);
    await assert.rejects(client.customRequest('dance'), /there is no request `dance`/);
    await assert.rejects(client.nextRequest({ threadId: 1 }), /no program is launched/);
});

test('a program runs to a breakpoint on a rung', async () => {
    await client.hitBreakpoint({ program, inputs: { button: true } }, { path: program, line: lineOf('( full )--+') });
    assert.equal(await value('presses'), '1');
});

test('a breakpoint on a block, by its column', async () => {
    const line = lineOf('[GE]');
    const column = text[line - 1].indexOf('[GE]') + 1;
    const stop = client.waitForEvent('stopped');
    await Promise.all([
        client.launch({ program }),
        client.waitForEvent('initialized').then(async () => {
            const { body } = await client.customRequest('breakpointLocations', { source: { path: program }, line });
            // Marks within the line would move the drawing apart.
            assert.deepEqual(body.breakpoints, [{ line }]);
            await client.setBreakpointsRequest({ source: { path: program }, breakpoints: [{ line, column }] });
            await client.configurationDoneRequest();
        }),
        stop,
    ]);
    const { body } = await client.stackTraceRequest({ threadId: 1 });
    assert.equal(textAt(body.stackFrames[0]), '[GE]( presses, LIMIT )');
});

test('a table gives inputs, scan by scan', async () => {
    await atEntry({ inputs: 'presses.csv' });
    const seen = [];
    for (let scan = 0; scan < 4; scan += 1) {
        await stopsAfter('step', client.stepOutRequest({ threadId: 1 }));
        seen.push(`${await value('button')} ${await value('presses')}`);
    }
    assert.deepEqual(seen, ['TRUE 1', 'TRUE 1', 'FALSE 1', 'TRUE 2']);
    // The history gives again what the table gave.
    await stopsAfter('step', client.stepBackRequest({ threadId: 1 }));
    await stopsAfter('entry', client.reverseContinueRequest({ threadId: 1 }));
    await stopsAfter('step', client.stepOutRequest({ threadId: 1 }));
    assert.equal(await value('presses'), '1');
});

test('steps by block, by rung, out, and by scan', async () => {
    await atEntry({ inputs: { button: true } });
    const seen = [];
    const note = ({ frames }) => seen.push(frames.map((frame) => `${frame.name.split(',')[0]} ${textAt(frame)}`).join(' < '));
    note(await stopsAfter('step', client.stepInRequest({ threadId: 1 })));
    note(await stopsAfter('step', client.stepInRequest({ threadId: 1 })));
    note(await stopsAfter('step', client.stepInRequest({ threadId: 1 })));
    note(await stopsAfter('step', client.stepOutRequest({ threadId: 1 })));
    note(await stopsAfter('step', client.nextRequest({ threadId: 1 })));
    note(await stopsAfter('step', client.nextRequest({ threadId: 1 })));
    note(await stopsAfter('step', client.nextRequest({ threadId: 1, granularity: 'instruction' })));
    note(await stopsAfter('step', client.stepBackRequest({ threadId: 1, granularity: 'instruction' })));
    note(await stopsAfter('step', client.stepBackRequest({ threadId: 1 })));
    note(await stopsAfter('step', client.stepOutRequest({ threadId: 1 })));
    assert.deepEqual(seen, [
        'main [$Tally]( 1, presses )',
        '$Tally#1 [ ]( EN ) < main [$Tally]( 1, presses )',
        '$Tally#1 [ADD]( sum, sum, step ) < main [$Tally]( 1, presses )',
        'main [$Tally]( 10, total )',
        'main [GE]( presses, LIMIT )',
        'main [ ]( button )',
        'main [TON]( hold, T#30ms )',
        'main [ ]( button )',
        'main [GE]( presses, LIMIT )',
        `main ${text[lineOf('[P]( button )') - 1]}`,
    ]);
    assert.equal(await value('SYS.SCAN'), '0');
    // All the way back.
    await stopsAfter('entry', client.reverseContinueRequest({ threadId: 1 }));
    assert.equal(await value('presses'), '0');
});

test('a step back goes over what a rung calls, and out of it to the call', async () => {
    await atEntry({ inputs: { button: true } });
    const place = async (part) => {
        const breakpoints = part ? [{ line: lineOf(part), condition: 'SYS.SCAN = 4' }] : [];
        await client.setBreakpointsRequest({ source: { path: program }, breakpoints });
    };
    const back = async () => {
        const { top, frames } = await stopsAfter('step', client.stepBackRequest({ threadId: 1 }));
        return [top.line, frames.length];
    };
    const calls = [lineOf('[$Tally]( 1'), 1];
    for (const [from, wanted] of [
        // Over two places of a user-defined block, and out of one.
        ['[GE]', calls],
        ['[ADD]( sum', calls],
        // Out of a function; the call is the last block of its rung.
        ['[DIV]', [lineOf('[TON]( hold'), 1]],
    ]) {
        await stopsAfter('entry', client.restartRequest({}));
        await place(from);
        await stopsAfter('breakpoint', client.continueRequest({ threadId: 1 }));
        await place(undefined);
        assert.deepEqual(await back(), wanted, from);
    }
    // Over a function: from the scan behind.
    await stopsAfter('step', client.stepOutRequest({ threadId: 1 }));
    const seen = [await back(), await back()];
    assert.deepEqual(seen, [[lineOf('[TON]( hold'), 1], [lineOf('[GE]'), 1]]);
});

test('the call stack goes through functions', async () => {
    await atEntry({ inputs: { button: true } });
    const breakpoints = [{ line: lineOf('[DIV]') }];
    await client.setBreakpointsRequest({ source: { path: program }, breakpoints });
    const { frames } = await stopsAfter('breakpoint', client.continueRequest({ threadId: 1 }));
    assert.deepEqual(frames.map(({ name }) => name.split(',')[0]), ['divide', 'main']);
    assert.equal(textAt(frames[1]), '<CALL>( divide )');
});

test('tags by what they are for, to be seen and changed', async () => {
    await atEntry();
    const { body } = await client.scopesRequest({ frameId: 1 });
    assert.deepEqual(
        body.scopes.map(({ name }) => name),
        ['Inputs', 'Outputs', 'Internal', 'Timers and counters', 'Constants', 'Blocks', 'System'],
    );
    assert.deepEqual(Object.keys(await variables('Inputs')), ['button', 'reset']);
    const { LIMIT } = await variables('Constants');
    assert.equal(LIMIT.value, '3');
    assert.deepEqual(LIMIT.presentationHint.attributes, ['readOnly']);
    const { hold } = await variables('Timers and counters');
    assert.deepEqual(Object.keys(await list(hold.variablesReference)), ['Q', 'ET', 'IN', 'PT']);
    const { marks } = await variables('Internal');
    assert.deepEqual(Object.keys(await list(marks.variablesReference)), ['[1]', '[2]', '[3]', '[4]']);
    assert.equal(marks.indexedVariables, 4);
    const blocks = await variables('Blocks');
    assert.deepEqual(Object.keys(blocks), ['$Tally#1', '$Tally#2']);
    assert.deepEqual(Object.keys(await list(blocks['$Tally#2'].variablesReference)), ['EN', 'ENO', 'step', 'sum', 'runs']);

    const inputs = body.scopes[0].variablesReference;
    const set = await client.setVariableRequest({ variablesReference: inputs, name: 'button', value: 'TRUE' });
    assert.equal(set.body.value, 'TRUE');
    await client.setVariableRequest({ variablesReference: marks.variablesReference, name: '[2]', value: 'LIMIT + 4' });
    assert.equal(await value('marks[2]'), '7');
    await assert.rejects(
        client.setVariableRequest({ variablesReference: inputs, name: 'button', value: 'many' }),
        /many/,
    );
    await client.customRequest('setExpression', { expression: '$Tally#1.runs', value: '41' });
    await stopsAfter('step', client.nextRequest({ threadId: 1 }));
    assert.equal(await value('$Tally#1.runs'), '42');
    // In the midst of a scan what is given waits for its end.
    const late = await client.customRequest('setExpression', { expression: 'button', value: 'FALSE' });
    assert.equal(late.body.value, 'TRUE \u2192 FALSE after this scan');
    await stopsAfter('step', client.stepOutRequest({ threadId: 1 }));
    assert.equal(await value('button'), 'FALSE');
});

test('the tags of a body are those of its place', async () => {
    await atEntry({ inputs: { button: true } });
    const breakpoints = [{ line: lineOf('[ADD]( runs'), column: text[lineOf('[ADD]( runs') - 1].indexOf('[ADD]( runs') + 1 }];
    await client.setBreakpointsRequest({ source: { path: program }, breakpoints });
    await stopsAfter('breakpoint', client.continueRequest({ threadId: 1 }));
    await stopsAfter('breakpoint', client.continueRequest({ threadId: 1 }));
    assert.equal((await variables('$Tally#2')).step.value, '10');
    assert.equal(await value('step + 1'), '11');
    await assert.rejects(value('step', 'watch', 2), /there is no tag `step`/);
});

test('tags are held', async () => {
    await atEntry();
    await client.customRequest('ladder/force', { name: 'button', value: 'TRUE' });
    const { button } = await variables('Inputs');
    assert.equal(button.value, 'TRUE (forced)');
    assert.deepEqual(button.presentationHint.attributes, ['forced']);
    assert.equal(await value('force full TRUE', 'repl'), 'TRUE (forced)');
    await stopsAfter('step', client.stepOutRequest({ threadId: 1 }));
    assert.equal(await value('full'), 'TRUE (forced)');
    await client.customRequest('ladder/unforce', { name: 'full' });
    await value('unforce', 'repl');
    assert.equal(await value('button'), 'FALSE');
    await assert.rejects(client.customRequest('ladder/force', { name: 'LIMIT', value: '4' }), /read-only/);
});

test('expressions in the language itself', async () => {
    await atEntry();
    await value('presses := 7', 'repl');
    for (const [expression, result] of [
        ['presses > 5', 'TRUE'],
        ['presses > 5 AND NOT button', 'TRUE'],
        ['presses * 2 + LIMIT', '17'],
        ['SQRT(2.0 * 8.0)', '4.0'],
        ['marks[1] + presses MOD 4', '3'],
        ['SUM(marks[1..4])', '0'],
        ['$Tally#1.runs + 1', '1'],
        ['hold.ET < T#1s', 'TRUE'],
        ['presses.0', 'TRUE'],
        ['MAX(presses, 9)', '9'],
    ]) {
        assert.equal(await value(expression), result, expression);
    }
    await value('divisor := 2', 'repl');
    assert.equal(await value('marks[divisor]'), '0');
    for (const [expression, problem] of [
        ['presse', /there is no tag `presse`; did you mean presses/],
        ['presses / (divisor - 2)', /division by zero/],
        ['presses +', /./],
        ['1 ) --( )( full', /./],
        ['presses AND button', /./],
        ['', /write an expression/],
    ]) {
        await assert.rejects(value(expression), problem, expression);
    }
    const { body } = await client.completionsRequest({ text: 'presses > ho', column: 13, frameId: 1 });
    assert.deepEqual(
        body.targets.map(({ label, start, length }) => [label, start, length]),
        ['hold', 'hold.ET', 'hold.IN', 'hold.PT', 'hold.Q'].map((label) => [label, 10, 2]),
    );
});

test('conditions, counts of hits and log points', async () => {
    await atEntry({ inputs: { button: true }, speed: 'max' });
    const line = lineOf('[GE]');
    const source = { path: program };
    await client.setBreakpointsRequest({ source, breakpoints: [{ line, condition: 'SYS.SCAN = 4' }] });
    await stopsAfter('breakpoint', client.continueRequest({ threadId: 1 }));
    assert.equal(await value('SYS.SCAN'), '4');
    await client.setBreakpointsRequest({ source, breakpoints: [{ line, hitCondition: '% 3' }] });
    await stopsAfter('breakpoint', client.continueRequest({ threadId: 1 }));
    assert.equal(await value('SYS.SCAN'), '7');
    const log = { line, logMessage: 'scan {SYS.SCAN}: {presses * 2} {{}}' };
    const set = await client.setBreakpointsRequest({ source, breakpoints: [log, { line, condition: 'SYS.SCAN = 9' }] });
    assert.deepEqual(set.body.breakpoints.map(({ verified }) => verified), [true, true]);
    const said = [];
    client.on('output', ({ body }) => said.push(body.output));
    await stopsAfter('breakpoint', client.continueRequest({ threadId: 1 }));
    assert.deepEqual(said, ['scan 8: 2 {}\n']);
    const wrong = await client.setBreakpointsRequest({
        source,
        breakpoints: [{ line, condition: 'pressed' }, { line, hitCondition: 'often' }, { line, logMessage: '{' }, { line, condition: 'presses' }],
    });
    for (const { verified, message } of wrong.body.breakpoints) {
        assert.equal(verified, false);
        assert.match(message, /pressed|often|brace|TRUE or FALSE/);
    }
});

test('a tag that changes stops the program', async () => {
    await atEntry();
    const info = await client.dataBreakpointInfoRequest({ name: 'presses' });
    assert.equal(info.body.dataId, 'presses');
    await client.setDataBreakpointsRequest({ breakpoints: [{ dataId: 'presses' }] });
    await value('button := TRUE', 'repl');
    const { event, top } = await stopsAfter('data breakpoint', client.continueRequest({ threadId: 1 }));
    assert.match(event.description, /presses changed from 0 to 1 at counter.clad:31/);
    assert.equal(textAt(top), '[ADD]( sum, sum, step )');
    assert.equal((await client.dataBreakpointInfoRequest({ name: 'nothing' })).body.dataId, null);
});

test('a fault is an exception', async () => {
    await atEntry({ inputs: { button: true, divisor: 0 } });
    const { event, top, frames } = await stopsAfter('exception', client.continueRequest({ threadId: 1 }));
    assert.match(event.description, /division by zero.*counter.clad:44/);
    assert.equal(textAt(top), '[DIV]( rate, total, divisor )');
    assert.equal(frames.length, 2);
    const { body } = await client.exceptionInfoRequest({ threadId: 1 });
    assert.equal(body.exceptionId, 'Fault');
    // The timer lets power through from the fourth scan on. The next fault is that of the next scan.
    assert.equal(await value('SYS.SCAN'), '3');
    await stopsAfter('exception', client.continueRequest({ threadId: 1 }));
    assert.equal(await value('SYS.SCAN'), '4');
    await client.setExceptionBreakpointsRequest({ filters: [] });
    await client.continueRequest({ threadId: 1 });
    await stopsAfter('pause', client.pauseRequest({ threadId: 1 }));
    await assert.rejects(client.exceptionInfoRequest({ threadId: 1 }), /did not stop for a fault/);
});

test('back to a breakpoint', async () => {
    await atEntry({ inputs: { button: true }, speed: 'max' });
    const source = { path: program };
    await client.setBreakpointsRequest({ source, breakpoints: [{ line: lineOf('[GE]'), condition: 'SYS.SCAN = 20' }] });
    await stopsAfter('breakpoint', client.continueRequest({ threadId: 1 }));
    await client.setBreakpointsRequest({ source, breakpoints: [{ line: lineOf('( full )--+'), condition: 'SYS.SCAN = 5' }] });
    const { top } = await stopsAfter('breakpoint', client.reverseContinueRequest({ threadId: 1 }));
    assert.equal(top.line, lineOf('( full )--+'));
    assert.equal(await value('SYS.SCAN'), '5');
    // And forward over the same scans.
    await client.setBreakpointsRequest({ source, breakpoints: [{ line: lineOf('[GE]'), condition: 'SYS.SCAN = 7' }] });
    await stopsAfter('breakpoint', client.continueRequest({ threadId: 1 }));
    assert.equal(await value('SYS.SCAN'), '7');
});

test('a scenario stops at the first expectation that is not met', async () => {
    const [, , stopped] = await Promise.all([
        client.configurationSequence(),
        client.launch({ program: scenarios, scenario: 'two are not enough' }),
        client.waitForEvent('stopped'),
    ]);
    assert.equal(stopped.body.reason, 'exception');
    assert.match(stopped.body.description, /full is FALSE, expected TRUE in step 3 \(counter.ladder-test:9\)/);
    const { body } = await client.stackTraceRequest({ threadId: 1 });
    const frame = body.stackFrames.at(-1);
    assert.equal(frame.source.path, scenarios);
    assert.deepEqual([frame.line, frame.column], [9, 12]);
    await client.setExceptionBreakpointsRequest({ filters: [] });
    const [exited] = await Promise.all([
        client.waitForEvent('exited'),
        client.waitForEvent('terminated'),
        client.continueRequest({ threadId: 1 }),
    ]);
    assert.equal(exited.body.exitCode, 1);
});

test('a scenario that passes ends by itself', async () => {
    const [, , exited] = await Promise.all([
        client.configurationSequence(),
        client.launch({ program, scenario: 'three presses' }),
        client.waitForEvent('exited'),
        client.assertOutput('stdout', 'scenario "three presses" passed'),
    ]);
    assert.equal(exited.body.exitCode, 0);
});

test('a run is paused, started anew and ended', async () => {
    await atEntry({ inputs: { button: true }, cycle: '1ms', speed: 1000 });
    const breakpoints = [{ line: lineOf('[GE]'), logMessage: 'running' }];
    await client.setBreakpointsRequest({ source: { path: program }, breakpoints });
    await Promise.all([client.assertOutput('console', 'running'), client.continueRequest({ threadId: 1 })]);
    await stopsAfter('pause', client.pauseRequest({ threadId: 1 }));
    assert.equal(await value('presses'), '1');
    await stopsAfter('entry', client.restartRequest({}));
    assert.equal(await value('presses'), '0');
    await Promise.all([client.waitForEvent('terminated'), client.terminateRequest()]);
    await assert.rejects(client.continueRequest({ threadId: 1 }), /the program is over/);
});

test('a scan that takes minutes does not keep a pause waiting', async () => {
    const folder = mkdtempSync(join(tmpdir(), 'ladder-dap-'));
    try {
        const endless = join(folder, 'endless.clad');
        writeFileSync(endless, 'VAR n : LINT; END_VAR\n+--<LBL>( again )--[ADD]( n, n, 1 )--<JMP>( again )--+\n');
        writeFileSync(join(folder, 'ladder.toml'), '[simulate]\nwatchdog = 1000000000000\n');
        await Promise.all([client.configurationSequence(), client.launch({ program: endless })]);
        await stopsAfter('pause', client.pauseRequest({ threadId: 1 }));
        assert.equal(await value('n'), '0');
        // A step gives up likewise.
        const step = client.stepOutRequest({ threadId: 1 });
        await Promise.all([step, client.pauseRequest({ threadId: 1 })]);
        await Promise.all([client.waitForEvent('terminated'), client.terminateRequest()]);
    } finally {
        rmSync(folder, { recursive: true });
    }
});
