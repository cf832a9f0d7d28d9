// Programs of other systems: which files are such.
import type { TextDocument } from 'vscode';

/** The language of a Python file that is a Click program. */
export const CLICK = 'ladder-click';

/** Endings that no other files have. */
const ENDINGS = ['iot', 'l5k', 'l5x', 'rung', 's7dcl', 'scl', 'slc', 'tcpou'];
const ENDING = new RegExp(`\\.(?:${ENDINGS.join('|')})$`, 'i');

/** A pattern for files of an ending, in capitals or not. */
const filesOf = (ending: string) => `**/*.${ending.replace(/[a-z]/g, (letter) => `[${letter}${letter.toUpperCase()}]`)}`;

/** The files that the server is shown; which XML is a program it says itself. */
export const FOREIGN_FILES = [...ENDINGS, 'st', 'xml'].map(filesOf);

/** Whether a simulation runs the document itself: ladder text, or Structured Text. */
export function runsItself({ languageId, uri }: TextDocument): boolean {
    return languageId === 'clad' || /\.st$/i.test(uri.path);
}

/** Whether a document is the settings of a project, whose tasks a simulation runs. */
export function isProject({ uri }: TextDocument): boolean {
    return uri.path.endsWith('/ladder.toml');
}

/** What is among the first lines of a program in XML. */
const XML_PROGRAM = /www\.plcopen\.org\/xml\/tc6|<SW\.Blocks\./;
const FIRST_LINES = 60;

/** Whether a document is a program of another system. */
export function isForeign(document: TextDocument): boolean {
    if (document.languageId === CLICK || ENDING.test(document.uri.path)) {
        return true;
    }
    if (!/\.xml$/i.test(document.uri.path)) {
        return false;
    }
    for (let line = 0; line < Math.min(FIRST_LINES, document.lineCount); line += 1) {
        if (XML_PROGRAM.test(document.lineAt(line).text)) {
            return true;
        }
    }
    return false;
}
