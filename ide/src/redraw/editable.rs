//! Which networks can be changed in the diagram, and where something can be put in.

use crate::drawing::gap::points;
use crate::drawing::rows::Drawing;
use ladder_analysis::context::Context;
use ladder_analysis::networks::NetworkAt;
use ladder_format::is_switched_off;
use ladder_syntax::{LineKind, TextSize};

/// The drawing of a network that can be changed.
///
/// # Errors
/// Why it cannot.
pub(super) fn drawing(context: &Context, network: NetworkAt<'_>) -> Result<Drawing, String> {
    let parse = &context.parse;
    if network.broken {
        return Err("the drawing of this network has an error: put that right in the text first".to_owned());
    }
    let mut lines = network.lines();
    let is_off = is_switched_off(parse, lines.start)
        || lines.clone().any(|line| {
            let of_line = &parse.lines()[line];
            of_line.kind != LineKind::Rung && of_line.text().contains("ladder:") && is_cut(of_line.text())
        });
    if is_off {
        let why = "this network is between `fmt off` and `fmt on`: it is drawn by hand, in the text";
        return Err(why.to_owned());
    }
    if lines.any(|line| parse.lines()[line].is_in_conflict()) {
        return Err("there is a conflict of a merge here: settle it in the text first".to_owned());
    }
    Drawing::of_network(context, network.index).map_err(|why| why.message().to_owned())
}

/// Whether a line of comments within a network is a directive of the formatter.
fn is_cut(line: &str) -> bool {
    let mut words = line.split(['#', ' ', '\t', '|']).filter(|word| !word.is_empty());
    words.any(|word| word == "ladder:") && words.any(|word| word == "fmt")
}

/// Where something can be put into a network: the places where its wires begin, sorted.
///
/// # Errors
///
/// Why the network cannot be changed in the diagram.
pub fn points_of(context: &Context, network: usize) -> Result<Vec<TextSize>, String> {
    let Some(network) = context.networks.get(network) else {
        return Ok(Vec::new());
    };
    let drawing = drawing(context, network)?;
    let mut wires: Vec<TextSize> = points(&drawing).iter().map(|gap| gap.anchor(&drawing)).collect();
    wires.sort_unstable();
    Ok(wires)
}
