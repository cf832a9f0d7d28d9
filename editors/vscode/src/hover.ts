// Hovers of a running program: what is under the pointer can be switched, set and forced from there.
import * as vscode from 'vscode';

import { operandAt } from '../../../panels/operands.ts';
import { LINKED, hoverLinks } from './hoverLinks.ts';
import type { Simulation } from './simulation.ts';

export function linksInHovers(simulation: Simulation): vscode.Disposable {
    return vscode.languages.registerHoverProvider('clad', {
        provideHover(document, { line, character }) {
            const session = simulation.of(document);
            if (!session || session.stale || session !== simulation.current) {
                return undefined;
            }
            const operand = operandAt(session.operands.get(line) ?? [], { line, character });
            const tags = operand?.tags.flatMap((name) => session.tag(name) ?? []) ?? [];
            if (tags.length === 0) {
                return undefined;
            }
            const markdown = new vscode.MarkdownString(hoverLinks(tags));
            markdown.isTrusted = { enabledCommands: [...LINKED] };
            return new vscode.Hover(markdown);
        },
    });
}
