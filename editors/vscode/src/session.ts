// A simulation of a document of this editor.
import type { TextDocument } from 'vscode';

import { Session as SessionOf } from '../../../panels/session.ts';

export type Session = SessionOf<TextDocument>;
export const Session = SessionOf;
