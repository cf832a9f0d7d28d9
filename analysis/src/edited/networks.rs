//! The networks of a text behind an edit: those of the parts in which it lies are read again, all others taken over.

use super::lines::{Lines, same_lines};
use super::tags::EditedTags;
use crate::context::{self, Body, Context};
use crate::control_flow::ControlFlow;
use crate::declaring::PlacesOfScopes;
use crate::known_blocks::KnownBlocks;
use crate::network::{self, BoundBlock, NetworkFacts, UserBlocks};
use crate::networks::Spliced;
use crate::networks::neighbours::break_neighbours;
use crate::outward;
use crate::reading::Reading;
use crate::skeleton;
use crate::user_block::UserBlockFacts;
use ladder_instructions::{Op, Shape};
use ladder_syntax::{Line, LineKind, Name, Network, Parse, TextRange};
use rustc_hash::FxHashSet;
use std::ops::Range;
use std::sync::{Arc, OnceLock};

/// A context on its way from one text to the next.
pub(crate) struct Edited {
    pub(crate) context: Context,
    /// The networks that are not there any more.
    pub(crate) removed: Vec<Removed>,
    /// The networks that are new.
    pub(crate) added: Vec<usize>,
    /// The networks in whose parts the edit lies.
    new: Range<usize>,
    /// One of those that are new or not there any more has a label.
    labelled: bool,
}

/// A network that is not there any more.
pub(crate) struct Removed {
    /// The number that it had.
    pub(crate) id: u32,
    pub(crate) facts: Arc<NetworkFacts>,
    pub(crate) scope: usize,
    body: Body,
}

impl Edited {
    /// Takes over the networks on whose lines nothing has changed, and reads the others.
    pub(super) fn networks(before: &Context, parse: &Arc<Parse>, change: &Lines) -> Option<Edited> {
        let mut known = KnownBlocks::new(before.user_blocks.clone(), &before.others);
        let Reread {
            old,
            networks,
            bodies,
            added,
            removed,
        } = reread(before, parse, change, &mut known);
        let new_facts = || {
            let new = networks.iter().filter(|network| network.id.is_none());
            new.map(|network| &network.facts)
        };
        // Blocks of other files have their numbers in the order in which the file first names them.
        let were_named = imported(before, removed.iter().map(|network| &network.facts));
        if known.list().len() != before.user_blocks.len() || !were_named.eq(imported(before, new_facts())) {
            return None;
        }
        let touched = || new_facts().chain(removed.iter().map(|network| &network.facts));
        let labelled = touched().any(|facts| is_marked(facts));
        if labelled && !may_follow_labels(before, touched()) {
            return None;
        }
        if before.networks.len() - old.len() + networks.len() == 0 {
            return None;
        }
        let may_jump = |facts: &Arc<NetworkFacts>| facts.control_flow.has(ControlFlow::JUMP);
        let mut context = Context {
            parse: Arc::clone(parse),
            serial: context::next_serial(),
            may_jump: before.may_jump || new_facts().any(may_jump),
            asks_others: before.asks_others || new_facts().any(|facts| !facts.names_tags_only),
            foreign_comments: OnceLock::new(),
            joined: None,
            places: PlacesOfScopes::default(),
            ..before.clone()
        };
        let new = old.start..old.start + networks.len();
        let ids = removed.iter().map(|network| network.id).collect();
        context
            .networks
            .splice(old.clone(), networks, ids, change.added, change.added_bytes);
        if context.bodies[old.clone()] != *bodies {
            Arc::make_mut(&mut context.bodies).splice(old, bodies);
        }
        let mut edited = Edited {
            context,
            removed,
            added,
            new,
            labelled,
        };
        edited.note_calls();
        Some(edited)
    }

    /// Notes which networks call functions.
    fn note_calls(&mut self) {
        let context = &mut self.context;
        let calls = |facts: &NetworkFacts| facts.control_flow.has(ControlFlow::CALL);
        let called = self.removed.iter().filter(|network| calls(&network.facts));
        let called: Vec<u32> = called.map(|network| network.id).collect();
        let calling = self
            .added
            .iter()
            .filter(|&&index| calls(context.networks.facts(index)));
        let calling: Vec<u32> = calling.map(|&index| context.networks.id(index)).collect();
        if called != calling {
            let noted = Arc::make_mut(&mut context.calling);
            for id in called {
                noted.remove(&id);
            }
            noted.extend(calling);
        }
    }

    /// Gives labels and functions their new places, and looks anew which networks around the edit have a mistake.
    pub(super) fn places(&mut self, before: &Context) {
        let context = &mut self.context;
        let networks = &context.networks;
        // Their networks have not changed, so they have the same numbers.
        let follow = |network: &mut usize, at: &mut TextRange| {
            let within = *at - before.networks.at(*network).range.start();
            *network = networks.index_of(before.networks.id(*network));
            *at = within + networks.at(*network).range.start();
        };
        let is_gone = |network: usize| {
            let id = before.networks.id(network);
            self.removed.iter().any(|removed| removed.id == id)
        };
        context
            .labels
            .retain(|label| !self.labelled || !is_gone(label.network));
        for label in &mut context.labels {
            follow(&mut label.network, &mut label.at);
        }
        for function in &mut context.functions {
            follow(&mut function.network, &mut function.at);
        }
        if self.labelled {
            let added = self.added.iter();
            let new = added.flat_map(|&index| skeleton::labels_in(networks.at(index)));
            context.labels.extend(new);
            context.labels.sort_by_key(|label| label.at.start());
            skeleton::name_labels(context);
        }
        let around = self.new.start.saturating_sub(1)..(self.new.end + 1).min(context.networks.len());
        for index in around.clone() {
            context.networks.reset_broken(index);
        }
        let sources = around.start.saturating_sub(1)..(around.end + 1).min(context.networks.len());
        break_neighbours(&context.parse, &mut context.networks, sources);
    }

    /// The networks that are new, those beside the edit of which another is to be thought now, and those that jump if labels
    /// have come or gone.
    pub(super) fn looked_at(&self, before: &Context) -> Vec<usize> {
        let networks = &self.context.networks;
        let around = self.new.start.saturating_sub(1)..(self.new.end + 1).min(networks.len());
        let is_other = |&index: &usize| {
            self.added.binary_search(&index).is_ok() || {
                let old = before.networks.index_of(networks.id(index));
                before.networks.at(old).broken != networks.at(index).broken
            }
        };
        let mut again: Vec<usize> = around.clone().filter(is_other).collect();
        if self.labelled && self.context.may_jump {
            again.extend(self.jumps_to_labels());
            again.sort_unstable();
            again.dedup();
        }
        again
    }

    /// The networks that may jump to the labels that have come or gone: those of their bodies, and those of other bodies that name
    /// one of them, for such a jump is told where that label is.
    fn jumps_to_labels(&self) -> Vec<usize> {
        let Context { networks, bodies, .. } = &self.context;
        let gone = self.removed.iter().map(|network| (&network.facts, network.body));
        let new = self.added.iter();
        let new = new.map(|&index| (networks.facts(index), bodies[index]));
        let marked: Vec<_> = gone.chain(new).filter(|(facts, _)| is_marked(facts)).collect();
        let named: FxHashSet<Name> = marked
            .iter()
            .flat_map(|(facts, _)| first_names(facts, Op::Lbl))
            .collect();
        let jumps = networks
            .iter()
            .filter(|it| it.control_flow.has(ControlFlow::JUMP));
        let concerned = jumps.filter(|network| {
            let body = bodies[network.index];
            marked.iter().any(|(_, marked)| *marked == body)
                || first_names(network.facts(), Op::Jmp).any(|name| named.contains(&name))
        });
        concerned.map(|network| network.index).collect()
    }

    /// Notes how tags are used that may be those of other files, and on which of these a block keeps its state.
    pub(super) fn note_outward(&mut self, tags: &EditedTags) {
        let context = &mut self.context;
        let mut outward = context.outward_tags.take();
        for (_, name) in &tags.used {
            if context.outward_named(name).any(context::keeps_state) {
                context.outward_states.insert(name.clone());
            } else {
                context.outward_states.remove(name);
            }
            if let Some(outward) = &mut outward {
                outward.set(name.clone(), outward::tag(context, name));
            }
        }
        context.outward_tags = outward.map(OnceLock::from).unwrap_or_default();
    }
}

/// The networks of the parts in which an edit lies.
struct Reread {
    /// Those before the edit.
    old: Range<usize>,
    /// Those behind it, and the bodies that they belong to.
    networks: Vec<Spliced>,
    bodies: Vec<Body>,
    /// Which of them are new.
    added: Vec<usize>,
    /// Those before it that are gone.
    removed: Vec<Removed>,
}

/// Reads the parts in which an edit lies: networks on whose lines nothing has changed are taken over.
fn reread(before: &Context, parse: &Parse, change: &Lines, known: &mut KnownBlocks) -> Reread {
    let (old_lines, new_lines) = (before.parse.lines(), parse.lines());
    let (new_parts, old_parts) = new_lines.parts_changed_since(old_lines);
    let lines = old_lines.first_line(old_parts.start)..old_lines.first_line(old_parts.end);
    let old = before
        .networks
        .partition_point(|network| network.first_line < lines.start)
        ..before
            .networks
            .partition_point(|network| network.first_line < lines.end);
    let mut gone: Vec<bool> = vec![true; old.len()];
    let mut reading = Reading::default();
    let mut networks: Vec<Spliced> = Vec::new();
    let mut bodies: Vec<Body> = Vec::new();
    let mut added = Vec::new();
    let mut next_old = old.start;
    for part in new_parts {
        let base = new_lines.first_line(part);
        for within in new_lines.parts()[part].networks() {
            let drawn = base + within.start..base + within.end;
            let start = parse.line_start(drawn.start);
            if let Some(index) = same_network(before, &drawn, change, &mut next_old, old.end) {
                gone[index - old.start] = false;
                bodies.push(before.bodies[index]);
                networks.push(Spliced {
                    id: Some(before.networks.id(index)),
                    facts: Arc::clone(before.networks.facts(index)),
                    first_line: drawn.start,
                    start,
                    scope: before.networks.at(index).scope,
                });
                continue;
            }
            added.push(old.start + networks.len());
            let near = networks.iter().zip(&bodies).rev();
            let near = near.map(|(network, body)| (network.scope, *body, network.first_line));
            let far = (0..old.start).rev().map(|index| {
                let network = before.networks.at(index);
                (network.scope, before.bodies[index], network.first_line)
            });
            let (scope, body) = around(parse, drawn.start, near.chain(far));
            let network = Network {
                lines: drawn.clone(),
                block: None,
            };
            let facts = network::network(parse, &network, known, &mut reading);
            bodies.push(body);
            networks.push(Spliced {
                id: None,
                facts: Arc::new(facts),
                first_line: drawn.start,
                start,
                scope,
            });
        }
    }
    let gone = old.clone().zip(gone).filter(|(_, gone)| *gone);
    let removed = gone.map(|(index, _)| Removed {
        id: before.networks.id(index),
        facts: Arc::clone(before.networks.facts(index)),
        scope: before.networks.at(index).scope,
        body: before.bodies[index],
    });
    Reread {
        removed: removed.collect(),
        old,
        networks,
        bodies,
        added,
    }
}

/// The network before the edit on the same lines as one behind it. `next`: the first that it may be, `end`: the first that it may not.
fn same_network(
    before: &Context,
    drawn: &Range<usize>,
    change: &Lines,
    next: &mut usize,
    end: usize,
) -> Option<usize> {
    let first_line = same_lines(drawn, change)?;
    let networks = &before.networks;
    while *next < end && networks.at(*next).first_line < first_line {
        *next += 1;
    }
    let is_it = *next < end && {
        let network = networks.at(*next);
        network.first_line == first_line && network.line_count() == drawn.len()
    };
    is_it.then_some(*next)
}

/// The scope and the body of a network that begins on a line. `above`: scopes, bodies and first lines of those above it, from the
/// nearest on.
fn around(
    parse: &Parse,
    line: usize,
    mut above: impl Iterator<Item = (usize, Body, usize)> + Clone,
) -> (usize, Body) {
    let is_frame = |line: &Line| matches!(line.kind, LineKind::BlockEnd | LineKind::BlockHeader);
    if let Some((scope, body, first)) = above.clone().next()
        && !parse.lines().range(first..line).any(is_frame)
    {
        return (scope, body);
    }
    let blocks = &parse.frame().blocks;
    let definition = |line: usize| blocks.iter().position(|block| block.lines.contains(&line));
    if let Some(block) = definition(line) {
        return (block + 1, Body::Block(block));
    }
    // It belongs to the function that begins above the definitions, if one does.
    let of_file = above.find(|(.., line)| definition(*line).is_none());
    (0, of_file.map_or(Body::Main, |(_, body, _)| body))
}

/// Whether labels that come and go are seen by jumps of the file alone, and no function begins or ends with them.
fn may_follow_labels<'f>(before: &Context, mut touched: impl Iterator<Item = &'f Arc<NetworkFacts>>) -> bool {
    let begins = |facts: &NetworkFacts| facts.blocks.iter().any(|block| block.op() == Some(Op::Fun));
    let jumps_out = |block: &UserBlockFacts| block.shape == Shape::Function;
    !touched.any(|facts| begins(facts)) && !before.user_blocks.iter().any(jumps_out)
}

/// The names in the first operands of the blocks of a network that are one instruction.
fn first_names(facts: &NetworkFacts, op: Op) -> impl Iterator<Item = Name> {
    let blocks = facts.blocks.iter().filter(move |block| block.op() == Some(op));
    blocks.filter_map(|block| Some(Name::new(block.facts.first_name()?.0)))
}

/// Whether other networks may mean something else when this one comes or goes: it has a label or begins a function.
fn is_marked(facts: &NetworkFacts) -> bool {
    facts.control_flow.has(ControlFlow::MARK)
}

/// The blocks of other files that networks name, in the order in which they do.
fn imported<'c>(
    before: &'c Context,
    networks: impl Iterator<Item = &'c Arc<NetworkFacts>>,
) -> impl Iterator<Item = usize> {
    let own = before.own_blocks;
    let strange = networks.filter(|facts| facts.user_blocks == UserBlocks::Others);
    let names = strange.flat_map(|facts| facts.blocks.iter().filter_map(BoundBlock::user_name));
    names.filter_map(move |name| {
        let key = Name::new(name);
        let mut imported = before.user_blocks[own..].iter();
        imported.position(|block| block.key == key)
    })
}
