// Files that are opened or dropped: programs, scenarios, and programs of other systems, which are translated.
import { hasReport, report, summary } from '../../panels/conversionReport.ts';
import { nameOf } from './link.ts';
import { FOLDER, type Server } from './server.ts';

/** A larger file is no program. In bytes. */
const MOST = 8 << 20;

export interface Opened {
    readonly name: string;
    readonly text: string;
    /** What became of a program of another system: a line, and the whole of it. */
    readonly summary?: string;
    readonly report?: string;
}

/** @throws with a sentence for people where it is no program that can be read */
export async function read(server: Server, file: File): Promise<Opened> {
    if (file.size > MOST) {
        throw new Error(`${file.name} is too large for a program.`);
    }
    let text: string;
    try {
        text = new TextDecoder('utf-8', { fatal: true }).decode(await file.arrayBuffer());
    } catch {
        throw new Error(`${file.name} is not a text in UTF-8.`);
    }
    if (/\.(clad|ladder-test)$/i.test(file.name)) {
        return { name: file.name, text };
    }
    const converted = await server.execute('ladder.convert', { uri: `${FOLDER}/${encodeURIComponent(file.name)}`, text, to: 'clad' });
    const name = nameOf(file.name.replace(/\.[^.]*$/, ''));
    return {
        name,
        text: converted.text,
        summary: `${summary(file.name, converted)}.`,
        ...(hasReport(converted) ? { report: report(file.name, converted) } : {}),
    };
}

/** Files that are dropped anywhere on the page, and those of the dialog of the browser. */
export function takeFiles(button: HTMLButtonElement, input: HTMLInputElement, take: (files: readonly File[]) => void): void {
    button.addEventListener('click', () => input.click());
    input.addEventListener('change', () => {
        take([...(input.files ?? [])]);
        input.value = '';
    });
    const has = (event: DragEvent) => event.dataTransfer?.types.includes('Files') === true;
    window.addEventListener('dragover', (event) => {
        if (has(event)) {
            event.preventDefault();
            document.body.classList.add('dropping');
        }
    });
    window.addEventListener('dragleave', (event) => event.relatedTarget === null && document.body.classList.remove('dropping'));
    window.addEventListener(
        'drop',
        (event) => {
            document.body.classList.remove('dropping');
            if (has(event)) {
                // Else the editor puts the file's text where it was dropped.
                event.preventDefault();
                event.stopPropagation();
                take([...(event.dataTransfer?.files ?? [])]);
            }
        },
        true,
    );
}
