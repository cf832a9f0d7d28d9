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
use crate::infer::{self, Entry};
use crate::known_blocks::KnownBlocks;
use crate::network::{self, BoundBlock, NetworkFacts, UserBlocks};
use crate::networks::neighbours::break_neighbours;
use crate::networks::{Networks, Spliced};
use crate::others::Others;
use crate::outward;
use crate::program::Role;
use crate::rare::Lead;
use crate::reading::Reading;
use crate::scope::{MOST_EXCHANGED, Origin, Scope, SectionKind, TagFacts, UseRef};
use crate::shared;
use crate::skeleton;
use crate::types::Type;
use crate::user_block::UserBlockFacts;
use crate::uses;
use ladder_instructions::{Op, Shape};
use ladder_syntax::{Line, LineKind, Name, Network, Parse, TextRange};
use rustc_hash::{FxHashMap, FxHashSet};
use smol_str::SmolStr;
use std::ops::Range;
use std::sync::{Arc, OnceLock};

/// Whether a context of a whole text can be the beginning: what a body names is declared in it, or a tag of the file. Tags of other
/// files that the file names are followed.
pub(crate) fn may_settle(context: &Context) -> bool {
    let followed = |tag: &TagFacts| {
        let origin = match tag.origin {
            Origin::Declared(SectionKind::External) => tag.rare.foreign.is_some() && !tag.mistyped,
            Origin::Shared => tag.is_imported_by_use(),
            _ => true,
        };
        origin && !tag.leads_elsewhere() && (!tag.mistyped || tag.is_declared())
    };
    let own = |tag: &TagFacts| followed(tag) && !tag.is_outward();
    let of_file = |tag: &TagFacts| {
        let is_named = matches!(tag.rare.lead, Some(Lead::Named(_)));
        is_named && tag.rare.foreign.is_none() && !tag.mistyped
    };
    let [file, bodies @ ..] = context.scopes.as_slice() else {
        return false;
    };
    let of_body = |body: &Scope| {
        let mut unusual = body.unusual();
        unusual.all(|(index, tag)| of_file(tag) || index < body.declared && own(tag))
    };
    file.unusual().all(|(_, tag)| followed(tag)) && bodies.iter().all(of_body)
}

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
    if news.declared.iter().any(is_outward) {
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
    next.note_outward(&tags);
    let used = news.used.into_iter().filter(is_outward);
    tags.used.extend(used.map(|name| (0, name)));
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
struct Edited {
    context: Context,
    /// The networks that are not there any more.
    removed: Vec<Removed>,
    /// The networks that are new.
    added: Vec<usize>,
    /// The networks in whose parts the edit lies.
    new: Range<usize>,
    /// One of those that are new or not there any more has a label.
    labelled: bool,
}

/// A network that is not there any more.
struct Removed {
    /// The number that it had.
    id: u32,
    facts: Arc<NetworkFacts>,
    scope: usize,
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
        let mut may_call = before.may_call;
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
                let (scope, body) = around(before, parse, drawn.start, above)?;
                let network = Network {
                    lines: drawn.clone(),
                    block: None,
                };
                let facts = network::network(parse, &network, &mut known, &mut reading);
                asks_others |= !facts.names_tags_only;
                may_call |= facts.control_flow.has(ControlFlow::CALL);
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
            may_call,
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
        for key in tags.used.iter().filter(|(scope, _)| *scope == 0) {
            let (_, name) = key;
            let tag = context.find_tag(key).filter(|tag| tag.is_outward());
            if tag.is_some_and(context::keeps_state) {
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

    /// A tag of a scope, and the tag of the file that it leads to.
    fn with_lead(&self, (scope, tag): Entry) -> impl Iterator<Item = Entry> + use<> {
        let facts = &self.context.scopes[scope].tags[tag];
        [Some((scope, tag)), self.context.leads_to(facts)]
            .into_iter()
            .flatten()
    }

    /// Enters what the new networks name, and takes out what the others did. Gives the tags that this concerns.
    fn names(&mut self) -> Option<EditedTags> {
        let gone: FxHashSet<u32> = self.removed.iter().map(|network| network.id).collect();
        let mut touched: FxHashMap<(usize, usize), Vec<UseRef>> = FxHashMap::default();
        for removed in &self.removed {
            for named in &removed.facts.named {
                let tag = self.context.scopes[removed.scope].find(&named.key)?;
                for entry in self.with_lead((removed.scope, tag)) {
                    touched.entry(entry).or_default();
                }
            }
        }
        // Tags that nobody has named before, in their order.
        let mut new: Vec<TagFacts> = Vec::new();
        let mut new_names: FxHashMap<Name, usize> = FxHashMap::default();
        for &index in &self.added {
            let network = self.context.networks.at(index);
            let id = self.context.networks.id(index);
            for (number, named) in (0..).zip(network.named.iter()) {
                let place = UseRef::new(id, number, named.kind);
                if let Some(tag) = self.context.scopes[network.scope].find(&named.key) {
                    for entry in self.with_lead((network.scope, tag)) {
                        touched.entry(entry).or_default().push(place);
                    }
                    continue;
                }
                if network.scope > 0 {
                    return None;
                }
                let at = match new_names.get(&named.key) {
                    Some(at) => *at,
                    None => {
                        let spelled = uses::spelling(network.facts(), named);
                        new.push(shared::brought_in(&self.context, spelled)?);
                        new_names.insert(named.key.clone(), new.len() - 1);
                        new.len() - 1
                    }
                };
                new[at].uses.0.push(place);
            }
        }
        let context = &mut self.context;
        let mut found: Vec<(usize, usize)> = Vec::new();
        let mut in_bodies: Vec<(usize, usize)> = Vec::new();
        let mut edited = EditedTags::default();
        for ((scope, tag), places) in touched {
            let is_found = tag >= context.scopes[scope].declared;
            // The places of one whose declaration says no type decide about that.
            if context.scopes[scope].tags[tag].mistyped {
                return None;
            }
            let facts = &mut context.scopes[scope].tags[tag];
            edited.used.push((scope, Name::new(&facts.name)));
            facts.uses.0.retain(|place| !gone.contains(&place.network));
            if !places.is_empty() {
                facts.uses.0.extend(places);
                let networks = &context.networks;
                facts.uses.0.sort_by_key(|place| networks.order_of(*place));
            }
            if is_found && scope > 0 {
                in_bodies.push((scope, tag));
            } else if is_found {
                found.push((scope, tag));
            }
        }
        for (scope, tag) in in_bodies {
            entry_stays(context, scope, tag)?;
        }
        let mut before: Vec<(usize, SmolStr, Option<Type>)> = Vec::new();
        for &(scope, tag) in &found {
            let facts = &context.scopes[scope].tags[tag];
            before.push((scope, facts.name.clone(), facts.ty));
            if !facts.uses.is_empty() {
                respelled(context, scope, tag);
                let typed = typed(context, &context.scopes[scope].tags[tag]);
                context.scopes[scope].tags[tag] = typed;
            }
        }
        let new: Vec<Arc<TagFacts>> = new.iter().map(|tag| Arc::new(typed(context, tag))).collect();
        // Another first use may mean another place among the tags.
        let in_file = found.iter().filter(|(scope, _)| *scope == 0);
        let found = in_file.map(|(_, tag)| *tag).collect();
        place_found(&mut context.scopes[0], found, new, &context.networks);
        let fresh = new_names.keys().map(|name| (0, name.clone())).collect();
        edited.infer_again(context, &before, fresh)?;
        edited.used.extend(new_names.into_keys().map(|name| (0, name)));
        Some(edited)
    }
}

/// The scope and the body of a network on this line, which is the first behind the one of which scope, body and line are given.
fn around(
    before: &Context,
    parse: &Parse,
    line: usize,
    above: Option<(usize, Body, usize)>,
) -> Option<(usize, Body)> {
    let is_frame = |line: &Line| matches!(line.kind, LineKind::BlockEnd | LineKind::BlockHeader);
    if let Some((scope, body, first)) = above
        && !parse.lines().range(first..line).any(is_frame)
    {
        return Some((scope, body));
    }
    let mut blocks = parse.frame().blocks.iter();
    match blocks.position(|block| block.lines.contains(&line)) {
        Some(block) => Some((block + 1, Body::Block(block))),
        // It may belong to a function that begins above a definition.
        None => before.functions.is_empty().then_some((0, Body::Main)),
    }
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

/// Puts tags that are only used to their places, by their first uses: some that are there, which may be used no more, and
/// new ones.
pub(crate) fn place_found(
    scope: &mut Scope,
    mut touched: Vec<usize>,
    new: Vec<Arc<TagFacts>>,
    networks: &Networks,
) {
    let first_use = |tag: &TagFacts| tag.uses.0.first().map(|place| networks.order_of(*place));
    if touched.len() > MOST_EXCHANGED {
        scope.exchange_found(&touched, new, first_use);
        return;
    }
    touched.sort_unstable();
    let is_touched = |tag: &usize| touched.binary_search(tag).is_ok();
    let key = |tag: usize| first_use(&scope.tags[tag]);
    // Between those that nothing has happened to.
    let is_in_place = |tag: usize| {
        let mut above = (scope.declared..tag).rev().filter(|tag| !is_touched(tag));
        let mut below = (tag + 1..scope.tags.len()).filter(|tag| !is_touched(tag));
        let own = key(tag);
        own.is_some()
            && above.next().is_none_or(|above| key(above) < own)
            && below.next().is_none_or(|below| own < key(below))
    };
    let (stay, mut moved): (Vec<usize>, Vec<usize>) = touched.iter().partition(|tag| is_in_place(**tag));
    if !stay.is_sorted_by_key(|tag| key(*tag)) {
        moved.extend(stay);
        moved.sort_unstable();
    }
    if moved.is_empty() && new.is_empty() {
        return;
    }
    scope.exchange_found(&moved, new, first_use);
}

/// How a tag is spelled at a place.
pub(crate) fn spelled_at(context: &Context, place: UseRef) -> &str {
    let network = context.networks.index_of(place.network);
    let network = context.networks.at(network).facts();
    uses::spelling(network, &network.named[place.named() as usize])
}

/// Whether a body's entry for a tag of the file stays as it is but for its uses. None: it is gone, is spelled in another way, or is in
/// another place among those of the body.
fn entry_stays(context: &Context, scope: usize, tag: usize) -> Option<()> {
    let body = &context.scopes[scope];
    let entry = &body.tags[tag];
    let first = entry.uses.0.first()?;
    let first_uses = body.tags.from(body.declared).map(|tag| tag.uses.0.first());
    let in_order = first_uses.is_sorted_by_key(|first| first.map(|place| context.networks.order_of(*place)));
    (in_order && spelled_at(context, *first) == entry.name).then_some(())
}

/// A tag is spelled as where it is first.
fn respelled(context: &mut Context, scope: usize, tag: usize) {
    let facts = &context.scopes[scope].tags[tag];
    let Some(place) = facts.uses.0.first() else { return };
    if facts.rare.foreign.is_some() {
        return;
    }
    let name = spelled_at(context, *place);
    if *facts.name != *name {
        let spelled = uses::undeclared(name, context.profile.law());
        let facts = &mut context.scopes[scope].tags[tag];
        facts.name = spelled.name;
        // To write it makes room for it.
        if facts.rare.address != spelled.rare.address {
            facts.rare.address.clone_from(&spelled.rare.address);
        }
    }
}

/// A tag with the type and the role that its places give it, if neither a declaration nor its name says them. It has no type yet
/// if that follows from its company.
pub(crate) fn typed(context: &Context, tag: &TagFacts) -> TagFacts {
    let mut tag = tag.clone();
    if !tag.is_inferred() {
        return tag;
    }
    tag.by_company = false;
    tag.ty = infer::answer(context, &tag);
    if tag.origin == Origin::Undeclared {
        tag.role = if tag.ty == Some(Type::BOOL) {
            uses::role(&tag.uses)
        } else {
            Role::Internal
        };
    }
    tag
}
