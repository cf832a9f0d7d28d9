// What a person stops a program with besides a breakpoint, through the editor's own debugger: breakpoints with a count, log
// points and faults, and the way to where it stopped.
const assert = require('node:assert/strict');

const vscode = require('vscode');

/** A program of the project; each scan counts, calls a function, and a divisor of zero is a fault. */
const NAME = 'tally.clad';
const THREAD = { threadId: 1 };

/**
 * Debugs the program from a stop before its first scan, and ends that whatever the step finds. What comes from the debugger is
 * kept: where it stops, what it writes.
 */
async function debugged(document, eventually, given, check) {
    const [folder] = vscode.workspace.workspaceFolders;
    const stops = [];
    const written = [];
    const tracker = vscode.debug.registerDebugAdapterTrackerFactory('ladder', {
        createDebugAdapterTracker: () => ({
            onDidSendMessage: ({ event, body }) => {
                if (event === 'stopped') {
                    stops.push(body);
                } else if (event === 'output') {
                    written.push(body.output);
                }
            },
        }),
    });
    const configuration = { type: 'ladder', request: 'launch', name: 'probe', program: document.uri.fsPath, speed: 'max', stopOnEntry: true, ...given };
    const quiet = { suppressDebugView: true, suppressDebugToolbar: true, suppressDebugStatusbar: true };
    assert.ok(await vscode.debug.startDebugging(folder, configuration, quiet));
    await eventually('the stop before the first scan', () => stops.length === 1);
    const session = vscode.debug.activeDebugSession;
    const ask = (request, args) => session.customRequest(request, args);
    const run = {
        ask,
        written,
        /** Goes on to the next stop. */
        async goesOn() {
            const before = stops.length;
            await ask('continue', THREAD);
            await eventually('the next stop', () => stops.length > before);
            return stops.at(-1);
        },
        frames: async () => (await ask('stackTrace', THREAD)).stackFrames,
        value: async (expression) => (await ask('evaluate', { expression, context: 'watch' })).result,
    };
    try {
        await check(run);
    } finally {
        tracker.dispose();
        vscode.debug.removeBreakpoints(vscode.debug.breakpoints);
        await vscode.debug.stopDebugging(session);
        await eventually('the end', () => vscode.debug.activeDebugSession === undefined);
    }
}

function breakpoint(document, text, { hits, log } = {}) {
    const place = new vscode.Location(document.uri, document.positionAt(document.getText().indexOf(text)).with({ character: 0 }));
    vscode.debug.addBreakpoints([new vscode.SourceBreakpoint(place, true, undefined, hits, log)]);
}

async function debugging({ step, open, eventually }) {
    await step('a breakpoint with a count stops at that hit, inside the function and the block that were called', async () => {
        const document = await open(NAME);
        breakpoint(document, '[ADD]', { hits: '5' });
        await debugged(document, eventually, {}, async (run) => {
            assert.equal((await run.goesOn()).reason, 'breakpoint');
            assert.equal(await run.value('SYS.SCAN'), '4');
            const names = (await run.frames()).map(({ name }) => name.split(/[ ,:]/)[0]);
            assert.deepEqual(names, ['$Tally#1', 'count', 'main']);
            assert.equal(await run.value('scans + 10'), '14');
        });
    });
    await step('a log point writes, and stops nothing', async () => {
        const document = await open(NAME);
        breakpoint(document, '<CALL>', { log: 'scan {SYS.SCAN} has {scans}' });
        await debugged(document, eventually, {}, async (run) => {
            await run.ask('continue', THREAD);
            await eventually('the third line', () => run.written.some((line) => line.startsWith('scan 2 has 2')));
        });
    });
    await step('a fault stops the program where it is, and is named', async () => {
        const document = await open(NAME);
        await debugged(document, eventually, { inputs: { divisor: 0 } }, async (run) => {
            const stop = await run.goesOn();
            assert.equal(stop.reason, 'exception');
            assert.match(stop.text ?? stop.description, /division by zero/);
            const [top] = await run.frames();
            assert.equal(top.line, document.positionAt(document.getText().indexOf('[DIV]')).line + 1);
        });
    });
    await step('a restart begins at the first scan', async () => {
        const document = await open(NAME);
        breakpoint(document, '[ADD]', { hits: '3' });
        await debugged(document, eventually, {}, async (run) => {
            await run.goesOn();
            assert.equal(await run.value('SYS.SCAN'), '2');
            await vscode.commands.executeCommand('workbench.action.debug.restart');
            await eventually('the first scan', async () => (await run.value('SYS.SCAN').catch(() => '')) === '0');
        });
    });
}

module.exports = { debugging };
