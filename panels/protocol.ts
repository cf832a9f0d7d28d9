// What the simulator of the language server says and is asked, as docs/protocol.md of the project defines it.
import type { Asked, Declarations, Edit, Edited, Offered } from './diagram/draw/requests.ts';
import type { Compared } from './compare/messages.ts';
import type { CrossReferenced } from './crossReference.ts';
import type { Drawn, Lines } from './diagram/messages.ts';
import type { SceneShown, SceneValues } from './scene/messages.ts';
import type { Traced, TraceAsked } from './trace/messages.ts';

/** A place in a text; both count from 0, characters in UTF-16 units. */
export interface Place {
    readonly line: number;
    readonly character: number;
}

export interface Range {
    readonly start: Place;
    readonly end: Place;
}

export type Value = boolean | number | string;

export interface Tag {
    readonly name: string;
    readonly type: string;
    /** An empty text of one that opens. */
    readonly value: Value;
    /** The value as people read it. */
    readonly text: string;
    readonly role: 'input' | 'output' | 'internal';
    readonly forced: boolean;
    /** It can be neither set nor forced. */
    readonly readOnly?: boolean;
    /** It has no value of its own, but opens into this many tags. */
    readonly parts?: number;
}

/** What a contact does with power: lets it through, would not, or holds up what comes. */
export type Contact = 'closed' | 'open' | 'blocks';

/** Whether power flows in one wire, block or connector. */
export interface Power {
    readonly range: Range;
    readonly on: boolean;
    /** Of a controller: that is not known. */
    readonly unknown?: boolean;
    readonly contact?: Contact;
}

/** An operand in a line that is shown, and the tags whose values belong next to it. */
export interface Operand {
    readonly range: Range;
    readonly block: Range;
    readonly tags: readonly string[];
    /** The drawing tells the value already. */
    readonly drawn?: boolean;
}

/** Where the value of an operand is shown: over the line above or below, which is blank there, or after the line; of what is declared always after it. */
export interface Label {
    /** Whose text it is. */
    readonly tag: string;
    /** What is before that text: which element it is of; after a declaration, which of its tags or members. */
    readonly index?: string;
    /** Where the operand begins. */
    readonly at: Range['start'];
    readonly side: 'above' | 'below' | 'between' | 'after';
    readonly column: number;
    /** Where neither line leaves room: the column after the end of the line; the tag's name is before the value there. */
    readonly after?: number;
}

/** A value for a tag, or what a person typed for it. */
export type Given = { readonly value: Value } | { readonly text: string };

/** How many times as fast as real time, or as fast as it goes. */
export type Speed = { readonly speed: number } | { readonly realTime: false };

/** Which part of a program is shown. */
export interface Shown {
    readonly lines: readonly { readonly first: number; readonly last: number }[];
    readonly tags: readonly string[];
}

export interface Fault {
    readonly message: string;
    readonly range: Range;
    readonly scan: number;
}

/** A running controller that is watched: it is read, and never written. */
export interface Controller {
    readonly name: string;
    readonly answers: boolean;
    /** Of its values, in milliseconds; none before there are any. */
    readonly ageMs?: number;
    /** How it is, in words. */
    readonly text: string;
    /** What it has otherwise than the program: a sentence each. */
    readonly differences?: readonly string[];
}

export interface State {
    readonly session: string;
    readonly uri: string;
    /** Of the text that all places belong to. */
    readonly version: number;
    /** That text has errors: the last program without any runs on. */
    readonly stale: boolean;
    /** The last change of the program while it ran. */
    readonly change?: {
        readonly number: number;
        readonly scan: number;
        readonly lost?: readonly { readonly message: string; readonly range?: Range }[];
    };
    /** The number of the change that brought the program which runs; none for the first. With another one the tags may be others. */
    readonly program?: number;
    /** Only what has changed is sent of the drawing. */
    readonly delta?: boolean;
    readonly status: 'paused' | 'running' | 'ended' | 'faulted';
    /** How it is, in words. */
    readonly text: string;
    /** The controller that is watched, if it is not a simulation. */
    readonly controller?: Controller;
    /** Where clients on this computer are served, in words. */
    readonly served?: string;
    readonly scan: number;
    readonly timeMs: number;
    /** How many scans can be stepped back, and how many were stepped back from. */
    readonly behind: number;
    readonly ahead: number;
    /** In the midst of a scan the block that runs next. */
    readonly next?: Range;
    /** The breakpoint that stopped the last run. */
    readonly hit?: { readonly number: number; readonly message: string; readonly range?: Range };
    /** How many tags are forced. */
    readonly forced: number;
    /** How many commands have taken effect. */
    readonly commands?: number;
    /** What has changed of what is shown. */
    readonly tags: readonly Tag[];
    readonly power: readonly Power[];
    readonly operands?: readonly Operand[];
    /** All of them, whenever one is at another place. */
    readonly labels?: readonly Label[];
    /** What has changed in the scenes that are shown. */
    readonly scenes?: readonly SceneValues[];
    readonly faults: readonly Fault[];
}

/** Why a tag holds what it holds, as a tree. */
export interface Reason {
    readonly tag: string;
    readonly value: Value;
    readonly type: string;
    readonly cause: 'block' | 'given' | 'forced' | 'system' | 'initial' | 'unknown';
    readonly text: string;
    readonly write?: ReasonWrite;
    readonly now?: ReasonWrite;
}

/** The block that wrote it. */
export interface ReasonWrite {
    readonly block: string;
    readonly range: Range;
    readonly uri?: string;
    readonly scan: number;
    readonly power: boolean;
    readonly ways?: readonly (readonly ReasonBlock[])[];
    readonly because?: readonly Reason[];
}

/** A block that let power through, or stops it; the left rail if it is not a block. */
export interface ReasonBlock {
    readonly block?: string;
    readonly range: Range;
    readonly uri?: string;
    readonly stops: boolean;
    readonly text: string;
    readonly because?: readonly Reason[];
}

export interface Why {
    readonly tag: string;
    readonly text: string;
    readonly blocks: readonly Range[];
    readonly reason: Reason;
}

/** What was done, as a file of scenarios. */
export interface Recorded {
    readonly file: string;
    readonly text: string;
    /** The tags of which something is expected. */
    readonly outputs: readonly string[];
    /** All that `outputs` may have. */
    readonly offered: readonly { readonly name: string; readonly type: string; readonly output: boolean }[];
    readonly notes?: readonly string[];
}

/** What tags held after each of the last scans, the oldest first. */
export interface History {
    readonly firstScan: number;
    readonly tags: readonly { readonly name: string; readonly type: string; readonly values: readonly Value[] }[];
}

/** The answer to `ladder.runScenarios`. */
export interface ScenariosRun {
    readonly uri: string;
    readonly version: number;
    readonly program: string;
    readonly scenarios: readonly ScenarioRun[];
    readonly coverage?: Exercised;
}

export interface ScenarioRun {
    readonly name: string;
    readonly range: Range;
    readonly passed: boolean;
    readonly scans: number;
    readonly differences: readonly { readonly tag: string; readonly ranges: readonly Range[]; readonly message: string }[];
    /** Properties that it violates; `range` is where the property has its name. */
    readonly violations?: readonly { readonly name: string; readonly range: Range; readonly scan: number; readonly message: string }[];
    /** Where it leaves what is assumed, in words. */
    readonly outside?: string;
    readonly faults: readonly { readonly message: string; readonly scan: number; readonly range?: Range }[];
    /** Both waveforms, with what differs. */
    readonly diagram?: string;
}

/** The answer to `ladder.proveProperties`. */
export interface PropertiesProved {
    readonly uri: string;
    readonly version?: number;
    readonly program: string;
    readonly properties: readonly PropertyProved[];
}

export interface PropertyProved {
    readonly name: string;
    readonly range: Range;
    readonly verdict: 'proved' | 'violated' | 'possible' | 'impossible' | 'unknown' | 'vacuous';
    readonly message: string;
    readonly scan?: number;
    readonly times?: 'any' | 'exact';
    readonly neverTriggered: boolean;
    readonly open: readonly { readonly message: string; readonly range?: Range }[];
    /** The rows of the run that was found. */
    readonly diagram?: string;
    /** That run as a file of scenarios. */
    readonly scenario?: string;
}

/** What scenarios exercised: of a part, whether it was closed (a coil: with power), and whether it was open. */
export interface Exercised {
    readonly networks: readonly { readonly range: Range; readonly scans: number }[];
    readonly parts: readonly { readonly kind: 'contact' | 'comparison' | 'coil'; readonly range: Range; readonly on: boolean; readonly off: boolean }[];
}

/** The answer of `start`. */
export interface Started {
    readonly session: string;
    readonly state: State;
    /** Where the first rung is. */
    readonly first?: Range;
    readonly notes?: readonly string[];
}

/** What a debugger says, or is told: a message of the Debug Adapter Protocol. */
export interface DebuggerMessage {
    readonly session: string;
    readonly message: object;
}

/** What each command takes besides the session, and what it answers. */
export interface Commands {
    start: { argument: { uri: string; options: { show: Shown; online?: boolean } }; answer: Started };
    debug: { argument: { launch: object; options: { show: Shown } }; answer: Started & { joined?: boolean } };
    step: { argument: { scans: number }; answer: State };
    stepBlock: { argument: object; answer: State };
    stepRung: { argument: object; answer: State };
    back: { argument: { scans: number }; answer: State };
    goTo: { argument: { scan: number }; answer: State };
    breakpoints: { argument: { lines: number[]; tags: string[] }; answer: State };
    why: { argument: { tag: string }; answer: Why };
    trace: { argument: TraceAsked & { tags: readonly string[] }; answer: Traced };
    history: { argument: { tags: readonly string[]; scans: number }; answer: History };
    record: { argument: { outputs?: readonly string[] }; answer: Recorded };
    warmRestart: { argument: object; answer: State };
    run: { argument: object; answer: State };
    speed: { argument: Speed; answer: State };
    show: { argument: Shown; answer: State };
    tags: { argument: { containing?: string; of?: string; names?: readonly string[] }; answer: { count: number; tags: Tag[] } };
    pause: { argument: object; answer: State };
    set: { argument: { tag: string } & Given; answer: State };
    force: { argument: { tag: string } & Given; answer: State };
    pulse: { argument: { tag: string }; answer: State };
    serve: { argument: { on: boolean }; answer: State };
    unforce: { argument: { tag?: string }; answer: State };
    reset: { argument: object; answer: State };
    stop: { argument: object; answer: { session: string; stopped: true } };
}

/** What `ladder.convert` answers. */
export interface Converted {
    readonly from: string;
    readonly to: string;
    /** How the names of such files end, without the dot. */
    readonly extension: string;
    readonly text: string;
    /** What belongs next to it; of a file that is not a text only the name. */
    readonly companions?: readonly { readonly name: string; readonly text?: string }[];
    readonly translated: number;
    readonly approximated: number;
    readonly refused: number;
    readonly remarks: readonly {
        /** From 1; missing where the place is in a text that nobody sees. */
        readonly line?: number;
        readonly column?: number;
        readonly outcome: string;
        readonly element: string;
        readonly reason: string;
    }[];
    readonly notes?: readonly string[];
}

/** What a program of another system becomes: the answer to `ladder.preview`, and later `ladder/preview`. */
export interface Previewed {
    readonly uri: string;
    /** Of the program's text. */
    readonly version: number;
    readonly text: string;
}

/** What a key does to a drawing. */
export type EditKind =
    | 'contact' | 'closedContact' | 'coil' | 'block' | 'branch' | 'invert' | 'left' | 'right' | 'up' | 'down' | 'delete';

/** The answer to `ladder.edit` and to `ladder.comment`. */
export interface EditedDrawing {
    readonly version: number;
    readonly edits: readonly { readonly range: Range; readonly newText: string }[];
    readonly cursor: Place | null;
}

/** One thing that can be drawn. */
export interface DrawableRow {
    readonly section: string;
    /** As it is drawn without operands: `[TON]`. */
    readonly block: string;
    readonly title: string;
    /** What it is called elsewhere: `XIC`. */
    readonly elsewhere?: readonly string[];
    /** What it is called in the United States, where that is another name. */
    readonly us?: string;
    /** What its parentheses hold until a person writes something else. Missing: it has none. */
    readonly operands?: string;
}

/** A text in another document: its words, and its picture as SVG. */
export interface DrawnFence {
    words: { text: string; kind?: string }[];
    picture?: { light: string; dark: string };
}

/** The commands besides those of the simulator. */
export interface OtherCommands {
    /** A drawing of the machine, with the values of a simulation or at rest. */
    'ladder.scene': { argument: { uri: string; session?: string }; answer: SceneShown };
    'ladder.fence': { argument: { text: string }; answer: DrawnFence };
    /** The page of a rule, in Markdown. */
    'ladder.rulePage': { argument: { rule: string }; answer: { markdown: string } };
    /** The source of a block of the library. */
    'ladder.libraryBlock': { argument: { block: string }; answer: { text: string } };
    'ladder.comment': { argument: { uri: string; lines: readonly Lines[] }; answer: EditedDrawing };
    'ladder.edit': { argument: { uri: string; range: Range; edit: EditKind }; answer: EditedDrawing };
    'ladder.diagram': {
        argument: { uri: string; lines: Lines; rail: number; known: readonly string[] };
        answer: Drawn;
    };
    'ladder.diagramEdit': { argument: { uri: string; version: number; edit: Edit }; answer: Edited };
    'ladder.diagramOffer': { argument: { uri: string; version: number } & Asked; answer: Offered };
    'ladder.declarations': { argument: { uri: string }; answer: Declarations };
    'ladder.diagramPalette': { argument: { uri: string; search?: string }; answer: { rows: readonly DrawableRow[] } };
    /** What changed since an earlier text. */
    'ladder.compare': { argument: { uri: string; base: string; drawings?: 'light' | 'dark' }; answer: Compared };
    'ladder.crossReference': { argument: { uri: string }; answer: CrossReferenced };
    'ladder.cursor': { argument: { uri: string; line: number | null }; answer: null };
    'ladder.preview': { argument: { uri: string }; answer: Previewed };
    'ladder.convert': { argument: { uri: string; text?: string; from?: string; to: string }; answer: Converted };
    'ladder.runScenarios': { argument: { uri: string; coverage: boolean }; answer: ScenariosRun };
    'ladder.proveProperties': { argument: { uri: string; name?: string }; answer: PropertiesProved };
    'ladder.notations': {
        argument: object;
        answer: { notations: readonly { name: string; title: string; extensions: readonly string[] }[] };
    };
}

export const stateNotification = 'ladder/simulationState';
export const shownNotification = 'ladder/simulationShown';
export const toDebuggerNotification = 'ladder/toDebugger';
export const fromDebuggerNotification = 'ladder/fromDebugger';
export const previewNotification = 'ladder/preview';
