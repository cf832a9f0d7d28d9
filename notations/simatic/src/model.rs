//! A block of a controller, however it was written: what is declared, and its networks as wires between points.

use crate::standard::{elementary, state_type};
use ladder_notation::{LineColumn, Report};
use std::fmt;

/// What a file declares.
#[derive(Debug, Default)]
pub(crate) struct Unit {
    pub(crate) place: LineColumn,
    pub(crate) kind: Kind,
    pub(crate) name: String,
    /// What a function returns; none for `Void`.
    pub(crate) returns: Option<Type>,
    pub(crate) variables: Vec<Variable>,
    /// Title and comment.
    pub(crate) told: Vec<String>,
    pub(crate) networks: Vec<Network>,
    /// What was left out while it was read.
    pub(crate) report: Report,
}

/// The kinds of blocks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum Kind {
    #[default]
    FunctionBlock,
    Function,
    Organization,
    Data,
    Type,
    /// A tag of a tag table, or a constant of one: then it is its only variable, with its value.
    Tag,
}

impl Kind {
    /// The word that it begins with.
    pub(crate) const fn keyword(self) -> &'static str {
        match self {
            Kind::FunctionBlock => "FUNCTION_BLOCK",
            Kind::Function => "FUNCTION",
            Kind::Organization => "ORGANIZATION_BLOCK",
            Kind::Data => "DATA_BLOCK",
            Kind::Type => "TYPE",
            Kind::Tag => "TAG",
        }
    }

    /// Whether it runs.
    pub(crate) const fn is_code(self) -> bool {
        matches!(self, Kind::FunctionBlock | Kind::Function | Kind::Organization)
    }

    /// Whether it is a tag of the project, which blocks name as it is.
    pub(crate) const fn is_tag(self) -> bool {
        matches!(self, Kind::Data | Kind::Tag)
    }

    /// Those that a source document begins with.
    pub(crate) const ALL: [Kind; 5] = [
        Kind::FunctionBlock,
        Kind::Function,
        Kind::Organization,
        Kind::Data,
        Kind::Type,
    ];
}

impl Unit {
    /// A constant of a tag table, with its value.
    pub(crate) fn constant(&self) -> Option<&Variable> {
        self.variables.first().filter(|_| self.kind == Kind::Tag)
    }
}

/// What a variable is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum Role {
    Input,
    Output,
    InOut,
    #[default]
    Static,
    Temp,
    Constant,
}

/// A declared variable, or a member of a structure.
#[derive(Debug, Clone, Default)]
pub(crate) struct Variable {
    pub(crate) place: LineColumn,
    pub(crate) name: String,
    pub(crate) role: Role,
    pub(crate) retain: bool,
    pub(crate) ty: Type,
    /// As it is written.
    pub(crate) initial: Option<String>,
    pub(crate) comment: Option<String>,
}

/// A type as it is declared.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Type {
    Named(String),
    Text(Option<u32>),
    Array(Vec<(String, String)>, Box<Type>),
    Structure(Vec<Variable>),
}

impl Default for Type {
    fn default() -> Type {
        Type::Named("Bool".to_owned())
    }
}

impl fmt::Display for Type {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Type::Named(name) if elementary(name).or_else(|| state_type(name)).is_some() => f.write_str(name),
            Type::Named(name) => write!(f, "\"{name}\""),
            Type::Text(None) => f.write_str("String"),
            Type::Text(Some(length)) => write!(f, "String[{length}]"),
            Type::Array(bounds, of) => {
                let bounds: Vec<String> = bounds
                    .iter()
                    .map(|(low, high)| format!("{low}..{high}"))
                    .collect();
                write!(f, "Array[{}] of {of}", bounds.join(", "))
            }
            Type::Structure(_) => f.write_str("Struct"),
        }
    }
}

impl PartialEq for Variable {
    fn eq(&self, other: &Variable) -> bool {
        self.name == other.name && self.ty == other.ty
    }
}

/// A network.
#[derive(Debug, Default)]
pub(crate) struct Network {
    pub(crate) place: LineColumn,
    /// Title and comment.
    pub(crate) told: Vec<String>,
    pub(crate) label: Option<(LineColumn, String)>,
    /// As it is written.
    pub(crate) text: String,
    /// Where bytes of the text are in the file, in their order; what follows one is on its line.
    pub(crate) places: Vec<(usize, LineColumn)>,
    pub(crate) body: Body,
}

impl Network {
    /// Where a byte of the text is in the file.
    pub(crate) fn place_in_text(&self, at: usize) -> LineColumn {
        let after = self.places.partition_point(|(start, _)| *start <= at);
        match after.checked_sub(1).map(|before| self.places[before]) {
            Some((start, place)) => LineColumn {
                column: place.column + (at - start) as u32,
                ..place
            },
            None => self.place,
        }
    }
}

/// What a network holds.
#[derive(Debug)]
pub(crate) enum Body {
    Ladder(Net),
    /// What is not read: its language, and why not.
    Text(String, String),
}

impl Default for Body {
    fn default() -> Body {
        Body::Ladder(Net::default())
    }
}

impl Body {
    /// A network in a language that is not read.
    pub(crate) fn in_language(language: &str) -> Body {
        Body::Text(
            language.to_owned(),
            format!("a network in {language} is not read"),
        )
    }
}

/// A network has no more parts.
pub(crate) const MOST_PARTS: usize = 2_000;

/// Wires with parts on them, between points. Point 0 is the left rail.
#[derive(Debug, Default)]
pub(crate) struct Net {
    pub(crate) points: usize,
    pub(crate) wires: Vec<Wire>,
}

/// The left rail.
pub(crate) const RAIL: usize = 0;

/// A wire.
#[derive(Debug)]
pub(crate) struct Wire {
    pub(crate) from: usize,
    /// Where it ends; none: nowhere.
    pub(crate) to: Option<usize>,
    pub(crate) parts: Vec<Part>,
}

/// An instruction or a call.
#[derive(Debug, Clone, Default)]
pub(crate) struct Part {
    pub(crate) place: LineColumn,
    /// As SIMATIC SD spells it.
    pub(crate) name: String,
    /// What holds its state: `#timer`.
    pub(crate) instance: Option<String>,
    /// `SrcType`, `Int`
    pub(crate) templates: Vec<(String, String)>,
    /// What it calculates: `IN1 + IN2`
    pub(crate) formula: Option<String>,
    pub(crate) arguments: Vec<Argument>,
    /// As it is written, in one line.
    pub(crate) text: String,
}

/// What is at a pin.
#[derive(Debug, Clone)]
pub(crate) struct Argument {
    /// None: by place.
    pub(crate) pin: Option<String>,
    pub(crate) value: Value,
    /// Whether it is written: `=>`.
    pub(crate) is_output: bool,
}

/// See [`Argument`].
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Value {
    /// As it is written.
    Operand(String),
    /// A tag of our own, with a bit.
    Helper(String),
    /// The power at a point.
    Power(usize),
    /// Nothing.
    Open,
}

impl Argument {
    /// An operand at a pin.
    pub(crate) fn new(pin: impl Into<String>, operand: impl Into<String>, is_output: bool) -> Argument {
        Argument {
            pin: Some(pin.into()),
            value: Value::Operand(operand.into()),
            is_output,
        }
    }
}

impl Part {
    /// An instruction, or a call of what holds a state.
    pub(crate) fn named(name: impl Into<String>) -> Part {
        Part {
            name: name.into(),
            ..Part::default()
        }
    }

    /// The same with something that it reads at a pin.
    pub(crate) fn given(mut self, pin: impl Into<String>, operand: impl Into<String>) -> Part {
        self.arguments.push(Argument::new(pin, operand, false));
        self
    }

    /// The same with something that it writes at a pin.
    pub(crate) fn taken(mut self, pin: impl Into<String>, operand: impl Into<String>) -> Part {
        self.arguments.push(Argument::new(pin, operand, true));
        self
    }

    /// The same for values of a type.
    pub(crate) fn typed(mut self, template: &str, ty: &str) -> Part {
        self.templates.push((template.to_owned(), ty.to_owned()));
        self
    }

    /// What is at a pin, where something is. Instructions with one operand have it by place.
    pub(crate) fn pin(&self, name: &str) -> Option<&Argument> {
        let named = |argument: &&Argument| match &argument.pin {
            Some(pin) => pin.eq_ignore_ascii_case(name),
            None => false,
        };
        self.arguments
            .iter()
            .find(named)
            .filter(|argument| argument.value != Value::Open)
    }

    /// What is at a pin, or given first without a name.
    pub(crate) fn only(&self, name: &str) -> Option<&Argument> {
        self.pin(name)
            .or_else(|| self.arguments.iter().find(|argument| argument.pin.is_none()))
    }

    /// The value of a template.
    pub(crate) fn template(&self, name: &str) -> Option<&str> {
        let mut all = self.templates.iter();
        all.find(|(own, _)| own.eq_ignore_ascii_case(name))
            .map(|(_, value)| value.as_str())
    }
}
