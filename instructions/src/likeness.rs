//! What a person probably meant by a spelling that the table does not have.

use crate::instruction::{Instruction, Shape};
use crate::lookup::by_op;
use crate::op::Op;
use crate::spelling::Spelling;
use crate::table::TABLE;

/// What Logix calls an instruction that has another name here: the names that people learn in the United States.
const LOGIX: &[(&str, Op)] = &[
    ("COP", Op::Bmov),
    ("CPT", Op::Calc),
    ("FLL", Op::Fill),
    ("JSR", Op::Call),
    ("ONS", Op::OneShotRising),
    ("OTE", Op::Coil),
    ("OTL", Op::SetCoil),
    ("OTU", Op::ResetCoil),
    ("SBR", Op::Fun),
    ("SQR", Op::Sqrt),
    ("XIC", Op::Contact),
    ("XIO", Op::NegatedContact),
    ("XPY", Op::Exp),
];

/// Names that further controllers and other notations have for an instruction. As those of Logix they are not accepted here:
/// they only make a better answer than the nearest spelling.
const KNOWN_ELSEWHERE: &[(&str, Op)] = &[
    ("COPY", Op::Bmov),
    ("CPY", Op::Bmov),
    ("GOSUB", Op::Call),
    ("GOTO", Op::Jmp),
    ("INV", Op::Inverter),
    ("JUMP", Op::Jmp),
    ("L", Op::SetCoil),
    ("LABEL", Op::Lbl),
    ("LIM", Op::Ge),
    ("NC", Op::NegatedContact),
    ("NO", Op::Contact),
    ("OUT", Op::Coil),
    ("POW", Op::Exp),
    ("RESET", Op::ResetCoil),
    ("RETURN", Op::Ret),
    ("RST", Op::ResetCoil),
    ("RTON", Op::Rto),
    ("SET", Op::SetCoil),
    ("SUBR", Op::Fun),
    ("TMR", Op::Ton),
    ("TND", Op::Ret),
    ("TONR", Op::Rto),
    ("U", Op::ResetCoil),
];

/// Names of instructions elsewhere that the table has nothing like: they are no slips of what they resemble.
const UNLIKE_ANY: &[&str] = &[
    "ANB", "ANDN", "ANI", "AVE", "CMP", "CMPL", "COSH", "DEC", "INC", "LDI", "MVM", "MVN", "NAND", "NOR",
    "ORB", "ORI", "ORN", "PID", "SINH", "STD", "SUM", "TANH", "XNOR", "XORN",
];

/// The row that goes by this name elsewhere.
pub(crate) fn known_elsewhere(spelling: Option<Spelling>) -> Option<&'static Instruction> {
    let spelling = spelling?;
    known()
        .find(|(name, _)| Spelling::read(name) == Some(spelling))
        .map(|(_, op)| by_op(*op))
}

fn known() -> impl Iterator<Item = &'static (&'static str, Op)> {
    LOGIX.iter().chain(KNOWN_ELSEWHERE)
}

/// The names that an instruction goes by elsewhere, that of Logix first.
pub fn names_elsewhere(row: &Instruction) -> impl Iterator<Item = &'static str> {
    let op = row.op;
    known().filter(move |(_, of)| *of == op).map(|(name, _)| *name)
}

/// What an instruction is called in the United States, where that is another name: `XIC`.
pub fn name_in_us(row: &Instruction) -> Option<&'static str> {
    LOGIX.iter().find(|(_, of)| *of == row.op).map(|(name, _)| *name)
}

/// See [`closest`](crate::closest).
pub(crate) fn closest(shape: Shape, mnemonic: &str) -> Option<&'static Instruction> {
    if let Some(row) = known_elsewhere(Spelling::read(mnemonic)) {
        return Some(row);
    }
    let typed = mnemonic.trim().to_ascii_uppercase();
    if UNLIKE_ANY.contains(&typed.as_str()) {
        return None;
    }
    spellings()
        .filter_map(|(row, spelling)| Some((slips(&typed, spelling)?, row.shape != shape, row)))
        .min_by_key(|(slips, other_shape, _)| (*slips, *other_shape))
        .map(|(_, _, row)| row)
}

/// See [`slip_of`](crate::slip_of).
pub(crate) fn slip_of(shape: Shape, mnemonic: &str) -> Option<&'static Instruction> {
    let typed = mnemonic.trim().to_ascii_uppercase();
    if known_elsewhere(Spelling::read(mnemonic)).is_some() || UNLIKE_ANY.contains(&typed.as_str()) {
        return None;
    }
    let mut near =
        spellings().filter(|(row, spelling)| row.shape == shape && slips(&typed, spelling) == Some(1));
    let (row, spelling) = near.next()?;
    let is_the_only_one = near.all(|(other, _)| other.op == row.op);
    (is_the_only_one && is_plausible(&typed, spelling)).then_some(row)
}

/// Every spelling of the table with its row.
fn spellings() -> impl Iterator<Item = (&'static Instruction, &'static str)> {
    TABLE
        .iter()
        .flat_map(|row| row.spellings().map(move |spelling| (row, spelling)))
}

/// Whether the one letter that parts a word from a spelling is a slip, and not what makes it another word: `MOVB` and
/// `ASIN` are other instructions than `MOV` and `SIN`, and among words of three letters nearly each is near to another.
fn is_plausible(typed: &str, spelling: &str) -> bool {
    let letters = typed.as_bytes();
    let is_longer = match letters {
        [.., before, last] if typed.starts_with(spelling) => before != last,
        [first, after, ..] if typed.ends_with(spelling) => first != after,
        _ => false,
    };
    match typed.len() {
        0..3 => false,
        3 => {
            let sorted = |word: &str| {
                let mut letters = word.as_bytes().to_vec();
                letters.sort_unstable();
                letters
            };
            sorted(typed) == sorted(spelling)
        }
        _ => !is_longer,
    }
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
