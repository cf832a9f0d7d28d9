//! All that is known of a file before its program is put together: what rules and the editor's features read.

use crate::by_name::ByName;
use crate::control_flow::ControlFlow;
use crate::declarations::{Declarations, DeclaredAt};
use crate::declare;
use crate::declaring::PlacesOfScopes;
use crate::diagnostic::Diagnostic;
use crate::edited;
use crate::exports::{self, Global};
use crate::facts::NodeKind;
use crate::foreign_comment::ForeignComments;
use crate::infer;
use crate::joined::Joined;
use crate::kept::Kept;
use crate::known_blocks::KnownBlocks;
use crate::misdeclared::Misdeclared;
use crate::network;
use crate::networks::{BlockAt, NetworkAt, Networks};
use crate::others::{Import, Others};
use crate::outward::{self, TagUse};
use crate::profile;
use crate::program::Role;
use crate::rare::Rare;
use crate::reading::{Reading, TOGETHER};
use crate::rule::Severity;
use crate::scope::{Origin, Scope, TagFacts, Use, UseRef, Uses};
use crate::shared;
use crate::still_wanted::StillWanted;
use crate::types::Scalar;
use crate::types::Type;
use crate::use_kind::Deed;
use crate::user_block::{self, UserBlockFacts};
use crate::uses;
use ladder_instructions::{Op, Profile, Shape};
use ladder_syntax::wiring::PartKind;
use ladder_syntax::{LineIndex, LineKind, Name, Parse, Structure, TextRange, TextSize};
use std::collections::{BTreeSet, HashMap};
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
    /// What is wrong with tags for all files; nothing if it is settled.
    pub(crate) found: Vec<Diagnostic>,
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
    /// The line behind the last section, and behind the last first line of a block definition.
    pub(crate) declared_to: usize,
    /// An edit between the declarations and the end changes what it names, and nothing else; see [`edited`].
    pub(crate) settled: bool,
    /// If it is settled: the tags whose declared type is open, by scope and name.
    pub(crate) mistyped: Vec<(usize, Name)>,
    /// If it is settled: the tags on which a block keeps its state and that may be those of other files too.
    pub(crate) outward_states: BTreeSet<Name>,
    /// Its VAR_GLOBAL tags, once somebody asks.
    pub(crate) globals: OnceLock<Arc<Vec<Global>>>,
    /// How it uses tags that it does not declare for itself, once somebody asks.
    pub(crate) outward_tags: OnceLock<ByName<TagUse>>,
    /// Without it no network calls a function.
    pub(crate) may_call: bool,
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
    pub(crate) labels_by_name: HashMap<(Body, Name), Vec<usize>>,
    pub(crate) functions_by_name: HashMap<Name, usize>,
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
    pub name: String,
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
    pub name: String,
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
        let of_tags = self.found.iter().map(|found| (found.range, found.severity));
        let declared = self.misdeclared.found();
        let own = TextSize::default();
        of_tags.chain(declared.map(move |found| (found.range(own, self), found.severity())))
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
        tag.rare
            .shared
            .map_or(tag, |(scope, tag)| &self.scopes[scope].tags[tag])
    }

    /// Where a tag is written, from top to bottom.
    pub fn writers<'c>(
        &'c self,
        tag: &'c TagFacts,
    ) -> impl DoubleEndedIterator<Item = Use> + Clone + use<'c> {
        let writers = tag.uses.0.iter().filter(|place| place.access().writes());
        writers.map(|place| self.networks.use_of(*place))
    }

    /// A tag by its scope and name, if it is there.
    pub(crate) fn find_tag(&self, (scope, name): &(usize, Name)) -> Option<&TagFacts> {
        let scope = self.scopes.get(*scope)?;
        scope.find(name).map(|tag| &scope.tags[tag])
    }

    /// The tags of all scopes, each once.
    pub(crate) fn own_tags(&self) -> impl Iterator<Item = &TagFacts> {
        let tags = self.scopes.iter().flat_map(|scope| &scope.tags);
        tags.filter(|tag| tag.rare.shared.is_none())
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
    let mut context = skeleton(parse, name, others, before, &wanted)?;
    uses::collect(&mut context, &wanted)?;
    let mut found = Vec::new();
    shared::share(&mut context, &mut found);
    infer::infer(&mut context, &wanted)?;
    context.settled = found.is_empty() && edited::may_settle(&context);
    if context.settled {
        let scopes = context.scopes.iter().enumerate();
        let tags = scopes.flat_map(|(number, scope)| scope.unusual().map(move |(_, tag)| (number, tag)));
        let mistyped = tags.filter(|(_, tag)| tag.mistyped);
        context.mistyped = mistyped
            .map(|(scope, tag)| (scope, Name::new(&tag.name)))
            .collect();
        let unusual = context.scopes[0].unusual().map(|(_, tag)| tag);
        let outward = unusual.filter(|tag| tag.is_outward());
        let states = outward.filter(|tag| keeps_state(tag));
        context.outward_states = states.map(|tag| Name::new(&tag.name)).collect();
    }
    context.found = found;
    Some(context)
}

/// Whether a block keeps its state on a tag. The tag may be of another type: then that is a mistake.
pub(crate) fn keeps_state(tag: &TagFacts) -> bool {
    let is_state = |place: &UseRef| place.deed() == Deed::KeepsState;
    matches!(tag.ty, Some(Type::State(_))) || tag.uses.0.iter().any(is_state)
}

/// The context before any use of a tag is looked at: declarations, blocks, networks, functions and labels. None if that is not
/// wanted any longer.
pub(crate) fn skeleton(
    parse: &Arc<Parse>,
    name: &str,
    others: &Others,
    before: Option<&Context>,
    wanted: &StillWanted<'_>,
) -> Option<Context> {
    let structure = &*parse.structure_once();
    let profile = profile::profile(parse);
    // In another profile the same text means something else.
    let before = before.filter(|before| before.profile == profile);
    let mut kept = before.map(|before| Kept::of(before, parse));
    let same = kept.as_ref().and_then(|kept| kept.declared(structure));
    let (scopes, declarations, misdeclared) = match same {
        Some(same) => same,
        None => declared(parse, structure, wanted)?,
    };
    let user_blocks: Vec<UserBlockFacts> = structure
        .blocks
        .iter()
        .zip(&scopes[1..])
        .map(|(definition, scope)| user_block::user_block(parse, definition, scope))
        .collect();
    let own_blocks = user_blocks.len();
    let signatures = user_block::signatures(&user_blocks);
    if let Some(kept) = &mut kept {
        kept.with_signatures(signatures);
    }
    let mut known = KnownBlocks::new(user_blocks, others);
    let mut reading = Reading::default();
    let mut networks = Networks::with_capacity(structure.networks.len());
    let mut control_flow = ControlFlow::default();
    for (number, drawn) in structure.networks.iter().enumerate() {
        wanted.one_more()?;
        if kept.is_none() && number.is_multiple_of(TOGETHER) {
            let next = &structure.networks[number..];
            reading.look_ahead(parse, &next[..next.len().min(TOGETHER)]);
        }
        let same = kept.as_mut().and_then(|kept| kept.network(drawn));
        let facts =
            same.unwrap_or_else(|| Arc::new(network::network(parse, drawn, &mut known, &mut reading)));
        control_flow = control_flow.with(facts.control_flow);
        let first = drawn.lines.start;
        let scope = drawn.block.map_or(0, |block| block + 1);
        networks.push(facts, first, parse.line_start(first), scope);
    }
    let all = 0..networks.len();
    break_neighbours(parse, &mut networks, all);
    let mut context = Context {
        parse: Arc::clone(parse),
        name: Arc::from(name),
        serial: next_serial(),
        change: None,
        found: Vec::new(),
        profile,
        cycle: profile::cycle(parse),
        networks,
        scopes,
        declarations,
        misdeclared,
        declared_to: declared_to(structure),
        settled: false,
        mistyped: Vec::new(),
        outward_states: BTreeSet::new(),
        globals: OnceLock::new(),
        outward_tags: OnceLock::new(),
        may_call: control_flow.has(ControlFlow::CALL),
        may_jump: control_flow.has(ControlFlow::JUMP),
        is_framed: parse.frame().is_whole(),
        user_blocks: known.into_list(),
        own_blocks,
        signatures,
        others: others.clone(),
        functions: Vec::new(),
        labels: Vec::new(),
        bodies: Arc::default(),
        foreign_comments: OnceLock::new(),
        joined: None,
        places: PlacesOfScopes::default(),
        labels_by_name: HashMap::new(),
        functions_by_name: HashMap::new(),
    };
    bodies(&mut context);
    Some(context)
}

/// The line behind the last section, and behind the last first line of a block definition.
pub(crate) fn declared_to(structure: &Structure) -> usize {
    let sections = structure.sections.iter().map(|section| section.lines.end);
    let headers = structure.blocks.iter().map(|block| block.lines.start + 1);
    sections.chain(headers).max().unwrap_or_default()
}

/// The scopes with their declared tags, and what is wrong with the declarations.
pub(crate) type Declared = (Vec<Scope>, Arc<Declarations>, Arc<Misdeclared>);

fn declared(parse: &Parse, structure: &Structure, wanted: &StillWanted<'_>) -> Option<Declared> {
    let mut scopes = vec![Scope::default()];
    scopes.extend(structure.blocks.iter().enumerate().map(|(index, definition)| {
        let mut scope = Scope::default();
        scope.block = Some(index);
        for name in ["EN", "ENO"] {
            let at = parse.line_range(definition.lines.start);
            scope.declare(Name::new(name), implicit(name, at));
        }
        scope
    }));
    let mut declarations = Declarations::default();
    let mut wrong = Misdeclared::default();
    let mut names = vec![0; scopes.len()];
    for section in &structure.sections {
        names[section.block.map_or(0, |block| block + 1)] += declare::names_about(parse, section);
    }
    for (scope, names) in scopes.iter_mut().zip(names) {
        scope.reserve_declared(names);
    }
    for section in &structure.sections {
        let scope = section.block.map_or(0, |block| block + 1);
        let scope = &mut scopes[scope];
        declare::section((parse, wanted), section, &mut declarations, scope, &mut wrong)?;
    }
    Some((scopes, Arc::new(declarations), Arc::new(wrong)))
}

/// The first rung below an open `\`, or above an open `/`, was probably meant to belong to the network.
pub(crate) fn break_neighbours(parse: &Parse, networks: &mut Networks, among: std::ops::Range<usize>) {
    for index in among {
        let network = networks.at(index);
        if network.wiring.unpaired.is_empty() {
            continue;
        }
        let wiring = &network.wiring;
        let last = wiring.rungs.len() - 1;
        let open = |rung: usize, kind| {
            wiring
                .unpaired
                .iter()
                .any(|&(r, part)| r == rung && wiring.rungs[r].parts[part].kind == kind)
        };
        let below = open(last, PartKind::Down) && rung_below(parse, network.line(last)).is_some();
        let above = open(0, PartKind::Up) && rung_above(parse, network.line(0)).is_some();
        if below && index + 1 < networks.len() {
            networks.set_broken(index + 1);
        }
        if above && index > 0 {
            networks.set_broken(index - 1);
        }
    }
}

fn implicit(name: &str, at: TextRange) -> TagFacts {
    TagFacts {
        name: name.into(),
        ty: Some(Type::Scalar(Scalar::Bool)),
        role: Role::Internal,
        origin: Origin::Implicit,
        retain: false,
        constant: false,
        rare: Rare::default(),
        declared_at: DeclaredAt::in_file(at),
        uses: Uses::default(),
        mistyped: false,
        by_company: false,
    }
}

/// Finds functions and labels, and which body each network belongs to. A network's first `<FUN>` counts. One in the
/// body of a `<$B>` begins a function of the file, which reaches to the end of the body (LANGUAGE §5.7).
fn bodies(context: &mut Context) {
    let mut current = Body::Main;
    // In the definition of a block: the function that its body has come to.
    let mut inner: Option<(usize, usize)> = None;
    let mut in_file = Vec::new();
    let mut bodies = Vec::with_capacity(context.networks.len());
    for network in &context.networks {
        let index = network.index;
        let definition = network.scope.checked_sub(1);
        inner = inner.filter(|(of, _)| Some(*of) == definition);
        let may_begin = definition.is_none_or(|block| context.user_blocks[block].shape == Shape::Function);
        context.labels.extend(labels_in(network));
        for block in marks_in(network).filter(|block| block.op() == Some(Op::Fun)) {
            let Some((name, key, at)) = named(&block) else {
                continue;
            };
            if may_begin && context.functions.last().is_none_or(|last| last.network != index) {
                match definition {
                    Some(block) => inner = Some((block, context.functions.len())),
                    None => current = Body::Function(context.functions.len()),
                }
                context.functions.push(FunctionFacts {
                    name,
                    key,
                    network: index,
                    at,
                });
            }
        }
        bodies.push(match (definition, inner) {
            (None, _) => current,
            (Some(_), Some((_, function))) => {
                // It runs with the tags of the file.
                in_file.push(index);
                Body::Function(function)
            }
            (Some(block), None) => Body::Block(block),
        });
    }
    context.bodies = Arc::new(bodies);
    for index in in_file {
        context.networks.set_scope(index, 0);
    }
    name_labels(context);
    for (index, function) in context.functions.iter().enumerate() {
        context
            .functions_by_name
            .entry(function.key.clone())
            .or_insert(index);
    }
}

/// The blocks of a network, if there is a label or the beginning of a function among them.
fn marks_in(network: NetworkAt<'_>) -> impl Iterator<Item = BlockAt<'_>> {
    let is_marked = network.control_flow.has(ControlFlow::MARK);
    let blocks = is_marked.then(|| network.blocks());
    blocks.into_iter().flatten()
}

/// The labels of a network, in the order of its blocks.
pub(crate) fn labels_in(network: NetworkAt<'_>) -> impl Iterator<Item = LabelFacts> {
    let labels = marks_in(network).filter(|block| block.op() == Some(Op::Lbl));
    labels.filter_map(move |block| {
        let (name, key, at) = named(&block)?;
        Some(LabelFacts {
            name,
            key,
            network: network.index,
            at,
        })
    })
}

/// The name in the first operand of a label or function, as written and as it is compared, and where it is.
fn named(block: &BlockAt<'_>) -> Option<(String, Name, TextRange)> {
    let operand = &block.facts.operands.first()?.value;
    let NodeKind::Name(name) = &operand.kind else {
        return None;
    };
    Some((name.to_string(), Name::new(name), block.absolute(operand.range)))
}

/// Enters the labels of each body by their names.
pub(crate) fn name_labels(context: &mut Context) {
    context.labels_by_name.clear();
    for (index, label) in context.labels.iter().enumerate() {
        let key = (context.bodies[label.network], label.key.clone());
        context.labels_by_name.entry(key).or_default().push(index);
    }
}

/// The line of the next rung, if only rail, comment and blank lines are between.
pub(crate) fn rung_below(parse: &Parse, line: usize) -> Option<usize> {
    let lines = parse.lines();
    let next = (line + 1..lines.len()).find(|&n| !lines[n].kind.is_decoration())?;
    (lines[next].kind == LineKind::Rung).then_some(next)
}

/// The line of the rung before, likewise.
pub(crate) fn rung_above(parse: &Parse, line: usize) -> Option<usize> {
    let lines = parse.lines();
    let previous = (0..line).rev().find(|&n| !lines[n].kind.is_decoration())?;
    (lines[previous].kind == LineKind::Rung).then_some(previous)
}
