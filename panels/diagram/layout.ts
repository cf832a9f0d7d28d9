// Where the pieces of a diagram are on a page that knows only those that it has shown: lines that nobody has asked for
// count as high as lines mostly are.
import type { Drawn, DrawnPiece, LineChange, Lines } from './messages.ts';

/** How high a line is of which nothing is known, in pixels. */
const LINE_HEIGHT = 40;

/** Blank below a piece: what a comment is about is close to it. */
const GAP = { comment: 2, heading: 6, network: 14, broken: 14 } as const;

/** Lines of the text of which it is known what they are. */
export interface Segment {
    first: number;
    last: number;
    /** What is drawn there; blank lines and declarations have nothing. */
    readonly piece?: Piece;
    /** The version of the text that it was asked for; less than that of the text if it must be asked for again. */
    version: number;
    /** Where it begins on the page. */
    top: number;
}

/** A drawing at its place. */
export interface Piece {
    /** The same as long as the drawing is. */
    readonly id: number;
    readonly kind: DrawnPiece['kind'];
    readonly key: string;
    readonly width: number;
    readonly height: number;
    /** It is half typed: this is how it was before. */
    readonly isHeld: boolean;
    /** Why nothing can be drawn in it, if so. */
    readonly why?: string;
}

/** A place on the page that stays where it is when something above it changes. */
export interface Anchor {
    line: number;
    readonly offset: number;
}

export class Layout {
    lineCount = 0;
    version = 0;
    scale = 1;
    readonly #segments: Segment[] = [];
    #height = 0;
    #ids = 0;

    get height(): number {
        return this.#height;
    }

    get segments(): readonly Segment[] {
        return this.#segments;
    }

    open(version: number, lineCount: number): void {
        this.version = version;
        this.lineCount = lineCount;
        this.#segments.length = 0;
        this.place();
    }

    /** Everything must be asked for again, as when drawings become wider. */
    outdate(): void {
        for (const segment of this.#segments) {
            segment.version = -1;
        }
    }

    /** The text is another one: what is below moves with it, and what was changed is shown as it was. */
    edit(version: number, lineCount: number, changes: readonly LineChange[]): void {
        this.version = version;
        this.lineCount = lineCount;
        for (const { first, last, count } of changes) {
            const more = count - (last - first + 1);
            const end = first + count;
            const kept = this.#segments.filter((segment) => segment.last < first || segment.first <= first || segment.last > last);
            for (const segment of kept) {
                if (segment.last < first) {
                    continue;
                }
                if (segment.first > last) {
                    segment.first += more;
                    segment.last += more;
                } else if (segment.first <= first) {
                    segment.last = segment.last >= last ? segment.last + more : end - 1;
                } else {
                    segment.first = end;
                    segment.last += more;
                }
            }
            this.#segments.splice(0, Infinity, ...kept.filter((segment) => segment.last >= segment.first));
        }
        this.place();
    }

    /** Takes in an answer. @returns whether it is about the text as it is now */
    take({ version, lineCount, lines, pieces }: Drawn): boolean {
        if (version !== this.version) {
            return false;
        }
        this.lineCount = lineCount;
        const isInside = (segment: Segment) => segment.first <= lines.last && segment.last >= lines.first;
        const old = this.#segments.filter(isInside);
        const found: Segment[] = [];
        let next = lines.first;
        for (const drawn of pieces) {
            if (drawn.lines.first > next) {
                found.push({ first: next, last: drawn.lines.first - 1, version, top: 0 });
            }
            const held = drawn.kind === 'broken' ? this.#held(drawn, old, version) : [];
            if (held.length > 0) {
                found.push(...held);
            } else {
                const piece = this.#pieceOf(drawn, old);
                found.push({ first: drawn.lines.first, last: drawn.lines.last, piece, version, top: 0 });
            }
            next = drawn.lines.last + 1;
        }
        if (next <= lines.last) {
            found.push({ first: next, last: lines.last, version, top: 0 });
        }
        const above = this.#segments.filter((segment) => segment.last < lines.first);
        const below = this.#segments.filter((segment) => segment.first > lines.last);
        this.#segments.splice(0, Infinity, ...above, ...found, ...below);
        this.place();
        return true;
    }

    #pieceOf({ kind, key, width, height, why }: DrawnPiece, old: readonly Segment[]): Piece {
        // What moved is nearest to where it was; of two that are alike any will do.
        const before = old.findIndex(({ piece }) => piece?.key === key && !piece.isHeld);
        const same = before >= 0 ? old[before] : undefined;
        if (same?.piece) {
            (old as Segment[]).splice(before, 1);
            return same.piece;
        }
        return { id: ++this.#ids, kind, key, width, height, isHeld: false, ...(why !== undefined && { why }) };
    }

    /** What stood where an error is now, as it was: one letter can swallow many networks. Nothing if there was no network. */
    #held({ lines }: DrawnPiece, old: readonly Segment[], version: number): Segment[] {
        const good = old.filter(({ first, last, piece }) => first <= lines.last && last >= lines.first && piece && piece.kind !== 'broken');
        if (!good.some(({ piece }) => piece?.kind === 'network')) {
            return [];
        }
        const segments: Segment[] = [];
        let next = lines.first;
        good.forEach((segment, index) => {
            // What was typed belongs to the network above it, at the beginning to the first.
            const first = index === 0 ? lines.first : Math.max(segment.first, next);
            const last = Math.min(index === good.length - 1 ? lines.last : segment.last, lines.last);
            if (first > next) {
                segments.push({ first: next, last: first - 1, version, top: 0 });
            }
            const { piece } = segment;
            const held = piece && (piece.isHeld ? piece : { ...piece, id: ++this.#ids, isHeld: true });
            segments.push({ first, last: Math.max(last, first), ...(held && { piece: held }), version, top: 0 });
            next = Math.max(last, first) + 1;
        });
        return segments;
    }

    /** Puts everything at its place. */
    place(): void {
        let top = 0;
        let next = 0;
        for (const segment of this.#segments) {
            top += (segment.first - next) * LINE_HEIGHT * this.scale;
            segment.top = top;
            top += this.#heightOf(segment);
            next = segment.last + 1;
        }
        this.#height = top + Math.max(this.lineCount - next, 0) * LINE_HEIGHT * this.scale;
    }

    #heightOf({ piece }: Segment): number {
        return piece ? (piece.height + GAP[piece.kind]) * this.scale : 0;
    }

    /** The segments that have something between two heights. */
    between(top: number, bottom: number): Segment[] {
        return this.#segments.filter((segment) => segment.top < bottom && segment.top + this.#heightOf(segment) > top);
    }

    /** The line at a height; in the midst of lines of which nothing is known by their share. */
    lineAt(y: number): number {
        let next = 0;
        let end = 0;
        for (const segment of this.#segments) {
            if (y < segment.top) {
                break;
            }
            end = segment.top + this.#heightOf(segment);
            if (y < end) {
                return segment.first;
            }
            next = segment.last + 1;
        }
        const line = next + Math.floor(Math.max(y - end, 0) / (LINE_HEIGHT * this.scale));
        return Math.max(Math.min(line, this.lineCount - 1), 0);
    }

    /** Where a line begins. */
    topOf(line: number): number {
        let next = 0;
        let end = 0;
        for (const segment of this.#segments) {
            if (line < segment.first) {
                break;
            }
            if (line <= segment.last) {
                return segment.top;
            }
            next = segment.last + 1;
            end = segment.top + this.#heightOf(segment);
        }
        return end + (line - next) * LINE_HEIGHT * this.scale;
    }

    /** The segment of a line. */
    at(line: number): Segment | undefined {
        let low = 0;
        let high = this.#segments.length;
        while (low < high) {
            const middle = (low + high) >> 1;
            if ((this.#segments[middle]?.last ?? 0) < line) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        const segment = this.#segments[low];
        return segment && segment.first <= line ? segment : undefined;
    }

    /** The lines between two heights that must be asked for, if there are any. */
    wanted(top: number, bottom: number): Lines | undefined {
        const last = this.lineAt(bottom);
        let first = this.lineAt(top);
        // A user may have drawn something where nothing was.
        const above = this.at(first - 1);
        if (above && !above.piece) {
            first = above.first;
        }
        // Lines at the edges of which all is known need not be asked for.
        while (first <= last) {
            const segment = this.at(first);
            if (segment?.version !== this.version) {
                return { first: segment ? Math.min(segment.first, first) : first, last };
            }
            first = segment.last + 1;
        }
        return undefined;
    }

    anchorAt(y: number): Anchor {
        const line = this.lineAt(y);
        return { line, offset: y - this.topOf(line) };
    }

    /** Where an anchor is now. */
    heightOfAnchor({ line, offset }: Anchor): number {
        return this.topOf(line) + offset;
    }
}

/** A line, moved by changes of the text. */
export function moved(line: number, changes: readonly LineChange[]): number {
    let now = line;
    for (const { first, last, count } of changes) {
        if (now > last) {
            now += count - (last - first + 1);
        } else if (now >= first) {
            now = Math.min(now, first + count - 1);
        }
    }
    return now;
}
