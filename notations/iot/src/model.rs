//! A program of the notation as its lines have it.

use super::word::Row;
use ladder_format::Circuit;
use ladder_notation::LineColumn;
use std::fmt;

/// A whole file.
#[derive(Debug, Clone, Default)]
pub(super) struct File {
    pub(super) parts: Vec<IotLine>,
}

impl File {
    /// The elements of all rungs, from left to right and top to bottom.
    pub(super) fn elements(&self) -> Vec<&Element> {
        fn collect<'c>(circuit: &'c Circuit<Element>, out: &mut Vec<&'c Element>) {
            match circuit {
                Circuit::Element(element) => out.push(element),
                Circuit::Series(parts) | Circuit::Parallel(parts) => {
                    for part in parts {
                        collect(part, out);
                    }
                }
            }
        }
        let mut out = Vec::new();
        for part in &self.parts {
            if let IotLine::Rung(circuit) = part {
                collect(circuit, &mut out);
            }
        }
        out
    }
}

/// A line.
#[derive(Debug, Clone)]
pub(super) enum IotLine {
    /// What a `#` says.
    Comment(String),
    /// A line that is not a part of the program, with its sign: `= title`, `> cycle 3`.
    Beside(String),
    Rung(Circuit<Element>),
}

/// An element of a rung.
#[derive(Debug, Clone)]
pub(super) struct Element {
    pub(super) place: LineColumn,
    pub(super) row: &'static Row,
    pub(super) operands: Vec<Operand>,
}

impl fmt::Display for Element {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.row.word)?;
        self.operands
            .iter()
            .try_for_each(|operand| write!(f, " {operand}"))
    }
}

/// What an element has to do with.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Operand {
    Variable(Variable),
    /// `T1:AC`
    Member(Variable, Member),
    Number(Number),
}

impl fmt::Display for Operand {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Operand::Variable(variable) => variable.fmt(f),
            Operand::Member(variable, member) => write!(f, "{variable}:{}", member.word()),
            Operand::Number(number) => f.write_str(&number.text),
        }
    }
}

/// A literal number.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Number {
    pub(super) text: String,
    pub(super) value: f64,
}

impl Number {
    /// As a whole number, if it is one, also where it is written `1.0`.
    pub(super) fn whole(&self) -> Option<i32> {
        let whole = self.value as i32;
        (f64::from(whole).to_bits() == (self.value + 0.0).to_bits()).then_some(whole)
    }

    /// Whether C takes it for a float.
    pub(super) fn is_float(&self) -> bool {
        self.text.contains(['.', 'e', 'E'])
    }
}

/// What a variable is, by the letters of its name. The order is that of the declarations.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) enum Family {
    Input,
    Output,
    Integer,
    Float,
    Timer,
    Counter,
}

impl Family {
    pub(super) const ALL: [Family; 6] = [
        Family::Input,
        Family::Output,
        Family::Integer,
        Family::Float,
        Family::Timer,
        Family::Counter,
    ];

    pub(super) const fn letters(self) -> &'static str {
        match self {
            Family::Input => "I",
            Family::Output => "Q",
            Family::Integer => "MI",
            Family::Float => "MF",
            Family::Timer => "T",
            Family::Counter => "C",
        }
    }

    /// Whether it is a timer or a counter.
    pub(super) const fn is_state(self) -> bool {
        matches!(self, Family::Timer | Family::Counter)
    }
}

/// A variable: its family, and its number as it is written (`MI01`).
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Variable {
    pub(super) family: Family,
    pub(super) number: u32,
    pub(super) digits: String,
}

impl fmt::Display for Variable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", self.family.letters(), self.digits)
    }
}

/// What a timer or counter remembers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Member {
    /// Preset.
    Pre,
    /// Accumulator: the count.
    Ac,
    /// Time base.
    B,
    /// Done.
    Dn,
    /// Enabled.
    En,
    /// Of a timer: when it counted last.
    Tt,
    /// Of a counter: that it has counted.
    Cc,
}

impl Member {
    const ALL: [Member; 7] = [
        Member::Pre,
        Member::Ac,
        Member::B,
        Member::Dn,
        Member::En,
        Member::Tt,
        Member::Cc,
    ];

    pub(super) const fn word(self) -> &'static str {
        match self {
            Member::Pre => "PRE",
            Member::Ac => "AC",
            Member::B => "B",
            Member::Dn => "DN",
            Member::En => "EN",
            Member::Tt => "TT",
            Member::Cc => "CC",
        }
    }

    /// The member of a timer or counter with this name.
    pub(super) fn named(word: &str, family: Family) -> Option<Member> {
        let has = |member: &Member| match member {
            Member::Pre | Member::Ac | Member::Dn => true,
            Member::B | Member::En | Member::Tt => family == Family::Timer,
            Member::Cc => family == Family::Counter,
        };
        Member::ALL
            .into_iter()
            .filter(has)
            .find(|member| member.word().eq_ignore_ascii_case(word))
    }
}
