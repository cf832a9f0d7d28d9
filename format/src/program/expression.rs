//! Operands of a sketch: literals, tags and their parts, formulas. They are spelled here and nowhere else.

use super::Invalid;
use super::path::{Path, Step};
use ladder_syntax::{MAX_DEPTH, MAX_TERMS, is_literal};
use std::fmt::{self, Display, Formatter};

/// What an operand holds.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Expression {
    /// A literal.
    Literal(Literal),
    /// A tag, or a part of it.
    Path(Path),
    /// `-a`, `NOT a`
    Unary(Sign, Box<Expression>),
    /// `a + b`
    Binary(Operator, Box<Expression>, Box<Expression>),
    /// `SQRT(a)`
    Call(String, Vec<Expression>),
    /// Parentheses that a person has written. Those that operators ask for need none.
    Group(Box<Expression>),
}

/// What is before its only operand.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "they are the signs themselves")]
pub enum Sign {
    Minus,
    Not,
}

/// What is between two operands, from the loosest to the tightest (LANGUAGE §5.2).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "they are the operators themselves")]
pub enum Operator {
    Or,
    Xor,
    And,
    Equal,
    NotEqual,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Shl,
    Shr,
    Plus,
    Minus,
    Times,
    Divide,
    Mod,
    Power,
}

/// Operators as they are written, and how tightly they bind; in the order of their variants.
const OPERATORS: [(Operator, &str, u8); 17] = [
    (Operator::Or, "OR", 1),
    (Operator::Xor, "XOR", 2),
    (Operator::And, "AND", 3),
    (Operator::Equal, "=", 4),
    (Operator::NotEqual, "<>", 4),
    (Operator::Less, "<", 5),
    (Operator::LessEqual, "<=", 5),
    (Operator::Greater, ">", 5),
    (Operator::GreaterEqual, ">=", 5),
    (Operator::Shl, "SHL", 6),
    (Operator::Shr, "SHR", 6),
    (Operator::Plus, "+", 7),
    (Operator::Minus, "-", 7),
    (Operator::Times, "*", 8),
    (Operator::Divide, "/", 8),
    (Operator::Mod, "MOD", 8),
    (Operator::Power, "^", POWER),
];

/// How tightly a power holds together, what has a sign, and what needs no parentheses anywhere.
const POWER: u8 = 9;
const SIGNED: u8 = 10;
const TIGHTEST: u8 = 11;
/// Relations of relations are clearer with parentheses.
const IN_RELATION: u8 = 6;

impl Operator {
    /// The operator that is written so, in capitals.
    pub fn of(written: &str) -> Option<Operator> {
        let mut all = OPERATORS.iter();
        all.find(|(_, own, _)| *own == written).map(|row| row.0)
    }

    /// How tightly it binds, compared with the others. What is of one sort is computed from left to right.
    pub const fn binding(self) -> u8 {
        self.row().1
    }

    /// Whether it compares: `=`, `<`
    pub const fn compares(self) -> bool {
        matches!(self.binding(), 4 | 5)
    }

    /// As it is written, and how tightly it binds.
    const fn row(self) -> (&'static str, u8) {
        let (_, written, binding) = OPERATORS[self as usize];
        (written, binding)
    }

    /// How tightly its left and its right operand must hold together. What is of one sort is computed from left to right.
    const fn asked(self) -> (u8, u8) {
        match self.binding() {
            // It groups to the right here, and to the left elsewhere.
            POWER => (SIGNED, SIGNED),
            _ if self.compares() => (IN_RELATION, IN_RELATION),
            binding => (binding, binding + 1),
        }
    }
}

impl Expression {
    /// A literal, as ladder text writes it.
    ///
    /// # Errors
    ///
    /// If it is not one.
    pub fn literal(text: impl Into<String>) -> Result<Expression, Invalid> {
        Literal::read(text).map(Expression::Literal)
    }

    /// `self operator right`
    #[must_use]
    pub fn with(self, operator: Operator, right: impl Into<Expression>) -> Expression {
        Expression::Binary(operator, Box::new(self), Box::new(right.into()))
    }

    /// `NOT self`
    #[must_use]
    pub fn negated(self) -> Expression {
        Expression::Unary(Sign::Not, Box::new(self))
    }

    /// A function of some values: `MIN(a, b)`
    pub fn call<E: Into<Expression>>(function: &str, arguments: impl IntoIterator<Item = E>) -> Expression {
        Expression::Call(
            function.to_owned(),
            arguments.into_iter().map(Into::into).collect(),
        )
    }

    /// The tag or part of one, if it is no more than that.
    pub const fn path(&self) -> Option<&Path> {
        match self {
            Expression::Path(path) => Some(path),
            _ => None,
        }
    }

    /// Calls something with each path in it, those of indices after those that have them.
    pub fn paths<'e>(&'e self, found: &mut impl FnMut(&'e Path)) {
        match self {
            Expression::Literal(_) => {}
            Expression::Path(path) => {
                found(path);
                path.indices().for_each(|index| index.paths(found));
            }
            Expression::Unary(_, inner) | Expression::Group(inner) => inner.paths(found),
            Expression::Binary(_, left, right) => {
                left.paths(found);
                right.paths(found);
            }
            Expression::Call(_, arguments) => arguments.iter().for_each(|argument| argument.paths(found)),
        }
    }

    /// Changes each path in it, those in indices first.
    pub fn change_paths(&mut self, with: &mut impl FnMut(&mut Path)) {
        match self {
            Expression::Literal(_) => {}
            Expression::Path(path) => {
                path.indices_mut().for_each(|index| index.change_paths(with));
                with(path);
            }
            Expression::Unary(_, inner) | Expression::Group(inner) => inner.change_paths(with),
            Expression::Binary(_, left, right) => {
                left.change_paths(with);
                right.change_paths(with);
            }
            Expression::Call(_, arguments) => arguments
                .iter_mut()
                .for_each(|argument| argument.change_paths(with)),
        }
    }

    /// The expression with other operands and arguments; a tag has none.
    #[must_use]
    pub fn map_inner(self, with: &mut impl FnMut(Expression) -> Expression) -> Expression {
        match self {
            Expression::Literal(_) | Expression::Path(_) => self,
            Expression::Unary(sign, inner) => Expression::Unary(sign, Box::new(with(*inner))),
            Expression::Group(inner) => Expression::Group(Box::new(with(*inner))),
            Expression::Binary(operator, left, right) => {
                let left = with(*left);
                Expression::Binary(operator, Box::new(left), Box::new(with(*right)))
            }
            Expression::Call(name, arguments) => {
                Expression::Call(name, arguments.into_iter().map(with).collect())
            }
        }
    }

    /// How tightly it holds together.
    const fn binding(&self) -> u8 {
        match self {
            Expression::Unary(..) => SIGNED,
            Expression::Binary(operator, ..) => operator.binding(),
            _ => TIGHTEST,
        }
    }

    /// Whether it needs parentheses where something must hold together so tightly.
    fn needs_parentheses(&self, asked: u8) -> bool {
        self.binding() < asked || matches!(self, Expression::Literal(literal) if literal.is_negative())
    }

    /// Whether it can be written. [`Block::of`](super::Block::of) asks this of its operands; contacts and coils take what is
    /// known to be so.
    ///
    /// # Errors
    ///
    /// If it is too long, nests too deep, or has a name that a tag or a member cannot have.
    pub fn check(&self) -> Result<(), Invalid> {
        if self.terms(0).is_none_or(|terms| terms >= MAX_TERMS) {
            return Err(Invalid::new("the formula is too long, or nests too deep"));
        }
        let mut checked = Ok(());
        self.paths(&mut |path| {
            if checked.is_ok() {
                checked = path.check();
            }
        });
        checked
    }

    /// How many operators, members, indices and arguments it has, as the parser counts them. `None`: it nests too deep.
    fn terms(&self, depth: u32) -> Option<u32> {
        let inside = |inner: &Expression| inner.terms(depth + 1);
        let all = |mut inner: std::slice::Iter<'_, Expression>| {
            inner.try_fold(inner.len() as u32, |sum, argument| Some(sum + inside(argument)?))
        };
        if depth >= MAX_DEPTH {
            return None;
        }
        match self {
            Expression::Literal(_) => Some(0),
            Expression::Path(path) => path.steps.iter().try_fold(0, |sum, step| {
                let own = match step {
                    Step::Member(_) | Step::Bit(_) => Some(0),
                    Step::Index(indices) => all(indices.iter()),
                    Step::Range(before, range) => {
                        let bounds = inside(&range.0)? + inside(&range.1)?;
                        Some(bounds + all(before.iter())?)
                    }
                };
                Some(sum + 1 + own?)
            }),
            Expression::Unary(_, inner) | Expression::Group(inner) => Some(1 + inside(inner)?),
            Expression::Binary(operator, left, right) => {
                let nests = left.needs_parentheses(operator.asked().0);
                Some(1 + left.terms(depth + u32::from(nests))? + inside(right)?)
            }
            Expression::Call(_, arguments) => all(arguments.iter()),
        }
    }
}

impl Display for Expression {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Expression::Literal(literal) => f.write_str(literal.as_str()),
            Expression::Path(path) => path.fmt(f),
            Expression::Unary(sign, inner) => {
                f.write_str(match sign {
                    Sign::Minus => "-",
                    Sign::Not => "NOT ",
                })?;
                Within(inner, TIGHTEST).fmt(f)
            }
            Expression::Binary(operator, left, right) => {
                let (before, after) = operator.asked();
                let written = operator.row().0;
                write!(f, "{} {written} {}", Within(left, before), Within(right, after))
            }
            Expression::Call(function, arguments) => {
                write!(f, "{function}({})", List(arguments))
            }
            Expression::Group(inner) => write!(f, "({inner})"),
        }
    }
}

/// An expression in a place where something must hold together so tightly.
struct Within<'e>(&'e Expression, u8);

impl Display for Within<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        if self.0.needs_parentheses(self.1) {
            write!(f, "({})", self.0)
        } else {
            self.0.fmt(f)
        }
    }
}

/// With commas between them.
pub(super) struct List<'l, T>(pub(super) &'l [T]);

impl<T: Display> Display for List<'_, T> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        for (number, item) in self.0.iter().enumerate() {
            let comma = if number == 0 { "" } else { ", " };
            write!(f, "{comma}{item}")?;
        }
        Ok(())
    }
}

impl From<Path> for Expression {
    fn from(path: Path) -> Expression {
        Expression::Path(path)
    }
}

impl From<&Path> for Expression {
    fn from(path: &Path) -> Expression {
        Expression::Path(path.clone())
    }
}

impl From<Literal> for Expression {
    fn from(literal: Literal) -> Expression {
        Expression::Literal(literal)
    }
}

impl From<i64> for Expression {
    fn from(number: i64) -> Expression {
        Expression::Literal(Literal::from(number))
    }
}

/// A literal, as it is written: `-5`, `T#5s`, `'text'`.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Literal(String);

impl Literal {
    /// A literal as ladder text writes it; a number may have a minus.
    ///
    /// # Errors
    ///
    /// If it is not one.
    pub fn read(text: impl Into<String>) -> Result<Literal, Invalid> {
        let text = text.into();
        let unsigned = match text.strip_prefix('-') {
            Some(digits) if digits.starts_with(|c: char| c.is_ascii_digit()) => digits,
            _ => &text,
        };
        if is_literal(unsigned) {
            return Ok(Literal(text));
        }
        Err(Invalid(format!(
            "`{text}` is not a value that can be written here"
        )))
    }

    /// A text; what cannot be in one as it is becomes its sign: `$'`, `$N`.
    pub fn text(text: &str) -> Literal {
        let mut out = String::from("'");
        for c in text.chars() {
            match c {
                '$' | '\'' => out.extend(['$', c]),
                c if c.is_ascii_control() => out.push_str(&format!("${:02X}", u32::from(c))),
                c => out.push(c),
            }
        }
        out.push('\'');
        Literal(out)
    }

    /// As it is written.
    pub fn as_str(&self) -> &str {
        &self.0
    }

    fn is_negative(&self) -> bool {
        self.0.starts_with('-')
    }
}

impl From<i64> for Literal {
    fn from(number: i64) -> Literal {
        Literal(number.to_string())
    }
}

impl From<bool> for Literal {
    fn from(value: bool) -> Literal {
        Literal(if value { "TRUE" } else { "FALSE" }.to_owned())
    }
}
