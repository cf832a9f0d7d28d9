//! Finding rows by mnemonic, by identity, and by likeness.

use crate::{Instruction, Op, Shape, TABLE};

/// The rows with this spelling in these brackets, compared without case; an empty spelling is a blank one.
/// Two rows for `NOT`, at most one otherwise.
pub fn lookup(shape: Shape, mnemonic: &str) -> impl Iterator<Item = &'static Instruction> {
    let _ = (shape, mnemonic);
    TABLE.iter().filter(|_| false)
}

/// The row of an instruction.
pub fn by_op(op: Op) -> &'static Instruction {
    TABLE.iter().find(|row| row.op == op).expect("a test checks that every Op has its row")
}

/// The spelling nearest to an unknown one (edit distance, ties by table order), in these brackets first.
pub fn closest(shape: Shape, mnemonic: &str) -> Option<&'static Instruction> {
    let _ = (shape, mnemonic);
    None
}
