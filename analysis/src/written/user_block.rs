//! Definitions of user-defined blocks: name, shape, parameters (LANGUAGE §5.7).

use crate::program::{ParameterKind, Unread};
use crate::values::types::Type;
use crate::written::import::Import;
use crate::written::type_spec::Declared;
use ladder_instructions::Shape;
use ladder_syntax::{Name, TextRange};
use rustc_hash::FxHasher;
use std::hash::{Hash, Hasher};
use std::sync::Arc;

/// A block definition as its header and declarations give it.
#[derive(Debug, Clone)]
pub struct UserBlockFacts {
    /// As written, with the `$`.
    pub name: String,
    /// As it is compared.
    pub key: Name,
    /// The shape that the header shows.
    pub shape: Shape,
    /// Where the header's first part is.
    pub at: TextRange,
    /// Its header or a declaration could not be read: its operands are not all known.
    pub doubtful: bool,
    /// The operands in the order of their declaration.
    pub parameters: Vec<Parameter>,
    /// What is known of it where it is an unread part.
    pub unread: Option<Arc<Unread>>,
    /// Where it is defined, if in another file. Its places are those of that file.
    pub import: Option<Import>,
}

impl UserBlockFacts {
    /// The file that defines it, if it is another one.
    pub fn file(&self) -> Option<&Arc<str>> {
        self.import.as_ref().map(|import| &import.file)
    }

    /// Whether a caller sees no difference.
    pub(crate) fn looks_like(&self, other: &UserBlockFacts) -> bool {
        let parameters = self.parameters.iter().zip(&other.parameters);
        (
            &self.name,
            self.shape,
            self.doubtful,
            self.parameters.len(),
            &self.unread,
        ) == (
            &other.name,
            other.shape,
            other.doubtful,
            other.parameters.len(),
            &other.unread,
        ) && parameters.into_iter().all(|(a, b)| a == b)
    }
}

/// A number that stands for what callers see of a file's blocks.
pub(crate) fn signatures(blocks: &[UserBlockFacts]) -> u64 {
    let mut hasher = FxHasher::default();
    for block in blocks {
        (&block.name, block.shape, block.doubtful, &block.unread).hash(&mut hasher);
        for parameter in &block.parameters {
            let Parameter {
                name,
                ty,
                tag,
                kind,
                has_default,
                ..
            } = parameter;
            (name, ty, tag, kind, has_default).hash(&mut hasher);
        }
    }
    hasher.finish()
}

/// A parameter of a user-defined block.
#[derive(Debug, Clone, PartialEq)]
pub struct Parameter {
    /// As declared.
    pub name: String,
    /// As it is compared.
    pub key: Name,
    /// Its type; none if that cannot be read.
    pub ty: Option<Type>,
    /// What its declaration says of its type, if that is more than an elementary type, a state or an array of elementary values.
    pub declared: Option<Arc<Declared>>,
    /// The tag in the body's scope.
    pub tag: usize,
    /// How it is passed.
    pub kind: ParameterKind,
    /// It may be left out.
    pub has_default: bool,
}
