// The declarations as a table above the networks: a cell is changed where it is, a row is added by typing into the last one.
import type { Range } from '../../protocol.ts';
import type { Finding } from '../messages.ts';
import type { Ask } from './asker.ts';
import type { Pen } from './pen.ts';
import type { Cells, Declarations, Edit } from './requests.ts';

/** More rows than this are searched, not scrolled. */
const MOST = 200;
/** The table follows the text this long after it has changed, in milliseconds. */
const PAUSE = 150;

const COLUMNS = [
    ['name', 'Name', 'name'],
    ['type', 'Type', 'BOOL'],
    ['address', 'Address', '%IX0.0'],
    ['initial', 'Initial', ''],
    ['comment', 'Comment', ''],
] as const satisfies readonly (readonly [keyof Cells, string, string])[];

const SECTIONS = ['VAR_INPUT', 'VAR_OUTPUT', 'VAR', 'VAR RETAIN', 'VAR CONSTANT', 'VAR_GLOBAL'];
const SECTIONS_OF_BLOCKS = ['VAR_INPUT', 'VAR_OUTPUT', 'VAR_IN_OUT', 'VAR', 'VAR RETAIN', 'VAR CONSTANT'];
const TYPES = ['BOOL', 'INT', 'DINT', 'REAL', 'TIME', 'STRING', 'BYTE', 'WORD', 'DWORD', 'UINT', 'UDINT', 'LREAL', 'TON', 'TOF', 'TP', 'CTU', 'CTD', 'CTUD'];

type Declared = Declarations['rows'][number];

function keyOf(name: string, block: string | undefined): string {
    return `${block ?? ''}\n${name}`;
}

/** A line of the table: a declared tag, or room for another one. */
class Row {
    readonly node = document.createElement('tr');
    readonly section = document.createElement('select');
    readonly inputs = COLUMNS.map(() => document.createElement('input'));
    readonly remove = document.createElement('button');
    declared: Declared | undefined;
    block: string | undefined;

    constructor() {
        const cell = (node: HTMLElement) => {
            const cell = document.createElement('td');
            cell.append(node);
            return cell;
        };
        for (const [index, input] of this.inputs.entries()) {
            input.type = 'text';
            input.spellcheck = false;
            input.autocomplete = 'off';
            input.dataset['column'] = COLUMNS[index]?.[0] ?? '';
        }
        this.inputs[1]?.setAttribute('list', 'declared-types');
        this.remove.type = 'button';
        this.remove.textContent = '×';
        this.node.append(cell(this.section), ...this.inputs.map(cell), cell(this.remove));
    }

    /** Shows a declaration, or nothing yet. What somebody types into stays. */
    show(declared: Declared | undefined, block: string | undefined): void {
        const isOther = this.declared?.cells.name !== declared?.cells.name;
        this.declared = declared;
        this.block = block;
        const name = declared?.cells.name ?? 'a new tag';
        const sections = [...new Set([...(block === undefined ? SECTIONS : SECTIONS_OF_BLOCKS), ...(declared ? [declared.cells.section] : [])])];
        if (this.section.options.length !== sections.length || isOther) {
            this.section.replaceChildren(...sections.map((section) => new Option(section)));
        }
        if (declared) {
            this.section.value = declared.cells.section;
        }
        this.section.setAttribute('aria-label', `Section of ${name}`);
        for (const [index, input] of this.inputs.entries()) {
            const [column, label, placeholder] = COLUMNS[index] ?? COLUMNS[0];
            input.setAttribute('aria-label', `${label} of ${name}`);
            input.placeholder = declared ? '' : placeholder;
            if (document.activeElement !== input || input.value === input.defaultValue) {
                input.value = declared?.cells[column] ?? '';
            }
            input.defaultValue = declared?.cells[column] ?? '';
        }
        this.remove.hidden = !declared;
        this.remove.title = `Delete ${name}`;
        this.remove.setAttribute('aria-label', this.remove.title);
        this.node.classList.toggle('empty-row', !declared);
    }

    /** What is written in it now; of a new tag the type is BOOL unless another one is written. */
    get cells(): Cells {
        const written = Object.fromEntries(COLUMNS.map(([column], index) => [column, this.inputs[index]?.value.trim() ?? '']));
        return { ...(written as Omit<Cells, 'section'>), type: written['type'] || (this.declared ? '' : 'BOOL'), section: this.section.value };
    }
}

export class DeclarationsTable {
    readonly node = document.createElement('details');
    readonly #summary = document.createElement('summary');
    readonly #search = document.createElement('input');
    readonly #body = document.createElement('tbody');
    readonly #more = document.createElement('p');
    readonly #ask: Ask;
    readonly #pen: Pen;
    readonly #visit: (by: 1 | -1) => void;
    /** By the names of their tags; those for new tags by their blocks alone. */
    #rows = new Map<string, Row>();
    /** One change after the other: each is of the text that the one before has made. */
    #done: Promise<void> = Promise.resolve();
    #table: Declarations = { version: 0, rows: [] };
    #findings: readonly Finding[] = [];
    #later: ReturnType<typeof setTimeout> | undefined;

    /** @param visit goes to the next finding, or the one before */
    constructor(ask: Ask, pen: Pen, visit: (by: 1 | -1) => void) {
        this.#visit = visit;
        this.#ask = ask;
        this.#pen = pen;
        this.node.className = 'declarations';
        this.#summary.textContent = 'Declarations';
        this.#search.type = 'search';
        this.#search.placeholder = 'Search';
        this.#search.hidden = true;
        this.#search.setAttribute('aria-label', 'Search the declarations');
        const table = document.createElement('table');
        table.setAttribute('aria-label', 'Declarations');
        const head = document.createElement('thead');
        const titles = document.createElement('tr');
        for (const title of ['Section', ...COLUMNS.map(([, label]) => label), 'Delete']) {
            const cell = document.createElement('th');
            cell.scope = 'col';
            const words = document.createElement('span');
            words.textContent = title;
            // What a button with a cross does needs no words above it for who sees it.
            words.classList.toggle('unseen', title === 'Delete');
            cell.append(words);
            titles.append(cell);
        }
        head.append(titles);
        table.append(head, this.#body);
        const types = document.createElement('datalist');
        types.id = 'declared-types';
        types.append(...TYPES.map((type) => new Option(type)));
        const scroller = document.createElement('div');
        scroller.className = 'rows';
        scroller.append(this.#search, table, this.#more, types);
        this.node.append(this.#summary, scroller);
        this.node.open = window.innerHeight > 560;
        this.node.addEventListener('toggle', () => this.outdate());
        this.#search.addEventListener('input', () => this.#show());
        this.#body.addEventListener('change', (event) => this.#changed(event));
        this.#body.addEventListener('focusout', (event) => this.#left(event));
        this.#body.addEventListener('keydown', (event) => this.#key(event));
        this.#body.addEventListener('click', ({ target }) => {
            const row = this.#rowOf(target);
            if (row?.declared && row.remove.contains(target as Node)) {
                this.#change(row.declared, (what) => ({ op: 'declaration', what, row: null }));
            }
        });
    }

    /** Another program is shown. */
    open(): void {
        this.#table = { version: 0, rows: [] };
        this.outdate();
    }

    /** The text is another one: asked again soon, if anybody sees the table. */
    outdate(): void {
        clearTimeout(this.#later);
        if (this.node.open && !this.node.hidden) {
            this.#later = setTimeout(() => void this.#look(), PAUSE);
        }
    }

    /** What is reported about the text. */
    report(findings: readonly Finding[]): void {
        this.#findings = findings;
        this.#mark();
    }

    /** The declaration that a finding is about has the focus. @returns whether there is one */
    focusOn(finding: Finding): boolean {
        const [row] = this.node.open ? this.#rowsOf(finding) : [];
        row?.inputs[0]?.focus();
        return row !== undefined;
    }

    async #look(): Promise<void> {
        const table = await this.#ask('declarations', {}).catch(() => undefined);
        if (table && table.version >= this.#table.version) {
            this.#table = table;
            this.#show();
        }
    }

    /** Rows are kept where they are, so that nobody who types loses a place. */
    #show(): void {
        const { rows, blocks = [] } = this.#table;
        const wanted = this.#search.value.trim().toLowerCase();
        const isWanted = ({ cells }: Declared) => wanted === '' || COLUMNS.some(([column]) => cells[column]?.toLowerCase().includes(wanted));
        const found = rows.filter(isWanted);
        const seen = found.slice(0, MOST);
        const lines: { heading?: string; declared?: Declared; block?: string }[] = [];
        for (const block of [undefined, ...blocks]) {
            const own = seen.filter((row) => row.block === block);
            if (block !== undefined) {
                lines.push({ heading: block });
            }
            const of = block === undefined ? {} : { block };
            lines.push(...own.map((declared) => ({ declared, ...of })), of);
        }
        const known = this.#rows;
        this.#rows = new Map();
        const nodes = lines.map(({ heading, declared, block }) => {
            if (heading !== undefined) {
                const line = document.createElement('tr');
                const cell = document.createElement('th');
                cell.colSpan = COLUMNS.length + 2;
                cell.scope = 'rowgroup';
                cell.textContent = heading;
                line.append(cell);
                return line;
            }
            let key = keyOf(declared?.cells.name ?? '', block);
            while (this.#rows.has(key)) {
                // What is declared twice is an error, and is two rows.
                key += ' again';
            }
            const row = known.get(key) ?? new Row();
            this.#rows.set(key, row);
            row.show(declared, block);
            return row.node;
        });
        // What goes is gone before what comes: a row that is moved would lose the focus.
        const stays = new Set<Element>(nodes);
        [...this.#body.children].filter((node) => !stays.has(node)).forEach((node) => node.remove());
        nodes.forEach((node, index) => {
            if (this.#body.children[index] !== node) {
                this.#body.insertBefore(node, this.#body.children[index] ?? null);
            }
        });
        this.#summary.textContent = rows.length === 0 ? 'Declarations' : `Declarations (${rows.length})`;
        this.#search.hidden = rows.length < 12;
        this.#more.textContent = found.length > seen.length ? `${found.length - seen.length} more: search for them` : '';
        this.#mark();
    }

    #mark(): void {
        for (const row of this.#rows.values()) {
            const own = this.#findings.filter((finding) => this.#rowsOf(finding).includes(row));
            const [name] = row.inputs;
            row.node.classList.toggle('reported', own.length > 0);
            row.node.title = own.map(({ message }) => message).join('\n');
            name?.setAttribute('aria-invalid', String(own.some(({ severity }) => severity === 'error')));
            name?.setAttribute('aria-description', row.node.title);
        }
    }

    /** The rows that a finding is about: those of its names, else all of its line. */
    #rowsOf(finding: Finding): Row[] {
        const { line } = finding.from;
        const onLine = [...this.#rows.values()].filter(({ declared }) => declared?.at.start.line === line);
        const named = onLine.filter(({ declared }) => touches(declared?.at, finding));
        return named.length > 0 ? named : onLine;
    }

    #rowOf(target: EventTarget | null): Row | undefined {
        const line = target instanceof Node ? target : null;
        return [...this.#rows.values()].find(({ node }) => node.contains(line));
    }

    /** Changes the declaration of a tag, wherever that is by then. */
    #change({ cells: { name }, block }: Declared, edit: (what: Range) => Edit): void {
        this.#done = this.#done.then(async () => {
            if (this.#table.version !== this.#pen.page.layout.version) {
                await this.#look();
            }
            const now = this.#table.rows.find((row) => row.cells.name === name && row.block === block);
            await (now && this.#pen.edit(edit(now.at)));
            // What was refused is shown as it is in the text.
            this.outdate();
        });
    }

    /** A cell is finished. */
    #changed({ target }: Event): void {
        const row = this.#rowOf(target);
        if (!row?.declared) {
            return;
        }
        const { declared, cells } = row;
        if (cells.name === declared.cells.name) {
            this.#change(declared, (what) => ({ op: 'declaration', what, row: cells }));
        } else if (cells.name !== '') {
            const key = keyOf(declared.cells.name, declared.block);
            this.#rows.delete(key);
            this.#rows.set(keyOf(cells.name, declared.block), row);
            this.#change(declared, ({ start }) => ({ op: 'rename', what: { start, end: start }, text: cells.name }));
        }
    }

    /** A new row is finished when it is left. */
    #left({ target, relatedTarget }: FocusEvent): void {
        const row = this.#rowOf(target);
        if (row && !row.declared && row !== this.#rowOf(relatedTarget) && document.hasFocus()) {
            this.#add(row);
        }
    }

    #add(row: Row): void {
        const { cells, block } = row;
        if (cells.name !== '') {
            row.inputs.forEach((input) => (input.value = ''));
            this.#done = this.#done.then(() => this.#pen.edit({ op: 'declaration', ...(block !== undefined && { block }), row: cells }));
        }
    }

    #key(event: KeyboardEvent): void {
        const row = this.#rowOf(event.target);
        event.stopPropagation();
        if (!row || !(event.target instanceof HTMLInputElement)) {
            return;
        }
        const column = row.inputs.indexOf(event.target);
        const all = [...this.#rows.values()];
        const go = (by: number) => all[all.indexOf(row) + by]?.inputs[column]?.focus();
        if (event.key === 'F8') {
            this.#visit(event.shiftKey ? -1 : 1);
        } else if (event.key === 'Escape') {
            event.target.value = event.target.defaultValue;
        } else if (event.key === 'Enter' && !row.declared) {
            this.#add(row);
            row.inputs[0]?.focus();
        } else if (event.key === 'Enter' || event.key === 'ArrowDown') {
            go(1);
        } else if (event.key === 'ArrowUp') {
            go(-1);
        } else {
            return;
        }
        event.preventDefault();
    }
}

function touches(at: Range | undefined, { from, to }: Finding): boolean {
    const isAfter = at !== undefined && (from.line < at.start.line || (from.line === at.start.line && from.character <= at.end.character));
    return isAfter && (to.line > at.start.line || (to.line === at.start.line && to.character >= at.start.character));
}
