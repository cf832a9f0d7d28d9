//! What a key draws: a contact, a coil or a block put in at the cursor, a branch around the selection, a block moved along
//! its rung or to the next one, a block deleted with its wire.

use super::change::{Change, change};
use super::editable::drawing;
use super::fragment::{Fragment, Given};
use super::layout::{self, formatted};
use super::lines;
use super::piece::{Piece, Redrawn};
use crate::drawing::beside::{self, Side};
use crate::drawing::carry;
use crate::drawing::gap::Gap;
use crate::drawing::insert;
use crate::drawing::item::{Item, ItemKind};
use crate::drawing::rows::Drawing;
use crate::refactor::insert_branch::{is_output, new_block};
use crate::refactor::names::new_tag;
use crate::refactor::place::{OnNetwork, Selected};
use crate::refactor::toggle;
use ladder_analysis::context::Context;
use ladder_analysis::networks::NetworkAt;
use ladder_format::Options;
use ladder_instructions::Op;
use ladder_syntax::{LineKind, TextRange, TextSize};

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

/// Changes the drawing at a selection, or at a cursor where it is empty.
///
/// # Errors
///
/// Why it cannot be done there.
pub fn redraw(
    context: &Context,
    range: TextRange,
    what: Redraw,
    options: &Options,
) -> Result<Redrawn, String> {
    let key = Key {
        place: Selected::in_context(context, range),
        context,
        options,
    };
    match what {
        Redraw::Contact => key.put_in("[ ]( ", "contact", " )"),
        Redraw::ClosedContact => key.put_in("[/]( ", "contact", " )"),
        Redraw::Coil => key.put_in("( )( ", "coil", " )"),
        Redraw::Block => key.put_in("[TON]( ", "timer", ", T#1s )"),
        Redraw::Branch => key.branch(),
        Redraw::Invert => key.invert(),
        Redraw::Left => key.along(false),
        Redraw::Right => key.along(true),
        Redraw::Up => key.across(false),
        Redraw::Down => key.across(true),
        Redraw::Delete => key.delete(),
    }
}

const NO_RUNG: &str = "put the cursor on a rung without errors in its drawing, or on an empty line";
const NO_BLOCK: &str = "put the cursor on a block of a rung without errors in its drawing";

struct Key<'c> {
    place: Selected<'c>,
    context: &'c Context,
    options: &'c Options,
}

impl<'c> Key<'c> {
    /// What is selected in a network that can be changed.
    fn on(&self, why: &str) -> Result<&OnNetwork<'c>, String> {
        let on = self.place.on.as_ref().ok_or(why)?;
        drawing(self.context, on.facts)?;
        Ok(on)
    }

    fn fragment(&self, scope: usize, text: &str) -> Result<Fragment, String> {
        let given = Given {
            text: text.to_owned(),
            ..Given::default()
        };
        Fragment::read(self.context, scope, &given, self.options)
    }

    /// What is done with a fragment in it; a person goes on at its name.
    fn done(&self, mut piece: Piece, fragment: Fragment, name: &str) -> Redrawn {
        if let Some(new) = piece.new.first() {
            let at = piece.text[usize::from(new.start())..].find(name).unwrap_or(0);
            piece.focus = Some(new.start() + TextSize::new(at as u32));
        }
        let said = format!("{} added", fragment.said);
        let mut pieces = fragment.declarations;
        pieces.push(piece);
        Redrawn::of(&self.context.parse, pieces, said, fragment.declared)
    }

    fn piece(&self, network: NetworkAt<'_>, drawing: Drawing) -> Result<Piece, String> {
        layout::piece(network.scope, &[drawing], None, self.options)
    }

    /// A block with a new tag at the cursor; on an empty line a rung with it.
    fn put_in(&self, before: &str, base: &str, after: &str) -> Result<Redrawn, String> {
        let name = new_tag(self.context, &[], base);
        let block = format!("{before}{name}{after}");
        let at = self.place.range.start();
        if self.place.on.is_none() {
            return self.on_empty_line(at, &block, &name);
        }
        let on = self.on(NO_RUNG)?;
        let line = self.context.parse.line_at(at).ok_or(NO_RUNG)?;
        let mut rows = 0..on.drawing.rows.len();
        let row = rows.find(|&row| on.facts.line(row) == line).ok_or(NO_RUNG)?;
        let items = &on.drawing.rows[row].items;
        let index = items
            .iter()
            .position(|item| item.at.start() >= at)
            .unwrap_or(items.len());
        let gap = within(&on.drawing, row, index);
        let fragment = self.fragment(on.facts.scope, &block)?;
        let new = insert::with(&on.drawing, gap, fragment.parts()?)?;
        Ok(self.done(self.piece(on.facts, new)?, fragment, &name))
    }

    fn on_empty_line(&self, at: TextSize, block: &str, name: &str) -> Result<Redrawn, String> {
        let parse = &self.context.parse;
        let line = parse.line_at(at);
        let is_blank = line.is_none_or(|line| parse.lines()[line].kind == LineKind::Blank);
        // Behind the last line end there is no line.
        let last = parse.lines().len().checked_sub(1);
        let ends = last.is_none_or(|last| parse.lines()[last].text().ends_with(['\n', '\r']));
        let is_after_all = at == parse.text_len() && ends;
        if (!is_blank && !is_after_all) || !self.place.range.is_empty() {
            return Err(NO_RUNG.to_owned());
        }
        let scope = line.map_or(0, |line| lines::scope_of(self.context, line));
        let fragment = self.fragment(scope, block)?;
        let text = formatted(fragment.rungs.trim_end(), scope > 0, self.options);
        let start = text.find(block).unwrap_or(0);
        let piece = Piece {
            range: TextRange::empty(at),
            new: vec![TextRange::at(TextSize::new(start as u32), TextSize::of(block))],
            focus: None,
            text,
        };
        Ok(self.done(piece, fragment, name))
    }

    fn branch(&self) -> Result<Redrawn, String> {
        const NO_PART: &str = "select contacts or coils of one rung";
        let on = self.on(NO_PART)?;
        let region = on.region().ok_or(NO_PART)?;
        let (name, block) = new_block(self.context, is_output(on, &region));
        let fragment = self.fragment(on.facts.scope, &block)?;
        let new = beside::with(&on.drawing, region.gaps(), fragment.parts()?, Side::Below)?;
        Ok(self.done(self.piece(on.facts, new)?, fragment, &name))
    }

    fn invert(&self) -> Result<Redrawn, String> {
        let mut actions = Vec::new();
        toggle::offer(&self.place, &mut actions);
        let edit = actions.iter().find_map(|action| action.own_edits().first());
        let edit = edit.ok_or("put the cursor on a contact or a coil")?;
        let head = Change::Head {
            what: edit.range,
            text: edit.text.clone(),
        };
        let done = change(self.context, &head, self.options)?;
        Ok(Redrawn { focus: None, ..done })
    }

    /// The row and the index of the one block that is selected.
    fn block(&self) -> Result<(&OnNetwork<'c>, usize, usize), String> {
        let on = self.on(NO_BLOCK)?;
        let (row, items) = on.trimmed().ok_or(NO_BLOCK)?;
        if items.len() != 1 || !on.drawing.rows[row].items[items.start].is_block() {
            return Err(NO_BLOCK.to_owned());
        }
        Ok((on, row, items.start))
    }

    fn moved(&self, pieces: Vec<Piece>) -> Redrawn {
        Redrawn::of(&self.context.parse, pieces, "Moved".to_owned(), Vec::new())
    }

    fn along(&self, right: bool) -> Result<Redrawn, String> {
        let (on, row, index) = self.block()?;
        let segment = on.drawing.segment(row, index);
        let other = if right { index + 1 } else { index.wrapping_sub(1) };
        let edge = other == segment.start || other + 1 == segment.end;
        let items = &on.drawing.rows[row].items;
        let passes = segment.contains(&other)
            && match items[other].kind {
                ItemKind::Up | ItemKind::Down => !edge,
                ItemKind::Block(_) | ItemKind::Comment => true,
                _ => false,
            };
        if !passes {
            return Err("the rung or the branch ends there".to_owned());
        }
        let to = Gap {
            row,
            index: if right { other + 1 } else { other },
        };
        let new = carry::moved(&on.drawing, &[(row, index)], to)?;
        Ok(self.moved(vec![self.piece(on.facts, new)?]))
    }

    fn across(&self, down: bool) -> Result<Redrawn, String> {
        let (on, row, index) = self.block()?;
        let target = if down { Some(row + 1) } else { row.checked_sub(1) };
        let target = target.filter(|&target| target < on.drawing.rows.len());
        let from = column(self.context, on.facts, row, &on.drawing.rows[row].items[index]);
        let Some(target) = target else {
            return self.to_neighbour(on, (row, index), from, down);
        };
        let to = nearest(&on.drawing, self.context, on.facts, target, from);
        let new = carry::moved(&on.drawing, &[(row, index)], to)?;
        Ok(self.moved(vec![self.piece(on.facts, new)?]))
    }

    /// The block leaves its network for the nearest rung of the one above or below it.
    fn to_neighbour(
        &self,
        on: &OnNetwork<'_>,
        block: (usize, usize),
        from: TextSize,
        down: bool,
    ) -> Result<Redrawn, String> {
        const NO_RUNG_THERE: &str = "there is no rung there";
        let context = self.context;
        let neighbour = if down {
            Some(on.network + 1).filter(|&next| next < context.networks.len())
        } else {
            on.network.checked_sub(1)
        };
        let neighbour = neighbour.filter(|&other| context.bodies[other] == context.bodies[on.network]);
        let facts = context.networks.at(neighbour.ok_or(NO_RUNG_THERE)?);
        let other = drawing(context, facts)?;
        if facts.blocks().any(|block| block.op() == Some(Op::Fun)) {
            return Err(NO_RUNG_THERE.to_owned());
        }
        let row = if down { 0 } else { other.rows.len() - 1 };
        let to = nearest(&other, context, facts, row, from);
        let (run, left) = carry::taken(&on.drawing, &[block])?;
        let new = insert::with(&other, to, carry::fresh(run))?;
        // A network needs a block.
        let own = match left {
            Some(left) => self.piece(on.facts, left)?,
            None => Piece::gone(lines::gone(context, on.facts.lines())),
        };
        Ok(self.moved(vec![own, self.piece(facts, new)?]))
    }

    fn delete(&self) -> Result<Redrawn, String> {
        let on = self.on(NO_BLOCK)?;
        let (row, items) = on.items.clone().ok_or(NO_BLOCK)?;
        let own = &on.drawing.rows[row].items;
        if !items.clone().any(|index| own[index].is_block()) {
            return Err(NO_BLOCK.to_owned());
        }
        let what = if self.place.range.is_empty() {
            items.map(|index| own[index].at).collect()
        } else {
            vec![self.place.range]
        };
        change(self.context, &Change::Delete { what }, self.options)
    }
}

/// The column of an item of a network, in bytes.
fn column(context: &Context, facts: NetworkAt<'_>, row: usize, item: &Item) -> TextSize {
    item.at.start() - context.parse.line_start(facts.line(row))
}

/// The place on a row of a drawing that is nearest to a column.
fn nearest(drawing: &Drawing, context: &Context, facts: NetworkAt<'_>, row: usize, from: TextSize) -> Gap {
    let items = &drawing.rows[row].items;
    let at = items
        .iter()
        .position(|item| column(context, facts, row, item) >= from);
    within(drawing, row, at.unwrap_or(items.len()))
}

/// The place before an item of a row, not outside of the rails, or of the branch that the row is.
fn within(drawing: &Drawing, row: usize, index: usize) -> Gap {
    let items = &drawing.rows[row].items;
    let first = drawing.drawn_start(row);
    let is_drawn = |item: &Item| item.kind != ItemKind::Comment;
    let last = items.iter().rposition(is_drawn).unwrap_or(0);
    let end = match items.get(last).map(|item| item.kind) {
        Some(ItemKind::Block(_)) => last + 1,
        _ => last,
    };
    Gap {
        row,
        index: index.clamp(first + 1, end.max(first + 1)),
    }
}
