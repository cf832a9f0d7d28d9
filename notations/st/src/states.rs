//! Timers, counters, bistables: calls of the standard's blocks, or of those that are written along.

use crate::arguments::{by_place, second};
use crate::checks::Checks;
use crate::power::Power;
use crate::project::{Result, Service};
use crate::term::{Binding, Term};
use crate::unit::Unit;
use ladder_analysis::program::{Argument, Block, Expr, ExprKind};
use ladder_analysis::values::types::{Scalar, Type};
use ladder_analysis::values::value::Value;
use ladder_instructions::{Op, StateType};
use std::collections::BTreeSet;

/// A TIME has so many milliseconds at most.
const MOST: i64 = i64::MAX / 1_000_000;

/// A timer, counter or bistable that a block is about.
struct State {
    kind: StateType,
    is_standard: bool,
    variable: String,
    text: String,
}

impl Unit<'_, '_> {
    fn state(&mut self, argument: Option<&Argument>) -> Result<State> {
        let Some(argument) = argument else {
            return self.stop("a block without its timer or counter");
        };
        let tag = self.state_tag(argument)?;
        let Type::State(kind) = self.project.source.program.tags[tag.0 as usize].ty else {
            return self.stop("a block without its timer or counter");
        };
        let (variable, text) = self.path(tag, &[]);
        let is_standard = self.project.is_standard(kind, tag);
        Ok(State {
            kind,
            is_standard,
            variable,
            text,
        })
    }

    pub(crate) fn timer(&mut self, block: &Block, en: usize, step: usize) -> Result<()> {
        let mut checks = Checks::new();
        let state = self.state(by_place(block).first().copied())?;
        let Some(preset) = second(block) else {
            return self.stop("a timer without its time");
        };
        let mut inputs = vec![("PT", self.preset(preset, &mut checks)?)];
        if let Some(reset) = self.named_bit(block, "R", &mut checks)? {
            inputs.push(("R", reset));
        } else if !state.is_standard {
            inputs.push(("R", Term::whole("FALSE")));
        }
        if !state.is_standard {
            let now = self.service(Service::Now);
            inputs.push(("NOW", Term::variable(&now)));
        }
        self.evaluated(&state, ("IN", "Q"), inputs, checks, (en, step));
        Ok(())
    }

    /// A TIME, or a plain integer in milliseconds.
    fn preset(&mut self, preset: &Expr, checks: &mut Checks) -> Result<Term> {
        if preset.ty == Scalar::Time {
            return self.value(preset, checks);
        }
        if let ExprKind::Constant(Value::Int(number)) = preset.kind {
            let nanoseconds = number.clamp(-MOST, MOST) * 1_000_000;
            return Ok(Term::whole(crate::literal::duration(nanoseconds)));
        }
        let mut value = self.settled(preset, checks)?;
        if preset.ty.width() == 64 {
            let value_of = |number: i64| Term::whole(number.to_string());
            value = if preset.ty.is_signed() {
                Term::call("LIMIT", &[&value_of(-MOST), &value, &value_of(MOST)])
            } else {
                Term::call("MIN", &[&value, &value_of(MOST)])
            };
        }
        Ok(Term::binary(&Term::whole("T#1ms"), "*", &value, Binding::Product))
    }

    pub(crate) fn counter(&mut self, block: &Block, en: usize, step: usize) -> Result<()> {
        let mut checks = Checks::new();
        let state = self.state(by_place(block).first().copied())?;
        let Some(preset) = second(block) else {
            return self.stop("a counter without its number");
        };
        let mut inputs = Vec::new();
        for (name, member) in [("CD", "CD"), ("R", "R"), ("LD", "LD_IN")] {
            if matches!(state.kind, StateType::Ctu | StateType::Ctc) && name != "R"
                || state.kind == StateType::Ctd && name == "CD"
            {
                continue;
            }
            let given = self.named_bit(block, name, &mut checks)?;
            inputs.push((member, given.unwrap_or_else(|| Term::whole("FALSE"))));
        }
        inputs.push(("PV", self.settled(preset, &mut checks)?));
        self.evaluated(&state, ("CU", "Q"), inputs, checks, (en, step));
        Ok(())
    }

    pub(crate) fn bistable(&mut self, op: Op, block: &Block, en: usize, step: usize) -> Result<()> {
        let mut checks = Checks::new();
        let state = self.state(by_place(block).first().copied())?;
        let reset = self
            .named_bit(block, "R", &mut checks)?
            .unwrap_or_else(|| Term::whole("FALSE"));
        let (set, reset_name) = if op == Op::Sr { ("S1", "R") } else { ("S", "R1") };
        self.evaluated(&state, (set, "Q1"), vec![(reset_name, reset)], checks, (en, step));
        Ok(())
    }

    /// The call of a block, and the power after it.
    fn evaluated(
        &mut self,
        state: &State,
        (input, output): (&str, &str),
        inputs: Vec<(&str, Term)>,
        checks: Checks,
        (en, step): (usize, usize),
    ) {
        if !state.is_standard {
            self.project.used.pieces.insert(piece_of(state.kind));
        }
        let power = self.entering(en, en);
        self.keep(Some(&BTreeSet::from([state.variable.clone()])));
        let term = power.or_true();
        let mut arguments = vec![format!("{input} := {}", term.text)];
        arguments.extend(
            inputs
                .iter()
                .map(|(name, term)| format!("{name} := {}", term.text)),
        );
        if !state.is_standard {
            arguments.push("CLEAR := FALSE".into());
        }
        let call = format!("{}({});", state.text, arguments.join(", "));
        let number = self.number();
        let mut q = Term::whole(format!("{}.{output}", state.text));
        q.reads.insert(state.variable.clone());
        if checks.is_empty() {
            self.line(call);
            self.rungs.powers[step] = Power::of(number, q);
            return;
        }
        let done = self.done(step);
        self.all_or_low(checks, vec![call], &q, (step, done));
    }

    /// `(RES)`, and `(R)` on a timer or counter: the block that is written along clears itself.
    pub(crate) fn clear(&mut self, argument: &Argument, en: usize, step: usize) -> Result<()> {
        let state = self.state(Some(argument))?;
        self.project.used.pieces.insert(piece_of(state.kind));
        let power = self.entering(en, step);
        self.rungs.powers[step] = power.clone();
        self.keep(Some(&BTreeSet::from([state.variable])));
        self.when(&power, &[format!("{}(CLEAR := TRUE);", state.text)]);
        Ok(())
    }
}

/// The block that is written along for a kind.
pub(crate) fn piece_of(kind: StateType) -> &'static str {
    match kind {
        StateType::Ton => "LADDER_TON",
        StateType::Tof => "LADDER_TOF",
        StateType::Tp => "LADDER_TP",
        StateType::Rto => "LADDER_RTO",
        StateType::Rtof => "LADDER_RTOF",
        StateType::Ctu => "LADDER_CTU",
        StateType::Ctd => "LADDER_CTD",
        StateType::Ctud => "LADDER_CTUD",
        StateType::Ctc => "LADDER_CTC",
        StateType::Sr => "LADDER_SR",
        StateType::Rs => "LADDER_RS",
    }
}
