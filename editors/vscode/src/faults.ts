// Faults of a running program (a division by zero, the watchdog), as problems at their places.
import * as vscode from 'vscode';

import { type Simulation, toRange } from './simulation.ts';

export function showFaults(simulation: Simulation): vscode.Disposable {
    const collection = vscode.languages.createDiagnosticCollection('ladder simulation');
    // What was shown last for each document: most states have no other faults than the one before.
    const shown = new Map<string, string>();
    return vscode.Disposable.from(
        collection,
        simulation.onDidChange((document) => {
            const session = simulation.of(document);
            const faults = session && !session.stale ? session.state.faults : [];
            const key = JSON.stringify(faults);
            const address = document.uri.toString();
            if ((shown.get(address) ?? '[]') === key) {
                return;
            }
            shown.set(address, key);
            collection.set(
                document.uri,
                faults.map(({ message, range, scan }) => {
                    const problem = new vscode.Diagnostic(toRange(range), `${message} (scan ${scan})`);
                    problem.source = 'ladder simulation';
                    return problem;
                }),
            );
        }),
    );
}
