//! A project of IEC 61131-3 as its file has it: types, globals, program organisation units, tasks.

use super::chart::Drawn;
use super::graph::Graph;
use ladder_format::program::Qualifier;
use ladder_notation::{LineColumn, Report};

/// A whole project.
#[derive(Debug, Clone, Default)]
pub struct Project {
    /// The comment above everything else.
    pub comments: Vec<String>,
    /// How its own system runs a network.
    pub evaluation: Evaluation,
    /// Whether it was written of ladder text: its standard blocks mean those of ladder text.
    pub is_own: bool,
    /// The types that it declares.
    pub types: Vec<TypeDeclaration>,
    /// The variables that all units see.
    pub globals: Vec<Variable>,
    /// Programs, functions and function blocks.
    pub units: Vec<Unit>,
    /// What runs them.
    pub tasks: Vec<Task>,
    /// What its reader could not carry.
    pub report: Report,
}

/// When contacts are read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Evaluation {
    /// All that feeds a coil is read again for each coil: the generator of Beremiz and OpenPLC.
    #[default]
    EachOutput,
    /// A network is read once: CODESYS.
    Once,
}

/// A type with its name.
#[derive(Debug, Clone)]
pub struct TypeDeclaration {
    /// Where.
    pub place: LineColumn,
    /// Its name as the file has it.
    pub name: String,
    /// What it is.
    pub ty: Type,
    /// What a variable of it begins with.
    pub initial: Option<Initial>,
    /// The comment on it.
    pub comment: Option<String>,
}

/// A program, function or function block.
#[derive(Debug, Clone)]
pub struct Unit {
    /// Where.
    pub place: LineColumn,
    /// Its name as the file has it.
    pub name: String,
    /// Which of the three.
    pub kind: UnitKind,
    /// What a function returns.
    pub returns: Option<Type>,
    /// Its variables in their order.
    pub variables: Vec<Variable>,
    /// The comment on it.
    pub comment: Option<String>,
    /// What it does.
    pub body: Body,
    /// Its actions and transitions: their titles and bodies.
    pub parts: Vec<Part>,
}

/// What a part is that goes on where the body ends.
pub(crate) const WORKSHEET: &str = "worksheet";

/// An action, a transition, or a further body.
#[derive(Debug, Clone)]
pub struct Part {
    /// Where.
    pub place: LineColumn,
    /// What it is: `action`, `transition`, `worksheet`.
    pub what: &'static str,
    /// Its name.
    pub name: String,
    /// What it does.
    pub body: Body,
}

/// What a unit is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum UnitKind {
    /// `PROGRAM`
    Program,
    /// `FUNCTION`
    Function,
    /// `FUNCTION_BLOCK`
    FunctionBlock,
}

/// A variable.
#[derive(Debug, Clone)]
pub struct Variable {
    /// Where.
    pub place: LineColumn,
    /// Its name as the file has it.
    pub name: String,
    /// What it is for.
    pub role: Role,
    /// `CONSTANT` or `RETAIN`, if it has one.
    pub qualifier: Option<Qualifier>,
    /// A direct address, with its `%`.
    pub address: Option<String>,
    /// Its type.
    pub ty: Type,
    /// What it begins with.
    pub initial: Option<Initial>,
    /// The comment on it.
    pub comment: Option<String>,
}

impl Variable {
    /// A variable of a unit, or a member, that begins with zero.
    pub(crate) fn local(place: LineColumn, name: String, ty: Type) -> Variable {
        Variable {
            place,
            name,
            role: Role::Local,
            qualifier: None,
            address: None,
            ty,
            initial: None,
            comment: None,
        }
    }
}

/// What a variable is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// `VAR`, and the members of structures
    Local,
    /// `VAR_TEMP`
    Temp,
    /// `VAR_INPUT`
    Input,
    /// `VAR_OUTPUT`
    Output,
    /// `VAR_IN_OUT`
    InOut,
    /// `VAR_EXTERNAL`
    External,
    /// `VAR_GLOBAL`
    Global,
}

/// A type where it is used.
#[derive(Debug, Clone, PartialEq)]
pub enum Type {
    /// By its name: elementary, declared, or a function block.
    Named(String),
    /// `STRING`, with its length.
    Text(Option<u32>),
    /// With the bounds of each dimension.
    Array(Vec<(String, String)>, Box<Type>),
    /// Its values, with the numbers that are given.
    Enumeration(Vec<(String, Option<String>)>),
    /// Its members.
    Structure(Vec<Variable>),
    /// A number between two.
    Range(String, String, String),
    /// What has no counterpart; what it is.
    Other(String),
}

impl PartialEq for Variable {
    fn eq(&self, other: &Variable) -> bool {
        (&self.name, &self.ty) == (&other.name, &other.ty)
    }
}

/// What a variable begins with.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Initial {
    /// As it is written.
    Simple(String),
    /// Values, each with how often it is repeated.
    Array(Vec<(u32, Initial)>),
    /// Members with their values.
    Structure(Vec<(String, Initial)>),
}

/// What a unit does.
#[derive(Debug, Clone)]
pub enum Body {
    /// LD or FBD.
    Graph(Graph),
    /// ST or IL: the language, the text, and where that begins.
    Text(&'static str, String, LineColumn),
    /// In ladder text: a block that is brought along.
    Ladder(String),
    /// SFC.
    Chart(Drawn),
    /// Nothing.
    Empty,
}

/// A task.
#[derive(Debug, Clone)]
pub struct Task {
    /// Where.
    pub place: LineColumn,
    /// Its name.
    pub name: String,
    /// `T#20ms`
    pub interval: Option<String>,
    /// The variable whose rise starts it.
    pub event: Option<String>,
    /// The smallest runs first.
    pub priority: i64,
    /// The names of the programs that it runs, with the place of each.
    pub programs: Vec<(LineColumn, String)>,
}
