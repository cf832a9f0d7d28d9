//! What is wrong with the names of a file, as it is found while they are joined: plain values, which the rules
//! `bad-declaration`, `duplicate-declaration` and those about literals put into sentences.

use super::scope::Entry;
use crate::other_files::exports::Global;
use crate::written::constant::ConstantProblem;
use ladder_syntax::TextRange;
use smol_str::SmolStr;
use std::sync::Arc;

/// Something wrong with a declaration, or with how scopes and files agree on a tag.
#[derive(Debug, Clone)]
pub(crate) enum NameProblem {
    /// A declaration that is well formed and means nothing: where, and why.
    Meaningless(TextRange, String),
    /// An initial value that does not fit its type.
    InitialValue(ConstantProblem),
    /// A name that its scope declares a second time.
    Twice {
        name: SmolStr,
        at: TextRange,
        first: SmolStr,
        first_at: TextRange,
    },
    /// A section of types in the definition of a block: where its first line is.
    TypesInBlock(TextRange),
    /// A section `VAR_IN_OUT` that is in no block's body: where its first line is.
    InOutsOfProgram(TextRange),
    /// A type that the file declares a second time.
    TypeTwice {
        name: SmolStr,
        at: TextRange,
        first_at: TextRange,
    },
    /// A type that several other files declare, and not alike.
    TypeOfFiles {
        name: SmolStr,
        at: TextRange,
        files: Vec<(Arc<str>, TextRange)>,
    },
    /// A type that nobody declares, and the one that is probably meant.
    UnknownType {
        name: SmolStr,
        at: TextRange,
        near: Option<SmolStr>,
    },
    /// A type that contains itself, by way of these.
    RecursiveType { names: Vec<SmolStr>, at: TextRange },
    /// A VAR_GLOBAL tag that the file declares a second time, otherwise.
    GlobalOtherwise {
        tag: Entry,
        first: Entry,
        differs: Differs,
    },
    /// A VAR_GLOBAL tag that another file declares otherwise.
    OtherwiseInFile {
        tag: Entry,
        other: InFile,
        differs: Differs,
    },
    /// A tag of other files, which do not declare it alike.
    FilesDiffer {
        tag: Entry,
        first: InFile,
        second: InFile,
    },
    /// A VAR_EXTERNAL tag that nothing declares as VAR_GLOBAL.
    NoGlobal { tag: Entry },
    /// A VAR_EXTERNAL tag of another type than the global.
    ExternalOtherwise {
        name: SmolStr,
        at: TextRange,
        ty: Option<crate::values::types::Type>,
        global: Entry,
    },
}

/// What one declaration says otherwise than another.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Differs {
    Type,
    Value,
    Address,
}

/// A declaration in another file.
#[derive(Debug, Clone)]
pub(crate) struct InFile {
    pub(crate) file: Arc<str>,
    pub(crate) global: Global,
}
