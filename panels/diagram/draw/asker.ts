// Questions of the page, each answered once.
import { reasonOf } from '../../reason.ts';
import type { FromPage, Question, ToPage } from '../messages.ts';
import type { OtherCommands, Range } from '../../protocol.ts';
import { commands, type Edited, type Requests } from './requests.ts';

/** Sends a command to the server. */
type Execute = <Name extends keyof OtherCommands>(command: Name, argument: OtherCommands[Name]['argument']) => Promise<OtherCommands[Name]['answer']>;

export type Ask = <Name extends keyof Requests>(name: Name, argument: Requests[Name]['argument']) => Promise<Requests[Name]['answer']>;

export class Asker {
    readonly #send: (message: FromPage) => void;
    readonly #open = new Map<number, { resolve(answer: unknown): void; reject(reason: Error): void }>();
    #last = 0;

    constructor(send: (message: FromPage) => void) {
        this.#send = send;
    }

    readonly ask: Ask = (name, argument) => {
        const id = ++this.#last;
        this.#send({ type: 'request', id, name, argument } as FromPage);
        return new Promise((resolve, reject) => {
            this.#open.set(id, { resolve: resolve as (answer: unknown) => void, reject });
        });
    };

    take({ id, answer, error }: Extract<ToPage, { type: 'reply' }>): void {
        const open = this.#open.get(id);
        this.#open.delete(id);
        if (error !== undefined) {
            open?.reject(new Error(error));
        } else {
            open?.resolve(answer);
        }
    }
}

/** What an editor does for the page of a program. */
export interface Host {
    readonly execute: Execute;
    /** Makes the edits, as one step of the text's history, and returns the version that the text has then. */
    make(edited: Edited): Promise<number>;
    fixes(range: Range): Promise<readonly string[]>;
    fix(range: Range, title: string): Promise<void>;
}

/** Answers what a page asks about a program. */
export async function answerOf(question: Question, uri: string, { execute, make, fixes, fix }: Host): Promise<unknown> {
    switch (question.name) {
        case 'edit': {
            const edited = await execute(commands.edit, { uri, ...question.argument });
            const { select, focus, said } = edited;
            return { select, focus, said, version: await make(edited) };
        }
        case 'fixes':
            return fixes(question.argument.range);
        case 'fix':
            return fix(question.argument.range, question.argument.title);
        default:
            return execute(commands[question.name], { uri, ...question.argument } as never);
    }
}

/** Replies to a question of a page. */
export async function reply(question: Question, answer: (question: Question) => Promise<unknown>): Promise<ToPage> {
    const { id } = question;
    try {
        return { type: 'reply', id, answer: await answer(question) };
    } catch (error) {
        return { type: 'reply', id, error: reasonOf(error) };
    }
}
