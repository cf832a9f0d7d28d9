//! What the reader puts into a loop after the rung, as the one instruction that it was: `FAL`, `FSC`, `FOR`, `BRK`.

use super::block::constant;
use super::native::Known;
use super::network::parts;
use super::rung::{Piece, it};
use super::{Result, Writer};
use ladder_analysis::program::{Argument, Block, BlockKind, Network, Place, TagId};
use ladder_instructions::Op;
use ladder_notation::circuit::series_parallel;
use ladder_syntax::Name;

fn op(block: &Block) -> Option<Op> {
    match block.kind {
        BlockKind::Instruction(row) => Some(row.op),
        BlockKind::User(_) => None,
    }
}

fn ops(network: &Network) -> Vec<Option<Op>> {
    network.blocks.iter().map(op).collect()
}

/// The tag that a block is given as its last operand.
fn last_tag(block: &Block) -> Option<TagId> {
    match &block.arguments.last()?.argument {
        Argument::Place(Place::Tag(tag), _) => Some(*tag),
        _ => None,
    }
}

impl Writer<'_> {
    /// Finds the loops that belong to instructions.
    pub(super) fn find_loops(&mut self) {
        if !self.input.is_own {
            return;
        }
        let program = self.input.program;
        for (number, network) in program.networks.iter().enumerate() {
            // Several of one rung follow each other.
            let mut next = number + 1;
            for block in &network.blocks {
                let BlockKind::User(user) = block.kind else {
                    continue;
                };
                let Some(Known::Native(name @ ("FAL" | "FSC" | "FOR"))) =
                    self.facts.known.get(&user).cloned()
                else {
                    continue;
                };
                let Some(turns) = last_tag(block) else { continue };
                let Some(count) = self.is_loop(name, turns, next) else {
                    continue;
                };
                self.facts.loops.begins.insert(block.location.range.start(), next);
                self.facts.loops.networks.extend(next..next + count);
                next += count;
                self.facts
                    .absorbed_names
                    .insert(Name::new(&program.tags[turns.0 as usize].name));
            }
        }
    }

    /// Whether networks are the loop of an instruction, and how many they are.
    fn is_loop(&mut self, name: &str, turns: TagId, first: usize) -> Option<usize> {
        use Op::{Add, Calc, Call, Contact, Ge, Jmp, Lbl, NegatedContact, Next, ResetCoil, SetCoil};
        let program = self.input.program;
        let at = |number: usize| {
            program
                .networks
                .get(first + number)
                .filter(|network| network.location.file == 0)
        };
        let begin = at(0)?;
        let [own] = &begin.blocks[..] else { return None };
        let counts = own
            .arguments
            .first()
            .and_then(|bound| bound.places().first().and_then(|(place, _)| place.root()));
        if op(own) != Some(Op::For) || counts != Some(turns) {
            return None;
        }
        let is = |number: usize, wanted: &[Op]| {
            at(number).is_some_and(|network| ops(network).into_iter().eq(wanted.iter().map(|op| Some(*op))))
        };
        let done = [Contact, Ge, SetCoil];
        match name {
            "FAL" => (is(1, &[Calc, Add]) && is(2, &[Next]) && is(3, &done)).then_some(4),
            "FSC" => {
                let ends =
                    at(1).is_some_and(|network| ops(network).ends_with(&[Some(SetCoil), Some(SetCoil)]));
                (ends && is(2, &[NegatedContact, Add]) && is(3, &[Next]) && is(4, &done)).then_some(5)
            }
            _ => {
                let plain = is(1, &[Calc, Call]);
                let leaves = is(1, &[Calc, Call, Contact, ResetCoil, Jmp]) && is(4, &[Lbl]);
                if !(plain || leaves) || !is(2, &[Next]) || !is(3, &[Ge, Calc]) {
                    return None;
                }
                // The number of the turn.
                if let Some(turn) = last_tag(own) {
                    self.facts
                        .absorbed_names
                        .insert(Name::new(&program.tags[turn.0 as usize].name));
                }
                Some(4 + usize::from(leaves))
            }
        }
    }

    /// `FAL`, `FSC` or `FOR` with what its loop does.
    pub(super) fn looped(&mut self, name: &str, block: &Block, texts: &[&str]) -> Result<Piece> {
        let first = self
            .facts
            .loops
            .begins
            .get(&block.location.range.start())
            .copied();
        let first = first.ok_or("it has no counterpart without the loop that the reader writes after it")?;
        let program = self.input.program;
        let body = &program.networks[first + 1];
        if name == "FOR" {
            let [from, to, step, _] = texts else {
                return Err("it is not whole".to_owned());
            };
            let index = self.target(&body.blocks[0])?;
            let called = self.source(body.blocks[1].arguments[0].range).trim().to_owned();
            let routine = self.names.spell(super::names::Kind::Routine, &called);
            return Ok(it("FOR", &[&routine, &index, from, to, step]));
        }
        let [control, _, _] = texts else {
            return Err("it is not whole".to_owned());
        };
        let mode = block.arguments.get(1).and_then(|bound| match &bound.argument {
            Argument::Value(value) => constant(value),
            _ => None,
        });
        let mode = match mode {
            Some(0) => "ALL".to_owned(),
            Some(-1) => "INC".to_owned(),
            Some(number) => number.to_string(),
            None => return Err("there its mode is a constant".to_owned()),
        };
        if name == "FAL" {
            let to = self.target(&body.blocks[0])?;
            let Some(Argument::Value(formula)) = body.blocks[0].arguments.get(1).map(|bound| &bound.argument)
            else {
                return Err("it is not whole".to_owned());
            };
            let formula = self.formula(formula)?;
            return Ok(it("FAL", &[control, "?", "?", &mode, &to, &formula]));
        }
        let formula = self.searched(body)?;
        Ok(it("FSC", &[control, "?", "?", &mode, &formula]))
    }

    /// What a search looks for, as a formula.
    fn searched(&mut self, body: &Network) -> Result<String> {
        let circuit = series_parallel(body).ok_or("it is not whole")?;
        let found = &parts(&circuit)[1..];
        let piece = match self.pattern(body, found)? {
            Some((pieces, _)) => pieces.into_iter().next(),
            None => {
                let lowered = self.block(body, 1, true)?;
                lowered.pieces.into_iter().next()
            }
        };
        let Some(Piece::It(text)) = piece else {
            return Err("it is not whole".to_owned());
        };
        let (name, operands) = text.trim_end_matches(')').split_once('(').unwrap_or_default();
        let sign = match name {
            "CMP" => return Ok(operands.to_owned()),
            "EQU" => "=",
            "NEQ" => "<>",
            "LES" => "<",
            "LEQ" => "<=",
            "GRT" => ">",
            "GEQ" => ">=",
            _ => return Err("there a search compares".to_owned()),
        };
        let (left, right) = operands.rsplit_once(',').unwrap_or_default();
        Ok(format!("{left} {sign} {right}"))
    }
}
