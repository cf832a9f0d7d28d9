//! All that is known of a file before its program is put together: what rules and the editor's features read.

use crate::at_address::AtAddress;
use crate::by_name::ByName;
use crate::declarations::Declarations;
use crate::declaring::PlacesOfScopes;
use crate::edited;
use crate::edited::may_settle;
use crate::exports::{self, Global};
use crate::foreign_comment::ForeignComments;
use crate::infer;
use crate::joined::Joined;
use crate::misdeclared::Misdeclared;
use crate::networks::{NetworkAt, Networks};
use crate::others::{Import, Others};
use crate::outward::{self, TagUse};
use crate::rare::Lead;
use crate::rule::Severity;
use crate::scope::{Origin, Scope, TagFacts, Use, UseRef};
use crate::shared;
use crate::skeleton;
use crate::still_wanted::StillWanted;
use crate::types::Type;
use crate::use_kind::Deed;
use crate::user_block::UserBlockFacts;
use crate::uses;
use crate::wrong_globals::WrongGlobals;
use ladder_instructions::Profile;
use ladder_syntax::{LineIndex, Name, Parse, TextRange, TextSize};
use rustc_hash::{FxHashMap, FxHashSet};
use smol_str::SmolStr;
use std::collections::BTreeSet;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, OnceLock};

/// A file's names, networks and blocks.
#[derive(Debug, Clone)]
pub struct Context {
    /// The parse that all of it was read off.
    pub parse: Arc<Parse>,
    /// What messages call the file.
    pub name: Arc<str>,
    /// Which context this is: no two have the same number.
    pub(crate) serial: u64,
    /// What is other than in the context that it was made from, if that is known.
    pub(crate) change: Option<Change>,
    /// What is wrong with tags for all files.
    pub(crate) wrong_globals: Arc<WrongGlobals>,
    /// Whose arithmetic and timing the program has.
    pub profile: Profile,
    /// The time from one scan to the next that it is made for, in nanoseconds, where it says so.
    pub cycle: Option<i64>,
    /// The networks, as in the structure.
    pub networks: Networks,
    /// The file's scope, then one for each block definition.
    pub scopes: Vec<Scope>,
    /// Where the lines of declarations are.
    pub(crate) declarations: Arc<Declarations>,
    /// What is wrong with them but for what the parser says.
    pub(crate) misdeclared: Arc<Misdeclared>,
    /// Which names mean one direct address.
    pub(crate) at_address: AtAddress,
    /// The line behind the last section, and behind the last first line of a block definition.
    pub(crate) declared_to: usize,
    /// An edit between the declarations and the end changes what it names, and nothing else; see [`edited`].
    pub(crate) settled: bool,
    /// If it is settled: a network of it calls, jumps, or holds a block of which the file has no definition, so that other files
    /// decide about what is found in it.
    pub(crate) asks_others: bool,
    /// If it is settled: the tags whose declared type is open, by scope and name.
    pub(crate) mistyped: Vec<(usize, Name)>,
    /// If it is settled: the tags on which a block keeps its state and that may be those of other files too.
    pub(crate) outward_states: BTreeSet<Name>,
    /// If it is settled: the names by which bodies of user-defined blocks name tags that they do not declare for themselves. They
    /// stay until it is read as a whole.
    pub(crate) named_in_bodies: Arc<FxHashSet<Name>>,
    /// Its VAR_GLOBAL tags, once somebody asks.
    pub(crate) globals: OnceLock<Arc<Vec<Global>>>,
    /// How it uses tags that it does not declare for itself, once somebody asks.
    pub(crate) outward_tags: OnceLock<ByName<TagUse>>,
    /// The numbers of the networks that call a function.
    pub(crate) calling: Arc<FxHashSet<u32>>,
    /// Without it no network jumps.
    pub(crate) may_jump: bool,
    /// Sections and block definitions begin and end where they should.
    pub(crate) is_framed: bool,
    /// The definitions of user-defined blocks: the file's own as in the structure, then those of other files that
    /// it uses.
    pub user_blocks: Vec<UserBlockFacts>,
    /// How many of them are its own.
    pub own_blocks: usize,
    /// Stands for what callers see of its own blocks.
    pub(crate) signatures: u64,
    /// The functions in the order of the text.
    pub functions: Vec<FunctionFacts>,
    /// The labels in the order of the text.
    pub labels: Vec<LabelFacts>,
    /// For each network the body it belongs to. Texts before and behind an edit share the list while it stays.
    pub bodies: Arc<Vec<Body>>,
    /// The other files of the workspace.
    pub others: Others,
    pub(crate) foreign_comments: OnceLock<ForeignComments>,
    /// What the names of its networks mean, if they were joined for the whole file and no edit has come since.
    pub(crate) joined: Option<Arc<Joined>>,
    /// Where declarations go that fixes add.
    pub(crate) places: PlacesOfScopes,
    /// The labels of each body by name, in the order of the text.
    pub(crate) labels_by_name: Arc<FxHashMap<(Body, Name), Vec<usize>>>,
    pub(crate) functions_by_name: Arc<FxHashMap<Name, usize>>,
}

/// What a context has that the one before it has not, so that whoever looked at that one looks at no more than this.
#[derive(Debug, Clone, Default)]
pub(crate) struct Change {
    /// The number of the context before.
    pub(crate) since: u64,
    /// The networks that are new, or have another network beside them.
    pub(crate) networks: Vec<usize>,
    /// The numbers of networks that are gone; new networks may have them now.
    pub(crate) removed: Vec<u32>,
    /// The tags that are used at other places, or have come or gone, by scope and name.
    pub(crate) tags: Vec<(usize, Name)>,
    /// Of these the ones that have another type or spelling: what is found at all their places may be other.
    pub(crate) retyped: Vec<(usize, Name)>,
}

/// A number that no context has.
pub(crate) fn next_serial() -> u64 {
    static NEXT: AtomicU64 = AtomicU64::new(1);
    NEXT.fetch_add(1, Ordering::Relaxed)
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
        if self.parse.lines()[line].line_ends > 0 {
            let within = usize::from(offset - self.parse.line_start(line));
            let text = self.parse.lines()[line].text().to_owned();
            number += LineIndex::new(&text).line(TextSize::new(within as u32));
        }
        number
    }

    /// The physical line, counted from 0, on which the logical line around an offset starts.
    pub(crate) fn physical_line(&self, offset: TextSize) -> u32 {
        let line = self.parse.line_at(offset).unwrap_or_default();
        self.parse.lines().line_ends_above(line)
    }

    /// Comments as other languages write them.
    pub(crate) fn foreign_comments(&self) -> &ForeignComments {
        self.foreign_comments
            .get_or_init(|| ForeignComments::find(&self.parse, |line| self.is_drawn(line)))
    }

    /// Whether a logical line is a rung of a network all of whose connectors have their partners.
    fn is_drawn(&self, line: usize) -> bool {
        let behind = self
            .networks
            .partition_point(|network| network.first_line <= line);
        let Some(network) = behind.checked_sub(1).map(|index| self.networks.at(index)) else {
            return false;
        };
        let offset = line - network.first_line;
        network.wiring.unpaired.is_empty() && network.wiring.line_offsets.binary_search(&offset).is_ok()
    }

    /// Where a tag is declared, or first used.
    pub fn place_of(&self, tag: &TagFacts) -> TextRange {
        if let Some((scope, target)) = self.leads_to(tag).filter(|_| !tag.is_declared()) {
            return self.place_of(&self.scopes[scope].tags[target]);
        }
        let first = || self.uses(tag).next();
        match tag.origin {
            Origin::Undeclared | Origin::Form => {
                first().map_or_else(|| self.declared_at(tag), |place| place.range)
            }
            Origin::Shared if tag.is_imported_by_use() => {
                first().map_or_else(|| self.declared_at(tag), |place| place.range)
            }
            Origin::Declared(_) | Origin::Implicit | Origin::Shared => self.declared_at(tag),
        }
    }

    /// What is wrong with its names: where, and how much that matters.
    pub(crate) fn mistakes(&self) -> impl Iterator<Item = (TextRange, Severity)> {
        let declared = self.wrong_globals.found().chain(self.misdeclared.found());
        let own = TextSize::default();
        declared.map(move |found| (found.range(own, self), found.severity()))
    }

    /// Its VAR_GLOBAL tags; of one name only the first.
    pub(crate) fn globals(&self) -> &Arc<Vec<Global>> {
        self.globals.get_or_init(|| Arc::new(exports::globals(self)))
    }

    /// How it uses tags that it does not declare for itself.
    pub(crate) fn outward_tags(&self) -> &ByName<TagUse> {
        self.outward_tags.get_or_init(|| outward::tags(self))
    }

    /// Where a tag is declared, of one that is.
    pub(crate) fn declared_at(&self, tag: &TagFacts) -> TextRange {
        self.declarations.range(tag.declared_at)
    }

    /// Where a tag is used, from top to bottom.
    pub fn uses<'c>(&'c self, tag: &'c TagFacts) -> impl DoubleEndedIterator<Item = Use> + Clone + use<'c> {
        tag.uses.0.iter().map(|place| self.networks.use_of(*place))
    }

    /// The tag in whose scope more is known of one that several scopes share; else the tag itself.
    pub fn shared<'c>(&'c self, tag: &'c TagFacts) -> &'c TagFacts {
        self.leads_to(tag)
            .map_or(tag, |(scope, tag)| &self.scopes[scope].tags[tag])
    }

    /// The scope of the tag that an entry leads to, and which of its tags it is.
    pub fn leads_to(&self, entry: &TagFacts) -> Option<(usize, usize)> {
        match entry.rare.lead.as_ref()? {
            Lead::Named(name) => Some((0, self.scopes[0].find(name)?)),
            Lead::Entry(scope, tag) => Some((*scope, *tag)),
        }
    }

    /// Where a tag is written, from top to bottom.
    pub fn writers<'c>(
        &'c self,
        tag: &'c TagFacts,
    ) -> impl DoubleEndedIterator<Item = Use> + Clone + use<'c> {
        let writers = tag.uses.0.iter().filter(|place| place.access().writes());
        writers.map(|place| self.networks.use_of(*place))
    }

    /// If it is settled: all tags of a name that are not those of one scope alone.
    pub(crate) fn outward_named<'c>(&'c self, name: &'c Name) -> impl Iterator<Item = &'c TagFacts> {
        let scopes = if self.named_in_bodies.contains(name) {
            self.scopes.len()
        } else {
            1
        };
        let tags = (0..scopes).filter_map(|scope| self.find_tag(&(scope, name.clone())));
        tags.filter(|tag| tag.is_outward() && !tag.leads_elsewhere())
    }

    /// The networks in the bodies of block definitions, with the blocks.
    pub(crate) fn networks_of_blocks(&self) -> impl Iterator<Item = (NetworkAt<'_>, usize)> {
        let bodies = self.bodies.iter().enumerate();
        bodies.filter_map(|(network, body)| match body {
            Body::Block(block) => Some((self.networks.at(network), *block)),
            Body::Main | Body::Function(_) => None,
        })
    }

    /// A tag by its scope and name, if it is there.
    pub(crate) fn find_tag(&self, (scope, name): &(usize, Name)) -> Option<&TagFacts> {
        let scope = self.scopes.get(*scope)?;
        scope.find(name).map(|tag| &scope.tags[tag])
    }

    /// The other tags of the file that are at the same direct address: together they are one tag.
    pub(crate) fn others_at_address<'c>(
        &'c self,
        tag: &'c TagFacts,
    ) -> impl Iterator<Item = &'c TagFacts> + use<'c> {
        self.at_address.others(self, tag)
    }

    /// The tag that stands for all at a tag's direct address: of most tags that is the tag itself.
    pub(crate) fn first_at_address(&self, (scope, tag): (usize, usize)) -> (usize, usize) {
        let first = self.at_address.first(&self.scopes[scope].tags[tag]);
        let first = first.and_then(|(scope, name)| Some((*scope, self.scopes[*scope].find(name)?)));
        first.unwrap_or((scope, tag))
    }

    /// The network that a jump from `network` to a label goes to: the nearest behind it, else the nearest
    /// before it or itself (LANGUAGE §5.5).
    pub fn jump_target(&self, network: usize, label: &Name) -> Option<usize> {
        self.jump_label(network, label).map(|(target, _)| target)
    }

    /// As `jump_target`, with the label's name as it is kept here.
    pub(crate) fn jump_label(&self, network: usize, label: &Name) -> Option<(usize, &Name)> {
        let key = (self.bodies[network], label.clone());
        let (key, labels) = self.labels_by_name.get_key_value(&key)?;
        let behind = labels.partition_point(|&label| self.labels[label].network <= network);
        let label = labels.get(behind).or_else(|| labels.last())?;
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

/// Reads a file's names, networks and blocks. Messages call the file by this name.
pub fn context(parse: &Arc<Parse>, name: &str, others: &Others) -> Context {
    context_after(None, parse, name, others)
}

/// As [`context()`]. What an earlier text had as well is taken from its context.
pub fn context_after(before: Option<&Context>, parse: &Arc<Parse>, name: &str, others: &Others) -> Context {
    match context_while(before, parse, name, others, &|| true) {
        Some(context) => context,
        None => unreachable!("it is always wanted"),
    }
}

/// As [`context_after()`], while `wanted` holds: where the names of the whole file are joined anew, that is asked between each
/// [`BETWEEN`](crate::BETWEEN) networks, tags or declarations. None once it does not.
pub fn context_while(
    before: Option<&Context>,
    parse: &Arc<Parse>,
    name: &str,
    others: &Others,
    wanted: &dyn Fn() -> bool,
) -> Option<Context> {
    if let Some(context) = before.and_then(|before| edited::edited(before, parse, name, others)) {
        return Some(context);
    }
    let wanted = StillWanted::new(wanted);
    let mut context = skeleton::skeleton(parse, name, others, before, &wanted)?;
    uses::collect(&mut context, &wanted)?;
    let wrong_globals = shared::share(&mut context);
    context.at_address = AtAddress::of(&context.scopes);
    infer::infer(&mut context, &wanted)?;
    context.settled = wrong_globals.follows_edits() && may_settle(&context);
    if context.settled {
        let scopes = context.scopes.iter().enumerate();
        let tags = scopes.flat_map(|(number, scope)| scope.unusual().map(move |(_, tag)| (number, tag)));
        let mistyped = tags.filter(|(_, tag)| tag.mistyped);
        context.mistyped = mistyped
            .map(|(scope, tag)| (scope, Name::new(&tag.name)))
            .collect();
        context.asks_others = context.networks.iter().any(|network| !network.names_tags_only);
        let unusual = context.scopes.iter().flat_map(Scope::unusual);
        let states =
            unusual.filter(|(_, tag)| tag.is_outward() && !tag.leads_elsewhere() && keeps_state(tag));
        context.outward_states = states.map(|(_, tag)| Name::new(&tag.name)).collect();
        let bodies = context.scopes[1..].iter().flat_map(Scope::unusual);
        let not_own = bodies.filter(|(_, tag)| tag.is_outward() || tag.leads_elsewhere());
        context.named_in_bodies = Arc::new(not_own.map(|(_, tag)| Name::new(&tag.name)).collect());
    }
    context.wrong_globals = Arc::new(wrong_globals);
    Some(context)
}

/// Whether a block keeps its state on a tag. The tag may be of another type: then that is a mistake.
pub(crate) fn keeps_state(tag: &TagFacts) -> bool {
    let is_state = |place: &UseRef| place.deed() == Deed::KeepsState;
    matches!(tag.ty, Some(Type::State(_))) || tag.uses.0.iter().any(is_state)
}
