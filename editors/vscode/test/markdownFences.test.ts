// Ladder text in the fences of a Markdown document has the colours of a program.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { test } from 'node:test';
import type { IGrammar, IRawGrammar } from 'vscode-textmate';

const require = createRequire(import.meta.url);
const oniguruma: typeof import('vscode-oniguruma') = require('vscode-oniguruma');
const textmate: typeof import('vscode-textmate') = require('vscode-textmate');

const read = (name: string) => readFileSync(new URL(`../${name}`, import.meta.url), 'utf8');
const contributed: { scopeName: string; path: string; injectTo?: string[] }[] = JSON.parse(read('package.json')).contributes.grammars;

/** A grammar of Markdown without rules of its own: what is coloured comes from the extension. */
const MARKDOWN = { scopeName: 'text.html.markdown', patterns: [], repository: {} } as unknown as IRawGrammar;

async function markdown(): Promise<IGrammar> {
    await oniguruma.loadWASM(Uint8Array.from(readFileSync(require.resolve('vscode-oniguruma/release/onig.wasm'))).buffer);
    const registry = new textmate.Registry({
        onigLib: Promise.resolve({
            createOnigScanner: (patterns) => new oniguruma.OnigScanner(patterns),
            createOnigString: (text) => new oniguruma.OnigString(text),
        }),
        loadGrammar: async (scope) => {
            const found = contributed.find(({ scopeName }) => scopeName === scope);
            return found ? JSON.parse(read(found.path)) : scope === MARKDOWN.scopeName ? MARKDOWN : null;
        },
        getInjections: (scope) => contributed.filter(({ injectTo }) => injectTo?.includes(scope)).map(({ scopeName }) => scopeName),
    });
    const grammar = await registry.loadGrammar(MARKDOWN.scopeName);
    assert.ok(grammar);
    return grammar;
}

const grammar = await markdown();

/** The innermost scope of a word where it first is in a line. */
function scopeOf(text: string, word: string, line: number): string | undefined {
    let state = textmate.INITIAL;
    for (const [nth, content] of text.split('\n').entries()) {
        const { tokens, ruleStack } = grammar.tokenizeLine(content, state);
        state = ruleStack;
        if (nth === line) {
            const at = content.indexOf(word);
            assert.ok(at >= 0, `${word} is not in ${content}`);
            return tokens.find(({ startIndex, endIndex }) => startIndex <= at && at < endIndex)?.scopes.at(-1);
        }
    }
    return undefined;
}

const RUNG = '+--[TON]( warmup, T#5s )--( )( ready )--+';

for (const opening of ['```clad', '```ladder', '~~~ CLAD', '````clad title="a motor"', '   ```clad', '```clad,ignore']) {
    test(`a fence that opens with ${opening} holds ladder text`, () => {
        const closing = /[`~]{3,}/.exec(opening)?.[0];
        const text = `${opening}\n${RUNG}\n${closing}\nTON\n`;
        assert.equal(scopeOf(text, 'TON', 1), 'support.function.clad');
        assert.equal(scopeOf(text, 'warmup', 1), 'variable.other.tag.clad');
        assert.equal(scopeOf(text, 'TON', 3), 'text.html.markdown');
    });
}

for (const opening of ['```', '```text', '```cladding', '```ladder-test', 'clad']) {
    test(`one that opens with ${opening} holds none`, () => {
        assert.equal(scopeOf(`${opening}\n${RUNG}\n`, 'TON', 1), 'text.html.markdown');
    });
}

test('what is left open in a fence ends with it', () => {
    for (const open of ['# a comment', 'VAR_INPUT', 'FUNCTION_BLOCK [$B]', '+--[ ]( a']) {
        assert.equal(scopeOf(`\`\`\`clad\n${open}\n\`\`\`\nTON\n`, 'TON', 3), 'text.html.markdown', open);
    }
});
