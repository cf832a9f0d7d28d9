//! What is changed in the diagram.

use super::editable::drawing;
use super::fragment::{Fragment, Given};
use super::layout::{self, formatted};
use super::lines::{self, Place, line_at, network_at, range_of, with_heading};
use super::piece::{Piece, Redrawn};
use crate::drawing::beside::{self, Side};
use crate::drawing::gap::{Gap, row_at};
use crate::drawing::remove::{Spot, without};
use crate::drawing::rows::{Drawing, Item, ItemKind, comments, lines_text};
use crate::drawing::selection::things;
use crate::drawing::{carry, ends, insert, merge};
use crate::refactor::flow::{is_flow, is_mark, leaves};
use crate::refactor::names::{called, each_name};
use crate::refactor::place::Selected;
use crate::refactor::split_network;
use ladder_analysis::context::{Body, Context};
use ladder_analysis::names::declaring::line_end;
use ladder_analysis::networks::network::BoundBlock;
use ladder_analysis::networks::{BlockAt, NetworkAt};
use ladder_format::Options;
use ladder_syntax::{LineKind, Name, TextRange, TextSize, parse};
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
        Change::MoveNetwork { network, before } => work.move_network(*network, *before)?,
        Change::Duplicate { network } => work.duplicate(*network)?,
        Change::Split { at } => work.split(*at)?,
        Change::Merge { networks } => work.merge(networks)?,
    };
    let mut declared = Vec::new();
    if let Some(fragment) = fragment {
        pieces.extend(fragment.declarations);
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
type Done = Result<(Vec<Piece>, String, Option<Fragment>), String>;

struct Work<'c> {
    context: &'c Context,
    options: &'c Options,
}

const NO_WIRE: &str = "there is no wire there that something could be put into";

impl Work<'_> {
    /// The network of a place, and its drawing.
    fn drawn(&self, place: TextSize) -> Result<(NetworkAt<'_>, Drawing), String> {
        let network = network_at(self.context, place)?;
        Ok((network, drawing(self.context, network)?))
    }

    fn fragment(&self, scope: usize, given: &Given) -> Result<Fragment, String> {
        Fragment::read(self.context, scope, given, self.options)
    }

    fn piece(&self, network: NetworkAt<'_>, drawing: Drawing) -> Result<Piece, String> {
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
        let gaps = [gap(from)?, gap(to)?];
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
        match what.iter().all(is_inside) {
            true => Ok((network, drawing, spots)),
            false => Err("select things of one network".to_owned()),
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

    fn delete_network(&self, place: TextSize) -> Done {
        let network = network_at(self.context, place)?;
        let lines = with_heading(self.context, network);
        let piece = Piece::gone(lines::gone(self.context, lines));
        Ok((vec![piece], "Network deleted".to_owned(), None))
    }

    /// The block that holds a range, with its place in the drawing.
    fn block(&self, what: TextRange) -> Result<(NetworkAt<'_>, Drawing, Spot, BlockAt<'_>), String> {
        let (network, drawing) = self.drawn(what.start())?;
        for (row, own) in drawing.rows.iter().enumerate() {
            for (index, item) in own.items.iter().enumerate() {
                if let ItemKind::Block(Some(number)) = item.kind
                    && item.at.contains_range(what)
                {
                    let block = network.blocks().nth(number).ok_or("there is no block there")?;
                    return Ok((network, drawing, (row, index), block));
                }
            }
        }
        Err("there is no block there".to_owned())
    }

    /// The drawing with another text of a block.
    fn with_block(
        &self,
        network: NetworkAt<'_>,
        mut drawing: Drawing,
        (row, index): Spot,
        text: String,
        given: Option<&Given>,
    ) -> Result<(Piece, Fragment), String> {
        let given = Given {
            text: format!("+--{text}--+"),
            ..given.cloned().unwrap_or_default()
        };
        let fragment = self.fragment(network.scope, &given)?;
        let parsed = parse(&fragment.rungs);
        let read = parsed
            .structure()
            .networks
            .first()
            .map(|network| Drawing::of_text(&parsed, network));
        let is_one = read.and_then(Result::ok).is_some_and(|read| {
            let mut things = layout::things(&read);
            things
                .next()
                .is_some_and(|item| item.is_block() && item.text == text)
                && things.next().is_none()
        });
        if !is_one {
            return Err(format!("`{text}` is not one block"));
        }
        let item = &mut drawing.rows[row].items[index];
        *item = Item {
            joined: item.joined,
            ..Item::block(text)
        };
        Ok((self.piece(network, drawing)?, fragment))
    }

    fn operand(&self, what: TextRange, given: &Given) -> Done {
        let (network, drawing, spot, block) = self.block(what)?;
        let item = &drawing.rows[spot.0].items[spot.1];
        let list = block.facts.list_range.map(|list| block.absolute(list));
        let inside = list.is_some_and(|list| list.start() < what.start() && what.end() < list.end());
        if !inside {
            return Err("there is no operand there".to_owned());
        }
        let gone = match given.text.trim().is_empty() {
            true => with_comma(block, what).unwrap_or(what),
            false => what,
        };
        let within = gone - item.at.start();
        let mut text = item.text.clone();
        text.replace_range(std::ops::Range::<usize>::from(within), given.text.trim());
        let said = match given.text.trim() {
            "" => format!("Operand of {} deleted", block.head_text()),
            new => format!("{} is {new} now", operand_name(self.context, what)),
        };
        let (piece, fragment) = self.with_block(network, drawing, spot, text, Some(given))?;
        Ok((vec![piece], said, Some(fragment)))
    }

    fn head(&self, what: TextRange, new: &str) -> Done {
        let (network, drawing, spot, block) = self.block(what)?;
        let head = block.head_range();
        if !head.contains_range(what) {
            return Err("this is not the first part of a block".to_owned());
        }
        let item = &drawing.rows[spot.0].items[spot.1];
        let mut text = item.text.clone();
        text.replace_range(std::ops::Range::<usize>::from(head - item.at.start()), new.trim());
        let (piece, fragment) = self.with_block(network, drawing, spot, text, None)?;
        // Its names were there before.
        let said = format!("{} now", fragment.said);
        Ok((vec![piece], said, None))
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

    fn network(&self, near: Option<TextSize>, is_above: bool, given: &Given) -> Done {
        let place = match near {
            None => lines::at_end(self.context),
            Some(near) => self.place_near(near, is_above)?,
        };
        let fragment = self.fragment(place.scope, given)?;
        let piece = self.put(&place, &fragment.rungs);
        Ok((vec![piece], "Network added".to_owned(), Some(fragment)))
    }

    fn place_near(&self, near: TextSize, is_above: bool) -> Result<Place, String> {
        let line = line_at(self.context, near).unwrap_or(0);
        Ok(match self.context.networks.on_line(line) {
            Some(network) if is_above => lines::above(
                self.context,
                with_heading(self.context, network).start,
                network.scope,
            ),
            Some(network) => lines::below(self.context, network.lines().end, network.scope),
            None if self.context.parse.lines().len() == 0 => lines::at_end(self.context),
            None => lines::near(self.context, line),
        })
    }

    /// Networks at a place between others.
    fn put(&self, place: &Place, rungs: &str) -> Piece {
        let line_end = line_end(&self.context.parse);
        let text = formatted(rungs.trim_end(), place.scope > 0, self.options);
        let text = text
            .trim_end()
            .split('\n')
            .map(|line| line.trim_end_matches('\r'));
        let text = text.collect::<Vec<_>>().join(line_end);
        let start = TextSize::of(place.before.as_str());
        let parsed = parse(&text);
        let first = parsed.structure().networks.first();
        let first = first.and_then(|network| Drawing::of_text(&parsed, network).ok());
        let first = first.and_then(|drawing| layout::things(&drawing).next().map(|item| item.at.start()));
        Piece {
            range: TextRange::empty(place.at),
            new: vec![TextRange::at(start, TextSize::of(text.as_str()))],
            focus: Some(start + first.unwrap_or_default()),
            text: format!("{}{text}{}", place.before, place.behind),
        }
    }

    fn comment(&self, place: TextSize, text: &str) -> Done {
        let network = network_at(self.context, place)?;
        let lines = comment_lines(text)?;
        if lines.is_empty() {
            return Err("write what the comment says".to_owned());
        }
        let line_end = line_end(&self.context.parse);
        let text = lines.join(line_end);
        let piece = Piece {
            range: TextRange::empty(range_of(self.context, network.lines()).start()),
            new: vec![TextRange::up_to(TextSize::of(text.as_str()))],
            focus: Some(TextSize::new(0)),
            text: text + line_end,
        };
        Ok((vec![piece], "Comment added".to_owned(), None))
    }

    fn edit_comment(&self, what: TextRange, text: &str) -> Done {
        let mut lines = comment_lines(text)?;
        let said = if lines.is_empty() {
            "Comment deleted"
        } else {
            "Comment changed"
        };
        let line = line_at(self.context, what.start()).ok_or("there is no comment there")?;
        let parse = &self.context.parse;
        if parse.lines()[line].kind == LineKind::Comment {
            let range = range_of(self.context, line..line + 1);
            let old = parse.text_in(range);
            let ending = &old[old.trim_end_matches(['\r', '\n']).len()..];
            let text = lines.join(line_end(parse));
            let piece = match text.is_empty() {
                true => Piece::gone(range),
                false => Piece {
                    range,
                    new: vec![TextRange::up_to(TextSize::of(text.as_str()))],
                    focus: Some(TextSize::new(0)),
                    text: format!("{text}{ending}"),
                },
            };
            return Ok((vec![piece], said.to_owned(), None));
        }
        let (network, mut drawing) = self.drawn(what.start())?;
        if lines.len() > 1 {
            return Err("a comment in a network is on one line".to_owned());
        }
        for row in 0..drawing.rows.len() {
            let items = &mut drawing.rows[row].items;
            let is_it = |item: &Item| item.kind == ItemKind::Comment && item.at.contains_range(what);
            let Some(index) = items.iter().position(is_it) else {
                continue;
            };
            match lines.pop() {
                Some(text) => {
                    items[index].text = text;
                    items[index].at = TextRange::default();
                }
                None => {
                    drawing.take(row, index);
                }
            }
            return Ok((vec![self.piece(network, drawing)?], said.to_owned(), None));
        }
        Err("there is no comment there".to_owned())
    }

    fn move_network(&self, place: TextSize, before: Option<TextSize>) -> Done {
        let context = self.context;
        let network = network_at(context, place)?;
        let own = with_heading(context, network);
        let body = context.bodies[network.index];
        let (to, target) = match before {
            Some(before) => {
                let target = network_at(context, before)?;
                let first = with_heading(context, target).start;
                (
                    lines::above(context, first, target.scope),
                    context.bodies[target.index],
                )
            }
            None => {
                let is_last = |index: &usize| context.bodies[*index] == body;
                let last = (0..context.networks.len())
                    .rev()
                    .find(is_last)
                    .unwrap_or(network.index);
                let last = context.networks.at(last);
                (lines::below(context, last.lines().end, last.scope), body)
            }
        };
        let range = range_of(context, own.clone());
        let gone = lines::gone(context, own.clone());
        if gone.contains_inclusive(to.at) || range.contains_inclusive(to.at) {
            return Err("the network is there already".to_owned());
        }
        let unknown = (network.scope != to.scope)
            .then(|| first_unknown(context, network.blocks(), to.scope))
            .flatten();
        if let Some(name) = unknown {
            return Err(format!("`{name}` is not known there: declare it there first"));
        }
        let text = lines_text(&context.parse, own);
        let text = text.trim_start_matches('\u{feff}').trim_end_matches(['\r', '\n']);
        let start = TextSize::of(to.before.as_str());
        let piece = Piece {
            range: TextRange::empty(to.at),
            new: vec![TextRange::at(start, TextSize::of(text))],
            focus: Some(start),
            text: format!("{}{text}{}", to.before, to.behind),
        };
        let said = match target {
            _ if target == body => "Network moved".to_owned(),
            Body::Function(number) => {
                format!(
                    "Network moved; it is in the function `{}` now",
                    context.functions[number].name
                )
            }
            Body::Block(number) => {
                format!(
                    "Network moved; it is in the block `{}` now",
                    context.user_blocks[number].name
                )
            }
            Body::Main => "Network moved; it is in the main program now".to_owned(),
        };
        Ok((vec![Piece::plain(gone, ""), piece], said, None))
    }

    fn duplicate(&self, place: TextSize) -> Done {
        let context = self.context;
        let network = network_at(context, place)?;
        if let Some(mark) = network.blocks().find(|block| is_mark(block)) {
            return Err(format!("{} would be there twice", mark.head_text()));
        }
        if let Some(why) = drawing(context, network).err().filter(|_| network.broken) {
            return Err(why);
        }
        let given = Given {
            text: lines_text(&context.parse, with_heading(context, network)),
            copied: true,
            declare: None,
        };
        let fragment = self.fragment(network.scope, &given)?;
        let place = lines::below(context, network.lines().end, network.scope);
        let piece = self.put(&place, &fragment.rungs);
        Ok((vec![piece], "Network duplicated".to_owned(), Some(fragment)))
    }

    fn split(&self, at: TextSize) -> Done {
        let (network, drawing) = self.drawn(at)?;
        let gap = Gap::at(&drawing, at).ok_or(NO_WIRE)?;
        let selected = Selected::in_context(self.context, TextRange::empty(at));
        let on = selected.on.as_ref().ok_or(NO_WIRE)?;
        let split = split_network::at(self.context, on, (gap.row, gap.index))?;
        let said = match &split.carries {
            Some(tag) => format!("Network split; {tag} carries the power"),
            None => "Network split".to_owned(),
        };
        let mut pieces = vec![layout::piece(
            network.scope,
            &[split.first, split.second],
            None,
            self.options,
        )?];
        // The tag is declared as any new one.
        let fragment = match &split.carries {
            Some(tag) => {
                let given = Given {
                    text: format!("+--[ ]( {tag} )--( )( {tag} )--+"),
                    declare: None,
                    copied: false,
                };
                Some(self.fragment(network.scope, &given)?)
            }
            None => None,
        };
        if let Some(piece) = pieces.first_mut() {
            piece.range = drawing.range();
        }
        Ok((pieces, said, fragment))
    }

    fn merge(&self, networks: &[TextSize]) -> Done {
        const NOT_NEXT: &str = "only a network and the one below it can be joined";
        let [first, second] = networks else {
            return Err(NOT_NEXT.to_owned());
        };
        let ((one, upper), (two, lower)) = (self.drawn(*first)?, self.drawn(*second)?);
        let context = self.context;
        let is_next = one.index + 1 == two.index && context.bodies[one.index] == context.bodies[two.index];
        let between = one.lines().end..two.lines().start;
        let is_aside = |line: usize| context.parse.lines()[line].kind.is_decoration();
        if !is_next || !between.clone().all(is_aside) {
            return Err(NOT_NEXT.to_owned());
        }
        let all = |network: NetworkAt<'_>, allowed: fn(&BoundBlock) -> bool| {
            network.blocks().all(|block| !is_flow(&block) || allowed(&block))
        };
        if !all(one, is_mark) || !all(two, leaves) {
            return Err("a block of program flow would do something else then".to_owned());
        }
        let lines: Vec<String> = between
            .map(|line| context.parse.lines()[line].text().to_owned())
            .collect();
        if lines.iter().any(|line| line.contains("ladder:")) {
            return Err("a directive is above the second network".to_owned());
        }
        let lines = lines
            .into_iter()
            .filter(|line| !comments(std::slice::from_ref(line)).is_empty());
        let new = merge::merged(&upper, &lower, lines.collect())?;
        let piece = layout::piece(one.scope, &[new], None, self.options)?;
        Ok((vec![piece], "Networks joined".to_owned(), None))
    }
}

/// The first name of some blocks that a scope does not know.
fn first_unknown<'c>(
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

/// An operand with the comma that parts it from the others.
fn with_comma(block: BlockAt<'_>, what: TextRange) -> Option<TextRange> {
    let ranges = block
        .facts
        .operands
        .iter()
        .map(|operand| block.absolute(operand.range));
    let ranges: Vec<TextRange> = ranges.collect();
    let number = ranges
        .iter()
        .position(|range| range.contains_range(what) || what.contains_range(*range))?;
    Some(match (number.checked_sub(1), ranges.get(number + 1)) {
        (Some(before), _) => TextRange::new(ranges[before].end(), ranges[number].end()),
        (None, Some(next)) => TextRange::new(ranges[0].start(), next.start()),
        (None, None) => ranges[0],
    })
}

fn operand_name(context: &Context, what: TextRange) -> String {
    match context.parse.text_in(what).trim() {
        "" => "The operand".to_owned(),
        name => name.to_owned(),
    }
}

/// Lines of a text as comments, each one of its own.
fn comment_lines(text: &str) -> Result<Vec<String>, String> {
    if text.contains('#') {
        return Err("a comment cannot hold a `#`: write it without".to_owned());
    }
    let lines = text.lines().map(str::trim).filter(|line| !line.is_empty());
    Ok(lines.map(|line| format!("# {line} #")).collect())
}
