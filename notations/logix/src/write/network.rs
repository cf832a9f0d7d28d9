//! Networks as rungs.

use super::rung::{Piece, Series, branch, it};
use super::{Result, Writer};
use ladder_analysis::program::Network;
use ladder_format::Circuit;
use ladder_notation::circuit::series_parallel;

/// What is around a part of a network.
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
        self.sheet.rungs.clear();
        self.sheet.before.clear();
        self.sheet.labels.clear();
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
                self.sheet.rungs.push(last);
            }
            None => return Err("it is not made of series and branches alone".to_owned()),
        }
        let mut rungs = std::mem::take(&mut self.sheet.before);
        let is_alone = rungs.is_empty() && self.sheet.rungs.len() == 1;
        let own = std::mem::take(&mut self.sheet.rungs);
        rungs.extend(own.into_iter().filter(|rung| !rung.is_empty() || is_alone));
        let mut labels = std::mem::take(&mut self.sheet.labels);
        if let Some(label) = labels.pop() {
            match rungs.first_mut() {
                Some(first) => first.insert(0, it("LBL", &[&label])),
                None => rungs.push(vec![it("LBL", &[&label])]),
            }
        }
        // A rung has one label there.
        let above = labels
            .iter()
            .map(|label| vec![it("LBL", &[label]), it("NOP", &[])]);
        rungs.splice(0..0, above);
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
                        Some(next) if around.top => self.sheet.rungs.push(std::mem::replace(&mut out, next)),
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
                    let made = (self.scope.made.len(), self.scope.first_scan.len());
                    match self.legs(network, legs, within) {
                        Ok(pieces) => out.extend(pieces),
                        // Legs at the end of a rung can be rungs of their own.
                        Err(why) if around.top && !used && why.ends_with(NEEDS_RAIL) => {
                            self.scope.made.truncate(made.0);
                            self.scope.first_scan.truncate(made.1);
                            let power = self.made("power", "BOOL", "power on a rung");
                            out.push(it("OTE", &[&power]));
                            self.sheet.rungs.push(std::mem::take(&mut out));
                            for leg in legs {
                                let begin = vec![it("XIC", &[&power])];
                                let leg = std::slice::from_ref(leg);
                                let last = self.series(network, leg, begin, around)?;
                                self.sheet.rungs.push(last);
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
