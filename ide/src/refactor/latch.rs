//! A pair of a set and a reset coil becomes a seal-in, and back. Both do the same: which of the two wins where set and
//! reset come together is kept, and where anything else writes the tag neither is done.

use super::flow::{has_mcr, is_flow};
use super::place::Selected;
use super::wrap_branch::only_reads;
use super::{Action, ActionKind};
use crate::drawing::item::{Item, ItemKind};
use crate::drawing::rows::{Drawing, lines_text};
use crate::drawing::term::{Rung, items};
use ladder_analysis::context::Context;
use ladder_analysis::names::scope::{Origin, SectionKind, TagFacts};
use ladder_analysis::networks::network::BoundBlock;
use ladder_analysis::written::facts::{Node, NodeKind};
use ladder_format::{Circuit, Edit};
use ladder_instructions::Op;
use ladder_syntax::{LineKind, Name, TextRange};

type Parts = Vec<Circuit<Item>>;

/// A network that ends with one coil.
struct Output<'c> {
    drawing: Drawing,
    rung: Rung,
    /// What is before the coil.
    before: Parts,
    coil: &'c BoundBlock,
    blocks: &'c [BoundBlock],
    network: usize,
    /// The tag's name, as it is written.
    tag: String,
}

impl<'c> Output<'c> {
    fn read(context: &'c Context, network: usize) -> Option<Output<'c>> {
        let drawing = Drawing::read(context, network)?;
        let rung = Rung::read(&drawing)?;
        let blocks = &context.networks.at(network).facts().blocks;
        let mut before = rung.parts.clone();
        let Some(Circuit::Element(Item {
            kind: ItemKind::Block(Some(number)),
            ..
        })) = before.pop()
        else {
            return None;
        };
        let coil = &blocks[number];
        let has_block = before.iter().flat_map(items).any(Item::is_block);
        if !has_block || blocks.iter().any(|block| block.faulty || is_flow(block)) {
            return None;
        }
        let tag = plain_tag(coil)?.to_owned();
        Some(Output {
            drawing,
            rung,
            before,
            coil,
            blocks,
            network,
            tag,
        })
    }

    fn is_tag(&self, name: &str) -> bool {
        Name::new(name) == Name::new(&self.tag)
    }

    /// The circuit that is high where contacts are not: none where they are anything but plain contacts of other tags.
    fn inverted(&self, circuit: &Circuit<Item>) -> Option<Circuit<Item>> {
        Some(match circuit {
            Circuit::Element(item) => {
                let ItemKind::Block(Some(number)) = item.kind else {
                    return None;
                };
                let block = &self.blocks[number];
                let head = match block.op() {
                    Some(Op::Contact) => "[/]",
                    Some(Op::NegatedContact) => "[ ]",
                    _ => return None,
                };
                let operand = &block.facts.operands.first()?.value;
                if !is_plain(operand) || mentions(operand, &self.tag) {
                    return None;
                }
                let list = block.facts.list_range? - block.facts.range.start();
                let list = item.text.get(std::ops::Range::<usize>::from(list))?;
                Circuit::Element(Item::block(format!("{head}{list}")))
            }
            Circuit::Series(parts) => {
                // A bare wire next to a contact is always high.
                let blocks: Option<Vec<_>> = parts.iter().map(|part| self.inverted(part)).collect();
                one_or(blocks.filter(|blocks| !blocks.is_empty())?, Circuit::Parallel)
            }
            Circuit::Parallel(branches) => {
                let branches: Option<Vec<_>> = branches.iter().map(|part| self.inverted(part)).collect();
                one_or(branches?, Circuit::Series)
            }
        })
    }

    fn inverted_all(&self, parts: &[Circuit<Item>]) -> Option<Circuit<Item>> {
        self.inverted(&Circuit::Series(parts.to_vec()))
    }

    /// Whether parts name the tag itself.
    fn any_mentions(&self, parts: &[Circuit<Item>]) -> bool {
        let blocks = parts.iter().flat_map(items).filter_map(|item| match item.kind {
            ItemKind::Block(Some(number)) => self.blocks.get(number),
            _ => None,
        });
        let mut operands = blocks.flat_map(|block| &block.facts.operands);
        operands.any(|operand| mentions(&operand.value, &self.tag))
    }
}

fn one_or(mut parts: Parts, many: fn(Parts) -> Circuit<Item>) -> Circuit<Item> {
    match parts.pop() {
        Some(only) if parts.is_empty() => only,
        last => {
            parts.extend(last);
            many(parts)
        }
    }
}

/// The tag that a coil or contact stands for, if it is a tag as a whole.
fn plain_tag(block: &BoundBlock) -> Option<&str> {
    match &block.facts.operands[..] {
        [operand] => match &operand.value.kind {
            NodeKind::Name(name) | NodeKind::Address(name) => Some(name),
            _ => None,
        },
        _ => None,
    }
}

/// Whether a contact of an operand is low exactly where the other contact of it is high: not so for ranges, nor where an
/// index may be outside its array.
fn is_plain(node: &Node) -> bool {
    match &node.kind {
        NodeKind::Name(_) | NodeKind::Address(_) => true,
        NodeKind::Member(base, _) => is_plain(base),
        _ => false,
    }
}

fn mentions(node: &Node, tag: &str) -> bool {
    match &node.kind {
        NodeKind::Name(name) | NodeKind::Address(name) => Name::new(name) == Name::new(tag),
        NodeKind::Member(base, _) => mentions(base, tag),
        NodeKind::Index(base, index) => mentions(base, tag) || mentions(index, tag),
        NodeKind::Range(base, first, last) => [base, first, last].iter().any(|node| mentions(node, tag)),
        NodeKind::Unary(_, inner) | NodeKind::Paren(inner) => mentions(inner, tag),
        NodeKind::Binary(_, left, right) => mentions(left, tag) || mentions(right, tag),
        NodeKind::Call(_, values) | NodeKind::Array(values) | NodeKind::Repeat(_, values) => {
            values.iter().any(|node| mentions(node, tag))
        }
        NodeKind::Members(_) | NodeKind::Literal(_) | NodeKind::NoFunction | NodeKind::Missing => false,
    }
}

/// Why the writes of these coils, of which there are `count`, cannot be changed.
fn obstacle(context: &Context, output: &Output<'_>, count: usize) -> Option<String> {
    let name = &output.tag;
    let scope = &context.scopes[context.networks.at(output.network).scope];
    let tag = scope.find(&Name::new(name)).map(|tag| &scope.tags[tag])?;
    let writes = context.uses(tag).filter(|place| place.access.writes()).count();
    if is_shared(context, tag) {
        return Some(format!("other files may write `{name}`"));
    }
    if writes != count {
        return Some(format!("`{name}` is written elsewhere too"));
    }
    if has_mcr(context, context.bodies[output.network]) {
        return Some("an <MCR> that is off would hold the one and drop the other".to_owned());
    }
    None
}

fn is_shared(context: &Context, tag: &TagFacts) -> bool {
    tag.is_alias()
        || tag.cold.foreign.is_some()
        || matches!(
            tag.origin,
            Origin::Shared
                | Origin::Implicit
                | Origin::Declared(SectionKind::Global | SectionKind::External | SectionKind::InOut)
        )
        || (tag.cold.address.is_some() && context.others.have_files())
}

fn action(title: String, why: Option<String>, edits: Vec<Edit>) -> Action {
    match why {
        Some(why) => Action::disabled(ActionKind::Rewrite, title, why),
        None => Action::new(ActionKind::Rewrite, title, edits),
    }
}

/// Two networks, one after the other: a set coil and a reset coil of one tag.
pub(super) fn offer_seal_in(place: &Selected<'_>, out: &mut Vec<Action>) {
    let context = place.context;
    let networks = place.networks.clone();
    let pairs: &[usize] = match networks.len() {
        1 => &[networks.start, networks.start.wrapping_sub(1)],
        2 => &[networks.start],
        _ => &[],
    };
    for &first in pairs.iter().filter(|first| **first < context.networks.len()) {
        if let Some(found) = seal_in(context, first) {
            out.push(found);
            return;
        }
    }
}

fn seal_in(context: &Context, first: usize) -> Option<Action> {
    if first + 1 >= context.networks.len() || context.bodies[first] != context.bodies[first + 1] {
        return None;
    }
    // Most networks do not end so: they need not be read.
    let ends = |network: usize| {
        let blocks = context.networks.at(network).blocks();
        blocks.take_while(|block| block.facts.rung == 0).last()?.op()
    };
    let coils = (ends(first)?, ends(first + 1)?);
    let (set_first, coil) = match coils {
        (Op::SetCoil, Op::ResetCoil) => (true, "( )"),
        (Op::ResetCoil, Op::SetCoil) => (false, "( )"),
        (Op::RetentiveSet, Op::RetentiveReset) => (true, "(M)"),
        (Op::RetentiveReset, Op::RetentiveSet) => (false, "(M)"),
        _ => return None,
    };
    let (one, two) = (Output::read(context, first)?, Output::read(context, first + 1)?);
    if !one.is_tag(&two.tag) || (one.coil.op(), two.coil.op()) != (Some(coils.0), Some(coils.1)) {
        return None;
    }
    let (set, reset) = if set_first { (&one, &two) } else { (&two, &one) };
    if set.any_mentions(&set.before) {
        return None;
    }
    let released = reset.inverted_all(&reset.before)?;
    let tag = &one.tag;
    let hold = Circuit::Element(Item::block(format!("[ ]( {tag} )")));
    let set_parts = Circuit::Series(set.before.clone());
    // The order of evaluation stays: what is above is evaluated first.
    let mut parts = if set_first {
        vec![Circuit::Parallel(vec![set_parts, hold]), released]
    } else {
        let held = Circuit::Series(vec![hold, released]);
        vec![Circuit::Parallel(vec![held, set_parts])]
    };
    parts.push(Circuit::Element(Item::block(format!("{coil}( {tag} )"))));
    let lines = between(context, first)?;
    let mut rung = one.rung.clone();
    rung.railed |= two.rung.railed;
    let mut drawing = rung.draw(&one.drawing, parts);
    drawing.head.push_str(&lines);
    drawing.take_comments_of(&two.drawing);
    let edit = Edit {
        range: one.drawing.range().cover(two.drawing.range()),
        text: drawing.text(),
    };
    let title = format!("Make a seal-in of the set and reset coils of `{tag}`");
    Some(action(title, obstacle(context, &one, 2), vec![edit]))
}

/// The comments between a network and the next one, if nothing else is there.
fn between(context: &Context, first: usize) -> Option<String> {
    let parse = &context.parse;
    let networks = &parse.structure().networks;
    let mut lines = networks[first].lines.end..networks[first + 1].lines.start;
    let is_plain = |line: usize| {
        let line = &parse.lines()[line];
        line.kind.is_decoration() && !line.is_in_conflict()
    };
    if !lines.clone().all(is_plain) {
        return None;
    }
    let ends = |range: TextRange| range.end();
    let begins_line = ends(parse.line_range(networks[first].lines.end - 1)) == parse.line_start(lines.start);
    let comments = lines
        .by_ref()
        .filter(|&line| parse.lines()[line].kind == LineKind::Comment);
    let text = comments.map(|line| lines_text(parse, line..line + 1)).collect();
    begins_line.then_some(text)
}

/// A seal-in: the tag of the coil in parallel to what sets it.
pub(super) fn offer_set_and_reset(place: &Selected<'_>, out: &mut Vec<Action>) {
    let Some(on) = &place.on else { return };
    out.extend(set_and_reset(place.context, on.network));
}

fn set_and_reset(context: &Context, network: usize) -> Option<Action> {
    let last = context
        .networks
        .at(network)
        .blocks()
        .filter(|block| matches!(block.op(), Some(Op::Coil | Op::RetentiveCoil)));
    // Most networks have no contact of the tag that they write.
    last.count().checked_sub(1)?;
    let output = Output::read(context, network)?;
    let (set_coil, reset_coil) = match output.coil.op() {
        Some(Op::Coil) => ("(S)", "(R)"),
        Some(Op::RetentiveCoil) => ("(SM)", "(RM)"),
        _ => return None,
    };
    let (Circuit::Parallel(branches), rest) = output.before.split_first()? else {
        return None;
    };
    let [upper, lower] = branches.as_slice() else {
        return None;
    };
    let (set, holds, set_wins) = if rest.is_empty() {
        if let Some(held) = output.held(upper) {
            (lower, held, true)
        } else {
            let held = output.held(lower)?;
            // The reset comes first now, and is read first.
            let reads_only = items(upper).into_iter().all(|item| match item.kind {
                ItemKind::Block(Some(number)) => only_reads(&output.blocks[number]),
                _ => true,
            });
            (upper, held, reads_only.then_some(true)?)
        }
    } else if output.held(lower).is_some_and(|held| held.is_empty()) {
        (upper, rest.to_vec(), false)
    } else if output.held(upper).is_some_and(|held| held.is_empty()) {
        (lower, rest.to_vec(), false)
    } else {
        return None;
    };
    let set = match set {
        Circuit::Series(parts) => parts.clone(),
        other => vec![other.clone()],
    };
    if holds.is_empty() || !set.iter().flat_map(items).any(Item::is_block) || output.any_mentions(&set) {
        return None;
    }
    let reset = output.inverted_all(&holds)?;
    let tag = &output.tag;
    let coil = |coil: &str| Circuit::Element(Item::block(format!("{coil}( {tag} )")));
    let mut set_parts = set;
    set_parts.push(coil(set_coil));
    let reset_parts = vec![reset, coil(reset_coil)];
    let (first, second) = if set_wins {
        (reset_parts, set_parts)
    } else {
        (set_parts, reset_parts)
    };
    let first = output.rung.draw(&output.drawing, first);
    let second = output.rung.draw_bare(&output.drawing, second);
    let line_end = output.drawing.line_end();
    let edit = Edit {
        range: output.drawing.range(),
        text: format!("{}{line_end}{}", first.text(), second.text()),
    };
    let title = format!("Write the seal-in of `{tag}` as a set and a reset coil");
    Some(action(title, obstacle(context, &output, 1), vec![edit]))
}

impl Output<'_> {
    /// What holds the tag in a branch that begins with its contact.
    fn held(&self, branch: &Circuit<Item>) -> Option<Parts> {
        let Circuit::Series(parts) = branch else {
            return None;
        };
        let (Circuit::Element(item), rest) = parts.split_first()? else {
            return None;
        };
        let ItemKind::Block(Some(number)) = item.kind else {
            return None;
        };
        let block = &self.blocks[number];
        let is_own =
            block.op() == Some(Op::Contact) && plain_tag(block).is_some_and(|name| self.is_tag(name));
        is_own.then(|| rest.to_vec())
    }
}
