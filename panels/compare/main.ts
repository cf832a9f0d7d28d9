// The page of a comparison: both forms of what changed next to each other. Keys go from change to change, a click to the text.
import type { FromPage, ToPage } from './messages.ts';

declare function acquireVsCodeApi(): { postMessage(message: FromPage): void };

const vscode = acquireVsCodeApi();
const sheet = new CSSStyleSheet();
document.adoptedStyleSheets = [sheet];
const summary = document.createElement('p');
summary.setAttribute('role', 'status');
const changes = document.createElement('main');
document.body.append(summary, changes);

const sections = () => [...changes.querySelectorAll<HTMLElement>('.change')];
const focused = () => sections().findIndex((section) => section.contains(document.activeElement));

/** The sections of a drawing that comes as text: a document made of it runs nothing. */
function parsed(drawing: string, line: number): Element[] {
    const found = [...new DOMParser().parseFromString(drawing, 'text/html').querySelectorAll('.change')];
    for (const section of found) {
        section.addEventListener('click', () => vscode.postMessage({ kind: 'reveal', line }));
        section.addEventListener('keydown', (event) => {
            if ((event as KeyboardEvent).key === 'Enter') {
                vscode.postMessage({ kind: 'reveal', line });
            }
        });
    }
    return found;
}

function take(message: ToPage): void {
    if (message.kind === 'refused') {
        summary.textContent = message.message;
        changes.replaceChildren();
        return;
    }
    const { name, compared } = message;
    const at = focused();
    sheet.replaceSync(compared.style ?? '');
    const none = compared.changes.length === 0;
    summary.textContent = `${name}: ${none ? 'no network, declaration or comment has changed since HEAD' : `${compared.summary} since HEAD`}.`;
    changes.replaceChildren(...compared.changes.flatMap(({ drawing, line }) => parsed(drawing ?? '', line)));
    // Who reads one goes on reading it.
    sections()[at]?.focus({ preventScroll: true });
}

addEventListener('message', ({ data }: MessageEvent<ToPage>) => take(data));
addEventListener('keydown', ({ key, ctrlKey, altKey, metaKey }) => {
    const step = { n: 1, j: 1, p: -1, k: -1 }[key];
    if (!step || ctrlKey || altKey || metaKey) {
        return;
    }
    const [all, at] = [sections(), focused()];
    const next = all[at < 0 ? (step > 0 ? 0 : all.length - 1) : at + step];
    next?.focus();
    next?.scrollIntoView({ block: 'nearest' });
});
vscode.postMessage({ kind: 'begin' });
