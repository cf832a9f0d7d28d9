// A debugging session with the client that the makers of the protocol test their own adapters with: a new one for each test of the
// file that takes this.
import assert from 'node:assert/strict';
import { once } from 'node:events';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { afterEach, beforeEach } from 'node:test';

import { DebugClient } from '@vscode/debugadapter-testsupport';

const { LADDER_BIN } = process.env;
export const program = fileURLToPath(new URL('programs/counter.clad', import.meta.url));
export const scenarios = fileURLToPath(new URL('programs/counter.ladder-test', import.meta.url));
export const text = readFileSync(program, 'utf8').split('\n');
/** The line of a text, from 1. */
export const lineOf = (part) => text.findIndex((line) => line.includes(part)) + 1;

/** @type {DebugClient} */
export let client;

/** The adapters that were started and may still run. */
const started = [];

/** Starts an adapter, as an editor does for each session. */
export async function startAdapter() {
    client = new DebugClient(LADDER_BIN, 'dap', 'ladder');
    await client.start();
    started.push(client._adapterProcess);
}

/** Goes away without a word from the adapter that was started last, and waits until it has ended. It may be over already. */
export async function leaveAdapter() {
    const adapter = started.pop();
    if (adapter?.exitCode === null && adapter.signalCode === null) {
        const ended = once(adapter, 'exit');
        adapter.stdin.end();
        await ended;
    }
}

beforeEach(startAdapter);

afterEach(async () => {
    while (started.length > 0) {
        await leaveAdapter();
    }
});

/** Starts a program that is before its first scan. */
export async function atEntry(more = {}) {
    await Promise.all([
        client.configurationSequence(),
        client.launch({ program, stopOnEntry: true, ...more }),
        client.assertStoppedLocation('entry', { path: program, line: lineOf('[P]( button )') }),
    ]);
}

/** Does something and waits until the program appears again. */
export async function stopsAfter(reason, action) {
    const [event] = await Promise.all([client.waitForEvent('stopped'), action]);
    assert.equal(event.body.reason, reason, JSON.stringify(event.body));
    const stack = await client.stackTraceRequest({ threadId: 1 });
    return { event: event.body, frames: stack.body.stackFrames, top: stack.body.stackFrames[0] };
}

/** What is at a place of the program. */
export const textAt = ({ line, column, endColumn }) => text[line - 1].slice(column - 1, endColumn - 1);

export async function variables(scope, frameId = 1) {
    const { body } = await client.scopesRequest({ frameId });
    const found = body.scopes.find(({ name }) => name === scope);
    assert.ok(found, `${scope} is none of ${body.scopes.map(({ name }) => name)}`);
    return list(found.variablesReference);
}

export async function list(variablesReference) {
    const { body } = await client.variablesRequest({ variablesReference });
    return Object.fromEntries(body.variables.map((variable) => [variable.name, variable]));
}

export async function value(expression, context = 'watch', frameId = 1) {
    const { body } = await client.evaluateRequest({ expression, context, frameId });
    return body.result;
}
