//! What a user-defined block does takes the place of one call of it. This is done where its body is one network that
//! begins with `EN` and ends with `ENO`, and where the operands can stand for what the body calls them.

use super::flow::is_flow;
use super::names::{new_tag, operand};
use super::place::{OnNetwork, Selected};
use super::{Action, ActionKind};
use crate::drawing::item::ItemKind;
use crate::drawing::passing::splice;
use crate::drawing::region::Region;
use crate::drawing::rows::{Drawing, Row};
use ladder_analysis::context::{Body, Context};
use ladder_analysis::names::declaring::Places;
use ladder_analysis::names::scope::{Origin, Scope, SectionKind, TagFacts};
use ladder_analysis::networks::BlockAt;
use ladder_analysis::networks::network::{Formal, Meaning};
use ladder_analysis::program::Access;
use ladder_analysis::program::ParameterKind;
use ladder_analysis::values::types::{Scalar, Type};
use ladder_analysis::written::facts::NodeKind;
use ladder_format::Edit;
use ladder_instructions::Op;
use ladder_syntax::Name;

pub(super) fn offer(place: &Selected<'_>, out: &mut Vec<Action>) {
    let Some(on) = &place.on else { return };
    let Some(block) = on.block() else { return };
    let Meaning::User(definition) = block.meaning else {
        return;
    };
    let title = format!("Inline the block `{}` here", block.head_text());
    match inlined(place, on, block, definition) {
        Ok(edits) => out.push(Action::new(ActionKind::Inline, title, edits)),
        Err(why) => out.push(Action::disabled(ActionKind::Inline, title, why)),
    }
}

fn inlined(
    place: &Selected<'_>,
    on: &OnNetwork<'_>,
    call: BlockAt<'_>,
    definition: usize,
) -> Result<Vec<Edit>, String> {
    let context = place.context;
    if definition >= context.own_blocks {
        return Err("the block is in another file".to_owned());
    }
    if place.has_errors() {
        return Err("fix the errors of the file first".to_owned());
    }
    if call
        .formals
        .iter()
        .any(|formal| matches!(formal, Formal::Instance))
    {
        return Err("its state belongs to a tag that others may read".to_owned());
    }
    let body = body(context, definition)?;
    let text = on
        .items
        .as_ref()
        .map(|(row, items)| on.drawing.rows[*row].items[items.start].text.as_str())
        .unwrap_or_default();
    let mut words = Words {
        place,
        inner: &context.scopes[definition + 1],
        outer: &context.scopes[on.facts.scope],
        new: Vec::new(),
    };
    let replaced = words.replacements(call, text, definition, &body)?;
    let mut rows = body.region.copy(&body.drawing);
    for row in &mut rows {
        for item in &mut row.items {
            let at = item.at;
            let inside = replaced.iter().filter(|(range, _)| at.contains_range(*range));
            let mut inside: Vec<_> = inside.collect();
            inside.sort_by_key(|(range, _)| std::cmp::Reverse(range.start()));
            for (range, new) in inside {
                let range = *range - at.start();
                item.text
                    .replace_range(std::ops::Range::<usize>::from(range), new);
            }
            if item.is_block() {
                item.kind = ItemKind::Block(None);
            }
        }
    }
    let drawing = in_place(on, rows).ok_or("the body cannot be drawn in this place")?;
    let mut edits = vec![drawing.replace()];
    edits.extend(words.declarations(context, on.facts.scope)?);
    Ok(edits)
}

/// The network of a body, and what of it is between `EN` and `ENO`.
struct Inner {
    network: usize,
    drawing: Drawing,
    region: Region,
}

fn body(context: &Context, definition: usize) -> Result<Inner, String> {
    let form = || "its body is not one network from a contact `EN` to a coil `ENO`".to_owned();
    let bodies = context.bodies.iter().enumerate();
    let mut networks = bodies.filter(|(_, body)| **body == Body::Block(definition));
    let (Some((network, _)), None) = (networks.next(), networks.next()) else {
        return Err(form());
    };
    let facts = context.networks.at(network);
    let drawing = Drawing::read(context, network).ok_or_else(form)?;
    let items = &drawing.rows[0].items;
    let first = drawing.drawn_start(0);
    let is = |index: usize, op: Op, name: &str| match items.get(index).map(|item| item.kind) {
        Some(ItemKind::Block(Some(number))) => {
            let block = facts.block(number);
            let operand = block.facts.operands.first().map(|operand| &operand.value.kind);
            block.op() == Some(op)
                && matches!(operand, Some(NodeKind::Name(it)) if it.eq_ignore_ascii_case(name))
        }
        _ => false,
    };
    let rail = items
        .get(first)
        .is_some_and(|item| item.kind == ItemKind::LeftRail);
    let end = (first..items.len()).find(|&index| is(index, Op::Coil, "ENO"));
    let (true, true, Some(end)) = (rail, is(first + 1, Op::Contact, "EN"), end) else {
        return Err(form());
    };
    let region = Region::of(&drawing, 0, first + 2..end).ok_or_else(form)?;
    let scope = &context.scopes[definition + 1];
    let once = |name: &str| {
        let tag = scope.find(&Name::new(name)).map(|tag| &scope.tags[tag]);
        tag.is_some_and(|tag| tag.uses.len() == 1)
    };
    let after = &items[end + 1..];
    let ends = after
        .iter()
        .all(|item| matches!(item.kind, ItemKind::RightRail | ItemKind::Comment));
    if !once("EN") || !once("ENO") || !ends || region.blocks(&drawing).len() + 2 != facts.blocks.len() {
        return Err(form());
    }
    if facts.blocks.iter().any(is_flow) {
        return Err("its body holds blocks of program flow".to_owned());
    }
    Ok(Inner {
        network,
        drawing,
        region,
    })
}

/// The caller's drawing with the rows of the body in the place of the call, if all runs in the same order.
fn in_place(on: &OnNetwork<'_>, mut rows: Vec<Row>) -> Option<Drawing> {
    let (row, items) = on.items.clone()?;
    let at = items.start;
    let mut drawing = on.drawing.clone();
    let call = &mut drawing.rows[row].items[at];
    let ItemKind::Block(Some(number)) = call.kind else {
        return None;
    };
    rows[0].items.first_mut()?.joined = call.joined;
    call.joined = true;
    let count = rows
        .iter()
        .flat_map(|row| &row.items)
        .filter(|item| item.is_block())
        .count();
    splice(&mut drawing, row, at, rows);
    let items = &mut drawing.rows[row].items;
    items.retain(|item| item.kind != ItemKind::Block(Some(number)));
    let expected = on.drawing.order()?;
    let expected: Vec<Option<usize>> = expected
        .into_iter()
        .flat_map(|block| match block {
            Some(block) if block == number => vec![None; count],
            other => vec![other],
        })
        .collect();
    (drawing.order()? == expected).then_some(drawing)
}

/// What the names of the body become.
struct Words<'a> {
    place: &'a Selected<'a>,
    inner: &'a Scope,
    outer: &'a Scope,
    /// New tags, for what the block keeps to itself.
    new: Vec<(String, Type, bool)>,
}

type Replacement = (ladder_syntax::TextRange, String);

impl Words<'_> {
    fn replacements(
        &mut self,
        call: BlockAt<'_>,
        text: &str,
        definition: usize,
        body: &Inner,
    ) -> Result<Vec<Replacement>, String> {
        let parameters = &self.place.context.user_blocks[definition].parameters;
        let mut replaced = Vec::new();
        let mut given: Vec<(Name, bool)> = Vec::new();
        for (index, tag) in self.inner.tags.iter().enumerate() {
            if tag.origin == Origin::Implicit {
                continue;
            }
            if is_outside(tag) {
                self.same_outside(tag)?;
                given.push((Name::new(&tag.name), true));
                continue;
            }
            let formal = parameters.iter().position(|parameter| parameter.tag == index);
            let new = match formal {
                None => self.own(tag)?,
                Some(formal) => {
                    let number = call
                        .formals
                        .iter()
                        .position(|it| matches!(it, Formal::Parameter(at) if *at == formal));
                    match number {
                        None if parameters[formal].kind == ParameterKind::Output => self.own(tag)?,
                        None => return Err(format!("the operand `{}` is left out", tag.name)),
                        Some(number) => {
                            let written = operand(&call, text, number).unwrap_or_default();
                            let node = &call.facts.operands[number].value.kind;
                            self.fits(tag, parameters[formal].kind, node, body)?;
                            if let NodeKind::Name(name) | NodeKind::Address(name) = node {
                                let writes = tag.uses.accesses().any(Access::writes);
                                given.push((Name::new(name), writes));
                            }
                            written.to_owned()
                        }
                    }
                }
            };
            replaced.extend(
                self.place
                    .context
                    .uses(tag)
                    .map(|place| (place.range, new.clone())),
            );
        }
        // One tag under two names: what is written under one would be read under the other too soon.
        for (at, (name, writes)) in given.iter().enumerate() {
            let mut others = given.iter().enumerate().filter(|(other, _)| *other != at);
            if others.any(|(_, (other, other_writes))| other == name && (*writes || *other_writes)) {
                return Err(format!(
                    "`{}` is given for two operands, or used in the body too",
                    name.as_str()
                ));
            }
        }
        Ok(replaced)
    }

    /// A tag that the body shares with all others must mean the same in the caller.
    fn same_outside(&self, tag: &TagFacts) -> Result<(), String> {
        let found = self
            .outer
            .find(&Name::new(&tag.name))
            .map(|found| &self.outer.tags[found]);
        match found {
            Some(found) if !is_outside(found) => {
                Err(format!("`{}` is another tag here than in the body", tag.name))
            }
            _ => Ok(()),
        }
    }

    /// A tag that the block keeps to itself becomes a new one.
    fn own(&mut self, tag: &TagFacts) -> Result<String, String> {
        let name = &tag.name;
        if !tag.cold.initial.is_empty() || tag.retain || tag.constant {
            return Err(format!(
                "`{name}` in the body has an initial value, or is retentive"
            ));
        }
        let ty = tag
            .ty
            .ok_or_else(|| format!("the type of `{name}` is not known"))?;
        let taken: Vec<String> = self.new.iter().map(|(name, ..)| name.clone()).collect();
        let key = Name::new(name);
        let free = self.outer.find(&key).is_none() && !taken.iter().any(|taken| Name::new(taken) == key);
        let new = if free {
            name.to_string()
        } else {
            new_tag(self.place.context, &taken, name)
        };
        let written = tag.uses.accesses().any(Access::writes);
        let known_by_use = match ty {
            Type::State(_) => true,
            Type::Scalar(Scalar::Bool) => written,
            _ => false,
        };
        self.new.push((new.clone(), ty, known_by_use));
        Ok(new)
    }

    /// Whether an operand can be wherever the body says its parameter.
    fn fits(&self, tag: &TagFacts, kind: ParameterKind, node: &NodeKind, body: &Inner) -> Result<(), String> {
        let name = &tag.name;
        let mut uses = self.place.context.uses(tag);
        let written = tag.uses.accesses().any(Access::writes);
        let read = tag.uses.accesses().any(Access::reads);
        match node {
            NodeKind::Name(argument) | NodeKind::Address(argument) => {
                let found = self
                    .outer
                    .find(&Name::new(argument))
                    .map(|found| &self.outer.tags[found]);
                if found.is_none_or(|found| found.ty != tag.ty) {
                    return Err(format!("the operand for `{name}` has another type than it"));
                }
            }
            NodeKind::Literal(_) if kind == ParameterKind::Input => {
                if tag.ty == Some(Type::BOOL) || uses.any(|place| !place.whole) {
                    return Err(format!("a literal cannot stand for `{name}` in the body"));
                }
            }
            _ => return Err(format!("the operand for `{name}` is not a plain tag or literal")),
        }
        match kind {
            ParameterKind::Input if written => Err(format!("the body writes its input `{name}`")),
            ParameterKind::Output => {
                let facts = self.place.context.networks.at(body.network);
                let always = uses.all(|place| {
                    place.whole && matches!(facts.blocks[place.block].op(), Some(Op::Coil | Op::NegatedCoil))
                });
                if always && !read && !tag.uses.is_empty() {
                    return Ok(());
                }
                Err(format!("the output `{name}` is not written by a coil alone"))
            }
            _ => Ok(()),
        }
    }

    fn declarations(self, context: &Context, scope: usize) -> Result<Vec<Edit>, String> {
        let declares = scope > 0 || context.scopes[0].declares();
        let needed = self
            .new
            .iter()
            .filter(|(_, _, known_by_use)| declares || !known_by_use);
        let tags: Vec<_> = needed
            .map(|(name, ty, _)| (SectionKind::Var, name.clone(), ty.to_string()))
            .collect();
        let closed = || "a section of declarations is not closed".to_owned();
        Places::new(context, scope).declare_all(&tags).ok_or_else(closed)
    }
}

/// Whether a tag is one of another scope, or the same in all.
fn is_outside(tag: &TagFacts) -> bool {
    tag.is_alias()
        || tag.cold.foreign.is_some()
        || tag.cold.address.is_some() && tag.origin != Origin::Declared(SectionKind::Var)
        || matches!(
            tag.origin,
            Origin::Shared | Origin::Declared(SectionKind::Global | SectionKind::External)
        )
}
