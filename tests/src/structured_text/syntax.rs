//! What a text is made of.

use super::value::Value;
use std::collections::HashMap;

/// A type as it is written.
#[derive(Debug, Clone)]
pub(super) enum Spec {
    /// By its name in capitals.
    Named(String),
    /// `STRING[n]`
    Text(usize),
    /// An array.
    Array(Vec<(i64, i64)>, Box<Spec>),
}

/// What a variable starts with.
#[derive(Debug, Clone)]
pub(super) enum Initial {
    /// One value.
    One(Expr),
    /// Elements, each so many times.
    Elements(Vec<(usize, Initial)>),
    /// Members.
    Members(Vec<(String, Initial)>),
}

/// A variable.
#[derive(Debug, Clone)]
pub(super) struct Variable {
    /// The word that its section begins with.
    pub section: String,
    /// In capitals.
    pub name: String,
    /// See [`Spec`].
    pub ty: Spec,
    /// What it starts with.
    pub initial: Option<Initial>,
}

/// A program, function or function block.
#[derive(Debug, Clone)]
pub(super) struct Unit {
    /// In capitals.
    pub name: String,
    /// What a function returns.
    pub result: Option<Spec>,
    /// In their order.
    pub variables: Vec<Variable>,
    /// Its statements.
    pub body: Vec<Statement>,
}

/// A declared type.
#[derive(Debug, Clone)]
pub(super) enum Declared {
    /// The values of an enumeration.
    Values(Vec<String>),
    /// The members of a structure.
    Members(Vec<(String, Spec, Option<Initial>)>),
    /// A name for an array.
    Array(Spec),
}

/// A whole text.
#[derive(Debug, Default)]
pub(super) struct Text {
    /// By their names.
    pub types: HashMap<String, Declared>,
    /// By their names.
    pub units: HashMap<String, Unit>,
    /// The program.
    pub program: String,
    /// Of the configuration.
    pub globals: Vec<Variable>,
}

/// A variable or part of one.
#[derive(Debug, Clone)]
pub(super) struct Path {
    /// In capitals.
    pub name: String,
    /// From there on.
    pub steps: Vec<Step>,
}

/// A step of a path.
#[derive(Debug, Clone)]
pub(super) enum Step {
    /// `.member`
    Member(String),
    /// `[i, j]`
    Index(Vec<Expr>),
}

/// An expression.
#[derive(Debug, Clone)]
pub(super) enum Expr {
    /// A literal.
    Literal(Value),
    /// What a variable holds.
    Read(Path),
    /// `NOT a`, `-a`
    Unary(String, Box<Expr>),
    /// `a op b`
    Binary(String, Box<Expr>, Box<Expr>),
    /// A function.
    Call(String, Vec<Expr>),
}

/// A statement.
#[derive(Debug, Clone)]
pub(super) enum Statement {
    /// `a := b`
    Assign(Path, Expr),
    /// `IF`
    If(Vec<(Expr, Vec<Statement>)>, Vec<Statement>),
    /// `FOR`
    For(Path, Expr, Expr, Vec<Statement>),
    /// `WHILE`
    While(Expr, Vec<Statement>),
    /// A call of a block.
    Call(Path, Vec<(String, Expr)>),
    /// `RETURN`
    Return,
    /// `EXIT`
    Exit,
}
