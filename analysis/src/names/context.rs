//! All that is known of a file before its program is put together: what rules and the editor's features read.

use crate::findings::foreign_comment::ForeignComments;
use crate::names::at_address::AtAddress;
use crate::names::joined::{Joined, NamedTags};
use crate::names::named_types::NamedTypes;
use crate::names::problem::NameProblem;
use crate::names::scope::{Entry, Origin, Scope, TagFacts};
use crate::names::unread_uses::UnreadUses;
use crate::networks::control_flow::ControlFlow;
use crate::networks::network::BoundBlock;
use crate::networks::use_place::Use;
use crate::networks::{NetworkAt, Networks};
use crate::other_files::others::Others;
use crate::program::{LoopEnds, loops};
use crate::written::import::Import;
use crate::written::user_block::UserBlockFacts;
use ladder_instructions::Profile;
use ladder_syntax::{LineIndex, Name, Parse, TextRange, TextSize};
use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use std::sync::{Arc, OnceLock};

/// A file's names, networks and blocks.
#[derive(Debug, Clone)]
pub struct Context {
    /// The parse that all of it was read off.
    pub parse: Arc<Parse>,
    /// What messages call the file.
    pub name: Arc<str>,
    /// Whose arithmetic and timing the program has.
    pub profile: Profile,
    /// The time from one scan to the next that it is made for, in nanoseconds, where it says so.
    pub cycle: Option<i64>,
    /// The networks, as in the structure.
    pub networks: Networks,
    /// The file's scope, then one for each block definition.
    pub scopes: Vec<Scope>,
    /// What is wrong with the names, as far as it was seen while they were joined.
    pub(crate) problems: Vec<NameProblem>,
    /// Which names mean one direct address.
    pub(crate) at_address: AtAddress,
    /// The definitions of user-defined blocks: the file's own as in the structure, then those of other files that
    /// it uses.
    pub user_blocks: Vec<UserBlockFacts>,
    /// How many of them are its own.
    pub own_blocks: usize,
    /// The types that it can name.
    pub types: NamedTypes,
    /// Stands for what callers see of its own blocks.
    pub(crate) signatures: u64,
    /// The functions in the order of the text.
    pub functions: Vec<FunctionFacts>,
    /// The labels in the order of the text.
    pub labels: Vec<LabelFacts>,
    /// For each network the body it belongs to.
    pub bodies: Vec<Body>,
    /// The other files of the workspace.
    pub others: Others,
    pub(crate) foreign_comments: OnceLock<ForeignComments>,
    /// What its unread parts may do with its tags.
    pub(crate) unread: UnreadUses,
    /// What the names of its networks mean.
    pub(crate) joined: Joined,
    /// The labels of each body by name, in the order of the text.
    pub(crate) labels_by_name: FxHashMap<(Body, Name), Vec<usize>>,
    pub(crate) functions_by_name: FxHashMap<Name, usize>,
}

/// What a network belongs to. A label is seen within its own body only.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Body {
    /// The main program.
    Main,
    /// A function, by its index.
    Function(usize),
    /// A block definition, by its index.
    Block(usize),
}

/// What a `<CALL>` calls.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Callee {
    /// A function of the file itself, by its index.
    Own(usize),
    /// A function of another file.
    Other(Import),
}

/// A `<FUN>`.
#[derive(Debug, Clone)]
pub struct FunctionFacts {
    /// As written.
    pub name: SmolStr,
    /// As it is compared.
    pub key: Name,
    /// The network that holds the `<FUN>`.
    pub network: usize,
    /// Where the name is.
    pub at: TextRange,
}

/// A `<LBL>`.
#[derive(Debug, Clone)]
pub struct LabelFacts {
    /// As written.
    pub name: SmolStr,
    /// As it is compared.
    pub key: Name,
    /// The network that it marks.
    pub network: usize,
    /// Where the name is.
    pub at: TextRange,
}

impl Context {
    /// Whether an operand of the file names a value of a type, as in `Phase.IDLE`.
    pub(crate) fn names_value_of(&self, ty: &Name) -> bool {
        let names = |network: NetworkAt<'_>| network.facts().named.iter().any(|named| named.key == *ty);
        self.networks.iter().any(names)
    }

    /// Whether messages call the file so.
    pub fn is_called(&self, name: &str) -> bool {
        *self.name == *name
    }

    /// The physical line of an offset, from 1: what messages name.
    pub fn line_number(&self, offset: TextSize) -> usize {
        let Some(line) = self.parse.line_at(offset) else {
            return 1;
        };
        let mut number = self.parse.lines().line_ends_above(line) as usize + 1;
        let found = &self.parse.lines()[line];
        let text = found.text();
        // Nearly every line has an end at its end and no other: then its length is nothing to look through.
        let own = u32::from(text.ends_with(['\n', '\r']));
        if found.line_ends > own {
            let within = usize::from(offset - self.parse.line_start(line));
            number += LineIndex::new(text).line(TextSize::new(within as u32));
        }
        number
    }

    /// Comments as other languages write them.
    pub(crate) fn foreign_comments(&self) -> &ForeignComments {
        self.foreign_comments
            .get_or_init(|| ForeignComments::find(&self.parse, |line| self.is_drawn(line)))
    }

    /// Whether a logical line is a rung of a network all of whose connectors have their partners.
    fn is_drawn(&self, line: usize) -> bool {
        let after = self
            .networks
            .partition_point(|network| network.first_line <= line);
        let Some(network) = after.checked_sub(1).map(|index| self.networks.at(index)) else {
            return false;
        };
        let offset = line - network.first_line;
        network.wiring.unpaired.is_empty() && network.wiring.line_offsets.binary_search(&offset).is_ok()
    }

    /// Where a tag is declared, or first used.
    pub fn place_of(&self, tag: &TagFacts) -> TextRange {
        if let Some((scope, target)) = self.alias_of(tag).filter(|_| !tag.is_declared()) {
            return self.place_of(&self.scopes[scope].tags[target]);
        }
        let first = || self.uses(tag).next();
        match tag.origin {
            Origin::Undeclared | Origin::Form => first().map_or_else(|| tag.declared_at, |place| place.range),
            Origin::Shared if tag.is_imported_by_use() => {
                first().map_or_else(|| tag.declared_at, |place| place.range)
            }
            Origin::Declared(_) | Origin::Implicit | Origin::Shared => tag.declared_at,
        }
    }

    /// Where a tag is used, from top to bottom.
    pub fn uses<'c>(&'c self, tag: &'c TagFacts) -> impl DoubleEndedIterator<Item = Use> + Clone + use<'c> {
        tag.uses.0.iter().map(|place| self.networks.use_of(*place))
    }

    /// The tag in whose scope more is known of one that several scopes share; else the tag itself.
    pub fn shared<'c>(&'c self, tag: &'c TagFacts) -> &'c TagFacts {
        self.alias_of(tag)
            .map_or(tag, |(scope, tag)| &self.scopes[scope].tags[tag])
    }

    /// The names of a network, with the tags that they mean.
    pub(crate) fn names_of<'c>(&'c self, network: NetworkAt<'c>) -> NamedTags<'c> {
        self.joined.names(network.index, &network.facts().named)
    }

    /// The block at a place where a tag is used.
    pub(crate) fn block_at(&self, place: &Use) -> &BoundBlock {
        &self.networks.facts(place.network).blocks[place.block]
    }

    /// The scope of the tag that an entry leads to, and which of its tags it is.
    pub fn alias_of(&self, entry: &TagFacts) -> Option<Entry> {
        entry.cold.alias_of
    }

    /// Where a tag is written, from top to bottom.
    pub fn writers<'c>(
        &'c self,
        tag: &'c TagFacts,
    ) -> impl DoubleEndedIterator<Item = Use> + Clone + use<'c> {
        let writers = tag.uses.0.iter().filter(|place| place.access().writes());
        writers.map(|place| self.networks.use_of(*place))
    }

    /// The networks in the bodies of block definitions, with the blocks.
    pub(crate) fn networks_of_blocks(&self) -> impl Iterator<Item = (NetworkAt<'_>, usize)> {
        let bodies = self.bodies.iter().enumerate();
        bodies.filter_map(|(network, body)| match body {
            Body::Block(block) => Some((self.networks.at(network), *block)),
            Body::Main | Body::Function(_) => None,
        })
    }

    /// The tags that have a direct address.
    pub(crate) fn addressed(&self) -> impl Iterator<Item = &TagFacts> {
        let all = self.scopes.iter().flat_map(|scope| &scope.tags);
        all.filter(|tag| tag.cold.address.is_some() && !tag.is_alias())
    }

    /// The other tags of the file that are at the same direct address: together they are one tag.
    pub(crate) fn others_at_address<'c>(
        &'c self,
        tag: &'c TagFacts,
    ) -> impl Iterator<Item = &'c TagFacts> + use<'c> {
        let all = self.at_address.all(tag).iter();
        let tags = all.map(|(scope, other)| &self.scopes[*scope].tags[*other]);
        tags.filter(|other| !std::ptr::eq(*other, tag))
    }

    /// Whether a tag stands for all at its direct address: of most tags that is so.
    pub(crate) fn is_first_at_address(&self, tag: &TagFacts) -> bool {
        let first = self.at_address.all(tag).first();
        first.is_none_or(|(scope, first)| std::ptr::eq(&raw const self.scopes[*scope].tags[*first], tag))
    }

    /// The tag that stands for all at a tag's direct address: of most tags that is the tag itself.
    pub(crate) fn first_at_address(&self, (scope, tag): Entry) -> Entry {
        let all = self.at_address.all(&self.scopes[scope].tags[tag]);
        all.first().copied().unwrap_or((scope, tag))
    }

    /// The loops: the network of each `<FOR>` with that of its `<NEXT>`, see [`loops`].
    pub fn loops(&self) -> Vec<(usize, usize)> {
        let mut of_bodies: FxHashMap<Body, Vec<LoopEnds>> = FxHashMap::default();
        for network in &self.networks {
            let ends = LoopEnds {
                network: network.index,
                begins: network.control_flow.has(ControlFlow::FOR),
                ends: network.control_flow.has(ControlFlow::NEXT),
            };
            if ends.begins || ends.ends {
                let body = self.bodies[network.index];
                of_bodies.entry(body).or_default().push(ends);
            }
        }
        of_bodies.into_values().flat_map(loops).collect()
    }

    /// The network that a jump from `network` to a label goes to: the nearest after it, else the nearest
    /// before it or itself (LANGUAGE §5.5).
    pub fn jump_target(&self, network: usize, label: &Name) -> Option<usize> {
        self.jump_label(network, label).map(|(target, _)| target)
    }

    /// As `jump_target`, with the label's name as it is kept here.
    pub(crate) fn jump_label(&self, network: usize, label: &Name) -> Option<(usize, &Name)> {
        let key = (self.bodies[network], label.clone());
        let (key, labels) = self.labels_by_name.get_key_value(&key)?;
        let after = labels.partition_point(|&label| self.labels[label].network <= network);
        let label = labels.get(after).or_else(|| labels.last())?;
        Some((self.labels[*label].network, &key.1))
    }

    /// The function of a name.
    pub fn function(&self, name: &Name) -> Option<usize> {
        self.functions_by_name.get(name).copied()
    }

    /// The function that a `<CALL>` of a name calls: the file's own, else that of another file.
    pub fn callee(&self, name: &Name) -> Option<Callee> {
        if let Some(own) = self.function(name) {
            return Some(Callee::Own(own));
        }
        let (file, function) = self.others.functions(name).next()?;
        Some(Callee::Other(Import {
            file: Arc::clone(&file.file),
            item: function.item,
        }))
    }
}
