//! A contact after a coil: a branch before the coil keeps the two apart.

use super::{Spot, action};
use crate::drawing::item::{Item, ItemKind};
use crate::drawing::term::Rung;
use crate::refactor::Action;
use ladder_analysis::networks::network::BoundBlock;
use ladder_analysis::{Analysis, Diagnostic};
use ladder_format::Circuit;
use ladder_instructions::Op;

pub(super) fn offer(analysis: &Analysis, found: &Diagnostic) -> Option<Action> {
    let coil = Spot::find(analysis, found.related.first()?.range)?;
    let contact = Spot::find(analysis, found.range)?;
    let rung = Rung::read(&coil.on.drawing)?;
    let item = |spot: &Spot<'_>| spot.on.drawing.rows[spot.row].items[spot.index].at;
    let at = |place| {
        let mut parts = rung.parts.iter();
        parts.position(|part| matches!(part, Circuit::Element(item) if item.at == place))
    };
    let first = at(item(&coil))?;
    // The contact may be in a branch of its own.
    let after = rung.parts[first..].iter().position(|part| {
        let mut items = crate::drawing::term::items(part).into_iter();
        items.any(|it| it.at == item(&contact))
    });
    let second = first + after?;
    let passes = rung.parts[first..second].iter().all(|part| match part {
        Circuit::Element(it) => keeps_power(&coil, it),
        _ => false,
    });
    let mut parts = rung.parts[..first].to_vec();
    parts.push(Circuit::Parallel(vec![
        Circuit::Series(rung.parts[first..second].to_vec()),
        Circuit::Series(rung.parts[second..].to_vec()),
    ]));
    let drawing = rung.draw(&coil.on.drawing, parts);
    // Every block runs when it ran before.
    if drawing.old_order()? != coil.on.drawing.old_order()? {
        return None;
    }
    let name = coil.name()?;
    let effect = if passes {
        ""
    } else {
        " (changes what the rung does)"
    };
    let title = format!("Draw a branch before the coil `{name}`{effect}");
    Some(action(title, vec![drawing.replace()]))
}

/// Whether the power that leaves something is the one that enters it: a coil that sets or resets shows its tag.
fn keeps_power(spot: &Spot<'_>, item: &Item) -> bool {
    match item.kind {
        ItemKind::Block(Some(number)) => {
            let op = spot.on.facts.blocks.get(number).and_then(BoundBlock::op);
            matches!(op, Some(Op::Coil | Op::NegatedCoil | Op::RetentiveCoil))
        }
        _ => true,
    }
}
