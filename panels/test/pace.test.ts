// What changes with every state is shown with one of them, and not for itself.
import assert from 'node:assert/strict';
import { mock, test } from 'node:test';

import { Pace } from '../pace.ts';

test('of a run something is shown now and then, with a state', () => {
    mock.timers.enable({ apis: ['Date', 'setTimeout'], now: 10_000 });
    const shown: number[] = [];
    const pace = new Pace(200, () => shown.push(Date.now() - 10_000));
    for (let state = 0; state < 20; state += 1) {
        pace.changed(true);
        mock.timers.tick(30);
    }
    assert.deepEqual(shown, [0, 210, 420]);
    // The last of them, when no other comes: 100 ms after it was due.
    for (let time = 0; time < 100; time += 1) {
        mock.timers.tick(10);
    }
    assert.deepEqual(shown, [0, 210, 420, 720]);
    // At rest at once.
    assert.deepEqual([pace.changed(true), pace.changed(false)], [true, true]);
    pace.changed(true);
    pace.dispose();
    mock.timers.tick(1000);
    assert.equal(shown.length, 6);
    mock.timers.reset();
});
