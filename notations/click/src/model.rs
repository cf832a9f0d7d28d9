//! A Click program as both of its notations have it: the Python DSL and the CSV grid.

use super::address::{Address, Span, Tag};
use super::bank::Bank;
use super::conversion::Convert;
use ladder_instructions::{Op, by_op};
use ladder_notation::LineColumn;

/// A whole program.
#[derive(Debug, Clone, Default)]
pub(super) struct Program {
    /// What the address picker says of addresses, if that is known.
    pub(super) nicknames: Vec<Nickname>,
    /// The main program.
    pub(super) main: Routine,
    /// The subroutines, in their order.
    pub(super) subroutines: Vec<Routine>,
    /// Of a ladder text: conditions of branches that it looks at before their rung acts, as Click does.
    pub(super) seen_first: Vec<Condition>,
}

impl Program {
    /// Whether it is subroutines alone.
    pub(super) fn has_no_main(&self) -> bool {
        let Routine {
            rungs,
            comments,
            after,
            ..
        } = &self.main;
        let is_empty = rungs.is_empty() && comments.is_empty() && after.is_empty();
        is_empty && self.main.place == LineColumn::START && !self.subroutines.is_empty()
    }

    /// The main program, then the subroutines.
    pub(super) fn routines(&self) -> impl Iterator<Item = &Routine> {
        std::iter::once(&self.main).chain(&self.subroutines)
    }
}

/// What the address picker says of an address.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Nickname {
    pub(super) address: Address,
    /// Empty: it has only a comment or a value.
    pub(super) name: String,
    pub(super) comment: String,
    pub(super) initial: Option<Constant>,
    /// None: as its bank.
    pub(super) retentive: Option<bool>,
}

/// The main program or a subroutine.
#[derive(Debug, Clone)]
pub(super) struct Routine {
    /// `main`, or what a call names.
    pub(super) name: String,
    pub(super) place: LineColumn,
    /// The comment above it.
    pub(super) comments: Vec<String>,
    pub(super) rungs: Vec<Rung>,
    /// The comments after its last rung.
    pub(super) after: Vec<String>,
}

impl Default for Routine {
    fn default() -> Routine {
        Routine {
            name: "main".to_owned(),
            place: LineColumn::START,
            comments: Vec::new(),
            rungs: Vec::new(),
            after: Vec::new(),
        }
    }
}

/// A rung: a condition, and what happens where it holds. The condition is checked once, before all actions.
#[derive(Debug, Clone)]
pub(super) struct Rung {
    pub(super) place: LineColumn,
    /// The comments above it, a line each.
    pub(super) comments: Vec<String>,
    pub(super) condition: Condition,
    pub(super) actions: Vec<Action>,
}

/// What lets power through.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Condition {
    /// Series. Empty: a bare wire, which is always on.
    All(Vec<Condition>),
    /// Parallel.
    Any(Vec<Condition>),
    Contact(Contact),
    Compare(Comparison),
}

impl Condition {
    /// A bare wire.
    pub(super) const ALWAYS: Condition = Condition::All(Vec::new());

    /// Whether nothing can stop the power.
    pub(super) fn is_always(&self) -> bool {
        match self {
            Condition::All(parts) => parts.iter().all(Condition::is_always),
            Condition::Any(parts) => parts.iter().any(Condition::is_always),
            Condition::Contact(_) | Condition::Compare(_) => false,
        }
    }
}

/// A contact.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Contact {
    pub(super) place: LineColumn,
    pub(super) kind: ContactKind,
    /// One bit, or a range of them: then all must be on (off).
    pub(super) bits: Bits,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum ContactKind {
    Open,
    Closed,
    Rising,
    Falling,
}

/// One bit, or a range of bits.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Bits {
    One(Tag),
    Many(Span),
}

impl Bits {
    pub(super) const fn bank(&self) -> Bank {
        match self {
            Bits::One(tag) => tag.bank,
            Bits::Many(span) => span.bank,
        }
    }
}

/// A comparison.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Comparison {
    pub(super) place: LineColumn,
    pub(super) left: Operand,
    pub(super) relation: Relation,
    pub(super) right: Operand,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Relation {
    Eq,
    Ne,
    Lt,
    Le,
    Gt,
    Ge,
}

impl Relation {
    pub(super) const ALL: [(Relation, &'static str, Op); 6] = [
        (Relation::Eq, "==", Op::Eq),
        (Relation::Ne, "!=", Op::Ne),
        (Relation::Lt, "<", Op::Lt),
        (Relation::Le, "<=", Op::Le),
        (Relation::Gt, ">", Op::Gt),
        (Relation::Ge, ">=", Op::Ge),
    ];

    /// As Python and the grid write it: `==`.
    pub(super) fn sign(self) -> &'static str {
        Relation::ALL[self as usize].1
    }

    /// As ladder text writes it: `EQ`.
    pub(super) fn mnemonic(self) -> &'static str {
        by_op(self.op()).mnemonic
    }

    /// The comparison of ladder text.
    pub(super) fn op(self) -> Op {
        Relation::ALL[self as usize].2
    }

    /// The one that an instruction of ladder text compares by.
    pub(super) fn of(op: Op) -> Option<Relation> {
        let row = Relation::ALL.iter().find(|row| row.2 == op)?;
        Some(row.0)
    }

    /// Either of these, whatever the case. A single `=` is Click's own.
    pub(super) fn named(text: &str) -> Option<Relation> {
        let text = if text == "=" { "==" } else { text };
        let mut all = Relation::ALL.iter();
        let row =
            all.find(|(relation, sign, _)| *sign == text || relation.mnemonic().eq_ignore_ascii_case(text))?;
        Some(row.0)
    }
}

/// A value, or the place where one goes.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Operand {
    Constant(Constant),
    Tag(Tag),
    Pointer(Pointer),
}

/// The address of a bank that another address names: `ds[ds.Step]`.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Pointer {
    /// Where it points into.
    pub(super) bank: Bank,
    /// What holds the number: Click allows DS only.
    pub(super) by: Tag,
    /// What is added to it: `DS[DS1+99]`.
    pub(super) offset: i32,
}

#[derive(Debug, Clone, PartialEq)]
pub(super) enum Constant {
    Bit(bool),
    /// Not checked against any range.
    Int(i64),
    /// `1234h`, `0x1234`
    Hex(u32),
    Float(f64),
    /// Without its quotes.
    Text(String),
}

/// What happens on a rung.
#[derive(Debug, Clone)]
pub(super) struct Action {
    pub(super) place: LineColumn,
    /// What else must hold, where the grid branches after the rung's own condition; [`Condition::ALWAYS`] elsewhere.
    pub(super) condition: Condition,
    pub(super) what: Instruction,
    /// Only on the scan in which the power comes.
    pub(super) oneshot: bool,
    /// The comments on its line.
    pub(super) comment: Option<String>,
}

/// An instruction that acts. Pins are conditions of their own: they are at the left rail.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Instruction {
    Out(Coil),
    Set(Coil),
    Reset(Coil),
    Timer(Timer),
    Counter(Counter),
    Copy {
        source: Operand,
        target: Operand,
        options: CopyOptions,
    },
    BlockCopy {
        source: Span,
        /// The first address that is written.
        target: Tag,
        options: CopyOptions,
    },
    Fill {
        source: Operand,
        target: Span,
        options: CopyOptions,
    },
    Pack {
        source: Span,
        target: Tag,
        options: CopyOptions,
    },
    Unpack {
        source: Tag,
        target: Span,
        options: CopyOptions,
    },
    Shift(Shift),
    Search(Search),
    Math(Math),
    Drum(Box<Drum>),
    Call(String),
    /// The rungs after it, up to that of [`Instruction::Next`], run so often in one scan.
    For(Operand),
    Next,
    End,
    Return,
    /// Nothing: `pass`.
    Nop,
    /// What ladder text has no counterpart for, such as a message. It stays a comment.
    Kept {
        /// As the notation writes it.
        text: String,
        why: String,
    },
}

#[derive(Debug, Clone, PartialEq)]
pub(super) struct Coil {
    pub(super) bits: Bits,
    /// The output changes at once, not at the end of the scan.
    pub(super) immediate: bool,
}

#[derive(Debug, Clone, PartialEq)]
pub(super) struct Timer {
    pub(super) kind: TimerKind,
    /// Its bit, in bank T.
    pub(super) tag: Tag,
    pub(super) setpoint: Operand,
    pub(super) unit: Unit,
    /// Of the retentive ones.
    pub(super) reset: Option<Condition>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum TimerKind {
    On,
    Off,
    RetentiveOn,
    /// The DSL alone has it; Click itself keeps time only with the on-delay.
    RetentiveOff,
}

impl TimerKind {
    pub(super) const fn is_retentive(self) -> bool {
        matches!(self, TimerKind::RetentiveOn | TimerKind::RetentiveOff)
    }
}

/// What a timer counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Unit {
    Milliseconds,
    Seconds,
    Minutes,
    Hours,
    Days,
}

impl Unit {
    pub(super) const ALL: [(Unit, &'static str, &'static str, i64); 5] = [
        (Unit::Milliseconds, "Tms", "ms", 1),
        (Unit::Seconds, "Ts", "s", 1_000),
        (Unit::Minutes, "Tm", "m", 60_000),
        (Unit::Hours, "Th", "h", 3_600_000),
        (Unit::Days, "Td", "d", 86_400_000),
    ];

    /// As both notations write it: `Ts`.
    pub(super) fn name(self) -> &'static str {
        Unit::ALL[self as usize].1
    }

    /// As a duration writes it: `s`.
    pub(super) fn suffix(self) -> &'static str {
        Unit::ALL[self as usize].2
    }

    /// The one that is so many nanoseconds long.
    pub(super) fn lasting(nanoseconds: i64) -> Option<Unit> {
        let mut all = Unit::ALL.iter();
        let row = all.find(|(.., milliseconds)| *milliseconds * 1_000_000 == nanoseconds)?;
        Some(row.0)
    }

    pub(super) fn named(name: &str) -> Option<Unit> {
        let row = Unit::ALL.iter().find(|(_, own, ..)| *own == name)?;
        Some(row.0)
    }
}

#[derive(Debug, Clone, PartialEq)]
pub(super) struct Counter {
    pub(super) kind: CounterKind,
    /// Its bit, in bank CT.
    pub(super) tag: Tag,
    pub(super) setpoint: Operand,
    /// Of the one that counts both ways.
    pub(super) count_down: Option<Condition>,
    pub(super) reset: Option<Condition>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum CounterKind {
    Up,
    Down,
    UpDown,
}

/// A shift register: the rung's power is what enters it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Shift {
    pub(super) bits: Span,
    /// Shifts on its rise. None: the notation does not say.
    pub(super) clock: Option<Condition>,
    pub(super) reset: Option<Condition>,
}

/// Goes through steps, in each of which its outputs have a pattern.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Drum {
    /// What ends each step.
    pub(super) steps: Steps,
    /// The bits that it writes.
    pub(super) outputs: Vec<Tag>,
    /// For each step, which of the outputs are on: the first is bit 0.
    pub(super) pattern: Vec<u16>,
    /// Holds the number of the step, from 1.
    pub(super) current_step: Tag,
    /// On once the last step has ended.
    pub(super) completion_flag: Tag,
    /// Back to the first step.
    pub(super) reset: Option<Condition>,
    /// To the step that [`Drum::jump_step`] says, on its rise.
    pub(super) jump: Option<Condition>,
    pub(super) jump_step: Option<Operand>,
    /// To the next step, on its rise.
    pub(super) jog: Option<Condition>,
}

impl Drum {
    /// No more steps, and no more outputs.
    pub(super) const MOST: usize = 16;

    /// What it looks at before it acts: its pins and its events.
    pub(super) fn conditions(&self) -> impl Iterator<Item = &Condition> {
        let events = match &self.steps {
            Steps::Events(events) => &events[..],
            Steps::Times { .. } => &[],
        };
        let pins = [&self.reset, &self.jump, &self.jog];
        pins.into_iter().flatten().chain(events)
    }
}

/// What ends the steps of a drum.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Steps {
    /// One for each step, on its rise.
    Events(Vec<Condition>),
    /// A time for each step.
    Times {
        presets: Vec<Operand>,
        unit: Unit,
        /// The time in the step, in bank TD.
        accumulator: Tag,
    },
}

impl Steps {
    pub(super) const fn len(&self) -> usize {
        match self {
            Steps::Events(events) => events.len(),
            Steps::Times { presets, .. } => presets.len(),
        }
    }
}

#[derive(Debug, Clone, PartialEq)]
pub(super) struct Search {
    pub(super) relation: Relation,
    pub(super) value: Operand,
    pub(super) among: Span,
    /// The number of the address that was found, or -1.
    pub(super) result: Tag,
    /// Whether one was found.
    pub(super) flag: Tag,
    pub(super) continuous: bool,
}

#[derive(Debug, Clone, PartialEq)]
pub(super) struct Math {
    pub(super) kind: MathKind,
    pub(super) formula: Formula,
    pub(super) target: Operand,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum MathKind {
    Decimal,
    Hex,
}

/// What a formula computes. `formula.rs` reads and writes it.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Formula {
    Value(Operand),
    /// `PI`
    Pi,
    /// A sign before it.
    Negated(Box<Formula>),
    /// The bits inverted.
    Not(Box<Formula>),
    Binary(Box<Formula>, Operator, Box<Formula>),
    /// `SIN(..)`, or `LRO(v, n)` with two.
    Call(Function, Vec<Formula>),
    Sum(Span),
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Operator {
    Add,
    Subtract,
    Multiply,
    Divide,
    Modulo,
    Power,
    And,
    Or,
    Xor,
    ShiftLeft,
    ShiftRight,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Function {
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Log,
    Ln,
    Sqrt,
    Rad,
    Deg,
    RotateLeft,
    RotateRight,
}

/// How a copy turns one kind of value into another. All false: as Click does when nothing is chosen.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct CopyOptions {
    /// Numbers into characters, or the reverse.
    pub(super) convert: Option<Convert>,
    /// Blanks around a number that is packed of characters are passed over.
    pub(super) allow_whitespace: bool,
    /// What else the notation says, by name and value, as it writes them: `("suppress_zero", "True")`.
    pub(super) named: Vec<(String, String)>,
}
