//! The table: all rows, in the order of LANGUAGE §5.

use crate::Instruction;

/// Every instruction, in the order of LANGUAGE §5.
pub static TABLE: &[Instruction] = &[];
