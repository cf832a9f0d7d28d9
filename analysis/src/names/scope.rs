//! The tags that a file, or the body of a user-defined block, knows.

use crate::by_name::ByName;
use crate::context::Context;
use crate::declarations::DeclaredAt;
use crate::network::BoundBlock;
use crate::numbering::Numbering;
use crate::program::Role;
use crate::rare::Rare;
use crate::tags::Tags;
use crate::types::{Scalar, Type};
use crate::use_kind::{Deed, UseKind};
use ladder_syntax::{Name, TextRange};
use smallvec::SmallVec;
use smol_str::SmolStr;
use std::ops::Range;
use std::sync::Arc;

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

/// How a block uses a tag.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Access {
    Read,
    Write,
    ReadWrite,
}

impl Access {
    /// Whether the block reads it.
    pub const fn reads(self) -> bool {
        !matches!(self, Access::Write)
    }

    /// Whether the block writes it.
    pub const fn writes(self) -> bool {
        !matches!(self, Access::Read)
    }
}

/// One place where a tag is in an operand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Use {
    /// The network, as in the structure.
    pub network: usize,
    /// The block in it.
    pub block: usize,
    /// The operand in it.
    pub operand: usize,
    /// Where the tag's name is, from the start of the file.
    pub range: TextRange,
    /// How it is used.
    pub access: Access,
    /// Whether the tag as a whole is meant, not a member, bit or element.
    pub whole: bool,
    /// Whether an index or a range is behind it.
    pub indexed: bool,
}

/// A use as a tag keeps it: it stays true when other networks are above it, and says without a look at its block how the tag
/// is used.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct UseRef {
    /// The number of the network; see [`Networks`](crate::networks::Networks).
    pub(crate) network: u32,
    /// Which of the names in it, and in the lowest bits how it is used.
    named: u32,
}

impl UseRef {
    /// A name of a network, which has fewer than 2^25 of them: each takes two bytes of a file of at most 64 MiB.
    pub(crate) const fn new(network: u32, named: u32, kind: UseKind) -> UseRef {
        UseRef {
            network,
            named: named << UseKind::BITS | kind.bits(),
        }
    }

    /// Which of the names in its network.
    pub(crate) const fn named(self) -> u32 {
        self.named >> UseKind::BITS
    }

    /// Whether it reads or writes the tag.
    pub(crate) const fn access(self) -> Access {
        UseKind::from_bits(self.named).access()
    }

    /// What its block does with the operand.
    pub(crate) const fn deed(self) -> Deed {
        UseKind::from_bits(self.named).deed()
    }
}

/// Where a tag is used, from top to bottom. Most tags are used once or twice.
#[derive(Debug, Clone, Default)]
pub struct Uses(pub(crate) SmallVec<[UseRef; 2]>);

impl Uses {
    /// How many places there are.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether it is used nowhere.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The places that write it.
    pub(crate) fn writers(&self) -> impl Iterator<Item = UseRef> {
        self.0.iter().copied().filter(|place| place.access().writes())
    }

    /// How each place uses it.
    pub fn accesses(&self) -> impl Iterator<Item = Access> {
        self.0.iter().map(|place| place.access())
    }
}

impl Use {
    /// The block, wherever it is.
    pub(crate) fn bound(self, context: &Context) -> &BoundBlock {
        &context.networks.at(self.network).facts().blocks[self.block]
    }
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
    /// Its places alone say no type: it has that of its company, or of integers.
    pub(crate) by_company: bool,
    /// Declared RETAIN.
    pub retain: bool,
    /// Declared CONSTANT.
    pub constant: bool,
    /// Where it is declared; for one without a declaration see [`Context::place_of`].
    pub(crate) declared_at: DeclaredAt,
    /// Where it is used. A shared tag counts the uses in all scopes.
    pub uses: Uses,
    /// Initial values, an address, where it leads to.
    pub rare: Rare,
}

impl TagFacts {
    /// Whether its places and company give it its type: neither a declaration nor its name does.
    pub(crate) fn is_inferred(&self) -> bool {
        match self.origin {
            Origin::Undeclared => true,
            Origin::Form => type_by_form(&self.name).is_none(),
            Origin::Declared(_) | Origin::Implicit | Origin::Shared => false,
        }
    }

    /// Whether no place of it says its type.
    pub(crate) const fn depends_on_company(&self) -> bool {
        self.by_company || self.ty.is_none()
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
        self.rare.address.as_deref().map(Name::new)
    }

    /// Whether it is an entry for a tag of another scope, of which more is known there; see [`Context::leads_to`].
    pub fn leads_elsewhere(&self) -> bool {
        self.rare.lead.is_some()
    }

    /// Of a declared tag, whether it may be shared with other scopes or files, or has no type by its declaration.
    fn is_unusual(&self) -> bool {
        self.is_outward() || self.mistyped || self.ty.is_none() || self.leads_elsewhere()
    }

    /// Whether it is a tag of another file that this file names without a declaration: then it is where it is first used.
    pub(crate) fn is_imported_by_use(&self) -> bool {
        let nowhere = DeclaredAt::in_file(TextRange::default());
        self.rare.foreign.is_some() && !self.leads_elsewhere() && self.declared_at == nowhere
    }

    /// Whether it has a declaration.
    pub const fn is_declared(&self) -> bool {
        matches!(self.origin, Origin::Declared(_))
    }
}

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

/// The type and role that a name without a declaration says by its form (LANGUAGE §4): `I1`, `MF3`, `%QX1.7`.
pub fn type_by_form(name: &str) -> Option<(Scalar, Role)> {
    if let Some(address) = name.strip_prefix('%') {
        return type_by_address(address);
    }
    let upper = name.to_ascii_uppercase();
    let letters = upper.trim_end_matches(|c: char| c.is_ascii_digit());
    if letters.len() == upper.len() {
        return None;
    }
    match letters {
        "I" => Some((Scalar::Bool, Role::Input)),
        "Q" => Some((Scalar::Bool, Role::Output)),
        "M" => Some((Scalar::Bool, Role::Internal)),
        "MI" => Some((Scalar::Dint, Role::Internal)),
        "MF" => Some((Scalar::Lreal, Role::Internal)),
        _ => None,
    }
}

/// `IX0.3`: the area, the size, then numbers with points between.
fn type_by_address(address: &str) -> Option<(Scalar, Role)> {
    let upper = address.to_ascii_uppercase();
    let mut letters = upper.chars();
    let role = match letters.next()? {
        'I' => Role::Input,
        'Q' => Role::Output,
        'M' => Role::Internal,
        _ => return None,
    };
    let scalar = match letters.next()? {
        'X' => Scalar::Bool,
        'B' => Scalar::Byte,
        'W' => Scalar::Word,
        'D' => Scalar::Dword,
        'L' => Scalar::Lword,
        _ => return None,
    };
    let numbers = &upper[2..];
    let well_formed = !numbers.is_empty()
        && numbers
            .split('.')
            .all(|n| !n.is_empty() && n.bytes().all(|b| b.is_ascii_digit()));
    well_formed.then_some((scalar, role))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn forms() {
        for (name, expected) in [
            ("I1", Some((Scalar::Bool, Role::Input))),
            ("q12", Some((Scalar::Bool, Role::Output))),
            ("MI3", Some((Scalar::Dint, Role::Internal))),
            ("MF0", Some((Scalar::Lreal, Role::Internal))),
            ("I", None),
            ("I1a", None),
            ("%IX0.3", Some((Scalar::Bool, Role::Input))),
            ("%MW10", Some((Scalar::Word, Role::Internal))),
            ("%IX", None),
            ("%ZX1", None),
        ] {
            assert_eq!(type_by_form(name), expected, "{name}");
        }
    }
}
