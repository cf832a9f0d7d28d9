//! The context of a text behind a small edit, from the one before it.
//!
//! An edit that touches rungs, rails, comments and blank lines alone changes what a few networks
//! name, and with it the uses of a few tags. All else is taken over: networks and tags are shared with the context
//! before, and only the plain numbers that say where networks are get copied. What comes out is what reading the whole
//! text gives; where that is not certain there is no short way, and the whole text is read.

use crate::company;
use crate::context::{self, Body, Context};
use crate::control_flow::ControlFlow;
use crate::declaring::PlacesOfScopes;
use crate::edited_declarations;
use crate::edited_lines::{Change, Lines, change, same_lines};
use crate::infer::Entry;
use crate::known_blocks::KnownBlocks;
use crate::network::{self, BoundBlock, NetworkFacts, UserBlocks};
use crate::networks::Spliced;
use crate::networks::neighbours::break_neighbours;
use crate::others::Others;
use crate::outward;
use crate::reading::Reading;
use crate::scope::TagFacts;
use crate::skeleton;
use crate::types::Type;
use crate::user_block::UserBlockFacts;
use ladder_instructions::{Op, Shape};
use ladder_syntax::{Line, LineKind, Name, Network, Parse, TextRange};
use smol_str::SmolStr;
use std::ops::Range;
use std::sync::{Arc, OnceLock};

/// The context of a text that came from another one's by edits; none if it takes more than a look at what they touch.
pub(crate) fn edited(before: &Context, parse: &Arc<Parse>, name: &str, others: &Others) -> Option<Context> {
    if !before.settled || !before.is_called(name) {
        return None;
    }
    // What they say of functions and blocks is not followed one by one.
    if before.asks_others && !others.are_the_same(&before.others) {
        return None;
    }
    let news = others.news_since(&before.others)?;
    let is_outward = |name: &Name| {
        before
            .find_tag(&(0, name.clone()))
            .is_some_and(TagFacts::is_outward)
    };
    let is_named = |name: &Name| {
        is_outward(name) || before.named_in_bodies.contains(name) || before.wrong_globals.is_about(name)
    };
    if news.declared.iter().any(is_named) {
        return None;
    }
    let change = change(before, parse)?;
    let (Change::Networks(lines) | Change::Declarations(lines)) = &change;
    let mut next = Edited::networks(before, parse, lines)?;
    next.context.others = others.clone();
    next.places(before);
    let mut tags = match &change {
        Change::Networks(lines) => {
            edited_declarations::move_declared(&mut next.context, before, lines)?;
            next.names()?
        }
        Change::Declarations(lines) => edited_declarations::enter(&mut next.context, before, lines)?,
    };
    let concerned = tags.used.iter().chain(&tags.retyped);
    if concerned
        .map(|(_, name)| name)
        .any(|name| before.wrong_globals.is_about(name))
    {
        return None;
    }
    next.note_outward(&tags);
    let used = news.used.into_iter().filter(is_outward);
    tags.used.extend(used.map(|name| (0, name)));
    tags.namesakes_in_bodies(&next.context);
    let networks = next.looked_at(before);
    let Edited {
        mut context, removed, ..
    } = next;
    context.change = Some(context::Change {
        since: before.serial,
        networks,
        removed: removed.iter().map(|network| network.id).collect(),
        tags: tags.used,
        retyped: tags.retyped,
    });
    Some(context)
}

/// The tags that an edit concerns.
#[derive(Default)]
pub(crate) struct EditedTags {
    /// Those that are used at other places, or declared at others.
    pub(crate) used: Vec<(usize, Name)>,
    /// Those that have another type or spelling.
    pub(crate) retyped: Vec<(usize, Name)>,
}

impl EditedTags {
    /// Another tag of the file has this name now.
    pub(crate) fn touched(&mut self, name: &Name) {
        self.used.push((0, name.clone()));
        self.retyped.push((0, name.clone()));
    }

    /// What is said of an undeclared tag of a body depends on whether the program has one of its name.
    fn namesakes_in_bodies(&mut self, context: &Context) {
        let of_file = self.used.iter().filter(|(scope, _)| *scope == 0);
        let named = of_file.filter(|(_, name)| context.named_in_bodies.contains(name));
        let bodies = named.flat_map(|(_, name)| (1..context.scopes.len()).map(|scope| (scope, name.clone())));
        let there: Vec<(usize, Name)> = bodies.filter(|key| context.find_tag(key).is_some()).collect();
        self.used.extend(there);
    }

    /// Infers the types that depend on places. `before`: tags with their spelling and type before the edit, which may be gone;
    /// `fresh`: tags that have come. None if they concern too many others.
    pub(crate) fn infer_again(
        &mut self,
        context: &mut Context,
        before: &[(usize, SmolStr, Option<Type>)],
        fresh: Vec<(usize, Name)>,
    ) -> Option<()> {
        let others = |context: &Context| -> Vec<(usize, Name)> {
            let named = before
                .iter()
                .map(|(scope, spelled, ty)| ((*scope, Name::new(spelled)), spelled, *ty));
            let is_other = |(key, spelled, ty): &((usize, Name), &SmolStr, Option<Type>)| {
                let tag = context.find_tag(key);
                tag.is_none_or(|tag| tag.ty != *ty || tag.name != **spelled)
            };
            named.filter(is_other).map(|(key, ..)| key).collect()
        };
        let changed = others(context).into_iter().chain(fresh);
        let changed = changed.filter_map(|(scope, name)| Some((scope, context.scopes[scope].find(&name)?)));
        let changed: Vec<Entry> = changed.collect();
        for (scope, tag) in company::infer_again(context, &changed)? {
            let name = Name::new(&context.scopes[scope].tags[tag].name);
            self.used.push((scope, name.clone()));
            self.retyped.push((scope, name));
        }
        self.retyped.extend(others(context));
        Some(())
    }
}

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
}

impl Edited {
    /// Takes over the networks on whose lines nothing has changed, and reads the others.
    fn networks(before: &Context, parse: &Arc<Parse>, change: &Lines) -> Option<Edited> {
        let (old_lines, new_lines) = (before.parse.lines(), parse.lines());
        let (new_parts, old_parts) = new_lines.parts_changed_since(old_lines);
        let lines = old_lines.first_line(old_parts.start)..old_lines.first_line(old_parts.end);
        let networks = &before.networks;
        let first = networks.partition_point(|network| network.first_line < lines.start);
        let end = networks.partition_point(|network| network.first_line < lines.end);
        let mut gone: Vec<bool> = vec![true; end - first];
        let mut reading = Reading::default();
        let mut known = KnownBlocks::new(before.user_blocks.clone(), &before.others);
        let mut spliced = Vec::new();
        let mut bodies: Vec<Body> = Vec::new();
        let mut added = Vec::new();
        let mut may_jump = before.may_jump;
        let mut asks_others = before.asks_others;
        let mut next_old = first;
        for part in new_parts {
            let base = new_lines.first_line(part);
            for within in new_lines.parts()[part].networks() {
                let drawn = base + within.start..base + within.end;
                let start = parse.line_start(drawn.start);
                let same = same_lines(&drawn, change).and_then(|at| {
                    while next_old < end && networks.at(next_old).first_line < at {
                        next_old += 1;
                    }
                    let is_it = next_old < end && networks.at(next_old).first_line == at;
                    (is_it && networks.at(next_old).line_count() == drawn.len()).then_some(next_old)
                });
                if let Some(index) = same {
                    gone[index - first] = false;
                    let place = networks.at(index);
                    bodies.push(before.bodies[index]);
                    spliced.push(Spliced {
                        id: Some(networks.id(index)),
                        facts: Arc::clone(networks.facts(index)),
                        first_line: drawn.start,
                        start,
                        scope: place.scope,
                    });
                    continue;
                }
                let index = first + spliced.len();
                let above = match (spliced.last(), first.checked_sub(1)) {
                    (Some(last), _) => Some((last.scope, *bodies.last()?, last.first_line)),
                    (None, Some(last)) => {
                        let place = networks.at(last);
                        Some((place.scope, before.bodies[last], place.first_line))
                    }
                    (None, None) => None,
                };
                let near = spliced.iter().zip(&bodies).rev();
                let near = near.map(|(network, body)| (network.first_line, *body));
                let far = (0..first).rev();
                let far = far.map(|index| (networks.at(index).first_line, before.bodies[index]));
                let (scope, body) = around(parse, drawn.start, above, near.chain(far));
                let network = Network {
                    lines: drawn.clone(),
                    block: None,
                };
                let facts = network::network(parse, &network, &mut known, &mut reading);
                asks_others |= !facts.names_tags_only;
                may_jump |= facts.control_flow.has(ControlFlow::JUMP);
                added.push(index);
                bodies.push(body);
                spliced.push(Spliced {
                    id: None,
                    facts: Arc::new(facts),
                    first_line: drawn.start,
                    start,
                    scope,
                });
            }
        }
        let gone = (first..end).zip(gone).filter(|(_, gone)| *gone);
        let removed = gone.map(|(index, _)| Removed {
            id: networks.id(index),
            facts: Arc::clone(networks.facts(index)),
            scope: networks.at(index).scope,
        });
        let removed: Vec<Removed> = removed.collect();
        let new_facts = spliced.iter().filter(|network| network.id.is_none());
        // They have their numbers in the order in which the file first names them.
        let old = removed.iter().map(|network| &network.facts);
        let new = new_facts.clone().map(|network| &network.facts);
        if known.list().len() != before.user_blocks.len() || !imported(before, old).eq(imported(before, new))
        {
            return None;
        }
        let touched = || {
            let new = new_facts.clone().map(|network| &network.facts);
            new.chain(removed.iter().map(|network| &network.facts))
        };
        let labelled = touched().any(|facts| is_marked(facts));
        if labelled && !may_follow_labels(before, touched()) {
            return None;
        }
        if networks.len() - (end - first) + spliced.len() == 0 {
            return None;
        }
        let new = first..first + spliced.len();
        let ids = removed.iter().map(|network| network.id).collect();
        let mut context = Context {
            parse: Arc::clone(parse),
            serial: context::next_serial(),
            may_jump,
            asks_others,
            foreign_comments: OnceLock::new(),
            joined: None,
            places: PlacesOfScopes::default(),
            ..before.clone()
        };
        context
            .networks
            .splice(first..end, spliced, ids, change.added, change.added_bytes);
        let calls = |facts: &NetworkFacts| facts.control_flow.has(ControlFlow::CALL);
        let called: Vec<u32> = removed
            .iter()
            .filter(|it| calls(&it.facts))
            .map(|it| it.id)
            .collect();
        let new_calls = added
            .iter()
            .filter(|&&index| calls(context.networks.facts(index)));
        let new_calls: Vec<u32> = new_calls.map(|&index| context.networks.id(index)).collect();
        if called != new_calls {
            let calling = Arc::make_mut(&mut context.calling);
            for id in called {
                calling.remove(&id);
            }
            calling.extend(new_calls);
        }
        if context.bodies[first..end] != *bodies {
            Arc::make_mut(&mut context.bodies).splice(first..end, bodies);
        }
        Some(Edited {
            context,
            removed,
            added,
            new,
            labelled,
        })
    }

    /// Gives labels and functions their new places, and looks anew which networks around the edit have a mistake.
    fn places(&mut self, before: &Context) {
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
    fn looked_at(&self, before: &Context) -> Vec<usize> {
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
            let jumps = networks
                .iter()
                .filter(|it| it.control_flow.has(ControlFlow::JUMP));
            again.extend(jumps.map(|network| network.index));
            again.sort_unstable();
            again.dedup();
        }
        again
    }

    /// Notes how tags are used that may be those of other files, and on which of these a block keeps its state.
    fn note_outward(&mut self, tags: &EditedTags) {
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

/// The scope and the body of a network on this line, which is the first behind the one of which scope, body and line are given.
/// `all_above`: lines and bodies of all networks above, from the nearest on.
fn around(
    parse: &Parse,
    line: usize,
    above: Option<(usize, Body, usize)>,
    mut all_above: impl Iterator<Item = (usize, Body)>,
) -> (usize, Body) {
    let is_frame = |line: &Line| matches!(line.kind, LineKind::BlockEnd | LineKind::BlockHeader);
    if let Some((scope, body, first)) = above
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
    let of_file = all_above.find(|(line, _)| definition(*line).is_none());
    (0, of_file.map_or(Body::Main, |(_, body)| body))
}

/// Whether labels that come and go are seen by jumps of the file alone, and no function begins or ends with them.
fn may_follow_labels<'f>(before: &Context, mut touched: impl Iterator<Item = &'f Arc<NetworkFacts>>) -> bool {
    let begins = |facts: &NetworkFacts| facts.blocks.iter().any(|block| block.op() == Some(Op::Fun));
    let jumps_out = |block: &UserBlockFacts| block.shape == Shape::Function;
    !touched.any(|facts| begins(facts)) && !before.user_blocks.iter().any(jumps_out)
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
