import assert from 'node:assert/strict';
import { test } from 'node:test';

import { hasReport, report, summary } from '../conversionReport.ts';

const CONVERTED = { from: 'textbook', to: 'clad', extension: 'clad', text: '', translated: 3, approximated: 1, refused: 1, remarks: [] };

test('how much says the same', () => {
    assert.equal(summary('motor.rung', CONVERTED), 'motor.rung: 3 translated, 1 approximated, 1 refused');
    assert.ok(!hasReport(CONVERTED));
});

test('a line for each remark, with its place if it is in the file', () => {
    const remarks = [
        { line: 2, column: 7, outcome: 'refused', element: '[PID]<x>', reason: 'the draft has no such block' },
        { outcome: 'approximated', element: 'T0', reason: 'it has another base' },
    ];
    const converted = { ...CONVERTED, remarks, notes: ['T0.csv belongs next to this program'] };
    assert.ok(hasReport(converted));
    assert.deepEqual(report('lamp.cplc', converted).split('\n'), [
        'lamp.cplc:2:7: refused: [PID]<x>: the draft has no such block',
        'lamp.cplc: approximated: T0: it has another base',
        'lamp.cplc: T0.csv belongs next to this program',
        'lamp.cplc: 3 translated, 1 approximated, 1 refused',
        '',
    ]);
});
