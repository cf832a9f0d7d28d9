import assert from 'node:assert/strict';
import { test } from 'node:test';

import type { Session } from '../session.ts';
import { answer, type Side, tell } from '../trace/answer.ts';
import type { FromPage, TraceAsked } from '../trace/messages.ts';

const asked: TraceAsked = { columns: 100, ticks: 5, cursors: [] };
const paused = { id: 's1', state: { status: 'paused' }, urgent: () => Promise.resolve({ tags: [{ name: 'a' }, { name: 'new' }] }) } as unknown as Session;
const running = { ...paused, id: 's2', state: { status: 'running' } } as unknown as Session;

/** An editor that shows the trace of a session, and notes what it is asked to do. */
function editor(session: Session | undefined, isSeen = true) {
    const done: unknown[][] = [];
    const note = (name: string) => (...given: unknown[]) => void done.push([name, ...given]);
    const names = ['send', 'pick', 'goTo', 'run', 'pause'] as const;
    const side = {
        ...Object.fromEntries(names.map((name) => [name, note(name)])),
        isSeen: () => isSeen,
        session: () => session,
        tags: () => Promise.resolve(['a', 'old']),
        choose: (_: Session, tags: readonly string[]) => note('choose')(tags),
    } as unknown as Side;
    return { side, done };
}

async function done(session: Session | undefined, message: FromPage): Promise<unknown[][]> {
    const { side, done } = editor(session);
    await answer(message, side);
    return done;
}

test('a page that is seen is told how the simulation is', async () => {
    const { side, done } = editor(running);
    await tell(side);
    assert.deepEqual(done, [['send', { kind: 'situation', situation: { session: 's2', running: true, tags: ['a', 'old'] } }]]);
    const hidden = editor(running, false);
    await tell(hidden.side);
    assert.deepEqual(hidden.done, []);
});

test('a tag that was renamed while it runs is shown by its new name', async () => {
    const [choose, traced] = await done(paused, { kind: 'ask', session: 's1', asked });
    assert.deepEqual(choose, ['choose', ['a', 'new']]);
    assert.equal((traced?.[1] as { kind: string }).kind, 'traced');
});

test('what is asked of another session is refused, and the page told of this one', async () => {
    const all = await done(paused, { kind: 'ask', session: 's9', asked });
    assert.deepEqual(all.map(([, message]) => (message as { kind: string }).kind), ['refused', 'situation']);
});

test('what a person does there is done with the session', async () => {
    assert.deepEqual(await done(paused, { kind: 'goTo', scan: 7 }), [['goTo', 7]]);
    assert.deepEqual(await done(paused, { kind: 'remove', tag: 'A' }), [['choose', ['old']]]);
    assert.deepEqual(await done(paused, { kind: 'move', tag: 'a', by: 1 }), [['choose', ['old', 'a']]]);
    assert.deepEqual(await done(paused, { kind: 'runOrPause' }), [['run']]);
    assert.deepEqual(await done(running, { kind: 'runOrPause' }), [['pause']]);
    assert.deepEqual(await done(undefined, { kind: 'choose' }), []);
});
