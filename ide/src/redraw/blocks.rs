//! A block of a network gets another operand, or another first part.

use super::change::{Done, Work};
use super::fragment::{Fragment, Given};
use super::layout;
use super::piece::Piece;
use crate::drawing::item::{Item, ItemKind};
use crate::drawing::remove::Spot;
use crate::drawing::rows::Drawing;
use ladder_analysis::context::Context;
use ladder_analysis::networks::{BlockAt, NetworkAt};
use ladder_syntax::{TextRange, parse};

impl Work<'_> {
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
        let errors = |block: &str| parse(&format!("+--{block}--+")).errors().len();
        let before = errors(&drawing.rows[row].items[index].text);
        let given = Given {
            text: format!("+--{text}--+"),
            ..given.cloned().unwrap_or_default()
        };
        let fragment = Fragment::of_block(self.context, network.scope, &given, before, self.options)?;
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

    pub(super) fn operand(&self, what: TextRange, given: &Given) -> Done {
        let (network, drawing, spot, block) = self.block(what)?;
        let item = &drawing.rows[spot.0].items[spot.1];
        let list = block.facts.list_range.map(|list| block.absolute(list));
        let inside = list.is_some_and(|list| list.start() < what.start() && what.end() < list.end());
        if !inside {
            return Err("there is no operand there".to_owned());
        }
        let gone = if given.text.trim().is_empty() {
            with_comma(block, what).unwrap_or(what)
        } else {
            what
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

    pub(super) fn head(&self, what: TextRange, new: &str) -> Done {
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
