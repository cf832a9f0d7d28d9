import assert from 'node:assert/strict';
import { test } from 'node:test';

import { escaped, fenced } from '../src/markdown.ts';

test('a value is no Markdown', () => {
    assert.equal(escaped("'![x](http://y)'"), "'\\!\\[x\\]\\(http\\://y\\)'");
    assert.equal(escaped('a\n\nb'), 'a  b');
});

test('a drawing ends where it ends', () => {
    assert.equal(fenced('a _-'), '```text\na _-\n```');
    assert.equal(fenced('```\n![x](y)'), '````text\n```\n![x](y)\n````');
});
