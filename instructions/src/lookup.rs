//! Finding rows by mnemonic, by identity, and by likeness.

use crate::instruction::{Instruction, Shape};
use crate::likeness;
use crate::op::Op;
use crate::spelling::{INDEX, Spelling};
use crate::table::TABLE;

/// The rows with this spelling in these brackets, compared without case; blanks around it do not count, and an
/// empty spelling is a blank one. Two rows for `NOT`, at most one otherwise.
pub fn lookup(shape: Shape, mnemonic: &str) -> impl ExactSizeIterator<Item = &'static Instruction> + Clone {
    rows_of(shape, Spelling::read(mnemonic))
}

/// The rows with this spelling in other brackets: `(S)` for `[S]`, `[TON]` for `<TON>`, both `[ ]` and `( )` for
/// `< >`. A spelling that people know from elsewhere counts too, so `[SET]`, which is a `[MOV]`, leads to `(S)`,
/// and `[RESET]` to `(R)`. Ask [`Instruction::takes`] which of them fits the operands.
pub fn in_other_shape(shape: Shape, mnemonic: &str) -> impl Iterator<Item = &'static Instruction> + Clone {
    let spelling = Spelling::read(mnemonic);
    Shape::ALL
        .into_iter()
        .flat_map(move |other| rows_of(other, spelling))
        .chain(likeness::known_elsewhere(spelling))
        .filter(move |row| row.shape != shape)
}

/// The row of an instruction.
pub fn by_op(op: Op) -> &'static Instruction {
    &TABLE[op as usize]
}

/// The row that an unknown spelling probably means: what other controllers call by that name (`XIC`, `JSR`),
/// else the spelling that fewest slips lead to (a letter too many, missing, wrong, or two swapped). Two slips
/// are forgiven, one where a spelling has three letters or fewer. At the same number of slips these brackets
/// come before others, then the order of the table decides.
pub fn closest(shape: Shape, mnemonic: &str) -> Option<&'static Instruction> {
    likeness::closest(shape, mnemonic)
}

/// The row of these brackets that a spelling is plainly a slip of: one letter too many, missing or wrong, or two swapped,
/// and no other instruction is as near. Other names of other controllers are no slips.
pub fn slip_of(shape: Shape, mnemonic: &str) -> Option<&'static Instruction> {
    likeness::slip_of(shape, mnemonic)
}

/// The row that other controllers and notations call by a name that the table does not have (`XIC`, `TMR`, `JSR`).
pub fn known_elsewhere(mnemonic: &str) -> Option<&'static Instruction> {
    likeness::known_elsewhere(Spelling::read(mnemonic))
}

fn rows_of(
    shape: Shape,
    spelling: Option<Spelling>,
) -> impl ExactSizeIterator<Item = &'static Instruction> + Clone {
    let found = match spelling {
        Some(spelling) => {
            let key = (shape as u8, spelling);
            let start = INDEX.partition_point(|entry| (entry.shape, entry.spelling) < key);
            let rest = &INDEX[start..];
            // One or two, of many hundreds.
            let same = rest
                .iter()
                .take_while(|entry| (entry.shape, entry.spelling) == key);
            &rest[..same.count()]
        }
        None => &[],
    };
    found.iter().map(|entry| &TABLE[usize::from(entry.row)])
}
