// The status bar's words about a simulation.
import type { State } from './protocol.ts';
import type { Speed } from './session.ts';
import { showDuration } from './value.ts';

const icons: Readonly<Record<State['status'], string>> = {
    running: '$(play)',
    paused: '$(debug-pause)',
    ended: '$(debug-stop)',
    faulted: '$(error)',
};

export interface StatusText {
    readonly text: string;
    readonly tooltip: string;
    readonly warning: boolean;
}

type Shown = Pick<State, 'status' | 'scan' | 'timeMs' | 'forced' | 'faults' | 'stale'>;

export function statusText(state: Shown, speed: Speed): StatusText {
    const { stale } = state;
    const faults = state.faults.length;
    const parts = [`Ladder: ${state.status}`, `scan ${state.scan}`, showDuration(state.timeMs)];
    if (speed !== 1) {
        parts.push(speed === 'max' ? 'full speed' : `${speed}x speed`);
    }
    if (state.forced > 0) {
        parts.push(`${state.forced} forced`);
    }
    if (faults > 0) {
        parts.push(faults === 1 ? '1 fault' : `${faults} faults`);
    }
    if (stale) {
        parts.push('before the errors in the text');
    }
    return {
        text: `${icons[state.status]} ${parts.join(', ')}`,
        tooltip: stale
            ? 'The text has errors; the last program without any runs on, and is shown in the lines that are still the same.'
            : (state.faults.at(-1)?.message ?? 'Simulation of the ladder program. Click to show its tags.'),
        warning: stale || faults > 0 || state.forced > 0,
    };
}
