// What can be taken out of the page: the text, its picture, the trace of a simulation, and the program in another notation.
import { summary } from '../../panels/conversionReport.ts';
import type { Value } from '../../panels/protocol.ts';
import type { Complete } from './complete.ts';
import { element } from './element.ts';
import type { OpenText } from './openText.ts';
import { FOLDER, type Server } from './server.ts';
import type { Simulation } from './simulation.ts';
import { zip } from './zip.ts';

/** The letters of a picture are twice as large in PNG, for screens and paper. */
const PNG_SCALE = 2;
/** The server answers with no more values at a time. */
const MOST_VALUES = 200_000;

/** Hands a file to the browser, as a download. */
export function save(name: string, content: string | Blob, type = 'text/plain'): void {
    const address = URL.createObjectURL(typeof content === 'string' ? new Blob([content], { type: `${type};charset=utf-8` }) : content);
    element('a', { href: address, download: name }).click();
    setTimeout(() => URL.revokeObjectURL(address), 10_000);
}

export function stemOf(name: string): string {
    return name.replace(/\.[^.]*$/, '');
}

/** Saves a program in another notation: with what belongs next to it as one archive. @returns what became of it */
export async function saveIn(notation: string, complete: Complete, { name, text }: { readonly name: string; readonly text: string }): Promise<string> {
    const uri = `${FOLDER}/${encodeURIComponent(name)}`;
    const converted = await complete.execute('ladder.convert', { uri, to: notation }, { [name]: text });
    const stem = stemOf(name);
    const program = { name: `${stem}.${converted.extension || 'txt'}`, text: converted.text };
    const companions = (converted.companions ?? []).map((companion) => {
        if (companion.text === undefined) {
            throw new Error(`${companion.name} is not a text: \`ladder convert -o\` writes it.`);
        }
        return { name: companion.name, text: companion.text };
    });
    if (companions.length === 0) {
        save(program.name, program.text);
    } else {
        save(`${stem}.zip`, zip([program, ...companions]));
    }
    return `${summary(program.name, converted)}.`;
}

/** The diagram of a program as a picture that needs nothing else. */
export async function toSvg(server: Server, program: OpenText): Promise<string> {
    const { picture } = await server.execute('ladder.fence', { text: program.text });
    if (!picture) {
        throw new Error('there is no network in this program to draw.');
    }
    return picture.light;
}

export async function toPng(svg: string): Promise<Blob> {
    const address = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
    try {
        const image = new Image();
        image.src = address;
        await image.decode();
        const canvas = element('canvas', { width: String(image.width * PNG_SCALE), height: String(image.height * PNG_SCALE) });
        canvas.getContext('2d')?.drawImage(image, 0, 0, canvas.width, canvas.height);
        return await new Promise((resolve, reject) =>
            canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('this picture is too large for the browser to make.'))), 'image/png'),
        );
    } finally {
        URL.revokeObjectURL(address);
    }
}

function cell(value: Value): string {
    const text = typeof value === 'boolean' ? String(Number(value)) : String(value);
    return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

/** The tags over the scans that are kept, as `ladder sim` writes them: a row for each scan. */
export async function toCsv(simulation: Simulation): Promise<string> {
    const { session } = simulation;
    const tags = (await simulation.allTags()).map(({ name }) => name);
    if (!session || tags.length === 0) {
        throw new Error('nothing is simulated: run the program first.');
    }
    const { scan, timeMs, behind } = session.state;
    const scans = Math.max(Math.min(behind, Math.floor(MOST_VALUES / tags.length / 4)), 1);
    const history = await simulation.history(tags, scans);
    if (!history) {
        throw new Error('nothing is simulated: run the program first.');
    }
    const interval = scan > 0 ? timeMs / scan : 0;
    const rows = (history.tags[0]?.values ?? []).map((_, row) => {
        const at = history.firstScan + row;
        return [String(at), String(at * interval), ...history.tags.map(({ values }) => cell(values[row] ?? ''))].join(',');
    });
    return `${['scan', 'time_ms', ...history.tags.map(({ name }) => cell(name))].join(',')}\n${rows.map((row) => `${row}\n`).join('')}`;
}
