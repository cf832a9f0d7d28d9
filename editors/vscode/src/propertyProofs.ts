// Properties in the Test Explorer: proved by the server, each with what came of it.
import * as vscode from 'vscode';
import { LSPErrorCodes, ResponseError } from 'vscode-languageclient/node';

import type { PropertyProved } from '../../../panels/protocol.ts';
import { reasonOf } from '../../../panels/reason.ts';
import { escaped, fenced } from './markdown.ts';
import { debugOne } from './scenarioDebugging.ts';
import { scenariosOf } from './scenarioFile.ts';
import type { Server } from './server.ts';

const PREFIX = 'property ';

/** The identity of a property among the scenarios of its file. */
export const propertyId = (name: string) => `${PREFIX}"${name}"`;

export const isProperty = ({ id }: vscode.TestItem) => id.startsWith(`${PREFIX}"`);

/** Whom is asked, where it is reported, and what the scenarios of the same run show of properties that are violated, by their names. */
export interface Proving {
    readonly server: Server;
    readonly run: vscode.TestRun;
    readonly token: vscode.CancellationToken;
    readonly shown: ReadonlyMap<string, readonly vscode.TestMessage[]>;
}

/** Proves properties of a file: all of them together, if all are asked for. One that a scenario violates has failed whether it is asked for or not. */
export async function proveAll(proving: Proving, file: vscode.TestItem, items: readonly vscode.TestItem[]): Promise<void> {
    const { run, shown } = proving;
    items.forEach((item) => run.started(item));
    for (const [name, messages] of shown) {
        const item = file.children.get(propertyId(name));
        if (item && !items.includes(item)) {
            run.failed(item, messages);
        }
    }
    const all = [...file.children].filter(([, item]) => isProperty(item)).length;
    if (items.length === all && all > 1) {
        const proved = await ask(proving, items, {});
        for (const item of proved ? items : []) {
            report(proving, item, proved?.find(({ name }) => propertyId(name) === item.id));
        }
        return;
    }
    for (const item of items) {
        await proveOne(proving, item);
    }
}

/** Proves one property, and debugs the run that was found. */
export async function debugProperty(proving: Proving, item: vscode.TestItem): Promise<void> {
    proving.run.started(item);
    const property = await proveOne(proving, item);
    const scenario = property?.scenario && scenariosOf(property.scenario)[0];
    if (item.uri && property && scenario) {
        await debugOne(item.uri, scenario.name, proving.token, property.scenario);
    }
}

async function proveOne(proving: Proving, item: vscode.TestItem): Promise<PropertyProved | undefined> {
    const proved = await ask(proving, [item], { name: item.label });
    if (proved) {
        report(proving, item, proved[0]);
    }
    return proved?.[0];
}

/** Asks the server; what goes wrong is told at each of the items. */
async function ask(
    { server, run, token, shown }: Proving,
    items: readonly vscode.TestItem[],
    only: { name?: string },
): Promise<readonly PropertyProved[] | undefined> {
    const uri = items[0]?.uri?.toString();
    if (uri === undefined) {
        return undefined;
    }
    try {
        return (await server.execute('ladder.proveProperties', { uri, ...only }, token)).properties;
    } catch (error) {
        const isOvertaken = error instanceof ResponseError && error.code === LSPErrorCodes.ContentModified;
        for (const item of items) {
            const violated = shown.get(item.label);
            if (violated) {
                run.failed(item, violated);
            } else if (token.isCancellationRequested || isOvertaken) {
                run.skipped(item);
            } else {
                run.errored(item, new vscode.TestMessage(reasonOf(error)));
            }
        }
        return undefined;
    }
}

function report({ run, shown }: Proving, item: vscode.TestItem, property: PropertyProved | undefined): void {
    if (!property) {
        run.errored(item, new vscode.TestMessage('The file has no such property any more.'));
        return;
    }
    const { verdict, diagram = '' } = property;
    const notes = property.open.map(({ message }) => (verdict === 'unknown' ? `not decided: ${message}` : `left open: ${message}`));
    const sentence = [property.message, ...(property.neverTriggered ? ['what is on its left side never happens'] : []), ...notes].join('; ');
    for (const line of [`${item.label}: ${sentence}`, ...(diagram ? diagram.split('\n') : [])]) {
        run.appendOutput(`${line}\r\n`, undefined, item);
    }
    const violated = shown.get(item.label) ?? [];
    if (violated.length === 0 && (verdict === 'proved' || verdict === 'possible')) {
        run.passed(item);
        return;
    }
    const message = new vscode.TestMessage(new vscode.MarkdownString(`${escaped(sentence)}${diagram && `\n\n${fenced(diagram)}`}`));
    if (item.uri && item.range) {
        message.location = new vscode.Location(item.uri, item.range.start);
    }
    if (violated.length > 0) {
        run.failed(item, verdict === 'violated' ? [message, ...violated] : violated);
    } else if (verdict === 'unknown') {
        run.errored(item, message);
    } else {
        run.failed(item, message);
    }
}
