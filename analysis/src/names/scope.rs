//! The tags that a file, or the body of a user-defined block, knows.

pub use super::tag_facts::{Origin, SectionKind, TagFacts};
pub use super::type_by_form::type_by_form;
pub(crate) use super::use_place::UseRef;
pub use super::use_place::{Access, Use, Uses};

use crate::by_name::ByName;
use crate::numbering::Numbering;
use crate::tags::Tags;
use ladder_syntax::Name;
use smallvec::SmallVec;
use std::ops::Range;
use std::sync::Arc;

/// More tags that uses have brought in are not exchanged one by one.
pub(crate) const MOST_EXCHANGED: usize = 16;

/// The tags of a file or of a block's body.
#[derive(Debug, Clone, Default)]
pub struct Scope {
    /// In the order of declaration, then of first use.
    pub tags: Tags,
    /// The tags that were there before any use was looked at, by name, and by the address at which they are declared.
    declared_names: ByName<u32>,
    /// By which numbers those names lead to the tags.
    numbering: Arc<Numbering>,
    /// Those that a use has brought in, by name.
    found_names: ByName<u32>,
    /// By which numbers those names lead to the tags, counted from the first of them.
    found_numbering: Arc<Numbering>,
    /// So many of the tags were there before any use was looked at.
    pub(crate) declared: usize,
    /// One of these may be shared with other scopes or files, or its declaration leaves its type open.
    unusual: bool,
    /// Those that are declared at an address.
    addressed: Vec<Name>,
    /// The block definition whose body it is.
    pub block: Option<usize>,
}

impl Scope {
    /// The tag of a name.
    pub fn find(&self, name: &Name) -> Option<usize> {
        let number = || self.found_names.get(name);
        let found = || Some(self.declared + self.found_numbering.index(number()?)?);
        self.find_declared(name).or_else(found)
    }

    /// The tags that may be shared with other scopes or files, or have no type by their declaration, with their indices; maybe
    /// also others. In most programs those are few.
    pub(crate) fn unusual(&self) -> impl Iterator<Item = (usize, &TagFacts)> {
        let first = if self.unusual { 0 } else { self.declared };
        (first..).zip(self.tags.from(first))
    }

    /// The type of a declared tag is open.
    pub(crate) fn set_mistyped(&mut self, tag: usize) {
        self.unusual = true;
        self.tags[tag].mistyped = true;
    }

    fn find_declared(&self, name: &Name) -> Option<usize> {
        self.numbering.index(self.declared_names.get(name)?)
    }

    /// Puts other declared tags in the place of some. Their names are for [`Scope::rename`] to say.
    pub(crate) fn exchange_declared(&mut self, old: Range<usize>, new: Vec<Arc<TagFacts>>) {
        if old.len() != new.len() {
            Arc::make_mut(&mut self.numbering).exchange(old.clone(), new.len());
            self.declared = self.declared - old.len() + new.len();
        }
        self.unusual |= new.iter().any(|tag| tag.is_unusual());
        self.tags.splice(old, new);
    }

    /// A declared tag is found by a name, or none any longer.
    pub(crate) fn rename(&mut self, name: Name, tag: Option<usize>) {
        let tag = tag.map(|tag| self.numbering.number(tag));
        self.declared_names.set(name, tag);
    }

    /// The scope as it was before any use was looked at. None if what was found since has changed a declared tag.
    pub(crate) fn as_declared(&self) -> Option<Scope> {
        let plain = |tag: &TagFacts| {
            let common = Origin::Declared(SectionKind::Global) == tag.origin
                || Origin::Declared(SectionKind::External) == tag.origin;
            !common && !tag.leads_elsewhere() && !tag.mistyped
        };
        let declared = self.tags.iter().take(self.declared);
        if !declared.clone().all(plain) {
            return None;
        }
        let addressed = declared.clone().filter(|tag| tag.rare.address.is_some());
        let addressed = addressed.map(|tag| Name::new(&tag.name)).collect();
        let declared = declared.map(|tag| TagFacts {
            name: tag.name.clone(),
            rare: tag.rare.clone(),
            uses: Uses(SmallVec::with_capacity(tag.uses.len())),
            ..*tag
        });
        let mut tags = Tags::default();
        declared.for_each(|tag| tags.push(tag));
        Some(Scope {
            tags,
            declared_names: self.declared_names.clone(),
            numbering: Arc::clone(&self.numbering),
            found_names: ByName::default(),
            found_numbering: Arc::default(),
            declared: self.declared,
            unusual: false,
            addressed,
            block: self.block,
        })
    }

    /// Makes room for so many declared tags.
    pub(crate) fn reserve_declared(&mut self, tags: usize) {
        self.declared_names.reserve(tags);
        Arc::make_mut(&mut self.numbering).reserve(tags);
    }

    /// Adds a tag before any use is looked at, by its name; the first one of a name is found by it.
    pub(crate) fn declare(&mut self, name: Name, tag: TagFacts) -> usize {
        let number = Arc::make_mut(&mut self.numbering).push();
        if tag.rare.address.is_some() {
            self.addressed.push(name.clone());
        }
        self.declared_names.add(name, number);
        self.unusual |= tag.is_unusual();
        self.tags.push(tag);
        self.declared = self.tags.len();
        self.declared - 1
    }

    /// Adds a tag that a use brings in.
    pub(crate) fn add(&mut self, tag: TagFacts) -> usize {
        self.add_found(Arc::new(tag))
    }

    fn add_found(&mut self, tag: Arc<TagFacts>) -> usize {
        let index = self.tags.len();
        let number = Arc::make_mut(&mut self.found_numbering).push();
        self.found_names.add(Name::new(&tag.name), number);
        self.tags.extend([tag]);
        index
    }

    /// Takes some of the tags that uses have brought in out of their places, and puts those that are still used and new ones
    /// to the places that a key says: all others are in the order of the key.
    pub(crate) fn exchange_found<K: Ord>(
        &mut self,
        touched: &[usize],
        mut new: Vec<Arc<TagFacts>>,
        key: impl Fn(&TagFacts) -> Option<K>,
    ) {
        if touched.len() + new.len() > MOST_EXCHANGED {
            let mut all = self.tags.split_off(self.declared);
            all.extend(new);
            all.retain(|tag| !tag.uses.is_empty());
            all.sort_by_cached_key(|tag| key(tag));
            self.found_names = ByName::default();
            self.found_numbering = Arc::default();
            for tag in all {
                self.add_found(tag);
            }
            return;
        }
        for &tag in touched.iter().rev() {
            let gone = self.tags.take(tag);
            self.exchange_found_names(tag, 1, 0);
            let name = Name::new(&gone.name);
            self.found_names.set(name, None);
            if !gone.uses.is_empty() {
                new.push(gone);
            }
        }
        for tag in new {
            let own = key(&tag);
            let (mut low, mut high) = (self.declared, self.tags.len());
            while low < high {
                let middle = low.midpoint(high);
                if key(&self.tags[middle]) < own {
                    low = middle + 1;
                } else {
                    high = middle;
                }
            }
            self.exchange_found_names(low, 0, 1);
            let number = self.found_numbering.number(low - self.declared);
            self.found_names.set(Name::new(&tag.name), Some(number));
            self.tags.splice(low..low, [tag]);
        }
    }

    fn exchange_found_names(&mut self, at: usize, old: usize, new: usize) {
        let at = at - self.declared;
        Arc::make_mut(&mut self.found_numbering).exchange(at..at + old, new);
    }

    /// Lets a tag be found by its direct address too; the first one at an address is.
    pub(crate) fn find_by_address(&mut self, address: &str, index: usize) {
        let number = self.numbering.number(index);
        self.declared_names.add(Name::new(address), number);
    }

    /// The tags that are declared at an address, as far as the whole text was read for them.
    pub(crate) fn addressed(&self) -> &[Name] {
        &self.addressed
    }

    /// Whether the scope has at least one declaration.
    pub fn declares(&self) -> bool {
        self.tags.iter().take(self.declared).any(TagFacts::is_declared)
    }
}
