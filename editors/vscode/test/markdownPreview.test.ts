// Ladder text in the preview of a Markdown document: coloured and drawn once the server has answered, and inert.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import type { DrawnFence } from '../../../panels/protocol.ts';
import { Fences, type Markdown } from '../src/markdown/fences.ts';

const escapeHtml = (text: string) => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;');

function page(): Markdown {
    return { renderer: { rules: { fence: (tokens, index) => `other ${tokens[index]?.info}` } }, utils: { escapeHtml } };
}

/** Something that is waited for. */
function moment() {
    let come = () => {};
    const came = new Promise<void>((resolve) => { come = resolve; });
    return { came, come };
}

const TEXT = '+--[ ]( <b>a</b> )--+\n';
const DRAWN: DrawnFence = {
    words: [{ text: '+--[ ]( ' }, { text: '<b>a</b>', kind: 'input' }, { text: ' )--+\n', kind: '"><script>' }],
    picture: { light: '<svg><script>1</script></svg>', dark: '<svg/>' },
};

test('a fence is plain until the server has answered, and then coloured and drawn', async () => {
    const shown = moment();
    let asked = 0;
    const fences = new Fences(async () => { asked += 1; return DRAWN; }, shown.come);
    const markdown = fences.plugin(page());
    const render = (info: string) => markdown.renderer.rules.fence?.([{ info, content: TEXT }], 0);
    assert.equal(render('clad'), `<div class="ladder-fence"><pre><code>${escapeHtml(TEXT)}</code></pre></div>\n`);
    await shown.came;
    const html = render('ladder title') ?? '';
    assert.equal(asked, 1);
    assert.ok(html.includes('<span class="ladder-input">&lt;b>a&lt;/b></span>'), html);
    assert.ok(!html.includes('<script') && !html.includes('<svg'), html);
    assert.equal(html.match(/<img /g)?.length, 2);
    assert.equal(render('ladder-test'), 'other ladder-test');
    assert.equal(render('rust'), 'other rust');
    fences.dispose();
});

test('without a server a fence stays plain, and is asked for again when there is one', async () => {
    const shown = moment();
    let works = false;
    const fences = new Fences(async () => works ? DRAWN : Promise.reject(new Error('none')), shown.come);
    const rule = fences.plugin(page()).renderer.rules.fence;
    const render = () => rule?.([{ info: 'clad', content: TEXT }], 0) ?? '';
    assert.ok(!render().includes('<span'));
    await Promise.resolve();
    works = true;
    fences.begin();
    assert.ok(!render().includes('<span'));
    await shown.came;
    assert.ok(render().includes('<span'));
    fences.dispose();
});
