// A person's first hour in VS Code, step by step, through the editor's own commands. Writes one JSON object a line.
const assert = require('node:assert/strict');
const { appendFileSync, readFileSync } = require('node:fs');

const vscode = require('vscode');

const { debugging } = require('./debugging.cjs');
const { fixes } = require('./fixes.cjs');

const report = process.env.LADDER_REPORT;

function tell(result) {
    appendFileSync(report, `${JSON.stringify(result)}\n`);
}

async function step(name, check) {
    const started = Date.now();
    try {
        await check();
        tell({ name, ok: true, ms: Date.now() - started });
    } catch (error) {
        tell({ name, ok: false, ms: Date.now() - started, message: error.message });
    }
}

/** Waits for something that the server brings about. */
async function eventually(what, value) {
    // Much longer than it takes: a busy machine is no fault.
    const limit = Date.now() + 60_000;
    for (;;) {
        const found = await value();
        if (found) {
            return found;
        }
        if (Date.now() > limit) {
            throw new Error(`waited 60 s in vain for ${what}`);
        }
        await new Promise((resolve) => setTimeout(resolve, 20));
    }
}

async function open(name) {
    const [folder] = vscode.workspace.workspaceFolders;
    const document = await vscode.workspace.openTextDocument(vscode.Uri.joinPath(folder.uri, name));
    await vscode.window.showTextDocument(document);
    return document;
}

/** The picture of a state: what has power keeps its characters, all else is blank. */
function live(document, state) {
    return [...Array(document.lineCount).keys()].map((line) => {
        const cells = document.lineAt(line).text.split('').map((character, column) => {
            const on = state.power.some(
                ({ range, on }) =>
                    on && range.start.line === line && range.start.character <= column && column < range.end.character,
            );
            return on ? character : ' ';
        });
        return cells.join('').trimEnd();
    });
}

async function session() {
    const ladder = vscode.extensions.getExtension('ladder-text.ladder');
    const api = await ladder.activate();
    const run = (command, ...given) => vscode.commands.executeCommand(`ladder.simulation.${command}`, ...given);
    const tag = (name) => api.state().tags.find((candidate) => candidate.name === name);

    await step('the language of .clad files is clad, without word wrap', async () => {
        const document = await open('motor.clad');
        assert.equal(document.languageId, 'clad');
        assert.equal(vscode.workspace.getConfiguration('editor', document).get('wordWrap'), 'off');
    });

    await step('a connector without a partner gets a diagnostic at its place', async () => {
        const document = await open('unpaired.clad');
        const [found] = await eventually('the diagnostic', () => {
            const all = vscode.languages.getDiagnostics(document.uri);
            return all.length > 0 && all;
        });
        assert.equal(found.code?.value ?? found.code, 'unpaired-connector');
        assert.deepEqual([found.range.start.line, found.range.start.character], [1, 36]);
    });

    await step('hovering over a timer explains it', async () => {
        const document = await open('motor.clad');
        const position = document.positionAt(document.getText().indexOf('TON'));
        const [hover] = await vscode.commands.executeCommand('vscode.executeHoverProvider', document.uri, position);
        assert.match(hover.contents.map((content) => content.value ?? content).join('\n'), /timer/i);
    });

    await step('a half-typed block is completed, with its operands', async () => {
        const document = await vscode.workspace.openTextDocument({ language: 'clad', content: '+--[ ]( go )--[TO' });
        const end = document.positionAt(document.getText().length);
        const list = await vscode.commands.executeCommand('vscode.executeCompletionItemProvider', document.uri, end);
        const labels = list.items.map(({ label }) => label.label ?? label);
        assert.ok(labels.some((label) => label.includes('TON')), labels.join(' '));
        const inside = await vscode.workspace.openTextDocument({ language: 'clad', content: '+--[TON]( t, ' });
        const help = await vscode.commands.executeCommand(
            'vscode.executeSignatureHelpProvider', inside.uri, inside.positionAt(inside.getText().length));
        assert.equal(help.signatures[0].activeParameter ?? help.activeParameter, 1);
    });

    await step('an empty line is offered a whole network, without an error', async () => {
        const document = await vscode.workspace.openTextDocument({ language: 'clad', content: '' });
        const editor = await vscode.window.showTextDocument(document);
        const start = new vscode.Position(0, 0);
        const offered = async () => {
            const { items } = await vscode.commands.executeCommand('vscode.executeCompletionItemProvider', document.uri, start);
            return items.find(({ label }) => (label.label ?? label) === 'seal-in');
        };
        const { insertText } = await eventually('the proposal', offered);
        await editor.insertSnippet(insertText, start);
        assert.match(document.getText(), /^\+--\\--\[ \]\( start \)--\\--\[\/\]\( stop \)-+\( \)\( run \)--\+\n\|  \/--\[ \]\( run \)-+\/ +\|$/);
        const symbols = () => vscode.commands.executeCommand('vscode.executeDocumentSymbolProvider', document.uri);
        await eventually('the network in the outline', async () => ((await symbols()) ?? []).length > 0);
        assert.deepEqual(vscode.languages.getDiagnostics(document.uri).filter(({ severity }) => severity === vscode.DiagnosticSeverity.Error), []);
        await vscode.commands.executeCommand('workbench.action.revertAndCloseActiveEditor');
    });

    await step('a tag is found at all its places, and renamed with the drawing laid out', async () => {
        const document = await open('motor.clad');
        const place = document.positionAt(document.getText().indexOf('start'));
        const found = await vscode.commands.executeCommand('vscode.executeReferenceProvider', document.uri, document.positionAt(document.getText().indexOf('run )')));
        assert.ok(found.filter(({ uri }) => uri.path === document.uri.path).length >= 3);
        const edit = await vscode.commands.executeCommand('vscode.executeDocumentRenameProvider', document.uri, place, 'start_button');
        await vscode.workspace.applyEdit(edit);
        const rails = document.getText().split('\n').filter((line) => /^\+.*\+$/.test(line));
        assert.ok(document.getText().includes('[ ]( start_button )'));
        assert.equal(new Set(rails.map((line) => line.length)).size, 1, rails.join('\n'));
        // Back to what is on disk, in every file that the renaming touched.
        for (const [uri] of edit.entries()) {
            await vscode.window.showTextDocument(await vscode.workspace.openTextDocument(uri));
            await vscode.commands.executeCommand('workbench.action.files.revert');
        }
    });

    await step('the outline, the colours, and what can be done at a contact', async () => {
        const document = await open('motor.clad');
        const symbols = await vscode.commands.executeCommand('vscode.executeDocumentSymbolProvider', document.uri);
        assert.ok(symbols.length > 0);
        const tokens = await vscode.commands.executeCommand('vscode.provideDocumentSemanticTokens', document.uri);
        assert.ok(tokens.data.length > 0);
        const at = document.positionAt(document.getText().indexOf('[/]') + 1);
        const actions = await vscode.commands.executeCommand('vscode.executeCodeActionProvider', document.uri, new vscode.Range(at, at));
        assert.ok(actions.some(({ kind }) => kind?.value.startsWith('refactor')), actions.map(({ title }) => title).join('; '));
    });

    await step('formatting aligns a crooked drawing', async () => {
        const document = await open('crooked.clad');
        await vscode.commands.executeCommand('editor.action.formatDocument');
        const motor = await open('motor.clad');
        assert.equal(document.getText(), motor.getText());
    });

    const shut = () => vscode.commands.executeCommand('workbench.action.revertAndCloseActiveEditor');

    await step('a program of another system becomes ladder text', async () => {
        await open('motor.rung');
        // The command ends when the message that sums it up is gone.
        void vscode.commands.executeCommand('ladder.convertFile');
        const document = await eventually('the ladder text', () =>
            vscode.workspace.textDocuments.find(({ languageId, isUntitled, getText }) =>
                languageId === 'clad' && isUntitled && getText().includes('( )( Q0 )')));
        assert.match(document.getText(), /\[ \]\( I0 \)/);
        await eventually('its editor', () => vscode.window.activeTextEditor?.document === document);
        await shut();
        await shut();
    });

    await step('a Python file is a Click program when a person asks, with its diagram next to it', async () => {
        const before = await open('tank.py');
        assert.equal(before.languageId, 'python');
        await vscode.commands.executeCommand('ladder.click.open');
        const document = await eventually('the language', () =>
            vscode.workspace.textDocuments.find(({ languageId }) => languageId === 'ladder-click'));
        const line = document.positionAt(document.getText().indexOf('out('));
        const hovers = await vscode.commands.executeCommand('vscode.executeHoverProvider', document.uri, line);
        assert.match(hovers.flatMap(({ contents }) => contents.map((content) => content.value ?? content)).join('\n'), /\( \)\( Valve \)/);
        await vscode.commands.executeCommand('ladder.click.preview');
        const drawing = vscode.workspace.textDocuments.find(({ uri }) => uri.scheme === 'ladder-click');
        assert.match(drawing.getText(), /\[LT\]\( Level, Limit \)/);
        await vscode.commands.executeCommand('workbench.action.closeEditorsInOtherGroups');
        await shut();
    });

    await fixes({ step, eventually });
    await debugging({ step, open, eventually });

    await step('of a long program only what the editor shows is sent', async () => {
        const rung = (number) => `+--[ ]( a${number} )--[/]( b${number} )--( )( c${number} )--+\n`;
        const content = Array.from({ length: 10_000 }, (_, number) => rung(number)).join('');
        const document = await vscode.workspace.openTextDocument({ language: 'clad', content });
        const editor = await vscode.window.showTextDocument(document);
        await run('start');
        const known = () => api.state()?.power.map(({ range }) => range.start.line) ?? [];
        const first = await eventually('a picture', () => known().length > 0 && known());
        assert.ok(first.length < 1000 && Math.max(...first) < 100, `${first.length} elements up to line ${Math.max(...first)}`);
        editor.revealRange(document.lineAt(5000).range, vscode.TextEditorRevealType.AtTop);
        await eventually('the lines that are scrolled to', () => known().includes(5000) && !known().includes(0));
        await run('toggle', { name: 'a5000', type: 'BOOL', value: false, role: 'input', forced: false });
        await run('step');
        await eventually('the power there', () =>
            api.state().power.some(({ range, on }) => on && range.start.line === 5000 && range.start.character > 25));
        assert.ok(api.state().tags.length < 1000, `${api.state().tags.length} tags`);
        await run('stop');
        await shut();
    });

    await step('three scans with start high give power to exactly these cells', async () => {
        const document = await open('motor.clad');
        await run('start');
        await run('toggle', tag('start'));
        for (let scan = 0; scan < 3; scan += 1) {
            await run('step');
        }
        // The answer to a step is there before the picture of it.
        const state = await eventually('the picture of the third scan', () => api.state().commands >= 4 && api.state().scan === 3 && api.state());
        assert.deepEqual(live(document, state), [
            '',
            '+--\\--[ ]( start )--\\--[/]( stop )---------------------------------( )( run )--+',
            '',
            '   /--[ ]( run )----/',
            '',
            '+--[ ]( run )----------------------------[TON]( warmup, T#20ms )--( )( lamp )--+',
            '',
        ]);
    });

    await step('the key for a toggle takes the contact under the cursor', async () => {
        const document = await open('motor.clad');
        const at = document.positionAt(document.getText().indexOf('[/]('));
        vscode.window.activeTextEditor.selection = new vscode.Selection(at, at);
        for (const value of [true, false]) {
            await run('toggle');
            await eventually(`stop to be ${value}`, () => tag('stop').value === value);
        }
    });

    await step('a hover tells the value', async () => {
        const document = await open('motor.clad');
        const position = document.positionAt(document.getText().indexOf('warmup') + 2);
        const [hover] = await vscode.commands.executeCommand('vscode.executeHoverProvider', document.uri, position);
        const text = hover.contents.map((content) => content.value ?? content).join('\n');
        assert.match(text, /^`warmup\.ET` = 20ms: \[Set\]\(command:ladder\.simulation\.set/m);
        assert.match(text, /^`warmup\.Q` = 1: \[Toggle\]\(command:ladder\.simulation\.toggle/m);
    });

    // For the page, which is checked next.
    await vscode.commands.executeCommand('ladder.tags.focus');
}

exports.activate = () => {
    // The page may be loaded again.
    if (readFileSync(report, 'utf8') !== '') {
        return;
    }
    session()
        .catch((error) => tell({ name: 'the extension starts', ok: false, ms: 0, message: error.message }))
        .finally(() => tell({ done: true }));
};
