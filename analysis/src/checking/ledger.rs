//! What is found in a file, by owner, kept from one text to the next.
//!
//! A network owns what is found in it by itself, a tag what is found at its places, the file all else. After an edit
//! only those are looked at again that the [`Change`] names, or whose surroundings changed in a
//! way that matters; what the others own stays, and moves with them.

mod flow;
mod in_networks;

use super::allowed::Allowed;
use super::at_tags::{AtTags, Flow};
use super::of_bodies::OfBodies;
use super::of_program::OfProgram;
use super::part_notes::PartNotes;
use super::shelf::Shelf;
use crate::context::{Change, Context};
use crate::control_flow::ControlFlow;
use crate::diagnostic::Diagnostic;
use crate::findings::Anchored;
use crate::program::Role;
use crate::rule::Severity;
use crate::rule_settings::RuleSettings;
use crate::rules::double_coil::Leaving;
use crate::rules::tag_summary::Known;
use crate::rules::{self, AroundTags};
use crate::scope::TagFacts;
use crate::still_wanted::StillWanted;
use crate::types::Type;
use crate::verdict::{ByPass, InNetwork, Pass};
use ladder_syntax::{Name, TextRange, TextSize};
use rustc_hash::{FxHashMap, FxHashSet};
use std::collections::BTreeSet;
use std::sync::Arc;

/// All that is found in a file.
#[derive(Debug)]
pub(crate) struct Ledger {
    /// The number of the context that it is about.
    context: u64,
    settings: RuleSettings,
    pub(super) shelf: Shelf,
    /// The numbers of networks that own something else than what the shelf has.
    unshelved: FxHashSet<u32>,
    /// By their numbers.
    networks: Vec<OfNetwork>,
    /// What each network has of program flow, by its number.
    control_flow: Vec<ControlFlow>,
    /// What they have together.
    any: ControlFlow,
    /// The numbers of networks whose drawing or types have an error.
    faulty: FxHashSet<u32>,
    /// The numbers of networks in which there is any error.
    unsound: FxHashSet<u32>,
    /// The numbers of networks with a mistake in the drawing, or a block that is not known.
    unclear: FxHashSet<u32>,
    /// The first block of a network that could not be resolved whole, counted from the start of the network.
    unresolved: FxHashMap<u32, TextRange>,
    /// The numbers of networks to look at after each edit: what is found there depends on more than is kept.
    volatile: FxHashSet<u32>,
    /// The numbers of networks with a member that its tag does not have: which timer or counter may be meant depends on the
    /// others of the file.
    unknown_members: FxHashSet<u32>,
    tags: AtTags,
    bodies: OfBodies,
    program: OfProgram,
    /// One of the file's outputs.
    an_output: Option<Name>,
    /// Whether a rail may be dead, once it is known.
    rail_varies: Option<bool>,
    pub(super) notes: PartNotes,
    pub(super) allowed: Allowed,
    /// How many findings the networks own.
    count: usize,
    /// There are so many that no networks were looked at from this one on.
    full_from: Option<usize>,
    work: Work,
}

/// What was looked at to find what is wrong in a text: of one that came from another by an edit, what the edit concerns.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Work {
    /// Networks.
    pub networks: usize,
    /// Tags.
    pub tags: usize,
    /// Findings that were kept, to see whether they are shown.
    pub findings: usize,
    /// Comments that switch rules off.
    pub comments: usize,
}

/// What is found in a network.
#[derive(Debug, Default)]
struct OfNetwork {
    /// Stands for all of its tags that findings depend on.
    stamp: u64,
    found: ByPass,
}

/// What the file as a whole owns: looked for after each edit.
#[derive(Debug, Default)]
pub(super) struct OfFile {
    /// What is wrong with names and definitions.
    pub(super) names: Vec<Diagnostic>,
    /// What is wrong with the program as a whole.
    pub(super) program: Vec<Diagnostic>,
    pub(super) known: Known,
}

impl Ledger {
    fn new(context: &Context, settings: &RuleSettings) -> Ledger {
        Ledger {
            context: context.serial,
            settings: settings.clone(),
            shelf: Shelf::new(settings),
            unshelved: FxHashSet::default(),
            networks: Vec::new(),
            control_flow: Vec::new(),
            any: ControlFlow::default(),
            faulty: FxHashSet::default(),
            unsound: FxHashSet::default(),
            unclear: FxHashSet::default(),
            unresolved: FxHashMap::default(),
            volatile: FxHashSet::default(),
            unknown_members: FxHashSet::default(),
            tags: AtTags::default(),
            bodies: OfBodies::default(),
            program: OfProgram::default(),
            an_output: None,
            rail_varies: None,
            notes: PartNotes::default(),
            allowed: Allowed::default(),
            count: 0,
            full_from: None,
            work: Work::default(),
        }
    }

    /// Looks for what is wrong in a file. `before` is what was found in an earlier text of it. None if that is not wanted any
    /// longer.
    pub(super) fn look(
        before: Option<Ledger>,
        context: &Context,
        settings: &RuleSettings,
        wanted: &StillWanted<'_>,
    ) -> Option<(Ledger, OfFile)> {
        let change = context.change.as_ref();
        let known = before.zip(change).filter(|(ledger, change)| {
            change.since == ledger.context && ledger.settings == *settings && ledger.full_from.is_none()
        });
        let (mut ledger, networks, change) = match known {
            Some((mut ledger, change)) => {
                let networks = ledger.follow(context, change);
                (ledger, networks, Some(change))
            }
            None => (
                Ledger::new(context, settings),
                (0..context.networks.len()).collect(),
                None,
            ),
        };
        ledger.context = context.serial;
        ledger.work = Work {
            networks: networks.len(),
            ..Work::default()
        };
        let numbers = context.networks.numbers();
        ledger.networks.resize_with(numbers, OfNetwork::default);
        ledger.control_flow.resize(numbers, ControlFlow::default());
        ledger.shelf.resize(numbers, context.declarations.numbers());
        let parts = ledger.notes.follow(context.parse.lines());
        ledger.work.comments =
            ledger
                .allowed
                .follow(context, change, (&ledger.notes, parts), &mut ledger.shelf);
        let flow = ledger.follow_flow(context, change, &networks);
        ledger.bodies.follow(context, change, &networks);
        ledger.program.follow(flow.touched);
        ledger.in_networks(context, &networks, wanted)?;
        let mut of_file = OfFile::default();
        rules::of_file(context, &mut of_file.names);
        let rungs = ledger.notes.rungs(context.parse.lines());
        of_file.names.extend(rungs.map(rules::commented_out_rung::found));
        ledger.of_tags(context, change, flow, wanted)?;
        let addressed: Vec<&TagFacts> = ledger.tags.addressed(context).collect();
        ledger.work.tags += addressed.len();
        rules::one_address::check(context, addressed.iter().copied(), &mut of_file.names);
        let toggled = ledger.find_unsound(context, &of_file.names);
        of_file.known.names = !ledger.tags.any_undeclared();
        let is_error = |found: &Diagnostic| found.severity == Severity::Error;
        of_file.known.whole = ledger.unsound.is_empty()
            && ledger.unclear.is_empty()
            && !of_file.names.iter().any(is_error)
            && !context
                .mistakes()
                .any(|(_, severity)| severity == Severity::Error)
            && ledger.tags.errors().next().is_none()
            && !has_syntax_errors(context);
        if !toggled.is_empty() {
            ledger.program.look_again();
        }
        ledger.power_again(context, toggled, wanted)?;
        ledger.put_on_shelf(context);
        if of_file.known.whole {
            ledger.work.tags += ledger
                .tags
                .decide_read_above(context, ledger.any, &mut ledger.shelf);
        }
        ledger.of_flow(context, of_file.known.whole);
        rules::overlapping_address::check(context, addressed.into_iter(), &mut of_file.program);
        Some((ledger, of_file))
    }

    /// Drops what networks own that are gone, and gives those to look at, from top to bottom.
    fn follow(&mut self, context: &Context, change: &Change) -> Vec<usize> {
        for &id in &change.removed {
            let gone = std::mem::take(&mut self.networks[id as usize]);
            self.count -= gone.found.len();
            self.unshelved.insert(id);
            self.unresolved.remove(&id);
            for numbers in [
                &mut self.faulty,
                &mut self.unsound,
                &mut self.unclear,
                &mut self.volatile,
                &mut self.unknown_members,
            ] {
                numbers.remove(&id);
            }
        }
        let mut again: BTreeSet<usize> = change.networks.iter().copied().collect();
        again.extend(self.volatile.iter().map(|&id| context.networks.index_of(id)));
        if !self.unknown_members.is_empty() && may_change_states(context, change) {
            let networks = self.unknown_members.iter();
            again.extend(networks.map(|&id| context.networks.index_of(id)));
        }
        for tag in &change.retyped {
            let Some(tag) = context.find_tag(tag) else {
                continue;
            };
            for place in &tag.uses.0 {
                again.insert(context.networks.index_of(place.network));
            }
        }
        again.into_iter().collect()
    }

    /// Exchanges what a pass has found in a network.
    fn set(&mut self, id: u32, pass: Pass, found: InNetwork) {
        let kept = &mut self.networks[id as usize].found;
        let before = kept.len();
        kept.set(pass, &found);
        if before == 0 && kept.len() == 0 {
            return;
        }
        self.count = self.count + kept.len() - before;
        if found.iter().any(|found| found.is_volatile()) {
            self.volatile.insert(id);
        }
        self.unshelved.insert(id);
    }

    /// Puts what is found anew on the shelf. Where a network keeps the same of its own, that is one list.
    fn put_on_shelf(&mut self, context: &Context) {
        for id in self.unshelved.drain() {
            let found = &self.networks[id as usize].found;
            self.shelf.set_network(id, found.iter());
            if let Some(network) = context.networks.numbered(id) {
                network.verdict.share(found);
            }
        }
    }

    /// Looks at the tags that a change concerns, and at all of them without one.
    fn of_tags(
        &mut self,
        context: &Context,
        change: Option<&Change>,
        flow: Flow,
        wanted: &StillWanted<'_>,
    ) -> Option<()> {
        let leaving = Leaving::of(flow.any, || {
            let leaves = |index: &usize| self.flow_at(context, *index).has(Leaving::WAYS);
            (0..context.networks.len())
                .filter(leaves)
                .map(|index| context.networks.id(index))
                .collect()
        });
        let around = AroundTags {
            has_outputs: self.has_outputs(context),
            leaving,
            declares: context.scopes[0].declares(),
        };
        self.work.tags = self
            .tags
            .follow(context, change, (around, flow), (&mut self.shelf, wanted))?;
        Some(())
    }

    /// Whether the file has an output. One that was found is mostly there still.
    fn has_outputs(&mut self, context: &Context) -> bool {
        let file = &context.scopes[0];
        let is_output = |tag: &TagFacts| tag.role == Role::Output;
        let known = self.an_output.as_ref().and_then(|name| file.find(name));
        if known.is_some_and(|tag| is_output(&file.tags[tag])) {
            return true;
        }
        let first = file.tags.iter().find(|tag| is_output(tag));
        self.an_output = first.map(|tag| Name::new(&tag.name));
        self.an_output.is_some()
    }

    /// Notes in which networks there is an error. Gives those of which that is new.
    fn find_unsound(&mut self, context: &Context, of_file: &[Diagnostic]) -> Vec<usize> {
        let mut unsound = self.faulty.clone();
        let mut add = |at: TextSize| {
            let behind = context
                .networks
                .partition_point(|network| network.range.start() <= at);
            let around = behind.checked_sub(1).map(|index| context.networks.at(index));
            if let Some(network) = around.filter(|network| at < network.range.end()) {
                unsound.insert(context.networks.id(network.index));
            }
        };
        let of_file = of_file.iter().map(|found| (found.range, found.severity));
        for (range, severity) in context.mistakes().chain(of_file) {
            if severity == Severity::Error {
                add(range.start());
            }
        }
        for found in self.tags.errors() {
            add(found.range(TextSize::default(), context).start());
        }
        let toggled = unsound.symmetric_difference(&self.unsound);
        let toggled = toggled.map(|&id| context.networks.index_of(id)).collect();
        self.unsound = unsound;
        toggled
    }

    /// What is found in networks with places that are true for this text only.
    pub(super) fn volatile_in_networks(&self) -> impl Iterator<Item = &Arc<Anchored>> {
        let of_network = |id: &u32| self.networks[*id as usize].found.iter();
        let all = self.volatile.iter().flat_map(of_network);
        all.filter(|found| found.is_volatile())
    }

    /// The same of what is found at tags.
    pub(super) fn volatile_at_tags(&self) -> impl Iterator<Item = &Arc<Anchored>> {
        self.tags.volatile()
    }

    /// What was looked at last.
    pub(super) fn work(&self) -> Work {
        self.work
    }

    /// Whether not all networks were looked at.
    pub(super) fn is_full(&self) -> bool {
        self.full_from.is_some()
    }

    /// The first block that could not be resolved whole.
    pub(super) fn unresolved(&self, context: &Context) -> Option<TextRange> {
        let first = self
            .unresolved
            .iter()
            .map(|(&id, &block)| (context.networks.index_of(id), block));
        let (index, block) = first.min_by_key(|(index, _)| *index)?;
        Some(block + context.networks.at(index).range.start())
    }
}

/// Whether a timer or counter may have come or gone.
fn may_change_states(context: &Context, change: &Change) -> bool {
    let is_state = |tag: &TagFacts| matches!(tag.ty, Some(Type::State(_)));
    let mut tags = change.tags.iter().map(|key| context.find_tag(key));
    !change.retyped.is_empty() || tags.any(|tag| tag.is_none_or(is_state))
}

fn has_syntax_errors(context: &Context) -> bool {
    let lines = context.parse.lines();
    lines
        .of_parts_that(ladder_syntax::Part::is_faulty)
        .any(|(_, line)| !line.errors.is_empty())
}
