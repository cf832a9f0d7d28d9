// The colours of ladder text and of scenarios: word by word, before the server knows anything of the text.
import { HighlightStyle, StreamLanguage, type StringStream, syntaxHighlighting } from '@codemirror/language';
import type { Extension } from '@codemirror/state';
import { tags } from '@lezer/highlight';

const KEYWORDS =
    /^(VAR|VAR_INPUT|VAR_OUTPUT|VAR_IN_OUT|VAR_GLOBAL|VAR_EXTERNAL|END_VAR|RETAIN|CONSTANT|AT|ARRAY|OF|TYPE|END_TYPE|STRUCT|END_STRUCT|FUNCTION_BLOCK|END_FUNCTION_BLOCK)$/i;
const TYPES =
    /^(BOOL|BYTE|WORD|DWORD|LWORD|SINT|INT|DINT|LINT|USINT|UINT|UDINT|ULINT|REAL|LREAL|TIME|DATE|TOD|DT|STRING|TON|TOF|TP|RTO|RTOF|CTU|CTD|CTUD|CTC|SR|RS)$/i;
const LITERAL = /^(?:[A-Za-z_]+|\d+)#[-+\w.:]+/;

interface State {
    inComment: boolean;
}

function comment(stream: StringStream, state: State): string {
    state.inComment = !stream.skipTo('#');
    if (state.inComment) {
        stream.skipToEnd();
    } else {
        stream.next();
    }
    return 'comment';
}

function program(stream: StringStream, state: State): string | null {
    if (state.inComment) {
        return comment(stream, state);
    }
    if (stream.match(LITERAL)) {
        return 'number';
    }
    if (stream.eat('#')) {
        return comment(stream, state);
    }
    if (stream.match(/^'[^'\n]*'?/)) {
        return 'string';
    }
    // The first part of a block says which one it is.
    if (stream.match(/^\[[^\][()\n]*\](?=\s*\()/) || stream.match(/^\([ /A-Za-z]*\)(?=\s*\()/) || stream.match(/^<\s*[A-Za-z]+\s*>/)) {
        return 'keyword';
    }
    if (stream.match(/^\d[\d_.]*(?:ns|us|ms|[dhms])?\b/)) {
        return 'number';
    }
    const word = stream.match(/^[$%]?[\p{L}_][\p{L}\p{N}_]*/u);
    if (word && word !== true) {
        return KEYWORDS.test(word[0]) ? 'keyword' : TYPES.test(word[0]) ? 'typeName' : /^(TRUE|FALSE)$/i.test(word[0]) ? 'bool' : 'variableName';
    }
    stream.next();
    return null;
}

function scenario(stream: StringStream, state: State): string | null {
    if (state.inComment) {
        return comment(stream, state);
    }
    if (stream.eat('#')) {
        return comment(stream, state);
    }
    if (stream.match(/^"[^"\n]*"?/)) {
        return 'string';
    }
    if (stream.sol() && stream.match(/^(program|plant|connect|step|interval|scenario|assume|property|set)\b/)) {
        return 'keyword';
    }
    if (stream.match(/^=>/)) {
        return 'keyword';
    }
    if (stream.match(/^[-_.]{2,}/)) {
        return 'number';
    }
    if (stream.match(/^[\p{L}_][\p{L}\p{N}_.]*/u)) {
        return 'variableName';
    }
    stream.next();
    return null;
}

const startState = (): State => ({ inComment: false });
const copyState = ({ inComment }: State): State => ({ inComment });

export const clad = StreamLanguage.define<State>({ name: 'clad', startState, copyState, token: program });
export const ladderTest = StreamLanguage.define<State>({ name: 'ladder-test', startState, copyState, token: scenario });

export const colours: Extension = syntaxHighlighting(
    HighlightStyle.define([
        { tag: tags.comment, color: 'var(--comment)' },
        { tag: tags.keyword, color: 'var(--keyword)' },
        { tag: tags.typeName, color: 'var(--type)' },
        { tag: tags.number, color: 'var(--number)' },
        { tag: tags.bool, color: 'var(--number)' },
        { tag: tags.string, color: 'var(--string)' },
        { tag: tags.variableName, color: 'var(--tag)' },
    ]),
);
