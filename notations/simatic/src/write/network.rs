//! Networks of a program as wires with parts on them.

use super::Project;
use super::element;
use super::power::{Parted, Power, Stands, is_rail, is_used, parted};
use super::strands::{self, Wiring};
use super::tags::Tags;
use crate::model::{Net, Part, RAIL, Wire};
use ladder_analysis::program::{Block, BlockKind, Network, Step};
use ladder_instructions::Op;

/// A call that has its power as an input.
struct Call {
    step: usize,
    /// The block of the network.
    number: usize,
    en: usize,
    writes: bool,
}

/// The networks that a network becomes.
///
/// # Errors
///
/// Why it has no form there.
pub(super) fn nets(tags: &mut Tags<'_>, network: &Network) -> Result<Vec<Net>, String> {
    let before = tags.made.len();
    around_calls(tags, network).inspect_err(|_| tags.made.truncate(before))
}

/// A block that is called from the rail parts a network: what leads to it, the call, and what follows it.
fn around_calls(tags: &mut Tags<'_>, network: &Network) -> Result<Vec<Net>, String> {
    let mut out = Vec::new();
    let mut stands = Stands::new();
    let mut rest = network.clone();
    while let Some(Call {
        step,
        number,
        en,
        writes,
    }) = call_from_rail(tags.project, &rest, &stands)
    {
        let Parted { before, after } = parted(&rest, step)?;
        let mut power = String::from("TRUE");
        if !is_rail(&rest, en) {
            power = tags.bit("power");
            stands.insert(number, Part::named("Coil").given("operand", power.clone()));
        }
        if before.steps.iter().any(|step| matches!(step, Step::Block { .. })) {
            out.push(net(tags, &before, &stands)?);
        }
        let result = (writes && is_used(&rest, step)).then(|| tags.bit("power"));
        let called = &rest.blocks[number];
        let call = element::call(tags, called, (&power, result.as_deref()));
        let head = &tags.project.text[called.location.range];
        let call = call.map_err(|why| format!("`{}`: {why}", head.trim()))?;
        out.push(Net {
            points: 1,
            wires: vec![Wire {
                from: RAIL,
                to: None,
                parts: vec![call],
            }],
        });
        let result = result.unwrap_or(power);
        stands.insert(number, Part::named("Contact").given("operand", result));
        rest = after;
        let goes_on = rest.steps[2..]
            .iter()
            .any(|step| matches!(step, Step::Block { .. }));
        if !goes_on {
            return Ok(out);
        }
    }
    out.push(net(tags, &rest, &stands)?);
    Ok(out)
}

/// The first block that only the rail can call.
fn call_from_rail(project: &Project<'_>, network: &Network, stands: &Stands) -> Option<Call> {
    let mut steps = network.steps.iter().enumerate();
    steps.find_map(|(step, own)| {
        let Step::Block { block: number, en } = *own else {
            return None;
        };
        let BlockKind::User(user) = network.blocks[number].kind else {
            return None;
        };
        let Power::Given { writes, .. } = project.used[user].power else {
            return None;
        };
        let is_simple = is_rail(network, en) && !(writes && is_used(network, step));
        let is_new = !stands.contains_key(&number);
        (is_new && !is_simple).then_some(Call {
            step,
            number,
            en,
            writes,
        })
    })
}

fn net(tags: &mut Tags<'_>, network: &Network, stands: &Stands) -> Result<Net, String> {
    let wires = strands::of(network)?;
    allowed(network, &wires)?;
    let mut made = Vec::with_capacity(wires.len());
    for wire in wires {
        let parts = wire.blocks.iter().map(|number| {
            if let Some(part) = stands.get(number) {
                return Ok(part.clone());
            }
            let block = &network.blocks[*number];
            let part = element::part(tags, block);
            part.map_err(|why| format!("`{}`: {why}", tags.project.text[block.location.range].trim()))
        });
        made.push(Wire {
            from: wire.from,
            to: wire.to,
            parts: parts.collect::<Result<_, String>>()?,
        });
    }
    Ok(Net {
        points: network.steps.len() + 1,
        wires: made,
    })
}

/// The label that marks a network.
pub(super) fn label(project: &Project<'_>, network: &Network) -> Option<String> {
    let is_label = |block: &&Block| matches!(block.kind, BlockKind::Instruction(row) if row.op == Op::Lbl);
    let block = network.blocks.iter().find(is_label)?;
    Some(project.source_of(block.arguments.first()?).to_owned())
}

/// Whether instructions stand where a document can have them.
fn allowed(network: &Network, wires: &[Wiring]) -> Result<(), String> {
    let op = |block: usize| match network.blocks[block].kind {
        BlockKind::Instruction(row) => Some(row.op),
        BlockKind::User(_) => None,
    };
    let blocks = network.steps.iter().filter_map(|step| match step {
        Step::Block { block, .. } => Some(*block),
        _ => None,
    });
    let mut before_last = blocks.rev().skip(1);
    if before_last.any(|block| matches!(op(block), Some(Op::Jmp | Op::Ret))) {
        return Err("a jump or return is the last of its network there".to_owned());
    }
    for wire in wires {
        for (at, block) in wire.blocks.iter().enumerate() {
            let is_last = at + 1 == wire.blocks.len() && wire.to.is_none();
            match op(*block) {
                Some(Op::SetCoil) if !is_last => {
                    return Err(
                        "after a set coil power goes on as it came there, and here it is the tag".to_owned(),
                    );
                }
                Some(Op::Inverter) if at == 0 && wire.from == RAIL => {
                    return Err("a Not stands after a contact there".to_owned());
                }
                _ => {}
            }
        }
    }
    Ok(())
}
