// What came of a scenario, as a message of the Test Explorer.
import * as vscode from 'vscode';

import { ownFailure, unitsBefore, violatedBy, type FileResult, type ScenarioResult } from './scenarioResults.ts';
import { whole } from './diskText.ts';
import { escaped, fenced } from './markdown.ts';

/** What came of one scenario; `hasPlace` says which properties have a place of their own, where it fails that violates them. */
export function report(
    run: vscode.TestRun,
    item: vscode.TestItem,
    scenario: ScenarioResult | undefined,
    { errors }: FileResult,
    lines: readonly string[],
    hasPlace: (property: string) => boolean,
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
    const { isFailure, violations } = ownFailure(scenario, hasPlace);
    if (!isFailure) {
        (scenario.violations ?? []).forEach(({ message }) => run.appendOutput(`${message}\r\n`, undefined, item));
        run.passed(item, duration);
        return;
    }
    const [first, ...others] = [...scenario.differences, ...violations];
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

/** What each scenario says that violates a property, at the scenario, by the name of the property. */
export function violations(file: vscode.TestItem, { scenarios }: FileResult): Map<string, vscode.TestMessage[]> {
    const messages = [...violatedBy(scenarios)].map(([property, shown]): [string, vscode.TestMessage[]] => [
        property,
        shown.map(({ scenario, message }) => {
            const sentence = `scenario "${scenario.name}": ${message}`;
            const drawn = new vscode.TestMessage(new vscode.MarkdownString(`${escaped(sentence)}\n\n${fenced(scenario.diagram ?? '')}`));
            if (file.uri) {
                drawn.location = new vscode.Location(file.uri, new vscode.Position(scenario.line - 1, 0));
            }
            return drawn;
        }),
    ]);
    return new Map(messages);
}
