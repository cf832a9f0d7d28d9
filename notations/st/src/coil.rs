//! Coils as assignments.

use crate::arguments::by_place;
use crate::block::when_lines;
use crate::checks::Checks;
use crate::place::Target;
use crate::power::Power;
use crate::project::Result;
use crate::term::Term;
use crate::unit::Unit;
use ladder_analysis::program::{Argument, Block};
use ladder_analysis::values::types::Scalar;
use std::collections::BTreeSet;

impl Unit<'_, '_> {
    /// `( )` and `(/)`
    pub(crate) fn coil(&mut self, block: &Block, en: usize, step: usize, follows: bool) -> Result<()> {
        let mut checks = Checks::new();
        let targets = self.coil_targets(block, &mut checks)?;
        let written: BTreeSet<String> = targets.iter().map(|target| target.variable.clone()).collect();
        let value = |power: &Power| {
            let term = power.or_true();
            match (follows, term.text.as_str()) {
                (true, _) => term,
                (false, "TRUE") => Term::whole("FALSE"),
                (false, "FALSE") => Term::whole("TRUE"),
                (false, _) => term.not(),
            }
        };
        if !checks.is_empty() {
            let power = self.entering(en, step);
            let done = self.done(step);
            self.keep(Some(&written));
            let term = value(&power);
            let lines = targets.iter().flat_map(|target| target.assign(&term)).collect();
            self.all_or_low(checks, lines, &power.or_true(), (step, done));
            return Ok(());
        }
        let power = self.rungs.powers[en].clone();
        let holds = match targets.as_slice() {
            // The coil's tag is the name of the power from here on.
            [target] if follows && target.is_whole() => !power.is_short() && self.is_needed_again(en, step),
            _ => false,
        };
        if holds {
            self.rungs.powers[step] = power.clone();
            let variable = &targets[0].variable;
            let number = self.hold(&power.numbers(), variable);
            self.keep(Some(&written));
            self.line(format!("{variable} := {};", value(&power).text));
            self.is_held(number, variable);
            return Ok(());
        }
        let power = self.entering(en, step);
        self.rungs.powers[step] = power.clone();
        self.keep(Some(&written));
        let term = value(&power);
        for target in &targets {
            target.assign(&term).iter().for_each(|line| self.line(line));
        }
        Ok(())
    }

    fn coil_targets(&mut self, block: &Block, checks: &mut Checks) -> Result<Vec<Target>> {
        match by_place(block).first() {
            Some(Argument::Place(place, Scalar::Bool)) => Ok(vec![self.place(place, checks)?]),
            Some(Argument::Range(range)) => self.element_targets(range, checks),
            _ => self.stop("a coil on something that is no BOOL"),
        }
    }

    pub(crate) fn set_coil(&mut self, block: &Block, en: usize, step: usize) -> Result<()> {
        let mut checks = Checks::new();
        let targets = self.coil_targets(block, &mut checks)?;
        let mut after = Vec::new();
        match by_place(block).first() {
            Some(Argument::Place(place, _)) => after.push(self.read(place, &mut Checks::new())?),
            Some(Argument::Range(range)) => after = self.elements(range, &mut Checks::new())?,
            _ => {}
        }
        let after = Term::all(&after).unwrap_or_else(|| Term::whole("TRUE"));
        let written: BTreeSet<String> = targets.iter().map(|target| target.variable.clone()).collect();
        let power = self.entering(en, en);
        self.keep(Some(&written));
        let lines: Vec<String> = targets
            .iter()
            .flat_map(|target| target.assign(&Term::whole("TRUE")))
            .collect();
        let number = self.number();
        if checks.is_empty() {
            self.when(&power, &lines);
            self.rungs.powers[step] = Power::of(number, after);
            return Ok(());
        }
        let done = self.done(step);
        self.all_or_low(checks, when_lines(&power, &lines), &after, (step, done));
        Ok(())
    }

    pub(crate) fn reset_coil(&mut self, block: &Block, en: usize, step: usize) -> Result<()> {
        if let Some(state @ (Argument::State(_) | Argument::ChosenState(_))) = by_place(block).first() {
            return self.clear(state, en, step);
        }
        let mut checks = Checks::new();
        let targets = self.coil_targets(block, &mut checks)?;
        let written: BTreeSet<String> = targets.iter().map(|target| target.variable.clone()).collect();
        let power = self.entering(en, step);
        let lines: Vec<String> = targets
            .iter()
            .flat_map(|target| target.assign(&Term::whole("FALSE")))
            .collect();
        if checks.is_empty() {
            self.rungs.powers[step] = power.clone();
            self.keep(Some(&written));
            self.when(&power, &lines);
            return Ok(());
        }
        self.keep(Some(&written));
        let done = self.done(step);
        self.all_or_low(checks, when_lines(&power, &lines), &power.or_true(), (step, done));
        Ok(())
    }

    pub(crate) fn edge_coil(&mut self, block: &Block, en: usize, step: usize, rises: bool) -> Result<()> {
        let mut checks = Checks::new();
        let targets = self.coil_targets(block, &mut checks)?;
        let base = match by_place(block).first() {
            Some(Argument::Place(place, _)) => self.called(place),
            _ => "rung".into(),
        };
        let power = self.entering(en, step);
        self.rungs.powers[step] = power.clone();
        let edge = self.edge_of_power(en, &base, rises);
        let written: BTreeSet<String> = targets.iter().map(|target| target.variable.clone()).collect();
        self.keep(Some(&written));
        let lines: Vec<String> = targets.iter().flat_map(|target| target.assign(&edge)).collect();
        if checks.is_empty() {
            for line in &lines {
                self.line(line);
            }
            return Ok(());
        }
        let done = self.done(step);
        self.all_or_low(checks, lines, &power.or_true(), (step, done));
        Ok(())
    }

    /// The variable that says whether a block did what it does, if anything asks.
    pub(crate) fn done(&mut self, step: usize) -> Option<String> {
        (self.rungs.left[step] > 0).then(|| self.temporary("power", Scalar::Bool))
    }

    pub(crate) fn is_done(&mut self, step: usize, done: Option<String>) {
        let number = self.number();
        self.rungs.powers[step] = match done {
            Some(done) => Power::of(number, Term::variable(&done)),
            None => Power::Dead,
        };
    }
}
