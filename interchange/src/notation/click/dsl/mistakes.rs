//! What is not in the DSL, with its place.

use crate::notation::{Lines, Place, ReadError};
use ruff_python_ast::{Expr, Stmt};
use ruff_text_size::Ranged;

/// A text, and what in it is not the DSL.
pub(super) struct Mistakes<'t> {
    text: &'t str,
    lines: Lines,
    all: Vec<(Place, String)>,
}

/// What could not be read. What it is has been noted.
#[derive(Debug, Clone, Copy)]
pub(super) struct Unread;

impl<'t> Mistakes<'t> {
    pub(super) fn new(text: &'t str) -> Mistakes<'t> {
        Mistakes {
            text,
            lines: Lines::of(text),
            all: Vec::new(),
        }
    }

    pub(super) fn text(&self) -> &'t str {
        self.text
    }

    /// What stands at a part of the program.
    pub(super) fn source(&self, of: &impl Ranged) -> &'t str {
        self.text
            .get(usize::from(of.start())..usize::from(of.end()))
            .unwrap_or("")
    }

    pub(super) fn place(&self, of: &impl Ranged) -> Place {
        self.lines.place(self.text, of.start().into())
    }

    pub(super) fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    /// Notes that something is not in the DSL.
    pub(super) fn note(&mut self, of: &impl Ranged, message: impl Into<String>) -> Unread {
        let place = self.place(of);
        self.all.push((place, message.into()));
        Unread
    }

    /// All of them as one error, if there are any: nothing of the file is read then.
    pub(super) fn into_error(mut self) -> Option<ReadError> {
        self.all.sort_by_key(|(place, _)| *place);
        let mut all = self.all.into_iter();
        let (place, message) = all.next()?;
        Some(ReadError {
            more: all.collect(),
            ..ReadError::at(place, message)
        })
    }
}

/// What a statement is, in words.
pub(super) fn statement(statement: &Stmt) -> &'static str {
    match statement {
        Stmt::FunctionDef(_) => "a function inside another",
        Stmt::ClassDef(_) => "a class",
        Stmt::Return(_) => "`return`",
        Stmt::Delete(_) => "`del`",
        Stmt::TypeAlias(_) => "`type`",
        Stmt::Assign(_) | Stmt::AugAssign(_) | Stmt::AnnAssign(_) => "an assignment",
        Stmt::For(_) => "`for`",
        Stmt::While(_) => "`while`",
        Stmt::If(_) => "`if`",
        Stmt::With(_) => "`with`",
        Stmt::Match(_) => "`match`",
        Stmt::Raise(_) => "`raise`",
        Stmt::Try(_) => "`try`",
        Stmt::Assert(_) => "`assert`",
        Stmt::Import(_) | Stmt::ImportFrom(_) => "an import",
        Stmt::Global(_) => "`global`",
        Stmt::Nonlocal(_) => "`nonlocal`",
        Stmt::Expr(_) => "an expression by itself",
        Stmt::Pass(_) => "`pass`",
        Stmt::Break(_) => "`break`",
        Stmt::Continue(_) => "`continue`",
        Stmt::IpyEscapeCommand(_) => "a command of IPython",
    }
}

/// What an expression is, in words.
pub(super) fn expression(expression: &Expr) -> &'static str {
    match expression {
        Expr::BoolOp(_) => "`and` or `or`",
        Expr::Named(_) => "`:=`",
        Expr::BinOp(_) => "a calculation",
        Expr::UnaryOp(_) => "a sign or `not`",
        Expr::Lambda(_) => "a lambda",
        Expr::If(_) => "a conditional expression",
        Expr::Dict(_) => "a dictionary",
        Expr::Set(_) => "a set",
        Expr::List(_) => "a list",
        Expr::Tuple(_) => "a tuple",
        Expr::ListComp(_) | Expr::SetComp(_) | Expr::DictComp(_) | Expr::Generator(_) => "a comprehension",
        Expr::Await(_) => "`await`",
        Expr::Yield(_) | Expr::YieldFrom(_) => "`yield`",
        Expr::Compare(_) => "a comparison",
        Expr::Call(_) => "a call",
        Expr::FString(_) => "an f-string",
        Expr::TString(_) => "a t-string",
        Expr::StringLiteral(_) => "a string",
        Expr::BytesLiteral(_) => "a bytes literal",
        Expr::NumberLiteral(_) => "a number",
        Expr::BooleanLiteral(_) => "a truth value",
        Expr::NoneLiteral(_) => "`None`",
        Expr::EllipsisLiteral(_) => "`...`",
        Expr::Attribute(_) => "an attribute",
        Expr::Subscript(_) => "an index",
        Expr::Starred(_) => "`*`",
        Expr::Name(_) => "a name",
        Expr::Slice(_) => "a slice",
        Expr::IpyEscapeCommand(_) => "a command of IPython",
    }
}
