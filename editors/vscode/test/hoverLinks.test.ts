import assert from 'node:assert/strict';
import { test } from 'node:test';

import type { Tag } from '../../../panels/protocol.ts';
import { hoverLinks, reasonLine } from '../src/hoverLinks.ts';

const tag = (more: Partial<Tag>): Tag => ({ name: 'start', type: 'BOOL', value: false, text: '0', role: 'input', forced: false, ...more });
const titles = (markdown: string) => [...markdown.matchAll(/\[([^\]]+)\]\(command:([.\w]+)/g)].map(([, title, command]) => `${title} ${command}`);

test('a BOOL can be toggled and forced from its hover', () => {
    assert.deepEqual(titles(hoverLinks([tag({})])), [
        'Toggle ladder.simulation.toggle',
        'Force ladder.simulation.force',
        'Why? ladder.simulation.why',
        'Trace ladder.trace.add',
    ]);
    assert.ok(hoverLinks([tag({})]).includes(encodeURIComponent('[{"name":"start"}]')));
});

test('what is forced can be released, a number is set, a constant is neither', () => {
    assert.deepEqual(titles(hoverLinks([tag({ forced: true })]))[1], 'Release ladder.simulation.unforce');
    assert.deepEqual(titles(hoverLinks([tag({ type: 'INT', value: 3, text: '3' })]))[0], 'Set ladder.simulation.set');
    assert.deepEqual(titles(hoverLinks([tag({ readOnly: true })])), ['Why? ladder.simulation.why', 'Trace ladder.trace.add']);
});

test('a value is no Markdown', () => {
    assert.ok(hoverLinks([tag({ type: 'STRING', value: '*[x](y)*', text: '*[x](y)*' })]).includes('\\*\\[x\\]\\(y\\)\\*'));
});

test('below the value is why, and the way to the rest', () => {
    const line = reasonLine('lamp is 1: [ ]( run ) is *on*', [{ line: 3 }]);
    assert.ok(!line.includes('*on*'));
    assert.deepEqual(titles(line), ['More ladder.hover.more']);
    assert.equal(reasonLine(undefined, undefined), '');
    assert.equal(line.split('\n').length, 1);
});
