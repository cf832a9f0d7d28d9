//! What a person probably meant by a spelling that the table does not have.

use crate::instruction::{Instruction, Shape};
use crate::lookup::by_op;
use crate::op::Op;
use crate::spelling::Spelling;
use crate::table::TABLE;

/// Names that other controllers and other notations give to an instruction, none of which is accepted here:
/// they only make a better answer than the nearest spelling.
const KNOWN_ELSEWHERE: &[(&str, Op)] = &[
    ("COP", Op::Bmov),
    ("COPY", Op::Bmov),
    ("CPT", Op::Calc),
    ("CPY", Op::Bmov),
    ("FLL", Op::Fill),
    ("GOSUB", Op::Call),
    ("GOTO", Op::Jmp),
    ("INV", Op::Inverter),
    ("JSR", Op::Call),
    ("JUMP", Op::Jmp),
    ("LABEL", Op::Lbl),
    ("LIM", Op::Limit),
    ("NC", Op::NegatedContact),
    ("NO", Op::Contact),
    ("ONS", Op::OneShotRising),
    ("OTE", Op::Coil),
    ("OTL", Op::SetCoil),
    ("OTU", Op::ResetCoil),
    ("OUT", Op::Coil),
    ("POW", Op::Exp),
    ("RESET", Op::ResetCoil),
    ("RETURN", Op::Ret),
    ("RST", Op::ResetCoil),
    ("RTON", Op::Rto),
    ("SBR", Op::Fun),
    ("SET", Op::SetCoil),
    ("SQR", Op::Sqrt),
    ("SUBR", Op::Fun),
    ("TND", Op::Ret),
    ("TONR", Op::Rto),
    ("XIC", Op::Contact),
    ("XIO", Op::NegatedContact),
    ("XPY", Op::Exp),
];

/// The row that goes by this name elsewhere.
pub(crate) fn known_elsewhere(spelling: Option<Spelling>) -> Option<&'static Instruction> {
    let spelling = spelling?;
    KNOWN_ELSEWHERE
        .iter()
        .find(|(name, _)| Spelling::read(name) == Some(spelling))
        .map(|(_, op)| by_op(*op))
}

/// The names that an instruction goes by elsewhere.
pub(crate) fn names_elsewhere(row: &Instruction) -> impl Iterator<Item = &'static str> {
    let op = row.op;
    KNOWN_ELSEWHERE
        .iter()
        .filter(move |(_, of)| *of == op)
        .map(|(name, _)| *name)
}

/// See [`closest`](crate::closest).
pub(crate) fn closest(shape: Shape, mnemonic: &str) -> Option<&'static Instruction> {
    if let Some(row) = known_elsewhere(Spelling::read(mnemonic)) {
        return Some(row);
    }
    let typed = mnemonic.trim().to_ascii_uppercase();
    TABLE
        .iter()
        .flat_map(|row| row.spellings().map(move |spelling| (row, spelling)))
        .filter_map(|(row, spelling)| Some((slips(&typed, spelling)?, row.shape != shape, row)))
        .min_by_key(|(slips, other_shape, _)| (*slips, *other_shape))
        .map(|(_, _, row)| row)
}

/// How many slips lead from a spelling to what was typed; none if that is too many to be one.
fn slips(typed: &str, spelling: &str) -> Option<usize> {
    let spelling = spelling.trim();
    let letters = typed.chars().count();
    let (shorter, longer) = (letters.min(spelling.len()), letters.max(spelling.len()));
    let forgiven = if shorter <= 3 { 1 } else { 2 };
    // A long name is not a slip of any mnemonic; this also bounds the work.
    if longer - shorter > forgiven {
        return None;
    }
    let distance = strsim::osa_distance(typed, spelling);
    // Where every letter differs nothing is alike: `[X]` is not a slip of `[P]`.
    (distance <= forgiven && distance < longer).then_some(distance)
}
