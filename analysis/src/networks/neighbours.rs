//! The rungs next to a network: one that its drawing lacks may be among them.

use crate::networks::Networks;
use ladder_syntax::wiring::PartKind;
use ladder_syntax::{LineKind, Parse};

/// The first rung below an open `\`, or above an open `/`, was probably meant to belong to the network.
pub(crate) fn break_neighbours(parse: &Parse, networks: &mut Networks, among: std::ops::Range<usize>) {
    for index in among {
        let network = networks.at(index);
        if network.wiring.unpaired.is_empty() {
            continue;
        }
        let wiring = &network.wiring;
        let last = wiring.rungs.len() - 1;
        let open = |rung: usize, kind| {
            wiring
                .unpaired
                .iter()
                .any(|&(r, part)| r == rung && wiring.rungs[r].parts[part].kind == kind)
        };
        let below = open(last, PartKind::Down) && rung_below(parse, network.line(last)).is_some();
        let above = open(0, PartKind::Up) && rung_above(parse, network.line(0)).is_some();
        if below && index + 1 < networks.len() {
            networks.set_broken(index + 1);
        }
        if above && index > 0 {
            networks.set_broken(index - 1);
        }
    }
}

/// The line of the next rung, if only rail, comment and blank lines are between.
pub(crate) fn rung_below(parse: &Parse, line: usize) -> Option<usize> {
    let lines = parse.lines();
    let next = (line + 1..lines.len()).find(|&n| !lines[n].kind.is_decoration())?;
    (lines[next].kind == LineKind::Rung).then_some(next)
}

/// The line of the rung before, likewise.
pub(crate) fn rung_above(parse: &Parse, line: usize) -> Option<usize> {
    let lines = parse.lines();
    let previous = (0..line).rev().find(|&n| !lines[n].kind.is_decoration())?;
    (lines[previous].kind == LineKind::Rung).then_some(previous)
}
