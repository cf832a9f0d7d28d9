// Scenarios and properties in the Test Explorer: run, debugged, run again when files change, with what they exercise.
import { execFile } from 'node:child_process';
import { homedir } from 'node:os';

import * as vscode from 'vscode';

import { failingStretches, missedLines, type FileResult, type Results, type Stretch } from './scenarioResults.ts';
import { textOf, whole } from './diskText.ts';
import { CoveredFile, details } from './scenarioCoverage.ts';
import { debugProperty, isProperty, propertyId, proveAll } from './propertyProofs.ts';
import { debugOne } from './scenarioDebugging.ts';
import { propertiesOf, scenariosOf, type Scenario } from './scenarioFile.ts';
import { report, violations } from './scenarioReport.ts';
import type { Server } from './server.ts';

const PATTERN = '**/*.ladder-test';
/** What makes scenarios run again. */
const WATCHED = '**/{*.ladder-test,*.clad,ladder.toml}';
const WHAT_MATTERS = ['--coverage', '--mutate'];
/** So much may be said of a file. */
const MOST_OUTPUT = 64 << 20;

const toRange = ({ line, start, end }: Stretch) => new vscode.Range(line, start, line, end);

export class TestExplorer implements vscode.Disposable {
    readonly #server: Server;
    readonly #controller = vscode.tests.createTestController('ladder', 'Ladder Scenarios');
    readonly #findings = vscode.languages.createDiagnosticCollection('ladder-test');
    readonly #disposables: vscode.Disposable[] = [this.#controller, this.#findings];
    /** The files, whose children are their scenarios and properties. */
    readonly #files = new Map<string, vscode.TestItem>();
    readonly #whatMatters: vscode.TestRunProfile;
    #isSearched = false;

    constructor(server: Server) {
        this.#server = server;
        const { Run, Debug, Coverage } = vscode.TestRunProfileKind;
        const profile = (name: string, kind: vscode.TestRunProfileKind, options: readonly string[], isDefault: boolean) => {
            const run = (request: vscode.TestRunRequest, token: vscode.CancellationToken) => this.#requested(request, token, options);
            const made = this.#controller.createRunProfile(name, kind, run, isDefault);
            made.supportsContinuousRun = isDefault;
            made.loadDetailedCoverage = async (_, covered) => (covered instanceof CoveredFile ? details(covered) : []);
            return made;
        };
        profile('Run', Run, [], true);
        this.#controller.createRunProfile('Debug', Debug, (request, token) => this.#debug(request, token), true);
        profile('Coverage', Coverage, ['--coverage'], true);
        // This takes a run of all scenarios for each contact.
        this.#whatMatters = profile('Coverage and What Matters', Coverage, WHAT_MATTERS, false);
        this.#controller.resolveHandler = async (item) => (item ? this.#read(item) : this.#search());
        this.#controller.refreshHandler = () => this.#search();
        const watcher = vscode.workspace.createFileSystemWatcher(PATTERN);
        this.#disposables.push(
            watcher,
            watcher.onDidCreate((uri) => this.#add(uri)),
            watcher.onDidChange((uri) => this.#add(uri)),
            watcher.onDidDelete((uri) => this.#remove(uri)),
            vscode.workspace.onDidOpenTextDocument((document) => this.#shown(document)),
            vscode.workspace.onDidChangeTextDocument(({ document }) => this.#shown(document)),
        );
        vscode.workspace.textDocuments.forEach((document) => this.#shown(document));
    }

    /** Saves a file of scenarios, that of the active editor if none is named, and runs them all. */
    async runFile(uri?: string): Promise<void> {
        const document = await scenariosAt(uri);
        if (document) {
            await document.save();
            await this.#run(new vscode.TestRunRequest([this.#item(document.uri)]), []);
        }
    }

    /** Runs all scenarios of the workspace, with what they exercise and which contacts matter. */
    async whatMatters(): Promise<void> {
        await this.#run(new vscode.TestRunRequest(undefined, undefined, this.#whatMatters), WHAT_MATTERS);
    }

    /** Proves the properties of a file, that of the active editor if none is named, or one of them. */
    async prove(uri?: string, name?: string): Promise<void> {
        const document = await scenariosAt(uri);
        if (!document) {
            return;
        }
        this.#shown(document);
        const all = [...this.#item(document.uri).children].map(([, item]) => item).filter(isProperty);
        const asked = name === undefined ? all : all.filter(({ id }) => id === propertyId(name));
        if (asked.length === 0) {
            void vscode.window.showInformationMessage('Ladder: there is no property in this file; write one, as in: never up and down');
            return;
        }
        await this.#run(new vscode.TestRunRequest(asked), []);
    }

    dispose(): void {
        vscode.Disposable.from(...this.#disposables).dispose();
    }

    async #search(): Promise<void> {
        this.#isSearched = true;
        const found = await vscode.workspace.findFiles(PATTERN);
        const known = new Set(found.map((uri) => uri.toString()));
        for (const [name, item] of this.#files) {
            if (!known.has(name) && item.uri && !vscode.workspace.textDocuments.some(({ uri }) => uri.toString() === name)) {
                this.#remove(item.uri);
            }
        }
        await Promise.all(found.map((uri) => this.#add(uri)));
    }

    async #add(uri: vscode.Uri): Promise<void> {
        const item = this.#item(uri);
        await this.#read(item);
    }

    #item(uri: vscode.Uri): vscode.TestItem {
        const name = uri.toString();
        let item = this.#files.get(name);
        if (!item) {
            item = this.#controller.createTestItem(name, vscode.workspace.asRelativePath(uri), uri);
            item.canResolveChildren = true;
            this.#files.set(name, item);
            this.#controller.items.add(item);
        }
        return item;
    }

    #remove(uri: vscode.Uri): void {
        const name = uri.toString();
        this.#files.delete(name);
        this.#controller.items.delete(name);
        this.#findings.delete(uri);
    }

    #shown(document: vscode.TextDocument): void {
        if (document.languageId === 'ladder-test' && document.uri.scheme === 'file') {
            this.#fill(this.#item(document.uri), document.getText());
            // What differed stood in another text.
            if (document.isDirty) {
                this.#findings.delete(document.uri);
            }
        }
    }

    async #read(item: vscode.TestItem): Promise<void> {
        if (item.uri && this.#files.has(item.id)) {
            try {
                this.#fill(item, await textOf(item.uri));
            } catch {
                this.#remove(item.uri);
            }
        }
    }

    #fill(file: vscode.TestItem, text: string): void {
        const item = (id: string, { name, line, lastLine }: Scenario) => {
            const item = file.children.get(id) ?? this.#controller.createTestItem(id, name, file.uri);
            item.range = new vscode.Range(line, 0, lastLine, Number.MAX_SAFE_INTEGER);
            return item;
        };
        const scenarios = scenariosOf(text).map((scenario) => item(scenario.name, scenario));
        const properties = propertiesOf(text).map((property) => {
            const proved = item(propertyId(property.name), property);
            proved.description = 'property';
            return proved;
        });
        file.children.replace([...scenarios, ...properties]);
    }

    /** Runs what is asked for; with `continuous` again whenever a file is saved that may matter. */
    async #requested(request: vscode.TestRunRequest, token: vscode.CancellationToken, options: readonly string[]): Promise<void> {
        if (!request.continuous) {
            await this.#run(request, options);
            return;
        }
        const watcher = vscode.workspace.createFileSystemWatcher(WATCHED);
        let waits: NodeJS.Timeout | undefined;
        let last: Promise<unknown> = Promise.resolve();
        // One after the other: what an earlier text gave must not be shown after what a later one did.
        const next = () => {
            last = last.catch(() => undefined).then(() => (token.isCancellationRequested ? undefined : this.#run(request, options)));
        };
        // Several files are saved at once.
        const again = () => {
            clearTimeout(waits);
            waits = setTimeout(next, 100);
        };
        watcher.onDidChange(again);
        watcher.onDidCreate(again);
        watcher.onDidDelete(again);
        token.onCancellationRequested(() => {
            clearTimeout(waits);
            watcher.dispose();
        });
    }

    /** The scenarios that are asked for, by their files. */
    async #chosen(request: vscode.TestRunRequest): Promise<Map<vscode.TestItem, vscode.TestItem[]>> {
        if (!this.#isSearched && !request.include) {
            await this.#search();
        }
        const wanted = request.include ?? [...this.#controller.items].map(([, item]) => item);
        const excluded = new Set(request.exclude ?? []);
        const chosen = new Map<vscode.TestItem, Set<vscode.TestItem>>();
        for (const item of wanted) {
            const file = item.parent ?? item;
            if (excluded.has(file)) {
                continue;
            }
            if (!item.parent) {
                await this.#read(item);
            }
            const children = item.parent ? [item] : [...item.children].map(([, child]) => child);
            const all = chosen.get(file) ?? new Set();
            children.filter((child) => !excluded.has(child)).forEach((child) => all.add(child));
            chosen.set(file, all);
        }
        return new Map([...chosen].map(([file, items]) => [file, [...items]]));
    }

    async #run(request: vscode.TestRunRequest, options: readonly string[]): Promise<void> {
        const run = this.#controller.createTestRun(request);
        const { token } = run;
        try {
            const program = this.#server.program();
            // What is run is what is on disk; the editor saves before, as its setting `testing.saveBeforeTest` says.
            const chosen = await this.#chosen(request);
            for (const items of chosen.values()) {
                items.forEach((item) => run.enqueued(item));
            }
            for (const [file, items] of chosen) {
                if (token.isCancellationRequested) {
                    break;
                }
                const [properties, scenarios] = [items.filter(isProperty), items.filter((item) => !isProperty(item))];
                const shown = scenarios.length > 0 ? await this.#runFile(run, program, file, scenarios, options, token) : new Map();
                await proveAll({ server: this.#server, run, token, shown }, file, properties);
            }
        } finally {
            run.end();
        }
    }

    /** @returns what the scenarios show of properties that are violated, by the names of these */
    async #runFile(
        run: vscode.TestRun,
        program: string | undefined,
        file: vscode.TestItem,
        items: readonly vscode.TestItem[],
        options: readonly string[],
        token: vscode.CancellationToken,
    ): Promise<ReadonlyMap<string, vscode.TestMessage[]>> {
        items.forEach((item) => run.started(item));
        if (!file.uri || program === undefined) {
            const why = vscode.workspace.isTrusted
                ? 'There is no program "ladder"; the log says more ("Ladder: Show Log").'
                : 'Nothing is run in a workspace that is not trusted.';
            items.forEach((item) => run.errored(item, new vscode.TestMessage(why)));
            return new Map();
        }
        const said = await execute(program, ['test', '--format', 'json', ...options, '--', file.uri.fsPath], token);
        let results: Results | undefined;
        try {
            results = JSON.parse(said.stdout) as Results;
        } catch {
            // What it could not do is on the other stream.
        }
        const [result] = results?.files ?? [];
        if (!result) {
            const message = new vscode.TestMessage(said.stderr.trim() || 'The scenarios could not be run.');
            items.forEach((item) => (token.isCancellationRequested ? run.skipped(item) : run.errored(item, message)));
            return new Map();
        }
        const lines = (await textOf(file.uri)).split(/\r\n|\n|\r/);
        this.#showDifferences(file.uri, result, lines);
        const ran = result.scenarios.filter(({ name }) => items.some(({ id }) => id === name));
        for (const item of items) {
            const scenario = ran.find(({ name }) => name === item.id);
            report(run, item, scenario, result, lines, (property) => file.children.get(propertyId(property)) !== undefined);
        }
        for (const mutated of results?.mutation ?? []) {
            const program = vscode.workspace.asRelativePath(whole(mutated.program));
            missedLines({ ...mutated, program }).forEach((line) => run.appendOutput(`${line}\r\n`));
        }
        for (const covered of results?.coverage ?? []) {
            run.addCoverage(new CoveredFile(vscode.Uri.file(whole(covered.file)), covered));
        }
        return violations(file, { ...result, scenarios: ran });
    }

    /** The columns that differ, as findings in their file. */
    #showDifferences(uri: vscode.Uri, { scenarios }: FileResult, lines: readonly string[]): void {
        const findings = scenarios.flatMap(({ name, differences }) =>
            differences.flatMap((difference) =>
                failingStretches(lines, difference).map((stretch) => {
                    const finding = new vscode.Diagnostic(toRange(stretch), difference.message, vscode.DiagnosticSeverity.Error);
                    finding.source = `scenario "${name}"`;
                    return finding;
                }),
            ),
        );
        this.#findings.set(uri, findings);
    }

    /** Debugs one scenario after the other; each says by its exit status whether it passed. */
    async #debug(request: vscode.TestRunRequest, token: vscode.CancellationToken): Promise<void> {
        const run = this.#controller.createTestRun(request);
        try {
            for (const [file, items] of await this.#chosen(request)) {
                for (const item of items) {
                    if (token.isCancellationRequested || !file.uri) {
                        return;
                    }
                    if (isProperty(item)) {
                        await debugProperty({ server: this.#server, run, token, shown: new Map() }, item);
                        continue;
                    }
                    run.started(item);
                    const status = await debugOne(file.uri, item.id, token);
                    if (status === 0) {
                        run.passed(item);
                    } else if (status === undefined) {
                        run.skipped(item);
                    } else {
                        run.failed(item, new vscode.TestMessage('An expectation was not met, or a fault stopped the program.'));
                    }
                }
            }
        } finally {
            run.end();
        }
    }
}

/** The file of scenarios at an address, else that of the active editor, if it is one. */
async function scenariosAt(uri: string | undefined): Promise<vscode.TextDocument | undefined> {
    const document = uri === undefined ? vscode.window.activeTextEditor?.document : await vscode.workspace.openTextDocument(vscode.Uri.parse(uri));
    return document?.languageId === 'ladder-test' ? document : undefined;
}

function execute(program: string, args: readonly string[], token: vscode.CancellationToken): Promise<{ stdout: string; stderr: string }> {
    return new Promise((resolve) => {
        // Not in the folder that is open, where Windows would look for libraries.
        const child = execFile(program, args, { cwd: homedir(), maxBuffer: MOST_OUTPUT }, (error, stdout, stderr) => {
            resolve({ stdout, stderr: stderr || (error && typeof error.code !== 'number' ? error.message : '') });
        });
        token.onCancellationRequested(() => child.kill());
    });
}
