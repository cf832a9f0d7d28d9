// What package.json and language-configuration.json promise, held against the code and against ladder text.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

import { FOREIGN_FILES } from '../src/foreignProgram.ts';

const read = (name: string) => readFileSync(new URL(`../${name}`, import.meta.url), 'utf8');
const manifest = JSON.parse(read('package.json'));
const language = JSON.parse(read('language-configuration.json'));

test('every command of package.json is registered, and every registered one is in package.json', () => {
    const declared = manifest.contributes.commands.map(({ command }: { command: string }) => command).sort();
    const registered = [...read('src/commands.ts').matchAll(/^ +'(ladder\.[.\w]+)':/gm)].map(([, name]) => name);
    // A view's own.
    registered.push('ladder.tags.filter', 'ladder.tags.watch', 'ladder.tags.unwatch');
    registered.sort();
    assert.deepEqual(registered, declared);
});

test('menus and the welcome text name commands that exist', () => {
    const declared = new Set(manifest.contributes.commands.map(({ command }: { command: string }) => command));
    const menus = Object.values(manifest.contributes.menus as Record<string, { command: string }[]>).flat();
    const welcome = [...JSON.stringify(manifest.contributes.viewsWelcome).matchAll(/command:([.\w]+)/g)];
    for (const command of [...menus.map(({ command }) => command), ...welcome.map(([, command]) => command)]) {
        assert.ok(declared.has(command) || command?.startsWith('workbench.'), command);
    }
});

test('the walkthrough leads to commands that exist, and its pictures are packed', () => {
    const declared = new Set(manifest.contributes.commands.map(({ command }: { command: string }) => command));
    const [{ steps }] = manifest.contributes.walkthroughs;
    assert.ok(read('.vscodeignore').includes('!walkthrough/*'));
    for (const { description, media, completionEvents } of steps) {
        const named = [description, ...completionEvents].flatMap((text: string) => [...text.matchAll(/(?:\(command|onCommand):([.\w]+)/g)]);
        for (const [, command] of named) {
            assert.ok(declared.has(command) || command?.startsWith('editor.action.'), command);
        }
        const files = media.image ? Object.values(media.image as Record<string, string>) : [media.markdown];
        for (const file of files) {
            assert.ok(read(file).length > 100, file);
        }
    }
});

test('the keys of a simulation are in the README', () => {
    const [, listed = ''] = /^- The keys, while a program is simulated([^]*?)^- /m.exec(read('README.md')) ?? [];
    const keys: { command: string; key: string }[] = manifest.contributes.keybindings;
    const simulation = keys.filter(({ command }) => command.startsWith('ladder.simulation.'));
    assert.ok(simulation.length >= 9);
    const words = new Set(listed.toLowerCase().split(/[\s,.:]+/));
    assert.deepEqual(simulation.filter(({ key }) => !words.has(key)), []);
});

test('the example is that of the documentation', async () => {
    const { EXAMPLE } = await import('../src/exampleText.ts');
    assert.equal(EXAMPLE, read('../../examples/motor.clad'));
});

test('settings that the code reads are declared', () => {
    const declared = Object.keys(manifest.contributes.configuration[0].properties);
    assert.ok(declared.includes('ladder.server.path'));
    assert.ok(declared.includes('ladder.inlayHints.enable'));
    for (const name of manifest.capabilities.untrustedWorkspaces.restrictedConfigurations) {
        assert.ok(declared.includes(name), name);
    }
});

test('an untrusted workspace runs nothing', () => {
    const { supported, restrictedConfigurations } = manifest.capabilities.untrustedWorkspaces;
    assert.equal(supported, 'limited');
    assert.ok(restrictedConfigurations.includes('ladder.server.path'));
    // A workspace says which program is started as little as it starts one.
    const { scope } = manifest.contributes.configuration[0].properties['ladder.server.path'];
    assert.equal(scope, 'machine');
    const start = /async start\(\)[^{]*\{\s*if \(!vscode\.workspace\.isTrusted\) \{[^}]*return;/;
    assert.match(read('src/server.ts'), start);
    const commands = manifest.contributes.commands as { command: string; enablement?: string }[];
    for (const { command, enablement } of commands) {
        if (/^ladder\.(simulation\.start|test|convert|exportAs|click\..*)$/.test(command)) {
            assert.match(enablement ?? '', /(^|&& )isWorkspaceTrusted$/);
        }
    }
    // Every program is named by its whole path, and started from a folder that is nobody's workspace.
    assert.doesNotMatch(read('src/server.ts'), /command: '/);
});

test('the server gets programs, scenarios, scenes, ladder.toml and programs of other systems, and no other file in TOML', () => {
    const [, selector] = /documentSelector: (\[.*?\]),\n/s.exec(read('src/server.ts')) ?? [];
    const patterns = FOREIGN_FILES.map((pattern) => ({ pattern }));
    assert.deepEqual(new Function('FOREIGN_FILES', `return ${selector}`)(FOREIGN_FILES), [
        { language: 'clad' },
        { language: 'ladder-click' },
        { language: 'ladder-test' },
        { pattern: '**/ladder.toml' },
        { pattern: '**/*.scene.svg' },
        ...patterns,
    ]);
});

test('the schema of ladder.toml is packed', () => {
    const [{ fileMatch, url }] = manifest.contributes.tomlValidation;
    assert.equal(fileMatch, 'ladder.toml');
    assert.equal(JSON.parse(read(url)).title, 'ladder.toml');
    assert.ok(read('.vscodeignore').includes('!schema/*.json'));
});

test('the languages claim .clad and .ladder-test files only, and files in Python are nobody else\'s', () => {
    const claimed = manifest.contributes.languages.map(({ extensions }: { extensions?: string[] }) => extensions);
    assert.deepEqual(claimed, [['.clad'], ['.ladder-test'], undefined]);
    for (const { id, filenames, filenamePatterns, firstLine } of manifest.contributes.languages) {
        assert.notEqual(id, 'python');
        assert.deepEqual([filenames, filenamePatterns, firstLine], [undefined, undefined, undefined], id);
    }
    assert.ok(manifest.activationEvents.every((event: string) => !event.includes('python')));
});

test('every grammar and configuration of a language is packed', () => {
    const packed = read('.vscodeignore');
    assert.ok(packed.includes('!syntaxes/*.json'));
    for (const { id, configuration } of manifest.contributes.languages) {
        assert.ok(packed.includes(`!${configuration.replace('./', '')}`), configuration);
        JSON.parse(read(configuration));
        const grammar = manifest.contributes.grammars.find(({ language }: { language: string }) => language === id);
        assert.equal(JSON.parse(read(grammar.path)).scopeName, grammar.scopeName);
    }
});

test('words are tags, direct addresses and names of blocks', () => {
    const { pattern, flags } = language.wordPattern;
    const words = '--[$Debounce]( größe, %IX0.3, T#5s )--'.match(new RegExp(pattern, `g${flags}`));
    assert.deepEqual(words, ['$Debounce', 'größe', '%IX0', '3', 'T', '5', 's']);
});

test('a section written on one line does not fold', () => {
    const start = new RegExp(language.folding.markers.start);
    assert.ok(start.test('VAR_INPUT'));
    assert.ok(!start.test('VAR_OUTPUT  run : BOOL;  END_VAR'));
    assert.ok(new RegExp(language.folding.markers.end).test('END_VAR'));
});
