//! The tags that a file, or the body of a user-defined block, knows.

pub use super::tag_facts::{Origin, SectionKind, TagFacts};
pub use super::type_by_form::type_by_form;

use crate::values::types::Type;
use ladder_syntax::{Name, TextRange};
use rustc_hash::FxHashMap;

/// A scope by its number, and a tag in it.
pub(crate) type Entry = (usize, usize);

/// The tags of a file or of a block's body.
#[derive(Debug, Clone, Default)]
pub struct Scope {
    /// In the order of declaration, then of first use.
    pub tags: Vec<TagFacts>,
    /// By name, and of those that the file declares also by the address at which they are declared.
    by_name: FxHashMap<Name, u32>,
    /// So many of the tags were there before any use was entered.
    pub(crate) declared: usize,
    /// The block definition whose body it is.
    pub block: Option<usize>,
}

impl Scope {
    /// The tag of a name.
    pub fn find(&self, name: &Name) -> Option<usize> {
        self.by_name.get(name).map(|tag| *tag as usize)
    }

    /// The tags that may be shared with other scopes or files, or have no type by their declaration, with their indices. In
    /// most programs those are few.
    pub(crate) fn unusual(&self) -> impl Iterator<Item = (usize, &TagFacts)> {
        let all = self.tags.iter().enumerate();
        all.filter(|(index, tag)| *index >= self.declared || tag.is_unusual())
    }

    /// Makes room for so many declared tags.
    pub(crate) fn reserve_declared(&mut self, tags: usize) {
        self.tags.reserve(tags);
        self.by_name.reserve(tags);
    }

    /// Adds a tag before any use is entered, by its name; the first one of a name is found by it.
    pub(crate) fn declare(&mut self, name: Name, tag: TagFacts) -> usize {
        let index = self.push(name, tag);
        self.declared = self.tags.len();
        index
    }

    /// Adds a tag that a use brings in. One that is declared by this name is still found by it.
    pub(crate) fn add(&mut self, tag: TagFacts) -> usize {
        self.push(Name::new(&tag.name), tag)
    }

    fn push(&mut self, name: Name, tag: TagFacts) -> usize {
        let index = self.tags.len();
        self.by_name.entry(name).or_insert(index as u32);
        self.tags.push(tag);
        index
    }

    /// Lets a tag be found by its direct address too; the first one at an address is.
    pub(crate) fn find_by_address(&mut self, address: &str, index: usize) {
        self.by_name.entry(Name::new(address)).or_insert(index as u32);
    }

    /// The user-defined blocks whose states its own tags are, with the places of these. In-outs are tags of others.
    pub(crate) fn block_states(&self) -> Vec<(Name, TextRange)> {
        let in_out = Origin::Declared(SectionKind::InOut);
        let own = self.tags.iter().take(self.declared);
        let own = own.filter(|tag| tag.is_declared() && tag.origin != in_out);
        let blocks = own.flat_map(|tag| {
            let blocks = tag.ty.map(Type::blocks).unwrap_or_default();
            blocks
                .into_iter()
                .map(|block| (Name::new(&block), tag.declared_at))
        });
        blocks.collect()
    }

    /// Whether the scope has at least one declaration.
    pub fn declares(&self) -> bool {
        self.tags.iter().take(self.declared).any(TagFacts::is_declared)
    }
}
