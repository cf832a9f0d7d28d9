//! What belongs together with the thing under the cursor, in the same file: the other places of a tag, label or
//! block, the partner of a connector, the rails of a network, the end of a section, the `<NEXT>` of a `<FOR>`.

use crate::locate::{OnRung, on_rung};
use crate::symbol::{Found, Symbol, Usage, find, occurrences};
use ladder_analysis::context::Context;
use ladder_analysis::networks::BlockAt;
use ladder_instructions::{Op, by_op};
use ladder_syntax::wiring::PartKind;
use ladder_syntax::{LineKind, SyntaxKind, TextRange, TextSize};

/// A place that is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Highlight {
    /// Where.
    pub range: TextRange,
    /// What is done with the thing there.
    pub usage: Usage,
}

/// What belongs to the thing at an offset, in the order of the text.
pub fn highlights(context: &Context, offset: TextSize) -> Vec<Highlight> {
    let file = context;
    if let Some(Found { symbol, range }) = find(file, offset) {
        return match symbol {
            Symbol::Instruction(op @ (Op::For | Op::Next)) => loops(context, op, range),
            // Every contact of the file, when one is meant, says nothing.
            Symbol::Instruction(op) if by_op(op).mnemonic.len() < 2 => Vec::new(),
            symbol => occurrences(file, &symbol)
                .into_iter()
                .map(|place| Highlight {
                    range: place.range,
                    usage: place.usage,
                })
                .collect(),
        };
    }
    let mentioned = |range| Highlight {
        range,
        usage: Usage::Mention,
    };
    drawn(context, offset)
        .or_else(|| keywords(context, offset))
        .unwrap_or_default()
        .into_iter()
        .map(mentioned)
        .collect()
}

/// A connector and its partner, or the rails of a network.
fn drawn(context: &Context, offset: TextSize) -> Option<Vec<TextRange>> {
    let place = on_rung(context, offset)?;
    match place.drawn.kind {
        PartKind::Down | PartKind::Up => Some(pair(context, &place)),
        PartKind::LeftRail | PartKind::RightRail => Some(rails(context, place.network)),
        // At either end of a rung it stands for the rail.
        PartKind::Bar => {
            let parts = &context.networks.at(place.network).facts().wiring.rungs[place.rung].parts;
            let outer = place.part == 0 || place.part + 1 == parts.len();
            outer.then(|| rails(context, place.network))
        }
        _ => None,
    }
}

fn pair(context: &Context, place: &OnRung<'_>) -> Vec<TextRange> {
    let network = context.networks.at(place.network);
    let points = network.wiring.points.iter();
    let mut mine = points.filter(|point| {
        (place.rung, place.part) == (point.upper, point.down)
            || (place.rung, place.part) == (point.upper + 1, point.up)
    });
    let range = |rung, part| network.part_range(&context.parse, rung, part);
    match mine.next() {
        Some(point) => vec![range(point.upper, point.down), range(point.upper + 1, point.up)],
        None => vec![range(place.rung, place.part)],
    }
}

fn rails(context: &Context, network: usize) -> Vec<TextRange> {
    let facts = context.networks.at(network);
    let mut rails = Vec::new();
    for (rung, drawing) in facts.wiring.rungs.iter().enumerate() {
        let last = drawing.parts.len().saturating_sub(1);
        for (index, part) in drawing.parts.iter().enumerate() {
            let outer = index == 0 || index == last;
            let rail = matches!(part.kind, PartKind::LeftRail | PartKind::RightRail)
                || (part.kind == PartKind::Bar && outer);
            if rail {
                rails.push(facts.part_range(&context.parse, rung, index));
            }
        }
    }
    rails
}

/// A `<FOR>` and its `<NEXT>` (LANGUAGE §5.5).
fn loops(context: &Context, op: Op, at: TextRange) -> Vec<Highlight> {
    let Some(mine) = context
        .networks
        .iter()
        .find(|network| network.range.contains_range(at))
    else {
        return Vec::new();
    };
    let find = |network: usize, op: Op| {
        let mut blocks = context.networks.at(network).blocks();
        blocks
            .find(|block| block.op() == Some(op))
            .map(BlockAt::head_range)
    };
    let partner = context.loops().into_iter().find_map(|(first, last)| match op {
        Op::For => (first == mine.index).then(|| find(last, Op::Next))?,
        _ => (last == mine.index).then(|| find(first, Op::For))?,
    });
    let partner = partner.filter(|_| find(mine.index, op) == Some(at));
    let mut ranges: Vec<TextRange> = partner.into_iter().collect();
    ranges.push(at);
    ranges.sort_by_key(|range| range.start());
    let mentioned = |range| Highlight {
        range,
        usage: Usage::Mention,
    };
    ranges.into_iter().map(mentioned).collect()
}

/// The first and last word of a section or block definition.
fn keywords(context: &Context, offset: TextSize) -> Option<Vec<TextRange>> {
    let parse = &context.parse;
    let line = parse.line_at(offset)?;
    let keyword_on = |line: usize| {
        let start = parse.line_start(line);
        let mut tokens = parse.lines()[line].syntax().descendants_with_tokens();
        let token = tokens.find_map(|it| it.into_token().filter(|it| it.kind() == SyntaxKind::KEYWORD))?;
        Some(token.text_range() + start)
    };
    let frame = parse.frame();
    let lines = match parse.lines()[line].kind {
        LineKind::SectionHeader | LineKind::SectionEnd => {
            let mut sections = frame.sections.iter();
            let section = sections.find(|it| it.lines.contains(&line) && it.closed)?;
            section.lines.clone()
        }
        LineKind::BlockHeader | LineKind::BlockEnd => {
            let mut blocks = frame.blocks.iter();
            blocks
                .find(|it| it.lines.contains(&line) && it.closed)?
                .lines
                .clone()
        }
        _ => return None,
    };
    if line != lines.start && line + 1 != lines.end {
        return None;
    }
    let both = [keyword_on(lines.start)?, keyword_on(lines.end - 1)?];
    both.iter()
        .any(|word| word.contains_inclusive(offset))
        .then(|| both.to_vec())
}

#[cfg(test)]
mod tests;
