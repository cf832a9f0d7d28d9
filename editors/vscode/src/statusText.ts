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

type Told = Pick<State, 'status' | 'scan' | 'timeMs' | 'forced' | 'faults'>;

export function statusText(state: Told, stale: boolean, speed: Speed): StatusText {
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
        parts.push('of an older text');
    }
    return {
        text: `${icons[state.status]} ${parts.join(', ')}`,
        tooltip: stale
            ? 'The program has changed; the simulation still runs the old one. Start it again to run the new one.'
            : (state.faults.at(-1)?.message ?? 'Simulation of the ladder program. Click to show its tags.'),
        warning: stale || faults > 0 || state.forced > 0,
    };
}
