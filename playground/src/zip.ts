// Several files as one: an archive that any system unpacks. They are texts, and stored as they are.

const table = Uint32Array.from({ length: 256 }, (_, byte) => {
    let value = byte;
    for (let bit = 0; bit < 8; bit += 1) {
        value = value & 1 ? 0xedb88320 ^ (value >>> 1) : value >>> 1;
    }
    return value;
});

const checksum = (bytes: Uint8Array) => ~bytes.reduce((sum, byte) => (sum >>> 8) ^ (table[(sum ^ byte) & 255] ?? 0), -1) >>> 0;

/** Numbers of the given widths in bytes, the lowest byte first. */
function fields(...numbers: readonly (readonly [width: 2 | 4, value: number])[]): Uint8Array<ArrayBuffer> {
    return Uint8Array.from(numbers.flatMap(([width, value]) => Array.from({ length: width }, (_, at) => (value >>> (8 * at)) & 255)));
}

/** The first moment that the format can say: an archive of the same files is the same. */
const DATE = 0x21;
const NAMES_ARE_UTF8 = 0x800;

export function zip(files: readonly { readonly name: string; readonly text: string }[]): Blob {
    const encoder = new TextEncoder();
    const parts: Uint8Array<ArrayBuffer>[] = [];
    const directory: Uint8Array<ArrayBuffer>[] = [];
    let at = 0;
    for (const { name, text } of files) {
        const [title, content] = [encoder.encode(name), encoder.encode(text)];
        const size = content.length;
        const common = fields([2, 20], [2, NAMES_ARE_UTF8], [2, 0], [2, 0], [2, DATE], [4, checksum(content)], [4, size], [4, size], [2, title.length], [2, 0]);
        parts.push(fields([4, 0x04034b50]), common, title, content);
        directory.push(fields([4, 0x02014b50], [2, 20]), common, fields([2, 0], [2, 0], [2, 0], [4, 0], [4, at]), title);
        at += 4 + common.length + title.length + size;
    }
    const length = directory.reduce((sum, part) => sum + part.length, 0);
    const end = fields([4, 0x06054b50], [2, 0], [2, 0], [2, files.length], [2, files.length], [4, length], [4, at], [2, 0]);
    return new Blob([...parts, ...directory, end], { type: 'application/zip' });
}
