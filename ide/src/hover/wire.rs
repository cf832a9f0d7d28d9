//! Hover on a wire or rail: when it has power, and what its network does, as formulas.

use super::Hover;
use crate::locate::OnRung;
use crate::markdown;
use ladder_analysis::context::Context;
use ladder_analysis::formulas;
use ladder_syntax::wiring::PartKind;

/// This many effects of a network are shown.
const MOST: usize = 8;

pub(super) fn hover(context: &Context, place: &OnRung<'_>) -> Option<Hover> {
    let network = context.networks.at(place.network);
    let mut markdown = power(context, place)?;
    if place.drawn.kind == PartKind::LeftRail {
        markdown.clear();
    }
    let effects = effects(context, place.network)?;
    if markdown.is_empty() && effects.is_empty() {
        return None;
    }
    if !effects.is_empty() {
        let gap = if markdown.is_empty() { "" } else { "\n\n" };
        markdown = format!("{markdown}{gap}{}", markdown::drawing("text", &effects));
    }
    Some(Hover {
        range: network.part_range(&context.parse, place.rung, place.part),
        markdown,
    })
}

/// When a part of a drawing has power, in a sentence.
pub(super) fn power(context: &Context, place: &OnRung<'_>) -> Option<String> {
    let network = context.networks.at(place.network);
    let elements = network.order.elements.iter();
    let (_, _, step, _) = elements
        .into_iter()
        .find(|(rung, part, ..)| (*rung, *part) == (place.rung, place.part))?;
    let power = formulas(context, place.network)?.power(*step)?;
    Some(match power.as_str() {
        "TRUE" => "Power: always".to_owned(),
        "FALSE" => "Power: never".to_owned(),
        formula => format!("Power: {}", markdown::code(formula)),
    })
}

/// What the blocks of a network do, a line each.
fn effects(context: &Context, network: usize) -> Option<String> {
    let formulas = formulas(context, network)?;
    let mut lines: Vec<String> = formulas
        .effects()
        .take(MOST + 1)
        .map(|(_, effect)| effect)
        .collect();
    if lines.len() > MOST {
        lines.truncate(MOST);
        lines.push("...".to_owned());
    }
    Some(lines.join("\n"))
}
