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
    let typed: Vec<char> = mnemonic
        .trim()
        .chars()
        .map(|letter| letter.to_ascii_uppercase())
        .collect();
    TABLE
        .iter()
        .flat_map(|row| row.spellings().map(move |spelling| (row, spelling)))
        .filter_map(|(row, spelling)| Some((slips(&typed, spelling)?, row.shape != shape, row)))
        .min_by_key(|(slips, other_shape, _)| (*slips, *other_shape))
        .map(|(_, _, row)| row)
}

/// How many slips lead from a spelling to what was typed; none if that is too many to be one.
fn slips(typed: &[char], spelling: &str) -> Option<usize> {
    let spelling = spelling.trim();
    let (shorter, longer) = (typed.len().min(spelling.len()), typed.len().max(spelling.len()));
    let forgiven = if shorter <= 3 { 1 } else { 2 };
    // A long name is no slip of any mnemonic; this also bounds the work.
    if longer - shorter > forgiven {
        return None;
    }
    let distance = distance(typed, spelling.as_bytes());
    // Where every letter differs nothing is alike: `[X]` is not a slip of `[P]`.
    (distance <= forgiven && distance < longer).then_some(distance)
}

/// Damerau-Levenshtein distance in its restricted form: insertions, deletions, replacements, and swaps of two
/// neighbours that are not touched again. `right` is a spelling of the table, which is short and ASCII.
fn distance(left: &[char], right: &[u8]) -> usize {
    // One column more than the longest spelling has letters.
    const COLUMNS: usize = 9;
    let mut before_last: [usize; COLUMNS];
    let mut last = [0; COLUMNS];
    let mut row: [usize; COLUMNS] = std::array::from_fn(|column| column);
    for (i, a) in left.iter().enumerate() {
        (before_last, last) = (last, row);
        row[0] = i + 1;
        for (j, b) in right.iter().enumerate() {
            let same = *a == char::from(*b);
            let mut cost = (last[j] + usize::from(!same))
                .min(last[j + 1] + 1)
                .min(row[j] + 1);
            if i > 0 && j > 0 && *a == char::from(right[j - 1]) && left[i - 1] == char::from(*b) {
                cost = cost.min(before_last[j - 1] + 1);
            }
            row[j + 1] = cost;
        }
    }
    row[right.len()]
}
