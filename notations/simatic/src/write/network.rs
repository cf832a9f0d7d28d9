//! Networks as rungs with named wires.

use super::Writer;
use super::element::Text;
use super::operand::Tags;
use super::power::{Parted, Power, Stands, is_rail, is_used, parted};
use super::strands;
use crate::model::RAIL;
use crate::sketch::rungs::{Piece, ways};
use crate::sketch::wiring::Strand;
use ladder_analysis::program::{Block, BlockKind, Network, Step};
use ladder_instructions::Op;
use ladder_syntax::TextSize;
use std::collections::HashMap;

/// A call that has its power as an input.
struct Call {
    step: usize,
    /// The block of the network.
    number: usize,
    en: usize,
    writes: bool,
}

impl<'a> Writer<'a> {
    /// The network of the program that a network of the text is.
    pub(super) fn network_at(&self, number: usize) -> Option<&'a Network> {
        self.networks.get(&self.start(number)).copied()
    }

    /// Where a network of the text begins.
    pub(super) fn start(&self, number: usize) -> TextSize {
        let parse = &self.analysis.context.parse;
        parse.line_start(parse.structure().networks[number].lines.start)
    }

    /// The rungs of each network that a network becomes.
    ///
    /// # Errors
    ///
    /// Why it has no form there.
    pub(super) fn network(&mut self, network: &Network, tags: &Tags) -> Result<Vec<String>, String> {
        let before = self.statics.len();
        let parts = self.around_calls(network, tags);
        parts.inspect_err(|_| self.statics.truncate(before))
    }

    /// A block that is called from the rail parts a network: what leads to it, the call, and what follows it.
    fn around_calls(&mut self, network: &Network, tags: &Tags) -> Result<Vec<String>, String> {
        let mut out = Vec::new();
        let mut stands = Stands::new();
        let mut rest = network.clone();
        while let Some(Call {
            step,
            number,
            en,
            writes,
        }) = self.call_from_rail(&rest, &stands)
        {
            let Parted { before, after } = parted(&rest, step)?;
            let mut power = String::from("TRUE");
            if !is_rail(&rest, en) {
                power = self.static_tag("power", "Bool");
                stands.insert(number, format!("Coil( {power} )"));
            }
            if before.steps.iter().any(|step| matches!(step, Step::Block { .. })) {
                out.push(self.rungs(&before, &stands, tags)?);
            }
            let is_used = is_used(&rest, step);
            let result = (writes && is_used).then(|| self.static_tag("power", "Bool"));
            let called = &rest.blocks[number];
            let call = self.call(called, (&power, result.as_deref()), tags);
            let call = call.map_err(|why| format!("`{}`: {why}", self.text[called.location.range].trim()))?;
            out.push(format!(
                "        RUNG wire#powerrail\r\n            {call}\r\n        END_RUNG\r\n"
            ));
            let result = result.unwrap_or(power);
            stands.insert(number, format!("Contact( {result} )"));
            rest = after;
            let goes_on = rest.steps[2..]
                .iter()
                .any(|step| matches!(step, Step::Block { .. }));
            if !goes_on {
                return Ok(out);
            }
        }
        out.push(self.rungs(&rest, &stands, tags)?);
        Ok(out)
    }

    /// The first block that only the rail can call.
    fn call_from_rail(&self, network: &Network, stands: &Stands) -> Option<Call> {
        let mut steps = network.steps.iter().enumerate();
        steps.find_map(|(step, own)| {
            let Step::Block { block: number, en } = *own else {
                return None;
            };
            let BlockKind::User(user) = network.blocks[number].kind else {
                return None;
            };
            let Power::Given { writes, .. } = self.powers[user] else {
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

    fn rungs(&mut self, network: &Network, stands: &Stands, tags: &Tags) -> Result<String, String> {
        let wires = strands::of(network)?;
        allowed(network, &wires)?;
        Ok(rungs(&self.strands(network, &wires, stands, tags)?))
    }

    /// The label that marks a network.
    pub(super) fn label(&self, network: &Network) -> Option<String> {
        let is_label =
            |block: &&Block| matches!(block.kind, BlockKind::Instruction(row) if row.op == Op::Lbl);
        let block = network.blocks.iter().find(is_label)?;
        Some(self.source(block.arguments.first()?).to_owned())
    }

    fn strands(
        &mut self,
        network: &Network,
        wires: &strands::Wires,
        stands: &Stands,
        tags: &Tags,
    ) -> Result<Vec<Strand<Text>>, String> {
        let mut out = Vec::new();
        for wire in &wires.wires {
            let mut strand = Strand::new(wire.from, wire.to);
            for block in &wire.blocks {
                if let Some(text) = stands.get(block) {
                    strand.elements.push(text.clone());
                    continue;
                }
                let block = &network.blocks[*block];
                let text = self.element(block, tags);
                let head = self.text[block.location.range].to_owned();
                let text = text.map_err(|why| format!("`{}`: {why}", head.trim()))?;
                strand.elements.push(text);
            }
            out.push(strand);
        }
        Ok(out)
    }
}

/// Whether instructions stand where a document can have them.
fn allowed(network: &Network, wires: &strands::Wires) -> Result<(), String> {
    let mut jumps = 0;
    let count = network
        .steps
        .iter()
        .filter(|step| matches!(step, Step::Block { .. }))
        .count();
    let mut done = 0;
    for step in &network.steps {
        let Step::Block { block, .. } = step else { continue };
        done += 1;
        if let BlockKind::Instruction(row) = network.blocks[*block].kind
            && matches!(row.op, Op::Jmp | Op::Ret)
        {
            jumps += 1;
            if jumps > 1 || done < count {
                return Err("a jump or return is the last of its network there".to_owned());
            }
        }
    }
    for wire in &wires.wires {
        for (at, block) in wire.blocks.iter().enumerate() {
            let is_last = at + 1 == wire.blocks.len() && wire.to.is_none();
            match network.blocks[*block].kind {
                BlockKind::Instruction(row) => match row.op {
                    Op::SetCoil if !is_last => {
                        return Err(
                            "after a set coil power goes on as it came there, and here it is the tag"
                                .to_owned(),
                        );
                    }
                    Op::Inverter if at == 0 && wire.from == RAIL => {
                        return Err("a Not stands after a contact there".to_owned());
                    }
                    _ => {}
                },
                BlockKind::User(_) => {}
            }
        }
    }
    Ok(())
}

/// The rungs of strands.
fn rungs(strands: &[Strand<Text>]) -> String {
    let mut names: HashMap<usize, String> = HashMap::new();
    let mut name = |point: usize| match point {
        RAIL => "wire#powerrail".to_owned(),
        point => {
            let next = names.len() + 1;
            let name = names.entry(point).or_insert_with(|| format!("wire#w{next}"));
            name.clone()
        }
    };
    let mut out = String::new();
    for way in ways(strands) {
        out.push_str(&format!("        RUNG {}\r\n", name(way.from)));
        let (last, pieces) = match way.pieces.split_last() {
            Some((Piece::Point(point), pieces)) => (Some(*point), pieces),
            _ => (None, &way.pieces[..]),
        };
        for piece in pieces {
            match piece {
                Piece::Point(point) => out.push_str(&format!("            {}\r\n", name(*point))),
                Piece::Element(element) => {
                    for line in element.lines() {
                        out.push_str(&format!("            {line}\r\n"));
                    }
                }
            }
        }
        match last {
            Some(point) => out.push_str(&format!("        END_RUNG {}\r\n", name(point))),
            None => out.push_str("        END_RUNG\r\n"),
        }
    }
    out
}
