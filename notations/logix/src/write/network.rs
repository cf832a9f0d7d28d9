//! Networks as rungs.

use super::rung::{Piece, Series, branch, count, it};
use super::{Result, Writer};
use ladder_analysis::program::{Argument, BlockKind, Bound, Network, Step};
use ladder_format::Circuit;
use ladder_instructions::{Op, Role};
use ladder_notation::circuit::series_parallel;

/// A rung that a network is split into has no more instructions.
const MOST_REPEATED: usize = 500;

/// What stands around a part of a network.
#[derive(Clone, Copy)]
struct Around {
    /// It is a rung of its own, which may end here.
    top: bool,
    /// It begins at the left rail.
    at_rail: bool,
    /// Power goes on after it.
    used: bool,
}

const NEEDS_RAIL: &str =
    "its power does not depend on its rung, which has no counterpart in the middle of a rung there";

impl Writer<'_> {
    /// The rungs of a network.
    pub(super) fn network(&mut self, network: &Network) -> Result<Vec<Series>> {
        self.rungs.clear();
        self.before.clear();
        self.label = None;
        match series_parallel(network) {
            Some(circuit) => {
                let parts = match circuit {
                    Circuit::Series(parts) => parts,
                    other => vec![other],
                };
                let around = Around {
                    top: true,
                    at_rail: true,
                    used: false,
                };
                let last = self.series(network, &parts, Series::new(), around)?;
                self.rungs.push(last);
            }
            None => self.repeated(network)?,
        }
        let mut rungs = std::mem::take(&mut self.before);
        let is_alone = rungs.is_empty() && self.rungs.len() == 1;
        let own = std::mem::take(&mut self.rungs);
        rungs.extend(own.into_iter().filter(|rung| !rung.is_empty() || is_alone));
        if let Some(label) = self.label.take() {
            match rungs.first_mut() {
                Some(first) => first.insert(0, it("LBL", &[&label])),
                None => rungs.push(vec![it("LBL", &[&label])]),
            }
        }
        Ok(rungs)
    }

    fn series(
        &mut self,
        network: &Network,
        parts: &[Circuit<usize>],
        mut out: Series,
        around: Around,
    ) -> Result<Series> {
        let mut at = 0;
        while let Some(part) = parts.get(at) {
            if let Some((pieces, taken)) = self.pattern(network, &parts[at..])? {
                out.extend(pieces);
                at += taken;
                continue;
            }
            at += 1;
            let used = around.used || at < parts.len();
            let within = Around {
                top: false,
                at_rail: around.at_rail && out.is_empty(),
                used,
            };
            match part {
                Circuit::Element(block) => {
                    let lowered = self.block(network, *block, used).map_err(|why| {
                        format!(
                            "`{}`: {why}",
                            self.source(network.blocks[*block].location.range).trim()
                        )
                    })?;
                    out.extend(lowered.pieces);
                    match lowered.cut {
                        None => {}
                        Some(next) if around.top => self.rungs.push(std::mem::replace(&mut out, next)),
                        Some(next) if around.at_rail => {
                            out.push(it("AFI", &[]));
                            out = branch(vec![out, next]);
                        }
                        Some(_) => {
                            return Err(format!(
                                "`{}`: {NEEDS_RAIL}",
                                self.source(network.blocks[*block].location.range).trim()
                            ));
                        }
                    }
                }
                Circuit::Series(inner) => {
                    out = self.series(network, inner, out, Around { used, ..around })?;
                }
                Circuit::Parallel(legs) => {
                    let made = (self.made.len(), self.first_scan.len());
                    match self.legs(network, legs, within) {
                        Ok(pieces) => out.extend(pieces),
                        // Legs at the end of a rung can be rungs of their own.
                        Err(why) if around.top && !used && why.ends_with(NEEDS_RAIL) => {
                            self.made.truncate(made.0);
                            self.first_scan.truncate(made.1);
                            let power = self.made("power", "BOOL", "power on a rung");
                            out.push(it("OTE", &[&power]));
                            self.rungs.push(std::mem::take(&mut out));
                            for leg in legs {
                                let begin = vec![it("XIC", &[&power])];
                                let leg = std::slice::from_ref(leg);
                                let last = self.series(network, leg, begin, around)?;
                                self.rungs.push(last);
                            }
                        }
                        Err(why) => return Err(why),
                    }
                }
            }
        }
        Ok(out)
    }

    fn legs(&mut self, network: &Network, legs: &[Circuit<usize>], around: Around) -> Result<Series> {
        let mut out = Vec::new();
        let mut at = 0;
        while let Some(leg) = legs.get(at) {
            match self.limits(network, &legs[at..])? {
                Some((limits, taken)) => {
                    out.push(vec![limits]);
                    at += taken;
                }
                None => {
                    let parts = match leg {
                        Circuit::Series(parts) => &parts[..],
                        one => std::slice::from_ref(one),
                    };
                    out.push(self.series(network, parts, Series::new(), around)?);
                    at += 1;
                }
            }
        }
        Ok(branch(out))
    }

    /// A network that is no series and branches: each block that acts has a rung of its own, with all contacts on the way to it.
    fn repeated(&mut self, network: &Network) -> Result<()> {
        let acts = |block: usize| match network.blocks[block].kind {
            BlockKind::Instruction(row) => row.role != Role::Condition,
            BlockKind::User(_) => true,
        };
        may_repeat(network, &acts)?;
        let mut powers: Vec<Option<Series>> = Vec::new();
        let mut rungs = Vec::new();
        for step in &network.steps {
            let power = match *step {
                Step::Start { rail } => rail.then(Vec::new),
                Step::Join { upper, lower } => match (powers[upper].clone(), powers[lower].clone()) {
                    (Some(upper), Some(lower)) if upper != lower => Some(branch(vec![upper, lower])),
                    (one, other) => one.or(other),
                },
                Step::Block { block, en } => {
                    let mut power = powers[en].clone();
                    if let Some(power) = &mut power {
                        let lowered = self.block(network, block, false)?;
                        if lowered.cut.is_some() {
                            return Err(format!("in a bridge {NEEDS_RAIL}"));
                        }
                        if acts(block) {
                            let mut rung = power.clone();
                            rung.extend(lowered.pieces);
                            rungs.push(rung);
                        } else {
                            power.extend(lowered.pieces);
                        }
                    }
                    power
                }
            };
            if power.as_ref().is_some_and(|power| count(power) > MOST_REPEATED) {
                return Err("it is a bridge, and too large to be written as the paths it makes".to_owned());
            }
            powers.push(power);
        }
        self.note(&format!(
            "it is a bridge, or has another order than a rung can have there: its contacts are repeated, on {} rungs",
            rungs.len()
        ));
        self.rungs = rungs;
        Ok(())
    }
}

/// The parts of a leg.
pub(super) fn parts(circuit: &Circuit<usize>) -> &[Circuit<usize>] {
    match circuit {
        Circuit::Series(parts) => parts,
        one => std::slice::from_ref(one),
    }
}

/// An instruction alone.
pub(super) fn only(piece: Piece) -> Series {
    vec![piece]
}

/// Whether contacts can be read again on a later rung.
fn may_repeat(network: &Network, acts: &impl Fn(usize) -> bool) -> Result<()> {
    let mut read = Vec::new();
    for (number, block) in network.blocks.iter().enumerate() {
        if acts(number) {
            continue;
        }
        let plain = matches!(block.kind, BlockKind::Instruction(row) if matches!(row.op, Op::Contact | Op::NegatedContact | Op::Eq | Op::Ne | Op::Gt | Op::Ge | Op::Lt | Op::Le));
        if !plain {
            return Err("it is a bridge, and not all that decides in it can be repeated".to_owned());
        }
        read.extend(
            block
                .arguments
                .iter()
                .flat_map(Bound::places)
                .filter_map(|(place, _)| place.root()),
        );
    }
    for number in (0..network.blocks.len()).filter(|number| acts(*number)) {
        let block = &network.blocks[number];
        let plain = matches!(block.kind, BlockKind::Instruction(row) if matches!(row.op, Op::Coil | Op::SetCoil | Op::ResetCoil | Op::Mov | Op::Add | Op::Sub | Op::Mul));
        let writes = block
            .arguments
            .iter()
            .filter(|bound| !matches!(bound.argument, Argument::Value(_)));
        let changes = writes
            .filter_map(|bound| bound.argument.root())
            .any(|root| read.contains(&root));
        if !plain || changes {
            return Err(
                "it is a bridge, or has an order that no rung keeps there, and what it writes decides in it"
                    .to_owned(),
            );
        }
    }
    Ok(())
}
