//! What a file declares: units, types, variables, tasks.

use super::chart_syntax::ChartText;
use super::tree::{Expression, Problem, Span, Statement};
use ladder_format::program::Qualifier;

/// A file.
#[derive(Debug, Default)]
pub(crate) struct File {
    pub(crate) types: Vec<TypeDeclaration>,
    pub(crate) globals: Vec<Variable>,
    pub(crate) units: Vec<Unit>,
    pub(crate) tasks: Vec<Task>,
    /// The type of each program that runs, with the name of its task.
    pub(crate) runs: Vec<(String, Option<String>)>,
    /// What is wrong outside of bodies.
    pub(crate) problems: Vec<Problem>,
}

/// A program, a function block, a function.
#[derive(Debug)]
pub(crate) struct Unit {
    pub(crate) span: Span,
    pub(crate) kind: UnitKind,
    pub(crate) name: String,
    pub(crate) name_span: Span,
    pub(crate) returns: Option<TypeText>,
    pub(crate) variables: Vec<Variable>,
    pub(crate) comment: Option<String>,
    pub(crate) body: Vec<Statement>,
    /// The body, where it is a chart.
    pub(crate) chart: Option<ChartText>,
    /// Where the statements are.
    pub(crate) body_span: Span,
    /// From the end of the head to the word that ends the unit, with comments.
    pub(crate) text_span: Span,
    /// What does not parse in the body.
    pub(crate) problems: Vec<Problem>,
    /// Its methods and properties, which are not read.
    pub(crate) methods: Vec<(Span, String)>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum UnitKind {
    Program,
    FunctionBlock,
    Function,
}

/// A variable, or a member of a structure.
#[derive(Debug, Clone)]
pub(crate) struct Variable {
    pub(crate) span: Span,
    pub(crate) name: String,
    pub(crate) role: Role,
    pub(crate) qualifier: Option<Qualifier>,
    pub(crate) address: Option<String>,
    pub(crate) ty: TypeText,
    pub(crate) initial: Option<Initial>,
    pub(crate) comment: Option<String>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Role {
    Local,
    Temp,
    Input,
    Output,
    InOut,
    External,
    Global,
}

/// A type as it is written.
#[derive(Debug, Clone)]
pub(crate) enum TypeText {
    Named(String),
    /// `STRING[20]`
    Text(Option<Expression>),
    Array(Vec<(Expression, Expression)>, Box<TypeText>),
    /// `INT(0..100)`
    Range(String, Box<(Expression, Expression)>),
    Structure(Vec<Variable>),
    Enumeration(Vec<(String, Option<Expression>)>),
    /// What ladder text does not have.
    Other(&'static str),
}

/// What a variable begins with.
#[derive(Debug, Clone)]
pub(crate) enum Initial {
    Value(Expression),
    /// Values, each so often.
    List(Vec<(u32, Option<Initial>)>),
    Members(Vec<(String, Initial)>),
}

#[derive(Debug)]
pub(crate) struct TypeDeclaration {
    pub(crate) span: Span,
    pub(crate) name: String,
    pub(crate) ty: TypeText,
    pub(crate) initial: Option<Initial>,
    pub(crate) comment: Option<String>,
}

#[derive(Debug)]
pub(crate) struct Task {
    pub(crate) name: String,
    pub(crate) priority: u32,
}
