//! Which instructions can be called by name in an expression.

use ladder_instructions::{Accepts, Instruction, Op};

/// Whether a row can be called by name in an expression.
pub fn is_callable(row: &Instruction) -> bool {
    let mut operands = row.operands.iter();
    operands
        .next()
        .is_some_and(|first| matches!(first.accepts, Accepts::Result(_)))
        && row.op != Op::Typ
        && row.operands.len() > 1
        && operands.all(|operand| {
            matches!(
                operand.accepts,
                Accepts::Value | Accepts::Bool | Accepts::Integer | Accepts::Number | Accepts::String
            )
        })
}
