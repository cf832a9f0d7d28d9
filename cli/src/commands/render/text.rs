//! The diagram drawn with characters.

use super::value_of;
use crate::findings::Source;
use ladder_analysis::values::value::Value;
use ladder_instructions::Op;
use ladder_picture::letters::{self, Gate, Live, Shown, Style};
use ladder_simulator::Simulation;
use ladder_syntax::TextRange;

/// The column of the right rail: what a terminal of 80 columns shows.
const RAIL: u32 = 78;

/// The diagram of a program, as it is written or as it is.
pub(crate) fn drawn(source: &Source, simulation: Option<&Simulation>, style: Style) -> String {
    let context = &source.analyze().context;
    let live = simulation.map(|simulation| live(source, simulation));
    let all = TextRange::up_to(context.parse.text_len());
    let pieces = letters::pieces(context, all, RAIL, live.as_ref());
    letters::text(&pieces, style)
}

/// A stretch of the diagram, as it is.
pub(crate) fn network(source: &Source, simulation: &Simulation, stretch: TextRange) -> String {
    let live = live(source, simulation);
    let pieces = letters::pieces(&source.analyze().context, stretch, RAIL, Some(&live));
    letters::text(&pieces, Style::default())
}

/// How the parts of the drawing are.
fn live(source: &Source, simulation: &Simulation) -> Live {
    let context = &source.analyze().context;
    let own = simulation.power().filter(|(_, location, _)| location.file == 0);
    let mut live = Live {
        power: own.map(|(_, location, on)| (location.range, on)).collect(),
        ..Live::default()
    };
    for index in 0..context.networks.len() {
        let network = context.networks.at(index);
        // The tags of a body have as many values as the block has places.
        if network.scope != 0 {
            continue;
        }
        for block in network.blocks() {
            for operand in &block.facts.operands {
                let range = block.absolute(operand.value.range);
                if let Some(shown) = shown(&source.text[range], simulation) {
                    live.values.insert(range, shown);
                }
            }
            let wanted = match block.instruction().map(|row| row.op) {
                Some(Op::Contact) => true,
                Some(Op::NegatedContact) => false,
                _ => continue,
            };
            let operand = block.facts.operands.first();
            let point = operand.map(|operand| &source.text[block.absolute(operand.value.range)]);
            if let Some(point) = point.and_then(|name| simulation.resolve(name.trim()).ok()) {
                let is_closed = simulation.value(&point) == Value::Bool(wanted);
                let gate = if is_closed { Gate::Closed } else { Gate::Open };
                let range = network.part_range(&context.parse, block.facts.rung, block.facts.part);
                live.contacts.insert(range, gate);
            }
        }
    }
    live
}

fn shown(operand: &str, simulation: &Simulation) -> Option<Shown> {
    let operand = operand.trim();
    let point = simulation.resolve(operand).ok();
    Some(Shown {
        text: value_of(simulation, operand)?.trim_start_matches("T#").to_owned(),
        forced: point.is_some_and(|point| simulation.is_forced(&point)),
    })
}
