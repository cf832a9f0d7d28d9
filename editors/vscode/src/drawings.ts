// The ladder text of open Click programs: which document shows whose, and what it shows.
import type { Previewed } from '../../../panels/protocol.ts';

/** The scheme of documents that show the ladder text of a Click program: they are not files, and nobody edits them. */
export const SCHEME = 'ladder-click';

/** What a drawing shows whose program is not open, as after a start of the editor. */
const NOTHING = '# Open the program that this shows, and choose "Show as Ladder" again. #\n';

/** @returns the parts of a drawing's address: that of the program's file, as a file of ladder text */
export function drawingOf(program: { readonly scheme: string; readonly path: string }) {
    const path = program.path.startsWith('/') ? program.path : `/${program.path}`;
    return { scheme: SCHEME, authority: program.scheme, path: `${path}.clad` };
}

/** The newest ladder text of each program, by the program's address. */
export class Drawings {
    readonly #newest = new Map<string, Previewed>();
    /** The programs' addresses by those of their drawings. */
    readonly #programs = new Map<string, string>();

    /** The program is open, and a drawing shows what it becomes. The server's answer begins again: versions may, too. */
    begin(drawing: string, previewed: Previewed): void {
        this.#programs.set(drawing, previewed.uri);
        const known = this.#newest.get(previewed.uri);
        if (!known || known.version <= previewed.version) {
            this.#newest.set(previewed.uri, previewed);
        }
    }

    /** @returns the drawing that shows something else now; an answer and a notification may cross */
    take(previewed: Previewed): string | undefined {
        const known = this.#newest.get(previewed.uri);
        if (known && known.version > previewed.version) {
            return undefined;
        }
        this.#newest.set(previewed.uri, previewed);
        return [...this.#programs].find(([, program]) => program === previewed.uri)?.[0];
    }

    /** The program is no longer open; its drawing keeps its text, and a version may come again. */
    end(program: string): void {
        const known = this.#newest.get(program);
        if (known) {
            this.#newest.set(program, { ...known, version: -1 });
        }
    }

    /** Whether a drawing shows this program. */
    has(program: string): boolean {
        return this.#newest.has(program);
    }

    text(drawing: string): string {
        const program = this.#programs.get(drawing);
        return (program !== undefined && this.#newest.get(program)?.text) || NOTHING;
    }
}
