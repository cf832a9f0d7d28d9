// What scenarios exercise, drawn next to the networks.
import * as vscode from 'vscode';

import { unitsBefore, waysOf, type Covered } from './scenarioResults.ts';
import { textOf } from './diskText.ts';

/** Coverage with what it was made of. */
export class CoveredFile extends vscode.FileCoverage {
    readonly covered: Covered;

    constructor(uri: vscode.Uri, covered: Covered) {
        const reached = covered.rungs.filter(({ scans }) => scans > 0).length;
        const ways = covered.parts.flatMap(waysOf);
        super(
            uri,
            new vscode.TestCoverageCount(reached, covered.rungs.length),
            new vscode.TestCoverageCount(ways.filter(({ isSeen }) => isSeen).length, ways.length),
        );
        this.covered = covered;
    }
}

/** What was reached, line by line, with the contacts and coils that were not seen both ways or are not shown to matter. */
export async function details({ uri, covered }: CoveredFile): Promise<vscode.StatementCoverage[]> {
    const lines = (await textOf(uri)).split(/\r\n|\n|\r/);
    return covered.rungs.map(({ line, scans }) => {
        const text = lines[line - 1] ?? '';
        const parts = covered.parts.filter((part) => part.line === line);
        const branches = parts.flatMap((part) => {
            const start = new vscode.Position(line - 1, unitsBefore(text, part.column));
            return waysOf(part).map(({ name, isSeen }) => new vscode.BranchCoverage(isSeen, start, `${part.kind} ${name}`));
        });
        return new vscode.StatementCoverage(scans, new vscode.Range(line - 1, 0, line - 1, text.length), branches);
    });
}
