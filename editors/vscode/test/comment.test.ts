import assert from 'node:assert/strict';
import { test } from 'node:test';

import { toggleComment } from '../src/comment.ts';
import { commentCases } from './shared.ts';

for (const { name, before, after, again, refused } of commentCases) {
    test(name, () => {
        if (refused !== undefined) {
            assert.deepEqual(toggleComment(before), { refused });
            return;
        }
        assert.deepEqual(toggleComment(before), { lines: after });
        assert.deepEqual(toggleComment(after ?? []), { lines: again });
    });
}
