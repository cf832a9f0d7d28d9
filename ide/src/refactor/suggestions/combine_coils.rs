//! Several coils of one tag become one: each of their rungs is a branch before it.

use super::{Spot, action};
use crate::drawing::item::{Item, ItemKind};
use crate::drawing::rows::{Drawing, lines_text};
use crate::drawing::term::{Rung, items};
use crate::refactor::Action;
use crate::refactor::flow::is_flow;
use ladder_analysis::context::Context;
use ladder_analysis::{Analysis, Diagnostic};
use ladder_format::{Circuit, Edit};
use ladder_syntax::{LineKind, TextRange};
use std::ops::Range;

/// A network that ends with one of the coils.
struct Output {
    network: usize,
    drawing: Drawing,
    rung: Rung,
    before: Vec<Circuit<Item>>,
    coil: Item,
    name: String,
}

impl Output {
    fn read(analysis: &Analysis, place: TextRange) -> Option<Output> {
        let spot = Spot::find(analysis, place)?;
        let rung = Rung::read(&spot.on.drawing)?;
        let mut before = rung.parts.clone();
        let Some(Circuit::Element(coil)) = before.pop() else {
            return None;
        };
        let has_block = before.iter().flat_map(items).any(Item::is_block);
        let blocks = &spot.on.facts.blocks;
        let is_moved = blocks.iter().any(|block| block.faulty || is_flow(block));
        if !coil.at.contains_range(place) || !coil.is_block() || !has_block || is_moved {
            return None;
        }
        Some(Output {
            network: spot.on.network,
            name: spot.name()?,
            before,
            coil,
            rung,
            drawing: spot.on.drawing,
        })
    }

    /// What it writes, and how: `(/)( y )`.
    fn is_like(&self, other: &Output) -> bool {
        let written = |item: &Item| {
            let drawn = item.text.chars().filter(|c| !c.is_whitespace());
            drawn.flat_map(char::to_lowercase).collect::<String>()
        };
        matches!(self.coil.kind, ItemKind::Block(_)) && written(&self.coil) == written(&other.coil)
    }
}

pub(super) fn offer(analysis: &Analysis, found: &Diagnostic) -> Option<Action> {
    let context = &analysis.context;
    if found.more_related > 0 || found.related.iter().any(|place| place.file.is_some()) {
        return None;
    }
    let mut places: Vec<TextRange> = found.related.iter().map(|place| place.range).collect();
    places.push(found.range);
    places.sort_by_key(|place| place.start());
    let outputs: Option<Vec<Output>> = places
        .iter()
        .map(|place| Output::read(analysis, *place))
        .collect();
    let mut outputs = outputs?;
    // The last one decides now: the new one is in its place.
    let last = outputs.pop()?;
    let apart = |pair: &[Output]| pair[0].network < pair[1].network;
    let is_apart = outputs.windows(2).all(apart) && outputs.last()?.network < last.network;
    if !is_apart || !outputs.iter().all(|output| output.is_like(&last)) {
        return None;
    }
    let mut edits: Vec<Edit> = Vec::new();
    let mut heads = String::new();
    for output in &outputs {
        let (range, head) = gone(context, output.network);
        heads.push_str(&head);
        let text = String::new();
        edits.push(Edit { range, text });
    }
    let count = outputs.len() + 1;
    let mut rung = last.rung.clone();
    let mut others = Vec::with_capacity(count);
    let mut branches = Vec::with_capacity(count);
    for output in outputs {
        rung.railed |= output.rung.railed;
        others.push(output.drawing);
        branches.extend(flattened(output.before));
    }
    branches.extend(flattened(last.before));
    let parts = vec![Circuit::Parallel(branches), Circuit::Element(last.coil)];
    let mut drawing = rung.draw(&last.drawing, parts);
    for other in &others {
        drawing.take_comments_of(other);
    }
    if !heads.is_empty() {
        let at = context.parse.line_start(heading(context, last.network));
        edits.push(Edit {
            range: TextRange::empty(at),
            text: heads,
        });
    }
    edits.push(Edit {
        range: last.drawing.range(),
        text: drawing.text(),
    });
    let title = format!(
        "Combine the {count} coils of `{}` into one (changes what the program does)",
        last.name
    );
    Some(action(title, edits))
}

/// Branches of a branch are branches of the whole.
fn flattened(mut before: Vec<Circuit<Item>>) -> Vec<Circuit<Item>> {
    if let [Circuit::Parallel(_)] = before.as_slice()
        && let Some(Circuit::Parallel(branches)) = before.pop()
    {
        return branches;
    }
    vec![Circuit::Series(before)]
}

/// What to take out of the text to be rid of a network: with the comments above it, which are returned, and the line that
/// parts it from the next.
fn gone(context: &Context, network: usize) -> (TextRange, String) {
    let parse = &context.parse;
    let lines = context.networks.at(network).lines();
    let first = heading(context, network);
    let head = lines_text(parse, first..lines.start);
    let mut end = lines.end;
    let is_blank = |line: usize| {
        let text = parse.lines().get(line).map(|line| line.text().trim().is_empty());
        text == Some(true)
    };
    if is_blank(end) {
        end += 1;
    }
    (covering(context, first..end), head)
}

/// The first of the lines of comments directly above a network, or its own first line. What speaks to the tools is not a heading.
fn heading(context: &Context, network: usize) -> usize {
    let own = context.networks.at(network).lines().start;
    let is_heading = |line: &usize| {
        let line = &context.parse.lines()[*line];
        line.kind == LineKind::Comment && !line.text().contains("ladder:")
    };
    (0..own).rev().take_while(is_heading).last().unwrap_or(own)
}

fn covering(context: &Context, lines: Range<usize>) -> TextRange {
    TextRange::new(
        context.parse.line_start(lines.start),
        context.parse.line_start(lines.end),
    )
}
