// What a diagram's page asks for, and who does it in the editor that shows the page.
import type { Commands } from '../protocol.ts';
import { reasonOf } from '../reason.ts';
import { reply } from './draw/asker.ts';
import type { Drawn, FromPage, Place, Question, ToPage } from './messages.ts';
import type { Teller } from './teller.ts';

type Of<Type extends FromPage['type']> = Extract<FromPage, { type: Type }>;
type Done = Promise<void> | void;

/** The side of the editor. */
export interface Side {
    send(message: ToPage): void;
    /** The page begins, and is to be sent the program. */
    begin(): Done;
    /** The program's text. */
    version(): number;
    draw(asked: Of<'ask'>): Promise<Drawn>;
    /** The page shows other lines. */
    look(): void;
    reveal(from: Place, to: Place, focus: boolean, isQuiet: boolean): Done;
    command(name: Of<'command'>['name']): Done;
    why(tag: string): Done;
    toggle(tag: string): Done;
    /** Asks the server what the page asks; an edit is made, as one step of the text's history. */
    request(question: Question): Promise<unknown>;
    /** Goes back, or forward again, in the text's history. @param isKey a key asks for it */
    history(step: 'undo' | 'redo', isKey: boolean): Done;
    change<Name extends 'set' | 'force' | 'pulse' | 'unforce'>(name: Name, argument: Commands[Name]['argument']): Done;
}

/** Does what the page asks for. */
export async function answer(message: FromPage, teller: Teller, side: Side): Promise<void> {
    switch (message.type) {
        case 'ready':
            return side.begin();
        case 'ask': {
            const version = side.version();
            const drawn = side.draw(message).then((drawn): ToPage => ({ type: 'drawn', drawn }));
            return side.send(await drawn.catch((error: unknown): ToPage => ({ type: 'failed', version, message: reasonOf(error) })));
        }
        case 'sees':
            teller.lines = message.lines;
            side.look();
            return teller.tell();
        case 'painted':
            return teller.painted();
        case 'reveal':
            return side.reveal(message.from, message.to, message.focus, message.isQuiet === true);
        case 'command':
            return side.command(message.name);
        case 'request':
            return side.send(await reply(message, (question) => side.request(question)));
        case 'undo':
        case 'redo':
            return side.history(message.type, message.isKey);
        case 'why':
            return side.why(message.tag);
        case 'toggle':
            return side.toggle(message.tag);
        case 'set':
        case 'force': {
            const { type, ...assigned } = message;
            return side.change(type, assigned);
        }
        case 'pulse':
        case 'unforce':
            return side.change(message.type, { tag: message.tag });
    }
}
