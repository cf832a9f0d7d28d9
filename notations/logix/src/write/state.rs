//! Timers, counters, bistables and edges of the language itself.
//!
//! Their power is their output there, and EN here: where the output is needed, a contact of it follows. Where it is
//! high without EN, the rung ends, and goes on from the rail.

use super::operand::milliseconds;
use super::rung::{Piece, Series, it};
use super::{Lowered, Result, Writer};
use ladder_analysis::program::{Argument, Block, Expr, ExprKind, Place, TagId};
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_instructions::Op;
use ladder_syntax::Name;

/// What is given to a timer or counter.
struct Given<'b> {
    /// Its tag.
    own: String,
    /// The tags that it can be: several where an index is computed.
    tags: Vec<TagId>,
    /// PT or PV.
    preset: Option<&'b Expr>,
    reset: Option<&'b Expr>,
    load: Option<&'b Expr>,
    down: Option<&'b Expr>,
}

/// What is run from the rail after the rung, and where power goes on from.
fn go_on(steps: Vec<Series>, after: Option<Series>) -> Option<Series> {
    match (steps.len(), after) {
        (0, after) => after,
        (1, None) => steps.into_iter().next(),
        (_, None) => Some(vec![Piece::Branch(steps)]),
        (_, Some(after)) => {
            let dead = |mut step: Series| {
                step.push(it("AFI", &[]));
                step
            };
            let mut legs: Vec<Series> = steps.into_iter().map(dead).collect();
            legs.push(after);
            Some(vec![Piece::Branch(legs)])
        }
    }
}

impl Writer<'_> {
    fn given<'b>(&mut self, block: &'b Block) -> Result<Given<'b>> {
        let mut given = Given {
            own: String::new(),
            tags: Vec::new(),
            preset: None,
            reset: None,
            load: None,
            down: None,
        };
        for bound in &block.arguments {
            let name = bound.operand.map_or("", |operand| operand.name);
            match (&bound.argument, name) {
                (Argument::State(_) | Argument::ChosenState(_), _) => {
                    given.tags = match &bound.argument {
                        Argument::ChosenState(chosen) => {
                            let tags = (0..chosen.count).map(|number| chosen.first.0 + number * chosen.step);
                            tags.map(TagId).collect()
                        }
                        Argument::State(tag) => vec![*tag],
                        _ => Vec::new(),
                    };
                    let written = self.source(bound.range).to_owned();
                    given.own = self.path(&written)?;
                }
                (Argument::Value(value), "PT" | "PV") => given.preset = Some(value),
                (Argument::Value(value), "R") => given.reset = Some(value),
                (Argument::Value(value), "LD") => given.load = Some(value),
                (Argument::Value(value), "CD") => given.down = Some(value),
                (_, name) => return Err(format!("it has no `{name}` there")),
            }
        }
        Ok(given)
    }

    /// A timer, counter or bistable. `used`: power goes on after it.
    pub(super) fn state(&mut self, op: Op, block: &Block, used: bool) -> Result<Lowered> {
        let given = self.given(block)?;
        // In the profile of Logix power is EN.
        let needs_output = used && !self.input.is_own;
        match op {
            Op::Ton | Op::Tof | Op::Tp | Op::Rto => self.timer(op, &given, needs_output),
            Op::Ctu | Op::Ctd | Op::Ctud => self.counter(op, &given, needs_output),
            Op::Sr | Op::Rs => self.bistable(op, &given, used),
            _ => Err("it has no counterpart there".to_owned()),
        }
    }

    /// The preset is in the tag there.
    fn keep_preset(&mut self, given: &Given<'_>, number: &str) -> Result<()> {
        for tag in &given.tags {
            let tag = &self.input.program.tags[tag.0 as usize];
            let block = tag
                .block
                .map(|block| self.input.program.blocks[block].name.to_ascii_uppercase());
            let key = (block.unwrap_or_default(), Name::new(&tag.name));
            let before = self.data.presets.insert(key, number.to_owned());
            if before.is_some_and(|before| before != number) {
                return Err(format!("there `{}` has one preset, and here two", tag.name));
            }
        }
        Ok(())
    }

    /// A number that never changes.
    fn constant_of(&self, expr: &Expr) -> Option<i64> {
        match &expr.kind {
            ExprKind::Constant(Value::Int(number)) => Some(*number),
            ExprKind::Pass(inner) => self.constant_of(inner),
            ExprKind::Read(Place::Tag(tag)) => {
                let tag = &self.input.program.tags[tag.0 as usize];
                match tag.initial.first() {
                    _ if !tag.constant => None,
                    Some(Value::Int(number)) => Some(*number),
                    _ => Some(0),
                }
            }
            _ => None,
        }
    }

    fn timer(&mut self, op: Op, given: &Given<'_>, needs_output: bool) -> Result<Lowered> {
        let own = &given.own;
        let mut pieces = Vec::new();
        let constant = given.preset.and_then(|preset| self.constant_of(preset));
        let number = match (given.preset, constant) {
            (Some(preset), Some(span)) => {
                let number = if preset.ty == Scalar::Time {
                    milliseconds(span)?
                } else {
                    span
                };
                number.max(0).to_string()
            }
            (Some(preset), None) if matches!(op, Op::Ton | Op::Rto) => {
                let preset = self.value(preset)?;
                pieces.push(it("MOV", &[&preset, &format!("{own}.PRE")]));
                "?".to_owned()
            }
            _ => return Err("there its time is a constant".to_owned()),
        };
        if number != "?" {
            self.keep_preset(given, &number)?;
        }
        let accumulated = if number == "?" { "?" } else { "0" };
        let done = it("XIC", &[&format!("{own}.DN")]);
        let timer = |name: &str| it(name, &[own, &number, accumulated]);
        match op {
            Op::Ton => {
                // While it is reset, power counts as low.
                if let Some(reset) = given.reset {
                    pieces.extend(self.condition(reset, false)?);
                }
                pieces.push(timer("TON"));
                pieces.extend(needs_output.then_some(done));
                Ok(Lowered { pieces, cut: None })
            }
            Op::Tof if given.reset.is_none() => Ok(Lowered {
                pieces: vec![timer("TOF")],
                cut: needs_output.then(|| vec![done]),
            }),
            Op::Rto => {
                pieces.push(timer("RTO"));
                let mut steps = Vec::new();
                if let Some(reset) = given.reset {
                    let mut step = self.condition(reset, true)?;
                    step.push(it("RES", &[own]));
                    steps.push(step);
                }
                Ok(Lowered {
                    pieces,
                    cut: go_on(steps, needs_output.then(|| vec![done])),
                })
            }
            Op::Tp if given.reset.is_none() => {
                let pulse = self.pulse(own);
                let begin = self.storage("risen", true);
                let pieces = vec![it("ONS", &[&begin]), it("XIO", &[&pulse]), it("OTL", &[&pulse])];
                // The next pulse may begin before the timer has seen its rung low.
                let ends = [it("OTU", &[&pulse]), it("RES", &[own])];
                let runs = [vec![it("XIC", &[&pulse]), timer("TON"), done], ends.to_vec()].concat();
                let after = needs_output.then(|| vec![it("XIC", &[&pulse])]);
                Ok(Lowered {
                    pieces,
                    cut: go_on(vec![runs], after),
                })
            }
            _ => Err("there it has no R".to_owned()),
        }
    }

    /// The bit that is high during the pulse of a TP.
    pub(super) fn pulse(&mut self, own: &str) -> String {
        if let Some(known) = self.data.pulses.get(own) {
            return known.clone();
        }
        let like = format!("{}_pulse", own.replace(|c: char| !c.is_ascii_alphanumeric(), "_"));
        let name = self.made(&like, "BOOL", "the pulse");
        self.data.pulses.insert(own.to_owned(), name.clone());
        name
    }

    fn counter(&mut self, op: Op, given: &Given<'_>, needs_output: bool) -> Result<Lowered> {
        let own = &given.own;
        let preset = given.preset.and_then(|preset| self.constant_of(preset));
        let preset = preset.ok_or("there its preset is a constant")?;
        if op == Op::Ctu && preset < 1 && !self.input.is_own {
            return Err("with a preset below 1 its output there comes only with its first count".to_owned());
        }
        let preset = preset.to_string();
        self.keep_preset(given, &preset)?;
        let (count, done) = (format!("{own}.ACC"), format!("{own}.DN"));
        let first = [("CU", op != Op::Ctd), ("CD", op != Op::Ctu)];
        for (bit, _) in first.iter().filter(|(_, has)| *has) {
            self.scope.first_scan.push(format!("{own}.{bit}"));
        }
        let counter = |name: &str| it(name, &[own, &preset, "0"]);
        let mut steps = Vec::new();
        if let Some(down) = given.down {
            let mut step = self.condition(down, true)?;
            step.push(counter("CTD"));
            steps.push(step);
        }
        if let Some(load) = given.load {
            let mut step = self.condition(load, true)?;
            step.push(it("MOV", &[&preset, &count]));
            steps.push(step);
        }
        // A RES would let a rung that stays high count again.
        if let Some(reset) = given.reset {
            let mut step = self.condition(reset, true)?;
            step.extend([it("MOV", &["0", &count]), it("OTU", &[&done])]);
            steps.push(step);
        }
        let (name, output) = match op {
            Op::Ctu => ("CTU", it("XIC", &[&done])),
            Op::Ctd => ("CTD", it("LEQ", &[&count, "0"])),
            _ => ("CTU", it("GEQ", &[&count, &preset])),
        };
        Ok(Lowered {
            pieces: vec![counter(name)],
            cut: go_on(steps, needs_output.then(|| vec![output])),
        })
    }

    fn bistable(&mut self, op: Op, given: &Given<'_>, used: bool) -> Result<Lowered> {
        let own = &given.own;
        let reset = given.reset.ok_or("its R is missing")?;
        let mut resets = self.condition(reset, true)?;
        resets.push(it("OTU", &[own]));
        let (pieces, steps) = if op == Op::Rs {
            (vec![it("OTL", &[own])], vec![resets])
        } else {
            let set = self.made("set", "BOOL", "whether it is set");
            let sets = vec![it("XIC", &[&set]), it("OTL", &[own])];
            (vec![it("OTE", &[&set])], vec![resets, sets])
        };
        Ok(Lowered {
            pieces,
            cut: go_on(steps, used.then(|| vec![it("XIC", &[own])])),
        })
    }
}

/// `(RES)`, or `(R)` on a timer or counter.
pub(super) fn reset_state(own: &str, ty: ladder_instructions::StateType) -> Result<Series> {
    use ladder_instructions::StateType::{Ctd, Ctu, Ctud, Rto, Ton};
    Ok(match ty {
        Ton | Rto => vec![it("RES", &[own])],
        Ctu | Ctd | Ctud => vec![
            it("MOV", &["0", &format!("{own}.ACC")]),
            it("OTU", &[&format!("{own}.DN")]),
        ],
        _ => return Err("a reset of such a timer has no counterpart there".to_owned()),
    })
}
