// Diagrams as editors of their own for ladder text: the editor keeps the text open for them, and restores them.
import * as vscode from 'vscode';

import { breakpointsAt } from '../breakpoints.ts';
import type { Server } from '../server.ts';
import type { Simulation } from '../simulation.ts';
import { folderOf, pageOf } from '../webviewPage.ts';
import { findingsOf } from './findings.ts';
import { DiagramPanel } from './panel.ts';

/** As package.json declares it. */
export const DIAGRAM = 'ladder.diagram';

export class DiagramEditors implements vscode.CustomTextEditorProvider, vscode.Disposable {
    readonly #extension: vscode.Uri;
    readonly #server: Server;
    readonly #simulation: Simulation;
    readonly #panels = new Map<vscode.WebviewPanel, DiagramPanel>();
    readonly #registration: vscode.Disposable;

    constructor(extension: vscode.Uri, server: Server, simulation: Simulation) {
        this.#extension = extension;
        this.#server = server;
        this.#simulation = simulation;
        this.#registration = vscode.window.registerCustomEditorProvider(DIAGRAM, this);
    }

    resolveCustomTextEditor(document: vscode.TextDocument, webview: vscode.WebviewPanel): void {
        webview.webview.options = { enableScripts: true, localResourceRoots: [folderOf(this.#extension)] };
        const panel = new DiagramPanel(document, webview, this.#server, this.#simulation);
        this.#panels.set(webview, panel);
        webview.onDidDispose(() => {
            this.#panels.delete(webview);
            panel.dispose();
        });
        webview.webview.html = pageOf(webview.webview, this.#extension, {
            name: 'diagram',
            title: 'Diagram',
            context: { preventDefaultContextMenuItems: true },
        });
    }

    /** Opens the diagram of a program next to its text, or brings it to the front. */
    async open(given?: unknown): Promise<void> {
        const active = vscode.window.activeTextEditor?.document;
        const uri = given instanceof vscode.Uri ? given : active?.languageId === 'clad' ? active.uri : undefined;
        if (!uri) {
            void vscode.window.showWarningMessage('Open a ladder program (.clad) to see its diagram.');
            return;
        }
        const there = [...this.#panels].find(([, { document }]) => document.uri.toString() === uri.toString());
        if (there) {
            there[0].reveal(undefined, true);
            return;
        }
        // Diagrams are tabs of one group.
        const other = [...this.#panels.keys()].find(({ viewColumn }) => viewColumn !== vscode.window.activeTextEditor?.viewColumn);
        const viewColumn = other?.viewColumn ?? vscode.ViewColumn.Beside;
        const options = { viewColumn, preserveFocus: true, preview: false };
        await vscode.commands.executeCommand('vscode.openWith', uri, DIAGRAM, options);
    }

    /** The diagram that one looks at. */
    get #active(): DiagramPanel | undefined {
        return [...this.#panels].find(([webview]) => webview.active)?.[1];
    }

    /** Shows what is reported about the program, or that nothing is. */
    async check(): Promise<void> {
        const document = this.#active?.document;
        if (document && findingsOf(document).length === 0) {
            void vscode.window.showInformationMessage(`Nothing is reported in ${document.uri.path.split('/').at(-1) ?? 'the program'}.`);
        } else if (document) {
            await vscode.commands.executeCommand('workbench.actions.view.problems');
        }
    }

    /** Shows the text of the program next to its diagram. */
    async showText(): Promise<void> {
        const start = { line: 0, character: 0 };
        await this.#active?.reveal(start, start, true);
    }

    /** What the menu of an element was opened on: its diagram, and its place in the text. */
    #chosen(context?: { place?: string }) {
        const [line, character] = (context?.place ?? '').split(':').map(Number);
        const panel = this.#active;
        return panel && line !== undefined && character !== undefined ? { panel, place: { line, character } } : undefined;
    }

    /** Shows it in the text. */
    async reveal(context?: { place?: string }): Promise<void> {
        const chosen = this.#chosen(context);
        await chosen?.panel.reveal(chosen.place, chosen.place, true);
    }

    /** A run stops in front of it, or no longer does. */
    toggleBreakpoint(context?: { place?: string }): void {
        const chosen = this.#chosen(context);
        if (!chosen) {
            return;
        }
        const { uri } = chosen.panel.document;
        const place = new vscode.Position(chosen.place.line, chosen.place.character);
        const there = breakpointsAt(vscode.debug.breakpoints, uri.toString(), place);
        if (there.length > 0) {
            vscode.debug.removeBreakpoints(there);
        } else {
            vscode.debug.addBreakpoints([new vscode.SourceBreakpoint(new vscode.Location(uri, place))]);
        }
    }

    dispose(): void {
        this.#registration.dispose();
    }
}
