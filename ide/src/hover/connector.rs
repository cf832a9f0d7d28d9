//! Hover on a connector: which partner it has.

use super::uses::line_link;
use super::{Hover, wire};
use crate::locate::OnRung;
use ladder_analysis::context::Context;
use ladder_syntax::numeral::nth;
use ladder_syntax::wiring::{PartKind, Wiring};

pub(super) fn hover(context: &Context, place: &OnRung<'_>) -> Hover {
    let network = context.networks.at(place.network);
    let wiring = &network.wiring;
    let down = place.drawn.kind == PartKind::Down;
    let (own, partner) = if down { ('\\', '/') } else { ('/', '\\') };
    let point = wiring.points.iter().find(|point| {
        if down {
            point.upper == place.rung && point.down == place.part
        } else {
            point.upper + 1 == place.rung && point.up == place.part
        }
    });
    let number = ordinal_on_line(wiring, place) + 1;
    let range = network.part_range(&context.parse, place.rung, place.part);
    let markdown = match point {
        Some(point) => {
            let rung = if down { point.upper + 1 } else { point.upper };
            let there = line_link(context.line_number(context.parse.line_start(network.line(rung))));
            let way = if down { "below" } else { "above" };
            format!(
                "Connector: the {} `{own}` of this line is joined with the {} `{partner}` of line {there} {way}.\n\n\
                 Both wires after the pair carry power if one of the wires before it does.",
                nth(number),
                nth(point.ordinal + 1)
            )
        }
        None => format!(
            "Connector without a partner: this is the {} `{own}` of its line, and the rung {} has fewer `{partner}`.",
            nth(number),
            if down { "below" } else { "above" }
        ),
    };
    let markdown = match wire::power(context, place) {
        Some(power) if point.is_some() => format!("{markdown}\n\n{power}"),
        _ => markdown,
    };
    Hover { range, markdown }
}

/// The number of the connector among those of its kind on its line, from 0.
fn ordinal_on_line(wiring: &Wiring, place: &OnRung<'_>) -> usize {
    wiring.rungs[place.rung]
        .connectors(place.drawn.kind)
        .take_while(|&part| part < place.part)
        .count()
}
