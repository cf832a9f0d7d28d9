//! `misleading-alignment`: two connectors are in one column and belong to two pairs.

use super::form::Form;
use crate::findings::diagnostic::{Applicability, Diagnostic};
use crate::findings::excerpt::columns;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::networks::NetworkAt;
use ladder_syntax::TextRange;
use ladder_syntax::numeral::nth;
use ladder_syntax::wiring::{PartKind, Point};

pub(crate) const RULE: Rule = Rule(
    &RuleFacts::new(RuleGroup::Connectors, "misleading-alignment", Severity::Info).fixed(Applicability::Safe),
);

pub(super) fn check(form: &Form<'_>, out: &mut Vec<Diagnostic>) {
    let network = form.network;
    if network.broken {
        return;
    }
    for points in network.wiring.points.chunk_by(|a, b| a.upper == b.upper) {
        // With one pair there is nothing to error it for; and nearly every drawing is straight.
        if points.len() > 1 && points.iter().any(|point| !is_straight(network, point)) {
            out.extend(misleading(form, points));
        }
    }
}

/// Whether both connectors are at one distance in bytes from the start of their lines: cheap, and the same as
/// one column where only plain characters are before them.
fn is_straight(network: NetworkAt<'_>, point: &Point) -> bool {
    let rungs = &network.wiring.rungs;
    rungs[point.upper].parts[point.down].range.start() == rungs[point.upper + 1].parts[point.up].range.start()
}

/// The first pair whose `\` is above the `/` of another pair.
fn misleading(form: &Form<'_>, points: &[Point]) -> Option<Diagnostic> {
    let network = form.network;
    let wiring = &network.wiring;
    let upper = points[0].upper;
    let starts = |rung: usize, part: usize| wiring.rungs[rung].parts[part].range.start();
    let of_rung = |rung: usize, part: fn(&Point) -> usize| {
        let offsets = points.iter().map(|point| starts(rung, part(point)));
        columns(form.parse, network.line(rung), offsets)
    };
    let downs = of_rung(upper, |point| point.down);
    let ups = of_rung(upper + 1, |point| point.up);
    let (pair, looks_like) = downs.iter().enumerate().find_map(|(pair, column)| {
        let other = ups.binary_search(column).ok()?;
        (other != pair).then_some((pair, other))
    })?;
    let place = |rung: usize, part: usize| network.part_range(form.parse, rung, part);
    let down = place(upper, points[pair].down);
    debug_assert_eq!(wiring.rungs[upper].parts[points[pair].down].kind, PartKind::Down);
    Some(
        Diagnostic::new(
            RULE,
            down,
            format!(
                "the {} `\\` is above the {} `/`, but pairs with the {}",
                nth(pair + 1),
                nth(looks_like + 1),
                nth(pair + 1)
            ),
        )
        .help("connectors pair in their order from left to right, whatever their columns")
        .related(place(upper + 1, points[pair].up), "this is its partner")
        // Laying the network out again puts every pair into one column.
        .fix(
            Applicability::Safe,
            "Put pairs into one column",
            TextRange::empty(down.start()),
            "",
        ),
    )
}
