//! Where breakpoints can be.

use std::collections::BTreeSet;

use ladder_analysis::program::Location;
use ladder_simulator::Breakpoint;
use ladder_syntax::{TextRange, TextSize};
use serde_json::{Value as Json, json};

use crate::sources::Counting;
use crate::target::Target;

/// Where a breakpoint of a line is: at the rung that begins there, at the first block that runs of those in the line, or
/// what comes first below it. With a column at the block there, or the next one of the line.
pub(crate) fn place(
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

/// The lines of some lines where a breakpoint can be. Places within a line are not among them: an editor would draw a mark at
/// each, which moves the drawing apart. A client that wants a block asks for a breakpoint at its column.
pub(crate) fn lines(
    target: &Target,
    file: u32,
    lines: std::ops::RangeInclusive<usize>,
    counting: Counting,
) -> Vec<Json> {
    let source = target.source(file);
    let networks = target.simulation().program().networks.iter();
    let rungs = networks
        .filter(|network| network.location.file == file)
        .map(|network| network.location.range.start());
    let starts = rungs.chain(blocks(target, file).map(TextRange::start));
    let found: BTreeSet<usize> = starts.map(|start| source.line(start)).collect();
    found
        .range(lines)
        .map(|&line| json!({"line": counting.line_out(line)}))
        .collect()
}
