//! What is changed in the diagram.

use super::editable::drawing;
use super::fragment::{Fragment, Given};
use super::layout;
use super::lines::{self, network_at};
use super::piece::{Piece, Redrawn};
use crate::declarations::Row;
use crate::drawing::beside::{self, Side};
use crate::drawing::gap::{Gap, row_at};
use crate::drawing::item::{Item, ItemKind};
use crate::drawing::remove::{Spot, without};
use crate::drawing::rows::Drawing;
use crate::drawing::selection::things;
use crate::drawing::{carry, ends, insert};
use crate::refactor::names::{called, each_name};
use ladder_analysis::context::Context;
use ladder_analysis::networks::{BlockAt, NetworkAt};
use ladder_format::Options;
use ladder_syntax::{Name, TextRange, TextSize};
use std::fmt::Write;

/// A change of a drawing. Places are those of the text.
#[derive(Debug, Clone, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Change {
    /// Something is put into the wire at a place.
    Insert { at: TextSize, given: Given },
    /// A branch is drawn beside what is between two places of a line.
    Parallel {
        from: TextSize,
        to: TextSize,
        side: Side,
        given: Given,
    },
    /// Things go, and branches of which nothing is left.
    Delete { what: Vec<TextRange> },
    /// A network goes.
    DeleteNetwork { network: TextSize },
    /// What is within the parentheses of a block is replaced; without text an operand goes.
    Operand { what: TextRange, given: Given },
    /// The first part of a block is replaced.
    Head { what: TextRange, text: String },
    /// Things go to another place.
    Move { what: Vec<TextRange>, to: TextSize },
    /// The end of the branch that a connector is joins another place.
    BranchEnd { what: TextSize, to: TextSize },
    /// A branch that ends by itself is joined to the line above it.
    Close { what: TextSize, to: TextSize },
    /// Networks are put in above or below a line; without one at the end of the file.
    Network {
        near: Option<TextSize>,
        is_above: bool,
        given: Given,
    },
    /// A comment is put above a network.
    Comment { network: TextSize, text: String },
    /// The comment at a place is replaced; without text it goes.
    EditComment { what: TextRange, text: String },
    /// A tag is declared in the file or in the body of a block.
    Declare { block: Option<String>, row: Row },
    /// The tag whose name is at a place is declared in another way, or no longer.
    Redeclare { what: TextRange, row: Option<Row> },
    /// A network goes to before another one, or to the end of its body.
    MoveNetwork {
        network: TextSize,
        before: Option<TextSize>,
    },
    /// A copy of a network is put below it.
    Duplicate { network: TextSize },
    /// A network becomes two.
    Split { at: TextSize },
    /// A network and the next one become one.
    Merge { networks: Vec<TextSize> },
}

/// Makes a change.
///
/// # Errors
///
/// Why it cannot be made, in a sentence.
pub fn change(context: &Context, change: &Change, options: &Options) -> Result<Redrawn, String> {
    let work = Work { context, options };
    let (mut pieces, mut said, fragment) = match change {
        Change::Insert { at, given } => work.insert(*at, given)?,
        Change::Parallel {
            from,
            to,
            side,
            given,
        } => work.parallel(*from, *to, *side, given)?,
        Change::Delete { what } => work.delete(what)?,
        Change::DeleteNetwork { network } => work.delete_network(*network)?,
        Change::Operand { what, given } => work.operand(*what, given)?,
        Change::Head { what, text } => work.head(*what, text)?,
        Change::Move { what, to } => work.moved(what, *to)?,
        Change::BranchEnd { what, to } => work.branch_end(*what, *to)?,
        Change::Close { what, to } => work.close(*what, *to)?,
        Change::Network {
            near,
            is_above,
            given,
        } => work.network(*near, *is_above, given)?,
        Change::Comment { network, text } => work.comment(*network, text)?,
        Change::EditComment { what, text } => work.edit_comment(*what, text)?,
        Change::Declare { block, row } => work.declare(block.as_deref(), row)?,
        Change::Redeclare { what, row } => work.redeclare(*what, row.as_ref())?,
        Change::MoveNetwork { network, before } => work.move_network(*network, *before)?,
        Change::Duplicate { network } => work.duplicate(*network)?,
        Change::Split { at } => work.split(*at)?,
        Change::Merge { networks } => work.merge(networks)?,
    };
    let mut declared = Vec::new();
    if let Some(fragment) = fragment {
        // At one place declarations come before networks.
        pieces.splice(0..0, fragment.declarations);
        declared = fragment.declared;
    }
    for tag in &declared {
        // Writing to a String does not fail.
        let _ = write!(
            said,
            "; {} declared as {} in {}",
            tag.name,
            tag.ty,
            tag.section.keyword()
        );
    }
    Ok(Redrawn::of(&context.parse, pieces, said, declared))
}

/// New text, what was done in words, and what was put in.
pub(super) type Done = Result<(Vec<Piece>, String, Option<Fragment>), String>;

pub(super) struct Work<'c> {
    pub(super) context: &'c Context,
    pub(super) options: &'c Options,
}

pub(super) const NO_WIRE: &str = "there is no wire there that something could be put into";

impl Work<'_> {
    /// The network of a place, and its drawing.
    pub(super) fn drawn(&self, place: TextSize) -> Result<(NetworkAt<'_>, Drawing), String> {
        let network = network_at(self.context, place)?;
        Ok((network, drawing(self.context, network)?))
    }

    pub(super) fn fragment(&self, scope: usize, given: &Given) -> Result<Fragment, String> {
        Fragment::read(self.context, scope, given, self.options)
    }

    pub(super) fn piece(&self, network: NetworkAt<'_>, drawing: Drawing) -> Result<Piece, String> {
        layout::piece(network.scope, &[drawing], None, self.options)
    }

    fn insert(&self, at: TextSize, given: &Given) -> Done {
        let (network, drawing) = self.drawn(at)?;
        let gap = Gap::at(&drawing, at).ok_or(NO_WIRE)?;
        let fragment = self.fragment(network.scope, given)?;
        let new = insert::with(&drawing, gap, fragment.parts()?)?;
        let said = format!("{} added", fragment.said);
        Ok((vec![self.piece(network, new)?], said, Some(fragment)))
    }

    fn parallel(&self, from: TextSize, to: TextSize, side: Side, given: &Given) -> Done {
        let (network, drawing) = self.drawn(from)?;
        let gap = |place| Gap::on_line(&drawing, place).ok_or(NO_WIRE);
        let gaps = [gap(from.min(to))?, gap(to.max(from))?];
        let fragment = self.fragment(network.scope, given)?;
        let new = beside::with(&drawing, gaps, fragment.parts()?, side)?;
        let things = things(&drawing, TextRange::new(from.min(to), to.max(from)));
        let name = first_name(network, &drawing, &things);
        let said = format!("{} added in parallel to {name}", fragment.said);
        Ok((vec![self.piece(network, new)?], said, Some(fragment)))
    }

    /// The one network that ranges are in, and the things of it.
    fn selected(&self, what: &[TextRange]) -> Result<(NetworkAt<'_>, Drawing, Vec<Spot>), String> {
        let first = what.first().ok_or("nothing is selected")?;
        let (network, drawing) = self.drawn(first.start())?;
        let mut spots: Vec<Spot> = what.iter().flat_map(|range| things(&drawing, *range)).collect();
        spots.sort_unstable();
        spots.dedup();
        if spots.is_empty() {
            return Err("there is nothing of a drawing there".to_owned());
        }
        let is_inside = |range: &TextRange| network.range.contains_inclusive(range.start());
        if what.iter().all(is_inside) {
            Ok((network, drawing, spots))
        } else {
            Err("select things of one network".to_owned())
        }
    }

    fn delete(&self, what: &[TextRange]) -> Done {
        // A selection may reach over several networks.
        let mut rest: Vec<TextRange> = what.to_vec();
        rest.sort_by_key(|range| range.start());
        let (mut pieces, mut names) = (Vec::new(), Vec::new());
        while let Some(first) = rest.first() {
            let network = network_at(self.context, first.start())?;
            let is_own = |range: &TextRange| network.range.contains_inclusive(range.start());
            let count = rest.iter().take_while(|range| is_own(range)).count().max(1);
            let (network, drawing, spots) = self.selected(&rest[..count])?;
            rest.drain(..count);
            names.push(first_name(network, &drawing, &spots));
            pieces.push(match without(&drawing, &spots)? {
                Some(new) => layout::piece(network.scope, &[new], before(&drawing, &spots), self.options)?,
                None => Piece::gone(lines::gone(self.context, network.lines())),
            });
        }
        Ok((pieces, format!("{} deleted", names.join(", ")), None))
    }

    fn moved(&self, what: &[TextRange], to: TextSize) -> Done {
        let (network, drawing, spots) = self.selected(what)?;
        let said = format!("{} moved", first_name(network, &drawing, &spots));
        let target = network_at(self.context, to)?;
        if target.index == network.index {
            let gap = Gap::at(&drawing, to).ok_or(NO_WIRE)?;
            let new = carry::moved(&drawing, &spots, gap)?;
            return Ok((vec![self.piece(network, new)?], said, None));
        }
        let (target, other) = self.drawn(to)?;
        let gap = Gap::at(&other, to).ok_or(NO_WIRE)?;
        self.check_names(network, &drawing, &spots, target.scope)?;
        let (run, left) = carry::taken(&drawing, &spots)?;
        let new = insert::with(&other, gap, carry::fresh(run))?;
        let own = match left {
            Some(left) => layout::piece(network.scope, &[left], before(&drawing, &spots), self.options)?,
            None => Piece::gone(lines::gone(self.context, network.lines())),
        };
        Ok((vec![own, self.piece(target, new)?], said, None))
    }

    /// Whether a scope knows all names of some things.
    fn check_names(
        &self,
        network: NetworkAt<'_>,
        drawing: &Drawing,
        spots: &[Spot],
        scope: usize,
    ) -> Result<(), String> {
        if network.scope == scope {
            return Ok(());
        }
        let blocks = spots
            .iter()
            .filter_map(|&(row, index)| match drawing.rows[row].items[index].kind {
                ItemKind::Block(Some(number)) => network.blocks().nth(number),
                _ => None,
            });
        let unknown = first_unknown(self.context, blocks, scope);
        unknown.map_or(Ok(()), |name| {
            Err(format!("`{name}` is not known there: declare it there first"))
        })
    }

    fn branch_end(&self, what: TextSize, to: TextSize) -> Done {
        let (network, drawing) = self.drawn(what)?;
        let row = row_at(&drawing, what).ok_or("there is no line there")?;
        let items = drawing.rows[row].items.iter();
        let is_connector = |item: &Item| {
            matches!(item.kind, ItemKind::Down | ItemKind::Up) && item.at.contains_inclusive(what)
        };
        let index = items
            .clone()
            .rposition(|item| is_connector(item) && item.at.start() == what);
        let index = index.or_else(|| drawing.rows[row].items.iter().position(is_connector));
        let connector = (
            row,
            index.ok_or("there is no line there that a branch begins or ends with")?,
        );
        let gap = Gap::at(&drawing, to).ok_or(NO_WIRE)?;
        let new = ends::moved(&drawing, connector, gap)?;
        Ok((
            vec![self.piece(network, new)?],
            "End of the branch moved".to_owned(),
            None,
        ))
    }

    fn close(&self, what: TextSize, to: TextSize) -> Done {
        let (network, drawing) = self.drawn(what)?;
        let row = row_at(&drawing, what).ok_or("there is no line there")?;
        let items = &drawing.rows[row].items;
        let found = items.iter().rposition(|item| item.at.contains_inclusive(what));
        let last = found.ok_or("no branch ends there by itself")?;
        let gap = Gap::at(&drawing, to).ok_or(NO_WIRE)?;
        let new = ends::closed(&drawing, (row, last), gap)?;
        Ok((vec![self.piece(network, new)?], "Branch closed".to_owned(), None))
    }
}

/// The first name of some blocks that a scope does not know.
pub(super) fn first_unknown<'c>(
    context: &Context,
    blocks: impl Iterator<Item = BlockAt<'c>>,
    scope: usize,
) -> Option<String> {
    let mut unknown = None;
    for block in blocks {
        for operand in &block.facts.operands {
            each_name(&operand.value, &mut |name, _| {
                let key = Name::new(name);
                let is_known = context.scopes[scope].find(&key).is_some()
                    || context.others.globals(&key).next().is_some()
                    || context.types.find(name).is_some();
                if !is_known && unknown.is_none() {
                    unknown = Some(name.to_owned());
                }
            });
        }
    }
    unknown
}

/// What a sentence calls the first of some things.
fn first_name(network: NetworkAt<'_>, drawing: &Drawing, spots: &[Spot]) -> String {
    let blocks = spots.iter().filter_map(|&(row, index)| {
        let item = &drawing.rows[row].items[index];
        match item.kind {
            ItemKind::Block(Some(number)) => Some(called(&network.facts().blocks[number], &item.text)),
            _ => None,
        }
    });
    let names: Vec<String> = blocks.collect();
    match names.as_slice() {
        [] => "Comment".to_owned(),
        [one] => one.clone(),
        [first, rest @ ..] => format!("{first} and {} more", rest.len()),
    }
}

/// The thing before the first of some.
fn before(drawing: &Drawing, spots: &[Spot]) -> Option<TextRange> {
    let (row, index) = *spots.first()?;
    let first = drawing.rows[row].items[index].at.start();
    let things = layout::things(drawing).take_while(|item| item.at.start() < first);
    things.last().map(|item| item.at)
}
