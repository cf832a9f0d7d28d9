//! What a block is given: places, values, expressions, each with its type.

use super::TagId;
use crate::program::SystemTag;
use crate::values::types::Scalar;
use crate::values::value::Value;
use ladder_instructions::{Op, Semantics, Timing};
use ladder_syntax::{Name, TextRange};

/// What is given for an operand.
#[derive(Debug, Clone)]
pub enum Argument {
    /// A value that is read, already in the type that the operand asks for.
    Value(Expr),
    /// A place that is written (or read and written), and its type.
    Place(Place, Scalar),
    /// A whole structure or array: each of its elementary parts as a place or a range, in the order of their declaration.
    Parts(Vec<Argument>),
    /// The state of a timer, counter or bistable.
    State(TagId),
    /// The same, where a computed index says which tag it is.
    ChosenState(Box<Chosen>),
    /// A range of an array, or (with `last` absent) the elements from an index on.
    Range(RangeRef),
    /// The network that a jump to this label from this block goes to; none for the label in `<LBL>` itself.
    Label(Option<usize>),
    /// In the body of a `<$B>`: a label that the body does not have, as names are compared. It is looked up where
    /// the block is, see [`Program::labels`](super::Program::labels).
    OuterLabel(Name),
    /// A function: index into [`Program::functions`](super::Program::functions); in `<FUN>` its own.
    Function(usize),
    /// SEARCH's operator: one of `Eq Ne Gt Ge Lt Le`.
    Operator(Op),
}

impl Argument {
    /// The tag that it lies in, if it is a place, a range or a state.
    pub fn root(&self) -> Option<TagId> {
        match self {
            Argument::Place(place, _) => place.root(),
            Argument::Range(range) => Some(range.tag),
            Argument::State(tag) => Some(*tag),
            Argument::ChosenState(chosen) => Some(chosen.first),
            _ => None,
        }
    }
}

/// Where a value is.
#[derive(Debug, Clone, PartialEq)]
pub enum Place {
    /// An elementary tag.
    Tag(TagId),
    /// One element of an array.
    Element(TagId, Box<Expr>),
    /// A member of a timer, counter or bistable.
    Member(TagId, Member),
    /// An elementary tag of several: an input or output of a block that a computed index chooses.
    Chosen(Box<Chosen>),
    /// A member of a timer, counter or bistable that a computed index chooses.
    ChosenMember(Box<Chosen>, Member),
    /// One bit of an integer or bit string, from 0.
    Bit(Box<Place>, Scalar, u8),
    /// A tag at a direct address which this place knows in another type than the tag has: the bits of the first type,
    /// read and written as the second. Both are integers or bit strings of one width.
    As(Box<Place>, Scalar, Scalar),
    /// A system tag.
    System(SystemTag),
}

impl Place {
    /// The tag that it is, or lies in; none for a system tag.
    pub fn root(&self) -> Option<TagId> {
        match self {
            Place::Tag(tag) | Place::Element(tag, _) | Place::Member(tag, _) => Some(*tag),
            Place::Chosen(chosen) | Place::ChosenMember(chosen, _) => Some(chosen.first),
            Place::Bit(inner, ..) | Place::As(inner, ..) => inner.root(),
            Place::System(_) => None,
        }
    }
}

/// One of several tags of one kind at equal distances: each element of an array of timers, counters or blocks is a tag.
#[derive(Debug, Clone, PartialEq)]
pub struct Chosen {
    /// The first of them.
    pub first: TagId,
    /// How many tags of the program are from one to the next.
    pub step: u32,
    /// How many they are.
    pub count: u32,
    /// Which one it is, counted from 0. It checks the indices that it is computed from.
    pub number: Expr,
}

/// A range of an array.
#[derive(Debug, Clone, PartialEq)]
pub struct RangeRef {
    /// The array.
    pub tag: TagId,
    /// Type of its elements.
    pub element: Scalar,
    /// Index of the first element meant.
    pub first: Box<Expr>,
    /// Index of the last; absent where an index alone says where the range starts.
    pub last: Option<Box<Expr>>,
    /// The array within its tag, where `first` counts over more than this array: over the elements that hold it, or over the
    /// dimensions before its last.
    pub row: Option<Row>,
    /// How many elements of the tag one index means: 1, and more for an array within the structures of an array.
    pub per_index: i64,
}

/// An array within the elements of its tag.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// What this array calls the first element of a range.
    pub index: Box<Expr>,
    /// Its own bounds.
    pub bounds: (i64, i64),
}

/// A typed expression.
#[derive(Debug, Clone, PartialEq)]
pub struct Expr {
    /// The type of its value.
    pub ty: Scalar,
    /// What it is.
    pub kind: ExprKind,
    /// Where it is.
    pub range: TextRange,
}

impl Expr {
    /// Every place that it reads, with where it is written.
    pub(super) fn each_read<'e>(&'e self, give: &mut impl FnMut(&'e Place, TextRange)) {
        match &self.kind {
            ExprKind::Read(place) => give(place, self.range),
            ExprKind::Pass(inner) | ExprKind::Unary(_, inner) => inner.each_read(give),
            ExprKind::Binary(_, left, right) | ExprKind::Compare(_, left, right) => {
                left.each_read(give);
                right.each_read(give);
            }
            ExprKind::Call(_, arguments) => arguments.iter().for_each(|argument| argument.each_read(give)),
            ExprKind::Offset(subscripts) => {
                for subscript in subscripts {
                    subscript.index.each_read(give);
                }
            }
            ExprKind::Constant(_) | ExprKind::Sum(_) => {}
        }
    }
}

/// The forms of an expression.
#[derive(Debug, Clone, PartialEq)]
pub enum ExprKind {
    /// A literal, in the expression's type.
    Constant(Value),
    /// A value that is read.
    Read(Place),
    /// A value that passes to the expression's type without `[TYP]`.
    Pass(Box<Expr>),
    /// `-a`, `NOT a`, in the expression's type.
    Unary(UnaryOperator, Box<Expr>),
    /// Arithmetic, logic and shifts, in the expression's type. The right side of a shift is any integer.
    Binary(BinaryOperator, Box<Expr>, Box<Expr>),
    /// A comparison: gives BOOL. Both sides have one type, or are integers of two types.
    Compare(Op, Box<Expr>, Box<Expr>),
    /// A function by name, in the expression's type.
    Call(Op, Vec<Expr>),
    /// `SUM(a[1..9])`
    Sum(RangeRef),
    /// Where an element of an array of several dimensions is, counted from 0 row by row.
    Offset(Vec<Subscript>),
}

/// One index of several.
#[derive(Debug, Clone, PartialEq)]
pub struct Subscript {
    /// Any integer.
    pub index: Expr,
    /// The first index of the dimension.
    pub first: i64,
    /// The last one.
    pub last: i64,
    /// How many elements are from one index to the next.
    pub stride: i64,
}

/// Unary operators of expressions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum UnaryOperator {
    /// `-`
    Minus,
    /// `NOT`: logical on BOOL, bitwise else.
    Not,
}

/// Binary operators of expressions that give the type they work in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum BinaryOperator {
    /// `OR`
    Or,
    /// `XOR`
    Xor,
    /// `AND`
    And,
    /// `SHL`
    Shl,
    /// `SHR`
    Shr,
    /// `+`
    Add,
    /// `-`
    Sub,
    /// `*`
    Mul,
    /// `/`
    Div,
    /// `MOD`
    Mod,
    /// `^`
    Power,
}

impl BinaryOperator {
    /// The instruction that does the same.
    pub const fn op(self) -> Op {
        match self {
            BinaryOperator::Or => Op::Or,
            BinaryOperator::Xor => Op::Xor,
            BinaryOperator::And => Op::And,
            BinaryOperator::Shl => Op::Shl,
            BinaryOperator::Shr => Op::Shr,
            BinaryOperator::Add => Op::Add,
            BinaryOperator::Sub => Op::Sub,
            BinaryOperator::Mul => Op::Mul,
            BinaryOperator::Div => Op::Div,
            BinaryOperator::Mod => Op::Mod,
            BinaryOperator::Power => Op::Exp,
        }
    }
}

/// A member of a timer, counter or bistable (LANGUAGE §4, Members).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[allow(missing_docs)]
pub enum Member {
    In,
    Pt,
    Q,
    Et,
    Cu,
    Cd,
    R,
    Ld,
    Pv,
    Cv,
    Qu,
    Qd,
    Q1,
    /// The counter changed in this evaluation.
    Changed,
    /// The timer is timing: `EN AND NOT DN`.
    Timing,
}

impl Member {
    /// As programs write it.
    pub const fn name(self) -> &'static str {
        match self {
            Member::In => "IN",
            Member::Pt => "PT",
            Member::Q => "Q",
            Member::Et => "ET",
            Member::Cu => "CU",
            Member::Cd => "CD",
            Member::R => "R",
            Member::Ld => "LD",
            Member::Pv => "PV",
            Member::Cv => "CV",
            Member::Qu => "QU",
            Member::Qd => "QD",
            Member::Q1 => "Q1",
            Member::Changed => "CC",
            Member::Timing => "TT",
        }
    }

    /// The member's type where blocks have these differences: what a timer counts is TIME, or scans and steps.
    pub const fn ty(self, semantics: &Semantics) -> Scalar {
        match (self, semantics.timing) {
            (Member::Pt | Member::Et, Timing::Clock) => Scalar::Time,
            (Member::Pt | Member::Et, Timing::Units) => Scalar::Int,
            (Member::Pt | Member::Et | Member::Pv | Member::Cv, _) => Scalar::integer_of(semantics),
            _ => Scalar::Bool,
        }
    }
}
