// The page of a scene: the picture of a machine, a table of the same values, and what a person does there.
import { Drawing } from './drawing.ts';
import { handsOn } from './hands.ts';
import type { FromPage, SceneShown, SceneSituation, ToPage } from './messages.ts';

declare function acquireVsCodeApi(): { postMessage(message: FromPage): void; getState(): { table?: boolean } | undefined; setState(state: object): void };

const vscode = acquireVsCodeApi();
const send = (message: FromPage) => vscode.postMessage(message);

function element<Name extends keyof HTMLElementTagNameMap>(name: Name, attributes: Readonly<Record<string, string>> = {}, ...content: (Node | string)[]): HTMLElementTagNameMap[Name] {
    const made = document.createElement(name);
    Object.entries(attributes).forEach(([attribute, value]) => made.setAttribute(attribute, value));
    made.append(...content);
    return made;
}

const run = element('button', { type: 'button', class: 'action' }, 'Run');
const asTable = element('button', { type: 'button', 'aria-pressed': 'false', title: 'The same values as a table' }, 'Table');
const standing = element('span', { class: 'standing' });
const notice = element('p', { class: 'notice', role: 'status', hidden: '' });
const picture = element('div', { class: 'picture' });
const rows = element('tbody');
const heading = element('tr', {}, ...['Part', 'Shows', 'Expression', 'Value'].map((title) => element('th', { scope: 'col' }, title)));
const table = element('table', { hidden: '' }, element('caption', { class: 'spoken' }, 'The values of the picture'), element('thead', {}, heading), rows);
const told = element('details', { class: 'told', hidden: '' });
const alarm = element('div', { class: 'spoken', 'aria-live': 'assertive' });
document.body.append(element('div', { class: 'toolbar', role: 'toolbar', 'aria-label': 'Scene' }, run, asTable, standing), notice, picture, element('div', { class: 'values', tabindex: '0', role: 'region', 'aria-label': 'Values' }, table), told, alarm);

/** The alarms that are shown and were announced. */
const alarms = new Set<string>();
let drawing: Drawing | undefined;
let letGo: (() => void) | undefined;
let situation: SceneSituation = { live: false, running: false, text: '' };

function say(text: string): void {
    notice.hidden = text === '';
    if (notice.textContent !== text) {
        notice.textContent = text;
    }
}

/** An alarm that comes is announced, also when it comes with the picture; not again where the picture is only drawn again. */
function announce(text: string, isShown: boolean): void {
    if (isShown && situation.live) {
        if (!alarms.has(text)) {
            alarms.add(text);
            alarm.textContent = text;
        }
    } else if (alarms.delete(text) && alarm.textContent === text) {
        alarm.textContent = '';
    }
}

function show(shown: SceneShown): void {
    const focused = drawing?.nodes.indexOf(document.activeElement as Element) ?? -1;
    letGo?.();
    drawing?.end();
    const cells = shown.rows.map(() => element('td', { class: 'value' }));
    rows.replaceChildren(
        ...shown.rows.map(({ name, attribute, expression }, row) =>
            element('tr', {}, element('th', { scope: 'row' }, name), element('td', {}, attribute), element('td', { class: 'code' }, expression), cells[row] ?? '')),
    );
    const onRow = (row: number, value: string) => {
        const cell = cells[row];
        if (cell && cell.textContent !== value) {
            cell.textContent = value;
        }
    };
    drawing = new Drawing(picture, shown, onRow, announce);
    letGo = handsOn(drawing, shown.acts, (tag, given) => {
        if (situation.live) {
            send({ kind: 'give', tag, given });
        } else {
            say('Run the program first: then what is pressed reaches it.');
        }
    });
    drawing.element(focused)?.focus();
    told.hidden = shown.findings.length === 0;
    told.replaceChildren(element('summary', {}, `Findings: ${shown.findings.length}`), element('ul', {}, ...shown.findings.map((finding) => element('li', {}, finding))));
    document.title = shown.title === '' ? 'Scene' : shown.title;
    say(shown.nodes.length === 0 ? 'The drawing cannot be shown.' : '');
}

function be(now: SceneSituation): void {
    if (now.live && !situation.live) {
        say('');
    }
    situation = now;
    run.textContent = now.running ? 'Pause' : 'Run';
    if (standing.textContent !== now.text) {
        standing.textContent = now.text;
    }
    document.body.classList.toggle('live', now.live);
}

function choose(isTable: boolean): void {
    asTable.setAttribute('aria-pressed', String(isTable));
    table.hidden = !isTable;
    document.body.classList.toggle('tabled', isTable);
    vscode.setState({ table: isTable });
}

run.addEventListener('click', () => send({ kind: 'runOrPause' }));
asTable.addEventListener('click', () => choose(table.hidden !== false));
window.addEventListener('message', ({ data }: MessageEvent<ToPage>) => {
    switch (data.kind) {
        case 'scene':
            show(data.shown);
            break;
        case 'values':
            drawing?.change(data.values);
            break;
        case 'situation':
            be(data.situation);
            break;
        case 'failed':
            say(data.message);
    }
});
choose(vscode.getState()?.table === true);
send({ kind: 'ready' });
