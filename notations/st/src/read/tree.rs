//! What a text in Structured Text says: statements and expressions, with their places.

pub(super) use super::token::Span;
use ladder_format::program::{Operator, Sign};

/// A value.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Expression {
    /// Where it is.
    pub span: Span,
    /// What it is.
    pub kind: ExpressionKind,
}

/// What a value is.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum ExpressionKind {
    /// A number, a duration, a text: as it is written. A word before `#` may be an enumeration: `Phase#IDLE`.
    Literal(LiteralKind, String),
    /// A tag, or a part of one.
    Place(Place),
    /// `-a`, `NOT a`
    Unary(Sign, Box<Expression>),
    /// `a + b`
    Binary(Operator, Box<Expression>, Box<Expression>),
    /// `a AND_THEN b`, `a OR_ELSE b`: the right side is computed only if the left one leaves it open.
    Lazy(Operator, Box<Expression>, Box<Expression>),
    /// `SQRT(a)`
    Call(Call),
    /// Parentheses.
    Group(Box<Expression>),
}

/// What a literal is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum LiteralKind {
    /// `12`, `16#FF`
    Integer,
    /// `1.5`
    Real,
    /// `T#5s`, `INT#5`
    Typed,
    /// `'text'`
    Text,
}

/// A tag, or a part of one.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Place {
    /// Where it is.
    pub span: Span,
    /// The name of the tag, without `#` and quotation marks; or an address with its `%`.
    pub root: String,
    /// From there to the part.
    pub steps: Vec<Step>,
}

impl Place {
    /// What names it, and the steps from there: of a name in quotes the members are part of it, as a part of what another file
    /// declares may be all that is known of that.
    pub(super) fn written(&self) -> (String, &[Step]) {
        let mut name = self.root.clone();
        let mut rest = &self.steps[..];
        while let ([Step::Member(member), after @ ..], true) = (rest, name.starts_with('"')) {
            name = format!("{name}.{member}");
            rest = after;
        }
        (name, rest)
    }
}

/// From a value to a part of it.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Step {
    /// `.name`
    Member(String),
    /// `.3`, `.%X3`
    Bit(u32),
    /// `.[i]`
    ComputedBit(Box<Expression>),
    /// `[i, j]`
    Index(Vec<Expression>),
    /// `.%B1`, `.%W0`, `.%D1`: how many bits, and the number of the part.
    Part(u32, u32),
    /// `^`: what ladder text does not have.
    Other(&'static str),
}

/// A call of a block or a function.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Call {
    /// What is called.
    pub callee: Place,
    /// In their order.
    pub arguments: Vec<Argument>,
}

/// What a call hands over.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Argument {
    /// The name of the parameter. None: by place.
    pub name: Option<String>,
    /// Which way it goes.
    pub direction: Direction,
    /// `name :=` without a value hands nothing over.
    pub value: Option<Expression>,
}

/// Which way an argument goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Direction {
    /// `a`, `name := a`
    In,
    /// `name => a`
    Out,
    /// `NOT name => a`
    OutNegated,
}

/// A statement.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Statement {
    /// Where it is.
    pub span: Span,
    /// What it is.
    pub kind: StatementKind,
}

/// How a value is assigned.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Assignment {
    /// `:=`, and `[:=]`, which is the same while a routine runs
    Value,
    /// `S=`
    Set,
    /// `R=`
    Reset,
    /// `REF=`
    Reference,
}

/// What a statement is.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum StatementKind {
    /// `a := b`; of several targets the last is nearest to the value.
    Assign(Vec<Place>, Assignment, Expression),
    /// `timer(IN := a)`
    Call(Call),
    /// `RETURN`
    Return,
    /// `EXIT`
    Exit,
    /// `CONTINUE`
    Continue,
    /// `GOTO there`
    Goto(String),
    /// `there:`
    Label(String),
    /// The branches with their conditions, and ELSE.
    If(Vec<(Expression, Vec<Statement>)>, Vec<Statement>),
    /// The selector, the arms, and ELSE.
    Case(Expression, Vec<Arm>, Vec<Statement>),
    /// A loop that counts.
    For(Box<For>),
    /// A loop with its condition before each turn.
    While(Expression, Vec<Statement>),
    /// A loop with its condition after each turn.
    Repeat(Vec<Statement>, Expression),
    /// `{...}`, `{{...}}`: text in C, or a choice of what is compiled. Its words.
    Pragma(Pragma, Vec<String>),
}

/// What a pragma is that is not idle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Pragma {
    /// Text in C.
    Code,
    /// Text in C that may leave the body.
    Leaving,
    /// What is after it is compiled, or is not.
    Choice,
}

/// An arm of a CASE.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Arm {
    /// Where its labels are.
    pub span: Span,
    /// One value, or all from one to another.
    pub labels: Vec<(Expression, Option<Expression>)>,
    /// What it does.
    pub body: Vec<Statement>,
}

/// A loop that counts.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct For {
    /// What counts.
    pub variable: Place,
    /// From here.
    pub from: Expression,
    /// To here.
    pub to: Expression,
    /// In steps of this.
    pub by: Option<Expression>,
    /// What is repeated.
    pub body: Vec<Statement>,
}

/// What does not parse.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Problem {
    /// Where.
    pub span: Span,
    /// What is wrong.
    pub message: String,
}

impl Problem {
    /// Why what it is in is unread as a whole; it is on this line.
    pub(super) fn in_words(&self, line: u32) -> String {
        format!("line {line} does not parse: {}", self.message)
    }
}
