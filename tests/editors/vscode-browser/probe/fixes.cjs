// What is offered for drawings as other tools have them.
const assert = require('node:assert/strict');

const vscode = require('vscode');

const OFFERED = [
    {
        what: 'three branches between two rails',
        drawn: '+--\\--[ ]( a )--\\--( )( y )--+\n|  |--[ ]( b )--|            |\n|  /--[ ]( c )--/            |\n',
        title: /^Draw it with `\/--\\`/,
        becomes: `+--\\--[ ]( a )--------\\${'-'.repeat(46)}( )( y )--+\n|  /--\\--[ ]( b )--\\--/${' '.repeat(56)}|\n|     /--[ ]( c )--/${' '.repeat(59)}|\n`,
    },
    {
        what: 'characters that draw boxes',
        drawn: '├──[ ]( a )──( )( y )──┤\n',
        title: /^Draw it with - \+/,
        becomes: `+--[ ]( a )${'-'.repeat(58)}( )( y )--+\n`,
    },
];

async function fixes({ step, eventually }) {
    for (const { what, drawn, title, becomes } of OFFERED) {
        await step(`${what}: the drawing of this language is offered`, async () => {
            const document = await vscode.workspace.openTextDocument({ language: 'clad', content: drawn });
            await vscode.window.showTextDocument(document);
            // Findings of the line with the cursor come later than others: which of them is the first says nothing.
            const fix = await eventually('the fix', async () => {
                for (const { range } of vscode.languages.getDiagnostics(document.uri)) {
                    const actions = await vscode.commands.executeCommand('vscode.executeCodeActionProvider', document.uri, range, 'quickfix', 20);
                    const offered = actions.find((action) => title.test(action.title));
                    if (offered) {
                        return offered;
                    }
                }
                return undefined;
            });
            await vscode.workspace.applyEdit(fix.edit);
            assert.equal(document.getText(), becomes);
            await eventually('no error', () => vscode.languages.getDiagnostics(document.uri).every(({ severity }) => severity > vscode.DiagnosticSeverity.Error));
            await vscode.commands.executeCommand('workbench.action.revertAndCloseActiveEditor');
        });
    }
}

module.exports = { fixes };
