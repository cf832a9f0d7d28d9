// A link that holds a program: compressed, in the fragment, which no browser sends to a server.

/** What a link opens. */
export interface Linked {
    readonly name: string;
    readonly text: string;
    readonly scenarios?: string;
    /** What is next to it: models of its machine, a scene, settings. */
    readonly files?: Readonly<Record<string, string>>;
}

/** A link may come from anybody: no more than this is made of it, in bytes. */
const MOST = 4 << 20;

async function piped(bytes: Uint8Array<ArrayBuffer>, through: CompressionStream | DecompressionStream, most: number): Promise<Uint8Array<ArrayBuffer>> {
    const reader = new Blob([bytes]).stream().pipeThrough(through).getReader();
    const chunks: Uint8Array<ArrayBuffer>[] = [];
    let length = 0;
    for (let next = await reader.read(); !next.done; next = await reader.read()) {
        length += next.value.length;
        if (length > most) {
            await reader.cancel();
            throw new Error('the link holds a text that is too long.');
        }
        chunks.push(next.value as Uint8Array<ArrayBuffer>);
    }
    return new Uint8Array(await new Blob(chunks).arrayBuffer());
}

function toText(bytes: Uint8Array): string {
    let binary = '';
    for (let at = 0; at < bytes.length; at += 0x8000) {
        binary += String.fromCharCode(...bytes.subarray(at, at + 0x8000));
    }
    return btoa(binary).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}

function toBytes(text: string): Uint8Array<ArrayBuffer> {
    const binary = atob(text.replaceAll('-', '+').replaceAll('_', '/'));
    return Uint8Array.from(binary, (letter) => letter.charCodeAt(0));
}

/** @returns the fragment, with its `#` */
export async function toFragment(linked: Linked): Promise<string> {
    const bytes = new TextEncoder().encode(JSON.stringify(linked));
    return `#program=${toText(await piped(bytes, new CompressionStream('deflate-raw'), Infinity))}`;
}

/**
 * Reads `#program=..`, as a link of this page has it, or `#text=..` with the text as it is, percent-encoded, as a page writes
 * it that has one.
 *
 * @returns undefined where the fragment holds no program
 * @throws where it holds one that cannot be read
 */
export async function fromFragment(fragment: string): Promise<Linked | undefined> {
    const parts = new URLSearchParams(fragment.replace(/^#/, '').replaceAll('+', '%2B'));
    const text = parts.get('text');
    if (text !== null) {
        return { name: nameOf(parts.get('name')), text };
    }
    const program = parts.get('program');
    if (program === null) {
        return undefined;
    }
    const bytes = await piped(toBytes(program), new DecompressionStream('deflate-raw'), MOST);
    const read: unknown = JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(bytes));
    if (typeof read !== 'object' || read === null || !('text' in read) || typeof read.text !== 'string') {
        throw new Error('the link holds no program.');
    }
    const scenarios = 'scenarios' in read && typeof read.scenarios === 'string' ? { scenarios: read.scenarios } : {};
    return { name: nameOf('name' in read ? read.name : undefined), text: read.text, ...scenarios, ...filesOf(read) };
}

/** The files next to a program, of those names that may be there. */
export function filesOf(read: object): { files?: Readonly<Record<string, string>> } {
    const given: unknown = 'files' in read ? read.files : undefined;
    if (typeof given !== 'object' || given === null) {
        return {};
    }
    const isOne = ([name, text]: [string, unknown]) => /^[\p{L}\p{N}_-]+(\.clad|\.scene\.svg|\.toml)$/u.test(name) && name.length <= 80 && typeof text === 'string';
    const files = (Object.entries(given) as [string, unknown][]).filter(isOne).slice(0, 16) as [string, string][];
    return files.length === 0 ? {} : { files: Object.fromEntries(files) };
}

/** A name that a file may have, whatever a link says. */
export function nameOf(given: unknown): string {
    const name = typeof given === 'string' ? given.replaceAll(/[^\p{L}\p{N}_.-]/gu, '_').slice(0, 80) : '';
    const stem = name.replace(/\.clad$/i, '').replace(/^\.+/, '');
    return `${stem === '' ? 'program' : stem}.clad`;
}
