// Scenes next to their texts: the machine as the simulation of its program has it.
import * as vscode from 'vscode';

import { withTheRest } from '../../../../panels/pace.ts';
import type { FromPage } from '../../../../panels/scene/messages.ts';
import { SceneTeller } from '../../../../panels/scene/teller.ts';
import type { Server } from '../server.ts';
import type { Simulation } from '../simulation.ts';
import { folderOf, pageOf } from '../webviewPage.ts';

const ENDING = '.scene.svg';
/** A drawing that is edited is shown again so long after the last key. In milliseconds. */
const REST = 300;

/** What is in front: a text, or a drawing that is shown as a picture. */
function inFront(): vscode.Uri | undefined {
    const input = vscode.window.tabGroups.activeTabGroup.activeTab?.input;
    const isCustom = input instanceof vscode.TabInputCustom;
    return isCustom ? input.uri : vscode.window.activeTextEditor?.document.uri;
}

export class ScenePanels implements vscode.Disposable {
    readonly #extension: vscode.Uri;
    readonly #server: Server;
    readonly #simulation: Simulation;
    readonly #panels = new Map<string, vscode.WebviewPanel>();

    constructor(extension: vscode.Uri, server: Server, simulation: Simulation) {
        this.#extension = extension;
        this.#server = server;
        this.#simulation = simulation;
    }

    /** Opens a scene: the one that is named or in front, else those next to the program that is in front. */
    async open(given?: unknown): Promise<void> {
        const uri = given instanceof vscode.Uri ? given : inFront();
        const scene = uri?.path.endsWith(ENDING) ? uri : uri && (await this.#nextTo(uri));
        if (!scene) {
            void vscode.window.showWarningMessage('Open a scene (NAME.scene.svg), or a program that has one in its folder.');
            return;
        }
        this.#show(scene);
    }

    /** The scene in the folder of a program; of several the one that a person chooses. */
    async #nextTo(program: vscode.Uri): Promise<vscode.Uri | undefined> {
        const folder = vscode.Uri.joinPath(program, '..');
        const names = (await vscode.workspace.fs.readDirectory(folder)).map(([name]) => name).filter((name) => name.endsWith(ENDING));
        const stem = program.path.split('/').at(-1)?.replace(/\.clad$/, '') ?? '';
        const own = names.find((name) => name === `${stem}${ENDING}`) ?? (names.length > 1 ? await vscode.window.showQuickPick(names, { title: 'Open Scene' }) : names[0]);
        return own === undefined ? undefined : vscode.Uri.joinPath(folder, own);
    }

    #show(uri: vscode.Uri): void {
        const there = this.#panels.get(uri.toString());
        if (there) {
            there.reveal(undefined, true);
            return;
        }
        const name = uri.path.split('/').at(-1) ?? '';
        const panel = vscode.window.createWebviewPanel('ladder.scene', name, { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true }, {
            enableScripts: true,
            localResourceRoots: [folderOf(this.#extension)],
        });
        this.#panels.set(uri.toString(), panel);
        const [server, simulation] = [this.#server, this.#simulation];
        const address = uri.toString();
        const opened = async (program: string | undefined) => program === undefined ? undefined : vscode.workspace.openTextDocument(vscode.Uri.parse(program));
        const sessionOf = (program: string | undefined) => {
            const document = vscode.workspace.textDocuments.find(({ uri }) => uri.toString() === (program && vscode.Uri.parse(program).toString()));
            return document && simulation.of(document);
        };
        const teller = new SceneTeller(
            {
                send: (message) => void panel.webview.postMessage(message),
                scene: (session) => server.execute('ladder.scene', { uri: address, ...(session !== undefined && { session }) }),
                session: sessionOf,
                give: async (tag, given) => {
                    const document = await opened(teller.program);
                    if (document) {
                        simulation.lookAt(document);
                        await simulation.command('set', { tag, ...given });
                    }
                },
                run: async (program) => {
                    const document = await opened(program);
                    if (document) {
                        simulation.lookAt(document);
                        // Who presses *Run* wants it to run, also where a simulation is to begin paused.
                        await (simulation.of(document) ? simulation.run() : simulation.start(document, () => Promise.resolve(true)));
                    }
                },
                pause: () => simulation.pause(),
            },
            () => address,
        );
        let later: NodeJS.Timeout | undefined;
        const again = () => {
            clearTimeout(later);
            later = setTimeout(() => void teller.open(), REST);
        };
        const subscriptions = vscode.Disposable.from(
            panel.webview.onDidReceiveMessage((message: FromPage) => teller.answer(message)),
            simulation.onDidChange(() => withTheRest(() => teller.tell())),
            vscode.workspace.onDidChangeTextDocument(({ document }) => document.uri.toString() === address && again()),
            vscode.workspace.onDidSaveTextDocument(({ uri }) => /\.(clad|toml)$/.test(uri.path) && again()),
            server.onDidStart(() => void teller.open()),
            new vscode.Disposable(() => clearTimeout(later)),
        );
        panel.onDidDispose(() => {
            this.#panels.delete(address);
            subscriptions.dispose();
        });
        panel.webview.html = pageOf(panel.webview, this.#extension, { name: 'scene', title: name });
    }

    dispose(): void {
        this.#panels.forEach((panel) => panel.dispose());
    }
}
