// Faults of a running program (a division by zero, the watchdog), as problems at their places.
import * as vscode from 'vscode';

import { type Simulation, toRange } from './simulation.ts';

export function showFaults(simulation: Simulation): vscode.Disposable {
    const collection = vscode.languages.createDiagnosticCollection('ladder simulation');
    return vscode.Disposable.from(
        collection,
        simulation.onDidChange((document) => {
            const session = simulation.of(document);
            const faults = session && !session.stale ? session.state.faults : [];
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
