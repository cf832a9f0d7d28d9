// Power flow and values drawn over the text; nothing is ever put between its characters.
import * as vscode from 'vscode';

import { lineText } from './lineValues.ts';
import { powerRanges } from './powerRanges.ts';
import type { Session } from './session.ts';
import { type Simulation, toRange } from './simulation.ts';

// Colour and weight, so that power is seen without colours too. Bold letters are as wide as others in a fixed font.
const on = vscode.window.createTextEditorDecorationType({
    color: new vscode.ThemeColor('ladder.powerOn'),
    fontWeight: 'bold',
    rangeBehavior: vscode.DecorationRangeBehavior.ClosedClosed,
});
const off = vscode.window.createTextEditorDecorationType({
    color: new vscode.ThemeColor('ladder.powerOff'),
    rangeBehavior: vscode.DecorationRangeBehavior.ClosedClosed,
});
const stale = vscode.window.createTextEditorDecorationType({
    color: new vscode.ThemeColor('ladder.powerOff'),
    opacity: '0.7',
    rangeBehavior: vscode.DecorationRangeBehavior.ClosedClosed,
});
const next = vscode.window.createTextEditorDecorationType({
    border: '1px solid',
    borderColor: new vscode.ThemeColor('editor.findMatchHighlightBorder'),
    backgroundColor: new vscode.ThemeColor('editor.stackFrameHighlightBackground'),
    rangeBehavior: vscode.DecorationRangeBehavior.ClosedClosed,
});
const values = vscode.window.createTextEditorDecorationType({
    after: { color: new vscode.ThemeColor('ladder.value'), margin: '0 0 0 2ch' },
    rangeBehavior: vscode.DecorationRangeBehavior.ClosedClosed,
});

function lineValues(session: Session): vscode.DecorationOptions[] {
    return [...session.lineTags].flatMap(([line, places]) => {
        const end = session.document.lineAt(line).range.end;
        // The page would make one blank of two.
        const contentText = lineText(session.state.tags, places).replaceAll(' ', '\u00a0');
        return { range: new vscode.Range(end, end), renderOptions: { after: { contentText } } };
    });
}

function clear(editor: vscode.TextEditor): void {
    for (const type of [on, off, stale, next, values]) {
        editor.setDecorations(type, []);
    }
}

function paint(editor: vscode.TextEditor, session: Session): void {
    if (session.stale) {
        clear(editor);
        editor.setDecorations(stale, session.staleRanges.map(toRange));
        return;
    }
    const ranges = powerRanges(session.state.power);
    editor.setDecorations(stale, []);
    editor.setDecorations(on, ranges.on.map(toRange));
    editor.setDecorations(off, ranges.off.map(toRange));
    editor.setDecorations(next, session.state.next ? [toRange(session.state.next)] : []);
    editor.setDecorations(values, lineValues(session));
}

function update(editor: vscode.TextEditor, simulation: Simulation): void {
    const session = simulation.of(editor.document);
    if (session) {
        paint(editor, session);
    } else {
        clear(editor);
    }
}

export function showPower(simulation: Simulation): vscode.Disposable {
    return vscode.Disposable.from(
        on,
        off,
        stale,
        next,
        values,
        simulation.onDidChange((document) => {
            for (const editor of vscode.window.visibleTextEditors) {
                if (editor.document === document) {
                    update(editor, simulation);
                }
            }
        }),
        vscode.window.onDidChangeVisibleTextEditors((editors) => {
            for (const editor of editors) {
                update(editor, simulation);
            }
        }),
    );
}
