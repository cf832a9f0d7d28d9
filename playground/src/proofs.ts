// Properties of the second text: proved for all inputs and all runs, or violated by a run that can be played.
import type { PropertyProved, Range } from '../../panels/protocol.ts';
import { reasonOf } from '../../panels/reason.ts';
import type { Complete } from './complete.ts';
import { element } from './element.ts';
import type { OpenText } from './openText.ts';
import type { Simulation } from './simulation.ts';

export interface ProofEvents {
    /** A sentence for people. */
    message(text: string): void;
    /** A button that leads to a place of the scenarios. */
    link(title: string, range: Range): HTMLElement;
    /** Puts the scenarios in front of a person. */
    show(): void;
}

const signs: Readonly<Record<PropertyProved['verdict'], string>> = {
    proved: '✓', possible: '✓', violated: '✗', impossible: '✗', vacuous: '✗', unknown: '?',
};

/** The scenario in a file of which it is the only one. */
const onlyScenario = (file: string) => file.slice(Math.max(file.search(/^scenario /m), 0));

export class Proofs {
    readonly node = element('div', { class: 'proofs' });
    readonly #complete: Complete;
    readonly #program: OpenText;
    readonly #scenarios: OpenText;
    readonly #simulation: Simulation;
    readonly #events: ProofEvents;
    #isProving = false;

    constructor(complete: Complete, program: OpenText, scenarios: OpenText, simulation: Simulation, events: ProofEvents) {
        this.#complete = complete;
        this.#program = program;
        this.#scenarios = scenarios;
        this.#simulation = simulation;
        this.#events = events;
        [program, scenarios].forEach((text) => text.onEdit(() => this.#edited()));
    }

    async prove(): Promise<void> {
        if (this.#isProving) {
            return;
        }
        const [program, scenarios] = [this.#program, this.#scenarios];
        const stop = element('button', { type: 'button', onclick: () => this.#complete.cancel() }, 'Stop');
        this.node.replaceChildren(element('p', { role: 'status' }, 'The properties are being proved. '), stop);
        this.#isProving = true;
        try {
            const files = { [program.name]: program.text, [scenarios.name]: scenarios.text };
            const { properties } = await this.#complete.execute('ladder.proveProperties', { uri: scenarios.uri }, files);
            this.#put(properties);
        } catch (error) {
            this.node.replaceChildren(element('p', { class: 'error' }, `Nothing is proved: ${reasonOf(error)}`));
            this.#events.message(`Nothing is proved: ${reasonOf(error)}`);
        } finally {
            this.#isProving = false;
        }
    }

    /** What was proved is about texts that are there no more. */
    #edited(): void {
        if (this.#isProving) {
            this.#complete.cancel();
        } else if (this.node.childElementCount > 0) {
            this.node.replaceChildren(element('p', { class: 'hint' }, 'The texts have changed since the properties were proved: prove them again.'));
        }
    }

    #put(properties: readonly PropertyProved[]): void {
        const held = properties.filter(({ verdict }) => verdict === 'proved' || verdict === 'possible').length;
        const summary = `${held} of ${properties.length} properties hold in every run`;
        this.node.replaceChildren(element('p', { class: 'summary' }, summary), ...properties.map((property) => this.#row(property)));
        this.#events.message(`${summary}.`);
    }

    #row({ name, range, verdict, message, neverTriggered, open, diagram, scenario }: PropertyProved): HTMLElement {
        const holds = verdict === 'proved' || verdict === 'possible';
        const notes = open.map((left) => `${verdict === 'unknown' ? 'not decided' : 'left open'}: ${left.message}`);
        const words = [...(neverTriggered ? ['what is on its left side never happens'] : []), ...notes];
        const drawn = diagram ? [element('pre', { tabindex: '0', role: 'group', 'aria-label': `The run for ${name}` }, diagram)] : [];
        const buttons = scenario
            ? [element('div', { class: 'fixes' },
                  element('button', { type: 'button', onclick: () => void this.#play(scenario) }, 'Play this run'),
                  element('button', { type: 'button', onclick: () => this.#keep(scenario) }, 'Keep it as a scenario'))]
            : [];
        return element(
            'section',
            { class: holds ? 'passed' : verdict === 'unknown' ? 'undecided' : 'not-passed' },
            this.#events.link(`${signs[verdict]} ${message}  ${name}`, range),
            ...words.map((text) => element('p', { class: 'hint' }, text)),
            ...drawn,
            ...buttons,
        );
    }

    /** The run in the simulation, up to the scan that it is about. */
    async #play(scenario: string): Promise<void> {
        await this.#simulation.play({ [this.#program.name]: this.#program.text, [this.#scenarios.name]: this.#scenarios.text }, this.#scenarios.uri, scenario);
    }

    #keep(scenario: string): void {
        const { view } = this.#scenarios;
        const { length } = view.state.doc;
        const before = view.state.doc.toString().replace(/\n*$/, '');
        const insert = `\n\n${onlyScenario(scenario)}`;
        view.dispatch({ changes: { from: before.length, to: length, insert }, selection: { anchor: before.length + 2 }, scrollIntoView: true, userEvent: 'input.fix' });
        this.#events.show();
        view.focus();
    }
}
