// Hovers of a simulated program: what is under the pointer, with what can be done with it, and while it is paused why it is so.
// What the server says besides is there when it is asked for.
import * as vscode from 'vscode';

import { operandAt } from '../../../panels/operands.ts';
import { LINKED, hoverLinks, MORE, reasonLine } from './hoverLinks.ts';
import type { Server } from './server.ts';
import type { Simulation } from './simulation.ts';

export function liveHovers(server: Server, simulation: Simulation): vscode.Disposable {
    /** The operand of which more was asked for. */
    let wanted = '';
    const operandOf = (document: vscode.TextDocument, { line, character }: vscode.Position) => {
        const session = simulation.of(document);
        if (!session || session.stale || session !== simulation.current) {
            return undefined;
        }
        const operand = operandAt(session.operands.get(line) ?? [], { line, character });
        const tags = operand?.tags.flatMap((name) => session.tag(name) ?? []) ?? [];
        return operand && tags.length > 0 ? { session, tags, id: `${document.uri} ${line}:${operand.range.start.character}` } : undefined;
    };
    server.isBrief = (document, position) => {
        const id = operandOf(document, position)?.id;
        return id !== undefined && id !== wanted;
    };
    const provider: vscode.HoverProvider = {
        async provideHover(document, position) {
            const found = operandOf(document, position);
            if (!found) {
                return undefined;
            }
            const { session, tags, id } = found;
            const isBrief = id !== wanted;
            if (isBrief) {
                wanted = '';
            }
            // Of a timer or counter its output.
            const tag = tags.find(({ value }) => typeof value === 'boolean') ?? tags[0];
            // A line that is drawn again while its hover waits loses it: a program that runs has the reason behind a link alone.
            const isAsked = tag && session.state.status !== 'running';
            // A value that cannot be explained is a value nevertheless.
            const why = isAsked ? await session.command('why', { tag: tag.name }).catch(() => undefined) : undefined;
            const { line, character } = position;
            const more = isBrief ? [{ line, character, id }] : undefined;
            const markdown = new vscode.MarkdownString([hoverLinks(tags), reasonLine(why?.reason.text, more)].filter(Boolean).join('\n\n'));
            markdown.isTrusted = { enabledCommands: [...LINKED, MORE] };
            return new vscode.Hover(markdown);
        },
    };
    const showMore = async ({ line, character, id }: { line: number; character: number; id: string }) => {
        const editor = vscode.window.activeTextEditor;
        if (editor) {
            wanted = id;
            const place = new vscode.Position(line, character);
            // The editor shows a hover that is asked for at the cursor.
            editor.selection = new vscode.Selection(place, place);
            // One that is there would stay as it is; an older editor cannot hide it.
            await vscode.commands.executeCommand('editor.action.hideHover').then(undefined, () => undefined);
            await vscode.commands.executeCommand('editor.action.showHover');
        }
    };
    return vscode.Disposable.from(
        vscode.languages.registerHoverProvider('clad', provider),
        vscode.commands.registerCommand(MORE, showMore),
    );
}
