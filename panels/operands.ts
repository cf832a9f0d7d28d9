// The operand that a place in the text means.
import type { Operand } from './protocol.ts';

interface Place {
    readonly line: number;
    readonly character: number;
}

/** Whether a place is in a range or just after it, where the cursor is after typing. */
function isAround({ start, end }: Operand['range'], { line, character }: Place): boolean {
    const afterStart = line > start.line || (line === start.line && character >= start.character);
    const beforeEnd = line < end.line || (line === end.line && character <= end.character);
    return afterStart && beforeEnd;
}

/** The operand at a place; anywhere else in a block its first one. */
export function operandAt(operands: readonly Operand[], place: Place): Operand | undefined {
    return operands.find(({ range }) => isAround(range, place)) ?? operands.find(({ block }) => isAround(block, place));
}
