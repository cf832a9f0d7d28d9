import assert from 'node:assert/strict';
import { test } from 'node:test';

import type { TextDocument } from 'vscode';

import { isForeign } from '../src/foreignProgram.ts';

const documentOf = (path: string, languageId: string, text: string) => {
    const lines = text.split('\n');
    return { uri: { path }, languageId, lineCount: lines.length, lineAt: (line: number) => ({ text: lines[line] }) } as unknown as TextDocument;
};

test('programs of other systems are known by their endings, XML by its content', () => {
    const plcopen = '<?xml version="1.0"?>\n<project xmlns="http://www.plcopen.org/xml/tc6_0201">';
    for (const [path, language, text, expected] of [
        ['/plant/Main.L5X', 'xml', '', true],
        ['/plant/Fill.TcPOU', 'plaintext', '', true],
        ['/plant/Block.s7dcl', 'plaintext', '', true],
        ['/plant/tank.py', 'ladder-click', '', true],
        ['/plant/tank.py', 'python', '', false],
        ['/plant/plc.xml', 'xml', plcopen, true],
        ['/plant/pom.xml', 'xml', '<project/>', false],
        ['/plant/motor.clad', 'clad', plcopen, false],
    ] as const) {
        assert.equal(isForeign(documentOf(path, language, text)), expected, `${path} ${language}`);
    }
});
