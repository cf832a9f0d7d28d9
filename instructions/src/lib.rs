//! The one table of ladder instructions.
//!
//! Every other crate asks this table what a block is: the parser's diagnostics (arity, shape, did-you-mean),
//! type inference, the formatter (what acts and what is a condition), hover and completion, the simulator and
//! the language reference. It is data only: no parsing, no evaluation.
//!
//! [`TABLE`] holds one [`Instruction`] per row of LANGUAGE §5, [`lookup`] finds the rows of a mnemonic.
//! A mnemonic may have two rows that differ in their operands (`[NOT]` the inverter and `[NOT]( y, a )` the
//! bitwise one); [`Instruction::takes`] tells them apart.
//!
//! Adding an instruction is one row here, one variant of [`Op`], one function in the simulator (the compiler
//! refuses the variant without it) and one scenario.

mod lookup;
mod op;
mod operand;
mod table;

pub use lookup::{by_op, closest, lookup};
pub use op::Op;
pub use operand::{Accepts, Direction, Operand, Presence, StateType, TypeClass};
pub use table::TABLE;

/// The outline of a block: which brackets its first part stands in (LANGUAGE §2).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Shape {
    /// `[..](..)`: contacts, comparisons, data, timers, counters, ports.
    Logical,
    /// `(..)(..)`: coils.
    Coil,
    /// `<..>(..)`: program flow.
    Function,
}

impl Shape {
    /// The opening and closing bracket of the first part.
    pub const fn brackets(self) -> (char, char) {
        match self {
            Shape::Logical => ('[', ']'),
            Shape::Coil => ('(', ')'),
            Shape::Function => ('<', '>'),
        }
    }
}

/// Whether a block decides about power or does something with it (LANGUAGE §8 rule 5). The formatter moves
/// acting blocks to the right.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Role {
    /// The blocks of §5.1, `<LBL>` and `<FUN>`.
    Condition,
    /// All others.
    Acting,
}

/// The section of LANGUAGE §5 that a row belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Group {
    /// §5.1 contacts, edges, comparisons.
    Condition,
    /// §5.2 moves, arithmetic, bits, strings, ranges.
    Data,
    /// §5.3 timers, counters, bistables.
    State,
    /// §5.4 coils.
    Coil,
    /// §5.5 program flow.
    Flow,
    /// §5.6 ports.
    Port,
}

/// One row of the table.
#[derive(Debug)]
pub struct Instruction {
    /// Which instruction this is, for exhaustive matches elsewhere.
    pub op: Op,
    /// The canonical spelling between the brackets, in capitals; a blank for the open contact and the coil.
    pub mnemonic: &'static str,
    /// Spellings that are also accepted (`EQU` for `EQ`).
    pub aliases: &'static [&'static str],
    /// The brackets it is written in.
    pub shape: Shape,
    /// Condition or acting.
    pub role: Role,
    /// Section of LANGUAGE §5.
    pub group: Group,
    /// The operands in their order; optional named ones last.
    pub operands: &'static [Operand],
    /// What power leaves the block, in a few words: `EN and tag`.
    pub eno: &'static str,
    /// A name of two or three words: "Open contact".
    pub title: &'static str,
    /// What it does, in Markdown: a first sentence that stands alone, then the details a person must know.
    pub doc: &'static str,
    /// A rung (or two) that shows it, in canonical layout, without errors when checked on its own.
    pub example: &'static str,
}

impl Instruction {
    /// Number of operands that must be given by place.
    pub fn required(&self) -> usize {
        self.operands.iter().filter(|o| o.presence == Presence::Required).count()
    }

    /// Whether the last positional operand may be given again and again.
    pub fn repeats(&self) -> bool {
        self.operands.iter().any(|o| matches!(o.presence, Presence::Repeated { .. }))
    }

    /// Whether `count` operands by place fit this row.
    pub fn takes(&self, count: usize) -> bool {
        let least = self.required();
        let most = self.operands.iter().filter(|o| o.presence == Presence::Trailing).count() + least;
        match self.operands.iter().find_map(|o| match o.presence {
            Presence::Repeated { group } => Some(group),
            _ => None,
        }) {
            Some(group) => count >= least && (count - least).is_multiple_of(group as usize),
            None => (least..=most).contains(&count),
        }
    }

    /// The operand that the `index`-th positional value (from 0) stands for.
    pub fn positional(&self, index: usize) -> Option<&'static Operand> {
        let fixed: Vec<&'static Operand> = self
            .operands
            .iter()
            .filter(|o| matches!(o.presence, Presence::Required | Presence::Trailing))
            .collect();
        if let Some(operand) = fixed.get(index) {
            return Some(operand);
        }
        let repeated: Vec<&'static Operand> =
            self.operands.iter().filter(|o| matches!(o.presence, Presence::Repeated { .. })).collect();
        if repeated.is_empty() {
            return None;
        }
        Some(repeated[(index - fixed.len()) % repeated.len()])
    }

    /// The optional operand with this name, compared without case.
    pub fn named(&self, name: &str) -> Option<&'static Operand> {
        self.operands
            .iter()
            .find(|o| matches!(o.presence, Presence::Named) && o.name.eq_ignore_ascii_case(name))
    }

    /// The signature as a person writes it: `[TON]( t, PT, R := )`.
    pub fn signature(&self) -> String {
        let (open, close) = self.shape.brackets();
        let mut text = format!("{open}{}{close}", self.mnemonic);
        if self.operands.is_empty() {
            return text;
        }
        text.push_str("( ");
        for (index, operand) in self.operands.iter().enumerate() {
            if index > 0 {
                text.push_str(", ");
            }
            text.push_str(operand.name);
            if operand.presence == Presence::Named {
                text.push_str(if operand.direction == Direction::Out { " =>" } else { " :=" });
            }
        }
        if self.repeats() {
            text.push_str(", ...");
        }
        text.push_str(" )");
        text
    }
}
