//! Changes of a drawing by a key: a contact, a coil or a block put in at the cursor, a branch around the selection, a
//! block moved along its rung or to the next one, a block deleted with its wire.
//!
//! Unlike a refactoring these change what a program does: a person draws.

use super::drawing::{Drawing, Item, ItemKind};
use super::names::new_tag;
use super::place::{OnNetwork, Selected};
use super::{Action, ActionKind, insert_branch, remove_branch, toggle};
use ladder_analysis::Analysis;
use ladder_analysis::context::Context;
use ladder_analysis::networks::NetworkAt;
use ladder_format::{Edit, Options, apply};
use ladder_instructions::Op;
use ladder_syntax::{LineKind, TextRange, TextSize};
use std::ops::Range;

/// What is done.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Redraw {
    /// A contact at the cursor.
    Contact,
    /// A contact at the cursor that lets power through while its tag is low.
    ClosedContact,
    /// A coil at the cursor.
    Coil,
    /// A timer at the cursor, to be made any other block.
    Block,
    /// A branch around the selection, with a contact or coil of its own.
    Branch,
    /// The contact or coil under the cursor becomes its opposite.
    Invert,
    /// The block under the cursor changes places with what is before it.
    Left,
    /// The same, with what is after it.
    Right,
    /// The block under the cursor goes to the rung above, in its column; from the first one to the network above.
    Up,
    /// The same, to the rung below.
    Down,
    /// What is selected goes, with its wire, and a branch that is empty then.
    Delete,
}

/// What comes of it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Redrawn {
    /// The edits, sorted, none touching another.
    pub edits: Vec<Edit>,
    /// Where the cursor is in the new text.
    pub cursor: Option<TextSize>,
}

/// Where the cursor goes.
enum Cursor {
    /// To the first place of a name.
    Name(String),
    /// After this many characters that layout does not change.
    After(usize),
    Stays,
}

/// Changes the drawing at a selection, or at a cursor where it is empty; `text` is what was analysed.
///
/// # Errors
///
/// Why it cannot be done there.
pub fn redraw(
    analysis: &Analysis,
    text: &str,
    range: TextRange,
    what: Redraw,
    options: &Options,
) -> Result<Redrawn, &'static str> {
    let place = Selected::find(analysis, range);
    let (edits, cursor) = match what {
        Redraw::Contact => put_in(&place, "[ ]( ", "contact", " )")?,
        Redraw::ClosedContact => put_in(&place, "[/]( ", "contact", " )")?,
        Redraw::Coil => put_in(&place, "( )( ", "coil", " )")?,
        Redraw::Block => put_in(&place, "[TON]( ", "timer", ", T#1s )")?,
        Redraw::Branch => first(
            &place,
            analysis,
            insert_branch::offer,
            "select contacts or coils of one rung",
        )?,
        Redraw::Invert => first(
            &place,
            analysis,
            toggle::offer,
            "put the cursor on a contact or a coil",
        )?,
        Redraw::Left => moved(&place, false)?,
        Redraw::Right => moved(&place, true)?,
        Redraw::Up => carried(&place, false)?,
        Redraw::Down => carried(&place, true)?,
        Redraw::Delete => deleted(&place, analysis)?,
    };
    let action = Action::new(ActionKind::Rewrite, "", edits);
    let edits = action.aligned(analysis, text, options);
    let new = apply(text, &edits);
    let cursor = match cursor {
        Cursor::Name(name) => new.find(&name),
        Cursor::After(count) => solid(&new).nth(count).map(|(at, _)| at),
        Cursor::Stays => None,
    };
    Ok(Redrawn {
        edits,
        cursor: cursor.map(|at| TextSize::new(at as u32)),
    })
}

/// The characters that layout does not change, with their places.
fn solid(text: &str) -> impl Iterator<Item = (usize, char)> + '_ {
    text.char_indices()
        .filter(|(_, c)| !matches!(c, ' ' | '\t' | '-' | '|' | '\r' | '\n'))
}

type Done = Result<(Vec<Edit>, Cursor), &'static str>;

/// The first of the actions that are offered.
fn first(
    place: &Selected<'_>,
    analysis: &Analysis,
    offer: fn(&Selected<'_>, &mut Vec<Action>),
    why_not: &'static str,
) -> Done {
    let mut actions = Vec::new();
    offer(place, &mut actions);
    let action = actions
        .iter()
        .find(|action| action.disabled.is_none())
        .ok_or(why_not)?;
    Ok((action.edits(analysis), Cursor::Stays))
}

const NO_RUNG: &str = "put the cursor on a rung without errors in its drawing, or on an empty line";

/// A block with a new tag at the cursor; on an empty line a rung with it.
fn put_in(place: &Selected<'_>, before: &str, base: &str, after: &str) -> Done {
    let name = new_tag(place.context, &[], base);
    let block = format!("{before}{name}{after}");
    let at = place.range.start();
    let Some(on) = &place.on else {
        let parse = &place.context.parse;
        let line = parse.line_at(at);
        let is_blank = line.is_none_or(|line| parse.lines()[line].kind == LineKind::Blank);
        // After the last line end there is no line.
        let after_all =
            at == parse.text_len() && (at == TextSize::new(0) || parse.to_string().ends_with(['\n', '\r']));
        if !is_blank && !after_all || !place.range.is_empty() {
            return Err(NO_RUNG);
        }
        let edit = Edit {
            range: TextRange::empty(at),
            text: format!("+--{block}--+"),
        };
        return Ok((vec![edit], Cursor::Name(name)));
    };
    let row = row_at(place, on).ok_or(NO_RUNG)?;
    let mut drawing = on.drawing.clone();
    let items = &drawing.rows[row].items;
    let index = items
        .iter()
        .position(|item| item.at.start() >= at)
        .unwrap_or(items.len());
    insert(&mut drawing, row, index, Item::block(block));
    Ok((vec![drawing.replace()], Cursor::Name(name)))
}

/// The row of the line that the cursor is on.
fn row_at(place: &Selected<'_>, on: &OnNetwork<'_>) -> Option<usize> {
    let line = place.context.parse.line_at(place.range.start())?;
    (0..on.drawing.rows.len()).find(|&row| on.facts.line(row) == line)
}

/// Puts an item in before another one, within the rails, with wire on both sides. Returns its index.
fn insert(drawing: &mut Drawing, row: usize, index: usize, mut item: Item) -> usize {
    let items = &mut drawing.rows[row].items;
    let starts = items.first().is_some_and(|item| item.kind == ItemKind::LeftRail);
    let ends = items.iter().position(|item| item.kind == ItemKind::RightRail);
    let index = index.max(usize::from(starts)).min(ends.unwrap_or(items.len()));
    item.joined = index > 0 && !items[index - 1].is_loose(items.get(index));
    if let Some(next) = items.get_mut(index) {
        next.joined |= !item.joined;
    }
    items.insert(index, item);
    index
}

const NO_BLOCK: &str = "put the cursor on a block of a rung without errors in its drawing";

/// The row and the index of the one block that is selected.
fn block<'p, 'a>(place: &'p Selected<'a>) -> Result<(&'p OnNetwork<'a>, usize, usize), &'static str> {
    let on = place.on.as_ref().ok_or(NO_BLOCK)?;
    let (row, items) = on.trimmed().ok_or(NO_BLOCK)?;
    if items.len() != 1 || !on.drawing.rows[row].items[items.start].is_block() {
        return Err(NO_BLOCK);
    }
    Ok((on, row, items.start))
}

fn moved(place: &Selected<'_>, right: bool) -> Done {
    let (on, row, index) = block(place)?;
    let mut drawing = on.drawing.clone();
    let segment = drawing.segment(row, index);
    let (a, b) = if right {
        (index, index + 1)
    } else {
        (index.wrapping_sub(1), index)
    };
    let other = if right { b } else { a };
    let edge = other == segment.start || other + 1 == segment.end;
    let items = &mut drawing.rows[row].items;
    let passes = segment.contains(&other)
        && match items[other].kind {
            ItemKind::LeftRail | ItemKind::RightRail | ItemKind::Stub => false,
            ItemKind::Up | ItemKind::Down => !edge,
            ItemKind::Block(_) | ItemKind::Comment => true,
        };
    if !passes {
        return Err("the rung or the branch ends there");
    }
    let (joined_a, joined_b) = (items[a].joined, items[b].joined);
    items.swap(a, b);
    items[a].joined = joined_a;
    items[b].joined = joined_b;
    let cursor = after(place, &drawing, row, other);
    Ok((vec![drawing.replace()], cursor))
}

/// The cursor in front of an item of a drawing that is put in the place of what it was read from.
fn after(place: &Selected<'_>, drawing: &Drawing, row: usize, index: usize) -> Cursor {
    let text = place.context.parse.to_string();
    let mut count = solid(&text[..drawing.range().start().into()]).count() + solid(&drawing.head).count();
    for above in &drawing.rows[..row] {
        count += above
            .items
            .iter()
            .map(|item| solid(&item.text).count())
            .sum::<usize>();
        count += above.below.iter().map(|line| solid(line).count()).sum::<usize>();
    }
    let before = &drawing.rows[row].items[..index];
    count += before.iter().map(|item| solid(&item.text).count()).sum::<usize>();
    Cursor::After(count)
}

fn carried(place: &Selected<'_>, down: bool) -> Done {
    let (on, row, index) = block(place)?;
    let target = if down { Some(row + 1) } else { row.checked_sub(1) };
    let target = target.filter(|&target| target < on.drawing.rows.len());
    let from = column(place.context, on.facts, row, &on.drawing.rows[row].items[index]);
    let mut drawing = on.drawing.clone();
    let mut item = drawing.take(row, index);
    item.kind = ItemKind::Block(None);
    let Some(target) = target else {
        return carried_to_neighbour(place, on, &drawing, item, from, down);
    };
    let index = put_on_row(&mut drawing, place.context, on.facts, target, item, from);
    let cursor = after(place, &drawing, target, index);
    Ok((vec![drawing.replace()], cursor))
}

/// The block leaves its network for the nearest rung of the one above or below it. `left` is its own network without it.
fn carried_to_neighbour(
    place: &Selected<'_>,
    on: &OnNetwork<'_>,
    left: &Drawing,
    item: Item,
    from: TextSize,
    down: bool,
) -> Done {
    const NO_RUNG_THERE: &str = "there is no rung there";
    let context = place.context;
    let neighbour = if down {
        Some(on.network + 1).filter(|&next| next < context.networks.len())
    } else {
        on.network.checked_sub(1)
    };
    let neighbour = neighbour.filter(|&other| context.bodies[other] == context.bodies[on.network]);
    let neighbour = neighbour.ok_or(NO_RUNG_THERE)?;
    let mut drawing =
        Drawing::read(context, neighbour).ok_or("the drawing of the network there has an error")?;
    let target = if down {
        0
    } else {
        drawing.rows.len().checked_sub(1).ok_or(NO_RUNG_THERE)?
    };
    let facts = context.networks.at(neighbour);
    if facts.blocks().any(|block| block.op() == Some(Op::Fun)) {
        return Err(NO_RUNG_THERE);
    }
    let index = put_on_row(&mut drawing, context, facts, target, item, from);
    // A network needs a block.
    let is_empty = !left.rows.iter().flat_map(|row| &row.items).any(Item::is_block);
    let own = Edit {
        range: left.range(),
        text: if is_empty { String::new() } else { left.text() },
    };
    let mut cursor = after(place, &drawing, target, index);
    if let Cursor::After(count) = &mut cursor
        && down
    {
        let text = context.parse.to_string();
        *count -= solid(&text[std::ops::Range::<usize>::from(own.range)]).count() - solid(&own.text).count();
    }
    Ok((vec![own, drawing.replace()], cursor))
}

/// The column of an item of a network, in bytes.
fn column(context: &Context, facts: NetworkAt<'_>, row: usize, item: &Item) -> TextSize {
    item.at.start() - context.parse.line_start(facts.line(row))
}

/// Puts a block on a row of a drawing, nearest to the column that it comes from, and returns its index there.
fn put_on_row(
    drawing: &mut Drawing,
    context: &Context,
    facts: NetworkAt<'_>,
    row: usize,
    item: Item,
    from: TextSize,
) -> usize {
    let items = &drawing.rows[row].items;
    let at = items
        .iter()
        .position(|item| column(context, facts, row, item) >= from);
    // Not outside of the branch that the rung is.
    let drawn = items
        .iter()
        .position(|item| item.kind != ItemKind::Comment)
        .unwrap_or(0);
    let last = items
        .iter()
        .rposition(|item| item.kind != ItemKind::Comment)
        .unwrap_or(0);
    let at = at.unwrap_or(items.len()).clamp(drawn + 1, last.max(drawn + 1));
    insert(drawing, row, at, item)
}

fn deleted(place: &Selected<'_>, analysis: &Analysis) -> Done {
    let on = place.on.as_ref().ok_or(NO_BLOCK)?;
    let (row, items) = on.items.clone().ok_or(NO_BLOCK)?;
    let blocks = |range: Range<usize>| {
        let items = &on.drawing.rows[row].items;
        range.filter(|&index| items[index].is_block()).collect::<Vec<_>>()
    };
    let gone = blocks(items.clone());
    if gone.is_empty() {
        return Err(NO_BLOCK);
    }
    let all: usize = on
        .drawing
        .rows
        .iter()
        .flat_map(|row| &row.items)
        .filter(|item| item.is_block())
        .count();
    if gone.len() == all {
        let edit = Edit {
            range: on.drawing.range(),
            text: String::new(),
        };
        return Ok((vec![edit], Cursor::Stays));
    }
    // A branch without a block would be a bare wire next to others.
    if row > 0 && blocks(on.drawing.segment(row, items.start)) == gone {
        let branch = first(place, analysis, remove_branch::offer, NO_BLOCK);
        if branch.is_ok() {
            return branch;
        }
    }
    let mut drawing = on.drawing.clone();
    for &index in gone.iter().rev() {
        drawing.take(row, index);
    }
    let cursor = after(place, &drawing, row, gone[0].min(drawing.rows[row].items.len()));
    Ok((vec![drawing.replace()], cursor))
}
