//! Where breakpoints can be.

use ladder_analysis::program::Location;
use ladder_simulator::Breakpoint;
use ladder_syntax::{TextRange, TextSize};
use serde_json::{Value as Json, json};

use super::sources::Counting;
use super::target::Target;

/// Where a breakpoint of a line is: at the rung that begins there, at the first block that runs of those in the line, or
/// what comes first below it. With a column at the block there, or the next one of the line.
pub(super) fn place(
    target: &Target,
    file: u32,
    line: usize,
    column: Option<TextSize>,
) -> Option<(Breakpoint, Location)> {
    let source = target.source(file);
    if let Some(offset) = column {
        let after =
            blocks(target, file).filter(|block| source.line(block.start()) == line && block.end() > offset);
        if let Some(range) = after.min_by_key(|block| block.start()) {
            let location = Location { file, range };
            return Some((Breakpoint::Block(location), location));
        }
    }
    let program = target.simulation().program();
    let networks = program.networks.iter().enumerate();
    let starts = networks
        .filter(|(_, network)| network.location.file == file)
        .map(|(number, network)| {
            (
                source.line(network.location.range.start()),
                Breakpoint::Network(number),
                network.location,
            )
        });
    let blocks = blocks(target, file).map(|range| {
        let location = Location { file, range };
        (source.line(range.start()), Breakpoint::Block(location), location)
    });
    // Of a line the rung goes before its blocks; of the blocks the first in their order of evaluation.
    let (_, breakpoint, location) = starts
        .chain(blocks)
        .filter(|(at, ..)| *at >= line)
        .min_by_key(|(at, ..)| *at)?;
    Some((breakpoint, location))
}

/// The blocks of a file in their order of evaluation within each network.
fn blocks(target: &Target, file: u32) -> impl Iterator<Item = TextRange> {
    let networks = target.simulation().program().networks.iter();
    let networks = networks.filter(move |network| network.location.file == file);
    networks.flat_map(|network| network.blocks.iter().map(|block| block.location.range))
}

/// Every place in some lines where a breakpoint can be.
pub(super) fn locations(
    target: &Target,
    file: u32,
    lines: std::ops::RangeInclusive<usize>,
    counting: Counting,
) -> Vec<Json> {
    let source = target.source(file);
    let networks = target.simulation().program().networks.iter();
    let rungs = networks
        .filter(|network| network.location.file == file)
        .map(|network| TextRange::empty(network.location.range.start()));
    let mut ranges: Vec<TextRange> = rungs.chain(blocks(target, file)).collect();
    ranges.retain(|range| lines.contains(&source.line(range.start())));
    ranges.sort_by_key(|range| (range.start(), range.len()));
    ranges
        .into_iter()
        .map(|range| {
            let place = counting.range(source, range);
            if range.is_empty() {
                return json!({"line": place["line"]});
            }
            place
        })
        .collect()
}
