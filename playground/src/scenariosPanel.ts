// The scenarios of the program: run them all, see both waveforms where one fails, and what of the program they never tried.
import { type Extension, StateEffect, StateField } from '@codemirror/state';
import { Decoration, type DecorationSet, EditorView } from '@codemirror/view';

import { type Covered, failingStretches, type FileResult, missing, type ScenarioResult, unitsBefore } from '../../panels/scenarioResults.ts';
import { element } from './element.ts';
import type { OpenText } from './openText.ts';
import { reasonOf, type Server } from './server.ts';

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

export class ScenariosPanel {
    readonly #server: Server;
    readonly #program: OpenText;
    readonly #scenarios: OpenText;
    readonly #say: (text: string) => void;
    readonly #show: (text: OpenText) => void;
    readonly #results = element('div', { class: 'results' });

    constructor(panel: HTMLElement, server: Server, program: OpenText, scenarios: OpenText, say: (text: string) => void, show: (text: OpenText) => void) {
        this.#server = server;
        this.#program = program;
        this.#scenarios = scenarios;
        this.#say = say;
        this.#show = show;
        const run = element('button', { type: 'button', class: 'primary', onclick: () => void this.run() }, 'Run all scenarios');
        const open = element('button', { type: 'button', onclick: () => show(scenarios) }, 'Edit them');
        panel.append(element('div', { class: 'bar' }, run, open), this.#results);
        this.forget();
    }

    /** Another program is in the editor. */
    forget(): void {
        this.#results.replaceChildren(
            element('p', { class: 'hint' }, 'Scenarios are the unit tests of a program: what is given to it, and what is expected, as timing diagrams in text.'),
        );
    }

    async run(): Promise<void> {
        try {
            const { files, coverage = [] } = await this.#server.execute('ladder.test', { uri: this.#scenarios.uri, coverage: true });
            const [file] = files;
            if (file) {
                this.#put(file, coverage);
            }
        } catch (error) {
            this.#results.replaceChildren(element('p', { class: 'error' }, reasonOf(error)));
            this.#say(reasonOf(error));
        }
    }

    #put(file: FileResult, coverage: readonly Covered[]): void {
        const passed = file.scenarios.filter((scenario) => scenario.passed).length;
        const summary = `${passed} of ${file.scenarios.length} scenarios passed`;
        const errors = file.mistakes.map(({ line, message }) => element('p', { class: 'error' }, `line ${line}: ${message}`));
        const covered = coverage.map((it) => this.#coverage(it));
        this.#results.replaceChildren(element('p', { class: 'summary' }, summary), ...errors, ...file.scenarios.map((scenario) => this.#row(scenario)), ...covered);
        this.#say(errors.length > 0 ? `The scenarios could not be run: ${file.mistakes[0]?.message ?? ''}` : `${summary}.`);
        this.#mark(file, coverage);
    }

    #row({ name, line, passed, differences, faults, diagram }: ScenarioResult): HTMLElement {
        const go = () => {
            this.#show(this.#scenarios);
            const place = { line: line - 1, character: 0 };
            this.#scenarios.select({ start: place, end: place }, true);
        };
        const title = element('button', { type: 'button', class: 'link', onclick: go }, `${passed ? '✓ passed' : '✗ failed'}  ${name}`);
        const said = [...differences.map(({ message }) => message), ...faults.map(({ message, scan }) => `fault in scan ${scan}: ${message}`)];
        const words = said.map((text) => element('p', { class: 'error' }, text));
        const drawn = diagram === undefined ? [] : [element('pre', { tabindex: '0', 'aria-label': `Waveforms of ${name}` }, diagram)];
        return element('section', { class: passed ? 'passed' : 'not-passed' }, title, ...words, ...drawn);
    }

    #coverage({ networks, parts }: Covered): HTMLElement {
        const ways = parts.flatMap((part) => missing(part).map((way) => ({ part, way })));
        const all = parts.length * 2;
        const { text } = this.#program;
        const lines = text.split('\n');
        const rows = ways.map(({ part: { kind, line, column }, way }) => {
            const character = unitsBefore(lines[line - 1] ?? '', column);
            const start = { line: line - 1, character };
            const words = (/^[^()]*\([^()]*\)(?:\([^()]*\))?|^\[[^\]]*\]\([^()]*\)/.exec((lines[line - 1] ?? '').slice(character)) ?? [kind])[0];
            const go = () => {
                this.#show(this.#program);
                this.#program.select({ start, end: { line: line - 1, character: character + words.length } }, true);
            };
            return element('li', {}, element('button', { type: 'button', class: 'link', onclick: go }, `line ${line}: ${words} was never ${way}`));
        });
        const summary = `Coverage: ${networks.exercised} of ${networks.all} networks were exercised, and ${all - ways.length} of ${all} ways of their parts.`;
        return element('section', { class: 'coverage' }, element('p', { class: 'summary' }, summary), element('ul', {}, ...rows));
    }

    /** Draws in both texts what was found. */
    #mark({ scenarios }: FileResult, coverage: readonly Covered[]): void {
        const texts = this.#scenarios.text.split('\n');
        const at = ({ line, start, end }: { line: number; start: number; end: number }, text: OpenText) =>
            [text.offset({ line, character: start }), text.offset({ line, character: end })] as const;
        const differences = scenarios.flatMap((scenario) => scenario.differences).flatMap((difference) => failingStretches(texts, difference));
        const failures = differences.map((stretch) => at(stretch, this.#scenarios)).filter(([from, to]) => from < to);
        this.#scenarios.view.dispatch({ effects: setMarks.of(Decoration.set(failures.map(([from, to]) => failed.range(from, to)), true)) });
        const lines = this.#program.text.split('\n');
        const marks = coverage.flatMap(({ rungs, parts }) => [
            ...rungs.map(({ line, scans }) => {
                const from = this.#program.offset({ line: line - 1, character: 0 });
                return Decoration.line({ class: scans > 0 ? 'exercised' : 'untried' }).range(from);
            }),
            ...parts.flatMap((part) => {
                const ways = missing(part);
                const start = unitsBefore(lines[part.line - 1] ?? '', part.column);
                const [from, to] = at({ line: part.line - 1, start, end: start + 3 }, this.#program);
                return ways.length > 0 && from < to ? [Decoration.mark({ class: 'half', attributes: { title: `never ${ways.join(', never ')}` } }).range(from, to)] : [];
            }),
        ]);
        this.#program.view.dispatch({ effects: setMarks.of(Decoration.set(marks, true)) });
    }
}
