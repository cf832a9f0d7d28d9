//! Which tags need a declaration; where it goes is for [`Places`] to say.

use crate::names::context::Context;
use crate::names::scope::SectionKind;

pub use crate::names::declaring::Places;

/// A tag that needs a declaration.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Undeclared {
    /// The section that its uses ask for.
    pub section: SectionKind,
    /// As first written.
    pub name: String,
    /// Its type.
    pub ty: String,
}

/// The tags of a scope that need a declaration and whose places say enough to make one, in the order of their first use.
pub fn undeclared(context: &Context, scope: usize) -> Vec<Undeclared> {
    crate::rules::undeclared_tag::undeclared(context, scope)
}

/// Whether a tag of a scope is one of [`undeclared()`].
pub fn can_be_declared(context: &Context, scope: usize, tag: usize) -> bool {
    crate::rules::undeclared_tag::can_be_declared(context, scope, &context.scopes[scope].tags[tag])
}
