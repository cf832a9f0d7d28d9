//! A project as its file has it, whichever file that is. Places are offsets in bytes.

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
    /// The names of the programs in the order in which tasks run them.
    pub(crate) scheduled: Vec<String>,
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
}

/// A program.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Program {
    pub(crate) at: usize,
    pub(crate) name: String,
    pub(crate) main: Option<String>,
    pub(crate) tags: Vec<Tag>,
    pub(crate) routines: Vec<Routine>,
    pub(crate) comment: Option<String>,
}

/// A routine of ladder logic. Other languages are in [`Project::refused`].
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Routine {
    pub(crate) at: usize,
    pub(crate) name: String,
    pub(crate) rungs: Vec<Rung>,
    pub(crate) comment: Option<String>,
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
}
