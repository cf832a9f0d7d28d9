// What came of a scenario, as a message of the Test Explorer.
import * as vscode from 'vscode';

import { unitsBefore, type FileResult, type ScenarioResult } from './scenarioResults.ts';
import { whole } from './diskText.ts';
import { escaped, fenced } from './markdown.ts';

/** What came of one scenario. */
export function report(
    run: vscode.TestRun,
    item: vscode.TestItem,
    scenario: ScenarioResult | undefined,
    { errors }: FileResult,
    lines: readonly string[],
): void {
    if (!scenario) {
        const messages = errors.map(({ file, line, column, message }) => {
            const shown = new vscode.TestMessage(message);
            shown.location = new vscode.Location(vscode.Uri.file(whole(file)), new vscode.Position(line - 1, column - 1));
            return shown;
        });
        run.errored(item, messages.length > 0 ? messages : new vscode.TestMessage('The file has no such scenario any more.'));
        return;
    }
    const duration = scenario.seconds * 1000;
    if (scenario.outside !== undefined) {
        run.appendOutput(`${scenario.outside}\r\n`, undefined, item);
    }
    if (scenario.passed) {
        run.passed(item, duration);
        return;
    }
    const [first, ...others] = [...scenario.differences, ...(scenario.violations ?? [])];
    // The first line is next to the row, too; the drawing has it at its end.
    const sentence = first?.message ?? 'A fault stopped the program.';
    const drawn = new vscode.TestMessage(new vscode.MarkdownString(`${escaped(sentence)}\n\n${fenced(scenario.diagram ?? '')}`));
    const at = (line: number, column: number) =>
        item.uri && new vscode.Location(item.uri, new vscode.Position(line - 1, unitsBefore(lines[line - 1] ?? '', column)));
    const place = first ? at(first.line, first.column) : item.uri && item.range && new vscode.Location(item.uri, item.range.start);
    if (place) {
        drawn.location = place;
    }
    const rest = others.map(({ line, column, message }) => {
        const shown = new vscode.TestMessage(message);
        const there = at(line, column);
        if (there) {
            shown.location = there;
        }
        return shown;
    });
    const faults = scenario.faults.map(({ file, line, scan, message }) => {
        const shown = new vscode.TestMessage(`fault in scan ${scan}: ${message}`);
        shown.location = new vscode.Location(vscode.Uri.file(whole(file)), new vscode.Position(line - 1, 0));
        return shown;
    });
    for (const line of (scenario.diagram ?? '').split('\n')) {
        run.appendOutput(`${line}\r\n`, undefined, item);
    }
    run.failed(item, [drawn, ...rest, ...faults], duration);
}
