//! What operands and boxes are apart from what they name: these bits of their flags.

pub(crate) const NEGATED: u32 = 1;
/// On what is written; with [`NEGATED`] it resets.
pub(crate) const SET: u32 = 2;
pub(crate) const RESET: u32 = 3;
pub(crate) const JUMP: u32 = 4;
pub(crate) const RETURN: u32 = 8;
pub(crate) const RISING: u32 = 16;
pub(crate) const FALLING: u32 = 32;
