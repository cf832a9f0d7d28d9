// What a trace's page is told and asks for, and who does it in the editor that shows the page.
import type { Session } from '../session.ts';
import { moved, removed, renamed } from './chosenTags.ts';
import type { FromPage, ToPage, TraceAsked } from './messages.ts';

type Done = Promise<void> | void;

/** The side of the editor. */
export interface Side {
    send(message: ToPage): void;
    /** Whether anybody sees the page. */
    isSeen(): boolean;
    /** The one whose trace is shown. */
    session(): Session | undefined;
    /** The tags that are shown of it. */
    tags(session: Session): Promise<readonly string[]>;
    /** Others are shown from now on; the page is told. */
    choose(session: Session, tags: readonly string[]): Done;
    /** Asks a person which. */
    pick(): Done;
    goTo(scan: number): Done;
    run(): Done;
    pause(): Done;
}

const isRunning = (session: Session | undefined) => session?.state.status === 'running';

/** Says how the simulation is: the page asks for what it shows of it. */
export async function tell(side: Side): Promise<void> {
    if (!side.isSeen()) {
        return;
    }
    const session = side.session();
    const tags = session ? await side.tags(session) : [];
    if (session === side.session()) {
        const situation = { running: isRunning(session), tags };
        side.send({ kind: 'situation', situation: session ? { session: session.id, ...situation } : situation });
    }
}

/** Does what the page asks for. */
export async function answer(message: FromPage, side: Side): Promise<void> {
    const session = side.session();
    if (message.kind === 'ready') {
        return tell(side);
    }
    if (message.kind === 'ask') {
        return session?.id === message.session ? trace(session, message.asked, side) : refuse(side);
    }
    if (!session) {
        return;
    }
    switch (message.kind) {
        case 'goTo':
            return side.goTo(message.scan);
        case 'choose':
            return side.pick();
        case 'remove':
            return side.choose(session, removed(await side.tags(session), message.tag));
        case 'move':
            return side.choose(session, moved(await side.tags(session), message.tag, message.by));
        case 'runOrPause':
            return isRunning(session) ? side.pause() : side.run();
    }
}

async function trace(session: Session, asked: TraceAsked, side: Side): Promise<void> {
    try {
        const tags = await side.tags(session);
        const traced = await session.urgent('trace', { ...asked, tags });
        const names = renamed(tags, traced.tags);
        if (names !== tags) {
            void side.choose(session, names);
        }
        side.send({ kind: 'traced', session: session.id, asked, traced });
    } catch {
        // The simulation has ended meanwhile.
        side.send({ kind: 'refused' });
    }
}

/** Another session is in sight than the one that was asked about, or was for a moment: the page asks again. */
async function refuse(side: Side): Promise<void> {
    side.send({ kind: 'refused' });
    await tell(side);
}
