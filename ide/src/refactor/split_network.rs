//! A network becomes two: where a rung is joined below another, or across a rung. Where power passes from the first to the
//! second, a new internal tag carries it.

use super::flow::{is_flow, is_mark, leaves};
use super::names::{called, new_tag};
use super::place::{OnNetwork, Selected};
use super::{Action, ActionKind};
use crate::drawing::item::{Item, ItemKind};
use crate::drawing::rows::{Drawing, Row, comments};
use ladder_analysis::context::Context;
use ladder_analysis::names::declaring::Places;
use ladder_analysis::names::scope::SectionKind;
use ladder_analysis::networks::network::BoundBlock;
use ladder_format::Edit;
use ladder_instructions::Op;
use std::ops::Range;

/// The two networks, and the tag that carries power from the first to the second.
pub(crate) struct Split {
    pub(crate) first: Drawing,
    pub(crate) second: Drawing,
    pub(crate) carries: Option<String>,
}

const MCR: &str = "an <MCR> switches the rungs below it in its network";

/// The two networks of one that is split at a place of a row, before the branch that the place is in.
///
/// # Errors
/// Why it cannot be split there.
pub(crate) fn at(
    context: &Context,
    on: &OnNetwork<'_>,
    (row, index): (usize, usize),
) -> Result<Split, &'static str> {
    if on.facts.blocks().any(|block| block.op() == Some(Op::Mcr)) {
        return Err(MCR);
    }
    let tag = new_tag(context, &[], "split");
    let begins = index == on.drawing.drawn_start(row) + 1;
    let rows = begins.then(|| between_rows(on, row, &tag)).flatten();
    let found = rows.or_else(|| Some(before_branch(on, row, index, &tag)?.1));
    let split = found.ok_or(
        "the network cannot be split here: its lines are joined on both sides, or nothing is before it",
    )?;
    if !is_in_order(on, &split) {
        return Err("the blocks of the network would run in another order");
    }
    Ok(split)
}

/// A split across the first row, where a place is, or before the branch that it is in.
fn before_branch(on: &OnNetwork<'_>, row: usize, index: usize, tag: &str) -> Option<(usize, Split)> {
    let (row, start) = on_first_row(&on.drawing, row, index.min(on.drawing.rows[row].items.len() - 1));
    let mut cuts = (1..=start).rev().map(|at| (at, across(on, row, at, tag)));
    cuts.find_map(|(at, split)| Some((at, split?)))
}

/// Whether every block runs when it ran before.
fn is_in_order(on: &OnNetwork<'_>, split: &Split) -> bool {
    let orders = [&split.first, &split.second].map(Drawing::old_order);
    let [Some(mut order), Some(second)] = orders else {
        return false;
    };
    order.extend(second);
    Some(order) == on.drawing.old_order()
}

pub(super) fn offer(place: &Selected<'_>, out: &mut Vec<Action>) {
    let Some(on) = &place.on else { return };
    let Some((row, items)) = on.trimmed() else { return };
    if on.facts.blocks().any(|block| block.op() == Some(Op::Mcr)) {
        out.push(Action::disabled(
            ActionKind::Rewrite,
            "Split the network here",
            MCR,
        ));
        return;
    }
    let tag = new_tag(place.context, &[], "split");
    if let Some(split) = between_rows(on, row, &tag) {
        let title = "Split the network above this rung";
        out.extend(action(place, on, title, &split));
    }
    // Within a branch there is no place to cut: then before it.
    if let Some((at, split)) = before_branch(on, row, items.start, &tag) {
        let after = on.drawing.rows[0].items[at..].iter();
        let mut blocks = after.filter_map(|item| match item.kind {
            ItemKind::Block(Some(number)) => Some(called(&on.facts.blocks[number], &item.text)),
            _ => None,
        });
        let name = blocks.next().unwrap_or_default();
        out.extend(action(
            place,
            on,
            &format!("Split the network before `{name}`"),
            &split,
        ));
    }
}

/// The item of the first row that a branch in which an item is begins at.
fn on_first_row(drawing: &Drawing, mut row: usize, mut item: usize) -> (usize, usize) {
    while row > 0 {
        let start = drawing.segment(row, item).start;
        let up = (start..=item)
            .rev()
            .find(|&at| drawing.rows[row].items[at].kind == ItemKind::Up);
        match up.and_then(|up| drawing.down_of(row, up)) {
            Some(down) => (row, item) = (row - 1, down),
            None => break,
        }
    }
    (row, item)
}

fn action(place: &Selected<'_>, on: &OnNetwork<'_>, title: &str, split: &Split) -> Option<Action> {
    if !is_in_order(on, split) {
        return None;
    }
    let line_end = on.drawing.line_end();
    let mut edits = vec![Edit {
        range: on.drawing.range(),
        text: format!(
            "{}{line_end}{line_end}{}",
            split.first.text(),
            split.second.text()
        ),
    }];
    let title = match &split.carries {
        Some(tag) => {
            edits.extend(declare(place, on.facts.scope, tag)?);
            format!("{title} (`{tag}` carries the power)")
        }
        None => title.to_owned(),
    };
    Some(Action::new(ActionKind::Rewrite, title, edits))
}

/// The declaration of a new BOOL where the scope declares its tags.
pub(super) fn declare(place: &Selected<'_>, scope: usize, tag: &str) -> Option<Vec<Edit>> {
    if scope == 0 && !place.context.scopes[0].declares() {
        return Some(Vec::new());
    }
    Places::new(place.context, scope).declare(SectionKind::Var, tag, "BOOL")
}

/// The blocks on some rows.
fn blocks<'f>(on: &OnNetwork<'f>, rows: Range<usize>) -> impl Iterator<Item = &'f BoundBlock> {
    let facts = on.facts.facts();
    facts
        .blocks
        .iter()
        .filter(move |block| rows.contains(&block.facts.rung))
}

/// The rungs from one on get a network of their own, if they are joined to one point of the rung above.
fn between_rows(on: &OnNetwork<'_>, row: usize, tag: &str) -> Option<Split> {
    let drawing = &on.drawing;
    let above = row.checked_sub(1)?;
    let mut downs = drawing.all(above, ItemKind::Down);
    let (down, None) = (downs.next()?, downs.next()) else {
        return None;
    };
    let up = drawing.up_of(above, down)?;
    if up != drawing.drawn_start(row) || !drawing.has_wire_after(row, up) {
        return None;
    }
    let below = row..drawing.rows.len();
    if !blocks(on, 0..row).all(|block| !is_flow(block) || is_mark(block) || leaves(block))
        || !blocks(on, below.clone()).all(|block| !is_flow(block) || leaves(block))
        || blocks(on, below.clone()).next().is_none()
        || blocks(on, 0..row).next().is_none()
    {
        return None;
    }
    let mut first = drawing.with_rows(drawing.rows[..row].to_vec());
    let mut second = drawing.with_rows(drawing.rows[below].to_vec());
    second.head = comments(&std::mem::take(&mut first.rows[above].below));
    let carries = if is_rail(drawing, above, down) {
        first.take(above, down);
        None
    } else {
        let railed = drawing.rows.iter().flat_map(|row| &row.items);
        let railed = railed.into_iter().any(|item| item.kind == ItemKind::RightRail);
        let mut items = vec![Item::up(false), Item::block(format!("( )( {tag} )"))];
        items.extend(railed.then(Item::right_rail));
        first.rows.push(Row {
            items,
            ..Row::default()
        });
        Some(tag.to_owned())
    };
    second.rows[0].items[up] = Item::left_rail();
    if carries.is_some() {
        let contact = Item::block(format!("[ ]( {tag} )"));
        second.rows[0].items.insert(up + 1, contact);
    }
    Some(Split {
        first,
        second,
        carries,
    })
}

/// Whether a `\` has the power of the left rail and no other.
fn is_rail(drawing: &Drawing, row: usize, down: usize) -> bool {
    let Some(before) = down.checked_sub(1).filter(|_| drawing.has_wire_before(row, down)) else {
        return false;
    };
    match drawing.rows[row].items[before].kind {
        ItemKind::LeftRail => true,
        ItemKind::Up if !drawing.has_wire_before(row, before) => {
            let above = drawing.down_of(row, before);
            above.is_some_and(|above| is_rail(drawing, row - 1, above))
        }
        _ => false,
    }
}

/// What is from an item of the first row on, and is joined below that, gets a network of its own.
fn across(on: &OnNetwork<'_>, row: usize, at: usize, tag: &str) -> Option<Split> {
    let drawing = &on.drawing;
    let items = &drawing.rows[0].items;
    if row != 0 || items.first().map(|item| item.kind) != Some(ItemKind::LeftRail) || !items[at].joined {
        return None;
    }
    let mut cuts = vec![at];
    for row in 1..drawing.rows.len() {
        let left = drawing.count_before(row - 1, cuts[row - 1], ItemKind::Down);
        let cut = match left.checked_sub(1) {
            Some(last) => {
                let last = drawing.all(row, ItemKind::Up).nth(last)?;
                drawing.segment(row, last).end
            }
            None => 0,
        };
        if drawing.count_before(row, cut, ItemKind::Up) != left {
            return None;
        }
        let rails = drawing.rows[row].items[cut..].iter();
        if rails.into_iter().any(|item| item.kind == ItemKind::LeftRail) {
            return None;
        }
        cuts.push(cut);
    }
    let (mut first, mut second) = (drawing.with_rows(Vec::new()), drawing.with_rows(Vec::new()));
    for (row, cut) in drawing.rows.iter().zip(&cuts) {
        let (left, right) = row.items.split_at(*cut);
        first.rows.push(Row {
            items: left.to_vec(),
            ..Row::default()
        });
        second.rows.push(Row {
            items: right.to_vec(),
            below: row.below.clone(),
            ..Row::default()
        });
    }
    let has_block = |drawing: &Drawing| drawing.rows.iter().flat_map(|row| &row.items).any(Item::is_block);
    if !has_block(&first) || !has_block(&second) || !may_part(on, &first, &second) {
        return None;
    }
    let railed = items.iter().any(|item| item.kind == ItemKind::RightRail);
    let on_top = &mut first.rows[0].items;
    on_top.push(Item::block(format!("( )( {tag} )")));
    on_top.extend(railed.then(Item::right_rail));
    let on_top = &mut second.rows[0].items;
    on_top.splice(0..0, [Item::left_rail(), Item::block(format!("[ ]( {tag} )"))]);
    first.drop_empty_rows();
    second.drop_empty_rows();
    Some(Split {
        first,
        second,
        carries: Some(tag.to_owned()),
    })
}

fn may_part(on: &OnNetwork<'_>, first: &Drawing, second: &Drawing) -> bool {
    let all = |drawing: &Drawing, allowed: fn(&BoundBlock) -> bool| {
        let items = drawing.rows.iter().flat_map(|row| &row.items);
        items.into_iter().all(|item| match item.kind {
            ItemKind::Block(Some(number)) => {
                let block = &on.facts.blocks[number];
                !is_flow(block) || allowed(block)
            }
            _ => true,
        })
    };
    all(first, is_mark) && all(second, leaves)
}
