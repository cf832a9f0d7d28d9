//! A tag: what its declaration says of it, and where it is used.

use crate::names::cold::Cold;
use crate::names::scope::type_by_form;
use crate::networks::use_place::Uses;
use crate::program::Role;
use crate::values::types::Type;
use ladder_syntax::{Name, TextRange};
use smol_str::SmolStr;

/// The section that a tag is declared in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum SectionKind {
    Var,
    Input,
    Output,
    InOut,
    Global,
    External,
}

impl SectionKind {
    /// The section that a keyword opens.
    pub fn from_keyword(keyword: &str) -> Option<SectionKind> {
        Some(match keyword.to_ascii_uppercase().as_str() {
            "VAR" => SectionKind::Var,
            "VAR_INPUT" => SectionKind::Input,
            "VAR_OUTPUT" => SectionKind::Output,
            "VAR_IN_OUT" => SectionKind::InOut,
            "VAR_GLOBAL" => SectionKind::Global,
            "VAR_EXTERNAL" => SectionKind::External,
            _ => return None,
        })
    }

    /// The keyword.
    pub const fn keyword(self) -> &'static str {
        match self {
            SectionKind::Var => "VAR",
            SectionKind::Input => "VAR_INPUT",
            SectionKind::Output => "VAR_OUTPUT",
            SectionKind::InOut => "VAR_IN_OUT",
            SectionKind::Global => "VAR_GLOBAL",
            SectionKind::External => "VAR_EXTERNAL",
        }
    }
}

/// Where a tag comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Origin {
    /// A declaration in this section.
    Declared(SectionKind),
    /// A direct address, or a name that says its type (`I1`, `MF3`).
    Form,
    /// `EN` and `ENO` in a block's body.
    Implicit,
    /// It is only used.
    Undeclared,
    /// A tag of another scope or file: a VAR_GLOBAL tag, or a direct address in a block's body.
    Shared,
}

/// A tag of a scope.
#[derive(Debug, Clone)]
pub struct TagFacts {
    /// As declared, or as first written.
    pub name: SmolStr,
    /// Its type. None until it is inferred.
    pub ty: Option<Type>,
    /// Input, output or neither.
    pub role: Role,
    /// Where it comes from.
    pub origin: Origin,
    /// Its declared type could not be read, or it is declared in two ways. No finding is about the type that it has
    /// at its places.
    pub mistyped: bool,
    /// Declared RETAIN.
    pub retain: bool,
    /// Declared CONSTANT.
    pub constant: bool,
    /// Where it is declared; for one without a declaration see [`Context::place_of`](crate::names::context::Context::place_of).
    pub(crate) declared_at: TextRange,
    /// Where it is used. A shared tag counts the uses in all scopes.
    pub uses: Uses,
    /// Initial values, an address, where it leads to.
    pub cold: Cold,
}

impl TagFacts {
    /// Whether its places give it its type: neither a declaration nor its name does.
    pub(crate) fn is_inferred(&self) -> bool {
        match self.origin {
            Origin::Undeclared => true,
            Origin::Form => type_by_form(&self.name).is_none(),
            Origin::Declared(_) | Origin::Implicit | Origin::Shared => false,
        }
    }

    /// Whether the same name in another file may mean this tag: then it is not the file's alone.
    pub(crate) const fn is_outward(&self) -> bool {
        !matches!(
            self.origin,
            Origin::Implicit
                | Origin::Declared(
                    SectionKind::Var | SectionKind::Input | SectionKind::Output | SectionKind::InOut
                )
        )
    }

    /// Its direct address, as it is compared.
    pub(crate) fn address(&self) -> Option<Name> {
        self.cold.address.as_deref().map(Name::new)
    }

    /// Whether it is an entry for a tag of another scope, of which more is known there; see [`Context::alias_of`](crate::names::context::Context::alias_of).
    pub fn is_alias(&self) -> bool {
        self.cold.alias_of.is_some()
    }

    /// Of a declared tag, whether it may be shared with other scopes or files, or has no type by its declaration.
    pub(super) fn is_unusual(&self) -> bool {
        self.is_outward() || self.mistyped || self.ty.is_none() || self.is_alias()
    }

    /// Whether it is a tag of another file that this file names without a declaration: then it is where it is first used.
    pub(crate) fn is_imported_by_use(&self) -> bool {
        self.cold.foreign.is_some() && !self.is_alias() && self.declared_at == TextRange::default()
    }

    /// Whether it has a declaration.
    pub const fn is_declared(&self) -> bool {
        matches!(self.origin, Origin::Declared(_))
    }
}
