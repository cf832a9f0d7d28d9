// The scenarios of the program: run them all, see both waveforms where one fails, and what of the program they never tried.
import { type Extension, StateEffect, StateField } from '@codemirror/state';
import { Decoration, type DecorationSet, EditorView } from '@codemirror/view';

import type { Exercised, Range, ScenarioRun, ScenariosRun } from '../../panels/protocol.ts';
import { reasonOf } from '../../panels/reason.ts';
import type { Complete } from './complete.ts';
import { element } from './element.ts';
import type { OpenText } from './openText.ts';
import { Proofs } from './proofs.ts';
import type { Server } from './server.ts';
import type { Simulation } from './simulation.ts';

const setMarks = StateEffect.define<DecorationSet>();

/** What a run has found in a text, until that is changed. */
const marksField = StateField.define<DecorationSet>({
    create: () => Decoration.none,
    update(value, { docChanged, effects }) {
        return effects.reduce((now, effect) => (effect.is(setMarks) ? effect.value : now), docChanged ? Decoration.none : value);
    },
    provide: (field) => EditorView.decorations.from(field),
});

export const marksOfRuns: Extension = [
    marksField,
    EditorView.theme({
        '.failed': { outline: '1px solid var(--error)', backgroundColor: 'var(--error-ground)' },
        '.exercised': { boxShadow: 'inset 3px 0 var(--on)' },
        '.untried': { boxShadow: 'inset 3px 0 var(--blocks)' },
        '.half': { borderBottom: '2px dotted var(--blocks)' },
    }),
];

const failed = Decoration.mark({ class: 'failed' });

type Part = Exercised['parts'][number];

/** What is missing of a contact, comparison or coil to have been seen both ways. */
function missing({ kind, on, off }: Part): string[] {
    const [isOn, isOff] = kind === 'coil' ? ['on', 'off'] : ['closed', 'open'];
    return [...(on ? [] : [isOn]), ...(off ? [] : [isOff])];
}

export class ScenariosPanel {
    readonly #server: Server;
    readonly #program: OpenText;
    readonly #scenarios: OpenText;
    readonly #say: (text: string) => void;
    readonly #show: (text: OpenText) => void;
    readonly #results = element('div', { class: 'runs' });
    readonly #proofs: Proofs;

    /** @param show puts one of the texts in front of a person */
    constructor(
        panel: HTMLElement, server: Server, complete: Complete, program: OpenText, scenarios: OpenText, simulation: Simulation,
        say: (text: string) => void, show: (text: OpenText) => void,
    ) {
        this.#server = server;
        this.#program = program;
        this.#scenarios = scenarios;
        this.#say = say;
        this.#show = show;
        const run = element('button', { type: 'button', class: 'primary', onclick: () => void this.run() }, 'Run all scenarios');
        const open = element('button', { type: 'button', onclick: () => show(scenarios) }, 'Edit them');
        this.#proofs = new Proofs(complete, program, scenarios, simulation, {
            message: say,
            link: (title, range) => this.#link(title, scenarios, range),
            show: () => show(scenarios),
        });
        const prove = element('button', { type: 'button', class: 'primary', onclick: () => void this.#proofs.prove() }, 'Prove all properties');
        panel.append(element('div', { class: 'bar' }, run, prove, open), element('div', { class: 'results' }, this.#proofs.node, this.#results));
        this.forget();
    }

    /** Another program is in the editor. */
    forget(): void {
        this.#proofs.node.replaceChildren();
        this.#results.replaceChildren(
            element('p', { class: 'hint' }, 'Scenarios are the unit tests of a program: what is given to it, and what is expected, as timing diagrams in text.'),
            element('p', { class: 'hint' }, 'Properties say what must hold in every run, such as "never up and down": they are proved, or a run is found that violates them.'),
        );
    }

    async run(): Promise<void> {
        try {
            const run = await this.#server.execute('ladder.runScenarios', { uri: this.#scenarios.uri, coverage: true });
            this.#put(run);
            this.#mark(run);
        } catch (error) {
            this.#results.replaceChildren(element('p', { class: 'error' }, reasonOf(error)));
            this.#say(`The scenarios were not run: ${reasonOf(error)}`);
        }
    }

    #put({ scenarios, coverage }: ScenariosRun): void {
        const passed = scenarios.filter((scenario) => scenario.passed).length;
        const summary = `${passed} of ${scenarios.length} scenarios passed`;
        const covered = coverage ? [this.#coverage(coverage)] : [];
        this.#results.replaceChildren(element('p', { class: 'summary' }, summary), ...scenarios.map((scenario) => this.#row(scenario)), ...covered);
        this.#say(`${summary}.`);
    }

    /** A button that leads to a place of a text. */
    #link(title: string, text: OpenText, range: Range): HTMLElement {
        const go = () => {
            this.#show(text);
            text.select(range, true);
        };
        return element('button', { type: 'button', class: 'link', onclick: go }, title);
    }

    #row({ name, range, passed, differences, violations = [], outside, faults, diagram }: ScenarioRun): HTMLElement {
        const title = this.#link(`${passed ? '✓ passed' : '✗ failed'}  ${name}`, this.#scenarios, range);
        const broken = [...differences, ...violations].map(({ message }) => message);
        const said = [...broken, ...faults.map(({ message, scan }) => `fault in scan ${scan}: ${message}`)];
        const words = said.map((text) => element('p', { class: 'error' }, text));
        words.push(...(outside === undefined ? [] : [element('p', { class: 'hint' }, outside)]));
        const drawn = diagram === undefined ? [] : [element('pre', { tabindex: '0', role: 'group', 'aria-label': `Waveforms of ${name}` }, diagram)];
        return element('section', { class: passed ? 'passed' : 'not-passed' }, title, ...words, ...drawn);
    }

    #coverage({ networks, parts }: Exercised): HTMLElement {
        const reached = networks.filter(({ scans }) => scans > 0).length;
        const ways = parts.flatMap((part) => missing(part).map((way) => ({ part, way })));
        const rows = ways.map(({ part: { range }, way }) => {
            const words = this.#program.view.state.sliceDoc(this.#program.offset(range.start), this.#program.offset(range.end));
            return element('li', {}, this.#link(`line ${range.start.line + 1}: ${words} was never ${way}`, this.#program, range));
        });
        const all = parts.length * 2;
        const summary = `Coverage: ${reached} of ${networks.length} networks were exercised, and ${all - ways.length} of ${all} ways of their contacts and coils.`;
        return element('section', { class: 'coverage' }, element('p', { class: 'summary' }, summary), element('ul', {}, ...rows));
    }

    /** Draws in both texts what was found. */
    #mark({ scenarios, coverage }: ScenariosRun): void {
        const within = (text: OpenText, range: Range, mark: Decoration) => {
            const [from, to] = [text.offset(range.start), text.offset(range.end)];
            return from < to ? [mark.range(from, to)] : [];
        };
        const ranges = scenarios.flatMap(({ differences, violations = [] }) => [
            ...differences.flatMap((difference) => difference.ranges),
            ...violations.map(({ range }) => range),
        ]);
        const failures = ranges.flatMap((range) => within(this.#scenarios, range, failed));
        this.#scenarios.view.dispatch({ effects: setMarks.of(Decoration.set(failures, true)) });
        const lines = (coverage?.networks ?? []).flatMap(({ range: { start, end }, scans }) =>
            // A network ends where the line after it begins.
            Array.from({ length: Math.max(end.line - start.line + (end.character > 0 ? 1 : 0), 1) }, (_, at) => {
                const from = this.#program.offset({ line: start.line + at, character: 0 });
                return Decoration.line({ class: scans > 0 ? 'exercised' : 'untried' }).range(from);
            }),
        );
        const halves = (coverage?.parts ?? []).flatMap((part) => {
            const ways = missing(part);
            return ways.length > 0 ? within(this.#program, part.range, Decoration.mark({ class: 'half', attributes: { title: `never ${ways.join(', never ')}` } })) : [];
        });
        this.#program.view.dispatch({ effects: setMarks.of(Decoration.set([...lines, ...halves], true)) });
    }
}
