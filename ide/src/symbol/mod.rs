//! What a word of the text names, and every place that names the same: what all of navigation and rename read.
//!
//! A [`Symbol`] says what is meant independently of where it was found, so that the same symbol is found from each of
//! its places, in whichever file they are. [`find()`] comes from an offset to a symbol, [`occurrences()`] from a symbol
//! to its places in one file, and [`everywhere()`] to those in the whole workspace.

pub(crate) mod declared;
mod everywhere;
mod find;
mod occurrences;
pub(crate) mod types;

pub(crate) use declared::{DeclaredName, declared_names};
pub(crate) use everywhere::{everywhere, in_files_of};
pub(crate) use find::{Found, find, tag_of};
pub(crate) use occurrences::{Occurrence, block_file, block_name, each_node, occurrences};

use ladder_analysis::context::Body;
use ladder_analysis::program::Access;
use ladder_instructions::Op;
use ladder_syntax::Name;
use std::sync::Arc;

/// Something that has a name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Symbol {
    /// A tag that belongs to one file, or to the body of one of its blocks (scope 1 for its first block); also a
    /// block's parameter.
    Tag {
        file: Arc<str>,
        scope: usize,
        name: Name,
    },
    /// A VAR_GLOBAL tag: one for the workspace, whichever files declare it.
    Global(Name),
    /// A direct address: one for the workspace.
    Address(Name),
    /// A label of a body; defined there or not.
    Label { file: Arc<str>, body: Body, name: Name },
    /// A function, in the file that calls of it lead to.
    Function { file: Arc<str>, name: Name },
    /// A user-defined block, likewise.
    Block { file: Arc<str>, name: Name },
    /// A member of a timer, counter or bistable, or a bit of a tag, by its name in the table.
    Member { of: Box<Symbol>, name: Name },
    /// A declared type, in the file that names of it lead to.
    Type { file: Arc<str>, name: Name },
    /// A member of a declared structure, or a value of a declared enumeration.
    Part { file: Arc<str>, ty: Name, name: Name },
    /// A member of SYS.
    System(Name),
    /// An instruction.
    Instruction(Op),
}

/// What a place does with the thing that it names.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Usage {
    /// It is defined or declared here.
    Definition,
    /// A VAR_EXTERNAL line: it is declared here and defined elsewhere.
    Declaration,
    /// It is read. A block that gets a value back through a parameter reads that parameter.
    Read,
    /// It is written. A block that is given a value for a parameter writes that parameter.
    Write,
    /// Both.
    ReadWrite,
    /// It is named: a call, a jump, a block where it is used.
    Mention,
}

impl Usage {
    /// Whether it is a definition or declaration.
    pub const fn declares(self) -> bool {
        matches!(self, Usage::Definition | Usage::Declaration)
    }

    /// Whether the thing gets a new value here.
    pub(crate) const fn writes(self) -> bool {
        matches!(self, Usage::Write | Usage::ReadWrite)
    }
}

impl From<Access> for Usage {
    fn from(access: Access) -> Usage {
        match access {
            Access::Read => Usage::Read,
            Access::Write => Usage::Write,
            Access::ReadWrite => Usage::ReadWrite,
        }
    }
}

impl Symbol {
    /// The name that is at its places; none if they differ (an instruction).
    pub(crate) fn name(&self) -> Option<&Name> {
        match self {
            Symbol::Tag { name, .. }
            | Symbol::Global(name)
            | Symbol::Address(name)
            | Symbol::Label { name, .. }
            | Symbol::Function { name, .. }
            | Symbol::Type { name, .. }
            | Symbol::Part { name, .. }
            | Symbol::Block { name, .. } => Some(name),
            Symbol::Member { of, .. } => of.name(),
            Symbol::System(_) | Symbol::Instruction(_) => None,
        }
    }

    /// The file that it belongs to; none if to the workspace, or to the language.
    pub(crate) fn file(&self) -> Option<&Arc<str>> {
        match self {
            Symbol::Tag { file, .. }
            | Symbol::Label { file, .. }
            | Symbol::Function { file, .. }
            | Symbol::Block { file, .. }
            | Symbol::Type { file, .. }
            | Symbol::Part { file, .. } => Some(file),
            Symbol::Member { of, .. } => of.file(),
            Symbol::Global(_) | Symbol::Address(_) | Symbol::System(_) | Symbol::Instruction(_) => None,
        }
    }
}
