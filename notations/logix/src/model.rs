//! A project as its file has it, whichever file that is. Places are offsets in bytes.

use std::collections::HashMap;

/// What a file holds: a whole controller, or a part of one with what it needs.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Project {
    pub(crate) name: String,
    /// Whose programs these are.
    pub(crate) family: Family,
    pub(crate) types: Vec<DataType>,
    pub(crate) aois: Vec<Aoi>,
    pub(crate) tags: Vec<Tag>,
    pub(crate) programs: Vec<Program>,
    pub(crate) tasks: Vec<Task>,
    pub(crate) protected: Vec<Protected>,
    /// What messages write: the tag of each message in capitals, and the tags.
    pub(crate) messages: HashMap<String, Vec<String>>,
    /// The period of the first periodic task, in milliseconds, as it is written.
    pub(crate) rate: Option<String>,
    /// Parts that cannot be read: the place, what it is, why.
    pub(crate) refused: Vec<(usize, String, String)>,
}

/// Whose programs they are.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) enum Family {
    /// Logix 5000 controllers.
    #[default]
    Logix,
    /// SLC 500 and MicroLogix, programmed with RSLogix 500.
    Slc,
}

/// A user-defined type.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct DataType {
    pub(crate) at: usize,
    pub(crate) name: String,
    /// A STRING of another length.
    pub(crate) is_string: bool,
    pub(crate) members: Vec<Member>,
    pub(crate) comment: Option<String>,
}

/// A member of a type.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Member {
    pub(crate) name: String,
    pub(crate) ty: String,
    pub(crate) dimensions: Vec<u32>,
    /// It only holds the bits of others.
    pub(crate) hidden: bool,
    /// The hidden member that holds this bit, and which it is.
    pub(crate) bit: Option<(String, u32)>,
    pub(crate) comment: Option<String>,
}

/// A tag, or a parameter of an Add-On Instruction.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Tag {
    pub(crate) at: usize,
    pub(crate) name: String,
    pub(crate) ty: String,
    pub(crate) dimensions: Vec<u32>,
    pub(crate) alias: Option<String>,
    pub(crate) usage: Usage,
    /// Whether a call must give it.
    pub(crate) required: bool,
    pub(crate) constant: bool,
    pub(crate) value: Option<Raw>,
    pub(crate) comment: Option<String>,
}

impl Tag {
    /// Whether it is a parameter that is an operand of a call.
    pub(crate) fn is_given(&self) -> bool {
        let is_system = ["EnableIn", "EnableOut"]
            .iter()
            .any(|own| self.name.eq_ignore_ascii_case(own));
        !is_system && (self.required || self.usage == Usage::InOut)
    }
}

/// What a tag is for.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) enum Usage {
    #[default]
    Local,
    Input,
    Output,
    InOut,
}

/// A value as a file has it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Raw {
    /// Its type, where it says so, and the number or text as it is written.
    Scalar(String, String),
    /// Its type, and members by name.
    Structure(String, Vec<(String, Raw)>),
    /// The type of its elements, how many there are in each dimension, and they themselves row by row.
    Array(String, Vec<u32>, Vec<Raw>),
    /// Elements or members in their order, as L5K has them.
    List(Vec<Raw>),
}

/// An Add-On Instruction.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Aoi {
    pub(crate) at: usize,
    pub(crate) name: String,
    pub(crate) parameters: Vec<Tag>,
    pub(crate) locals: Vec<Tag>,
    pub(crate) routines: Vec<Routine>,
    pub(crate) comment: Option<String>,
    /// It is this other one, for arrays of other sizes.
    pub(crate) sized_from: Option<usize>,
}

/// A task.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Task {
    pub(crate) name: String,
    pub(crate) kind: TaskKind,
    /// Nothing runs it.
    pub(crate) inhibited: bool,
    /// How often it runs, in milliseconds as they are written.
    pub(crate) rate: Option<String>,
    /// 1 runs first, 15 last of those with a rate.
    pub(crate) priority: Option<i64>,
    /// The names of its programs, in their order.
    pub(crate) programs: Vec<String>,
}

/// When a task runs.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) enum TaskKind {
    /// Whenever no other does.
    #[default]
    Continuous,
    Periodic,
    Event,
}

impl TaskKind {
    /// As both kinds of files name it.
    pub(crate) fn named(name: &str) -> TaskKind {
        match name.to_ascii_uppercase().as_str() {
            "PERIODIC" => TaskKind::Periodic,
            "EVENT" => TaskKind::Event,
            _ => TaskKind::Continuous,
        }
    }
}

/// An Add-On Instruction whose source is protected.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Protected {
    pub(crate) at: usize,
    pub(crate) name: String,
    /// What the file has of it.
    pub(crate) text: String,
}

/// A program.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Program {
    pub(crate) at: usize,
    pub(crate) name: String,
    /// No task runs it.
    pub(crate) inhibited: bool,
    pub(crate) main: Option<String>,
    pub(crate) tags: Vec<Tag>,
    pub(crate) routines: Vec<Routine>,
    pub(crate) comment: Option<String>,
}

/// A routine.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Routine {
    pub(crate) at: usize,
    pub(crate) name: String,
    pub(crate) rungs: Vec<Rung>,
    /// It is in another language, which has no rungs.
    pub(crate) foreign: Option<Foreign>,
    pub(crate) comment: Option<String>,
}

/// A routine that is not ladder logic.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Foreign {
    pub(crate) language: Language,
    /// Lines of structured text; of all else what the file has.
    pub(crate) text: String,
}

/// A language without rungs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Language {
    StructuredText,
    FunctionBlocks,
    Chart,
    /// Its source is protected.
    Protected,
}

impl Language {
    /// What a routine in it is.
    pub(crate) const fn is(self) -> &'static str {
        match self {
            Language::StructuredText => "it is structured text",
            Language::FunctionBlocks => "it is a function block diagram",
            Language::Chart => "it is a sequential function chart",
            Language::Protected => "its source is protected",
        }
    }
}

/// A rung.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Rung {
    /// Where its text begins.
    pub(crate) at: usize,
    pub(crate) text: String,
    pub(crate) comment: Option<String>,
    /// Another mark than `N`: it is part of a pending edit.
    pub(crate) edit: Option<String>,
    /// It stands for a whole routine in another language.
    pub(crate) foreign: Option<Foreign>,
}
