// Files that are opened or dropped: programs, scenarios, and programs of other systems, which are translated.
import { hasReport, report, summary } from '../../panels/conversionReport.ts';
import type { Complete, Files } from './complete.ts';
import { type Linked, nameOf } from './link.ts';
import { FOLDER } from './server.ts';

/** A larger file is no program. In bytes. */
const MOST = 8 << 20;

export interface Read {
    readonly program: Linked;
    /** What became of it: a line, and for a program of another system the whole of it. */
    readonly summary: string;
    readonly report?: string;
}

function textOf(name: string, bytes: Uint8Array): string {
    try {
        return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
    } catch {
        throw new Error(`${name} is not a text in UTF-8.`);
    }
}

const isProgram = (name: string) => /\.clad$/i.test(name);
const isScenarios = (name: string) => /\.ladder-test$/i.test(name);

/**
 * Reads files that were given together: each program is one, scenarios go with the program among them, else with the one that is
 * open, and a program of another system may have what belongs to it next to it.
 *
 * @throws with a sentence for people where there is no program that can be read
 */
export async function read(complete: Complete, files: readonly File[], open: Linked): Promise<readonly Read[]> {
    const large = files.find(({ size }) => size > MOST);
    if (large) {
        throw new Error(`${large.name} is too large for a program.`);
    }
    const all = await Promise.all(files.map(async (file) => ({ name: file.name, bytes: new Uint8Array(await file.arrayBuffer()) })));
    const texts = all.filter(({ name }) => isProgram(name) || isScenarios(name)).map(({ name, bytes }) => ({ name, text: textOf(name, bytes) }));
    const scenarios = texts.find(({ name }) => isScenarios(name));
    const programs = texts.filter(({ name }) => isProgram(name)).map(({ name, text }) => ({ name: nameOf(name), text }));
    if (scenarios) {
        const last = programs.pop() ?? open;
        const program = { ...last, scenarios: scenarios.text };
        return [...programs, program].map((one) => ({ program: one, summary: `${one === program ? scenarios.name : one.name} is open.` }));
    }
    if (programs.length > 0) {
        return programs.map((program) => ({ program, summary: `${program.name} is open.` }));
    }
    const [first] = all;
    return first ? [await translated(complete, first.name, Object.fromEntries(all.map(({ name, bytes }) => [name, bytes])))] : [];
}

async function translated(complete: Complete, file: string, files: Files): Promise<Read> {
    const converted = await complete.execute('ladder.convert', { uri: `${FOLDER}/${encodeURIComponent(file)}`, to: 'clad' }, files);
    return {
        program: { name: nameOf(file.replace(/\.[^.]*$/, '')), text: converted.text },
        summary: `${summary(file, converted)}.`,
        ...(hasReport(converted) ? { report: report(file, converted) } : {}),
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
