//! Contacts, coils and data blocks.

use crate::arguments::{by_place, named, place, values};
use crate::checks::Checks;
use crate::power::Power;
use crate::project::{Result, Service};
use crate::term::Term;
use crate::unit::Unit;
use ladder_analysis::program::{Argument, Block, BlockKind, Expr, ExprKind, Place};
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_instructions::Op;
use std::collections::BTreeSet;

impl Unit<'_, '_> {
    /// One block. True: the rest of the network is in an IF that is still open.
    pub(crate) fn block(&mut self, block: &Block, en: usize, step: usize) -> Result<bool> {
        let row = match block.kind {
            BlockKind::Instruction(row) => row,
            BlockKind::User(user) => return self.user_block(user, block, en, step).map(|()| false),
        };
        match row.op {
            Op::Contact | Op::NegatedContact => self.contact(block, en, step, row.op == Op::Contact)?,
            Op::RisingContact | Op::FallingContact => {
                self.edge_contact(block, en, step, row.op == Op::RisingContact)?;
            }
            Op::Inverter => {
                self.rungs.powers[step] = match &self.rungs.powers[en] {
                    Power::Dead => Power::rail(),
                    live @ Power::Live(_) => match live.term() {
                        None => Power::Dead,
                        Some(term) => {
                            let term = term.not();
                            let number = self.number();
                            Power::of(number, term)
                        }
                    },
                };
            }
            Op::OneShotRising | Op::OneShotFalling => {
                let edge = self.edge_of_power(en, "rung", row.op == Op::OneShotRising);
                let number = self.number();
                self.rungs.powers[step] = Power::of(number, edge);
            }
            Op::Eq | Op::Ne | Op::Gt | Op::Ge | Op::Lt | Op::Le => self.compares(row.op, block, en, step)?,

            Op::Coil | Op::RetentiveCoil | Op::NegatedCoil => {
                self.coil(block, en, step, row.op != Op::NegatedCoil)?;
            }
            Op::SetCoil | Op::RetentiveSet => self.set_coil(block, en, step)?,
            Op::ResetCoil | Op::RetentiveReset | Op::Res => self.reset_coil(block, en, step)?,
            Op::RisingCoil | Op::FallingCoil => self.edge_coil(block, en, step, row.op == Op::RisingCoil)?,

            Op::Ton | Op::Tof | Op::Tp | Op::Rto | Op::Rtof => self.timer(block, en, step)?,
            Op::Ctu | Op::Ctd | Op::Ctud | Op::Ctc => self.counter(block, en, step)?,
            Op::Sr | Op::Rs => self.bistable(row.op, block, en, step)?,

            Op::Shift => self.shift_range(block, en, step)?,
            Op::Lbl | Op::Fun | Op::Next | Op::Persist => {
                self.rungs.powers[step] = self.rungs.powers[en].clone();
            }
            Op::Jmp => return self.jump(block, en, step),
            Op::Ret | Op::End => self.leave(row.op, en, step)?,
            Op::Call => self.call(block, en, step)?,
            Op::For => self.begins_loop(block, en, step)?,
            Op::Mcr => {
                let power = self.entering(en, step);
                self.rungs.powers[step] = power.clone();
                if let Some(rail) = self.rungs.rail.clone() {
                    let term = power.or_true();
                    self.line(format!("{rail} := {};", term.text));
                }
            }
            Op::Adc | Op::Pwm | Op::Usnd | Op::Urcv | Op::Fmt => {
                return self.stop("a port, which each system has in its own way: use tags at addresses");
            }
            _ => self.data(row.op, block, en, step)?,
        }
        Ok(false)
    }

    /// What a block that acts on power alone does, and the variable that it writes. None: it does something else, or must check
    /// something first.
    pub(crate) fn plain_act(&mut self, block: &Block) -> Result<Option<(Vec<String>, String)>> {
        let BlockKind::Instruction(row) = block.kind else {
            return Ok(None);
        };
        let mut checks = Checks::new();
        let act = match row.op {
            Op::ResetCoil | Op::RetentiveReset => match by_place(block).first() {
                Some(Argument::Place(place, _)) => {
                    let target = self.place(place, &mut checks)?;
                    Some((target.assign(&Term::whole("FALSE")), target.variable))
                }
                _ => None,
            },
            op if is_data(op) => self.data_act(op, block, &mut checks)?,
            _ => None,
        };
        Ok(act.filter(|_| checks.is_empty()))
    }

    fn contact(&mut self, block: &Block, en: usize, step: usize, open: bool) -> Result<()> {
        let mut checks = Checks::new();
        let mut term = match by_place(block).first() {
            Some(Argument::Value(value)) => {
                let term = self.value(value, &mut checks)?;
                if open { term } else { term.not() }
            }
            Some(Argument::Range(range)) => {
                let all = self.elements(range, &mut checks)?;
                let terms: Vec<Term> = all
                    .into_iter()
                    .map(|term| if open { term } else { term.not() })
                    .collect();
                Term::all(&terms).unwrap_or_else(|| Term::whole("TRUE"))
            }
            _ => return self.stop("a contact on something that is no BOOL"),
        };
        if term.text == "TRUE" {
            self.rungs.powers[step] = self.rungs.powers[en].clone();
            return Ok(());
        }
        if let Power::Dead = self.rungs.powers[en] {
            return Ok(());
        }
        let number = self.number();
        if !checks.is_empty() {
            term = self.when_checked(en, checks, &term);
            self.rungs.powers[step] = Power::of(number, term);
            return Ok(());
        }
        self.rungs.powers[step] = self.rungs.powers[en].and(number, term);
        Ok(())
    }

    /// A condition that may be evaluated only with power, and if something holds: the variable that has it, and the power.
    fn when_checked(&mut self, en: usize, checks: Checks, term: &Term) -> Term {
        let power = self.entering(en, en);
        let name = self.temporary("power", Scalar::Bool);
        self.line(format!("{name} := FALSE;"));
        self.guarded(
            power.term().as_ref(),
            checks,
            &[format!("{name} := {};", term.text)],
            None,
        );
        Term::variable(&name)
    }

    fn compares(&mut self, op: Op, block: &Block, en: usize, step: usize) -> Result<()> {
        if let Power::Dead = self.rungs.powers[en] {
            return Ok(());
        }
        let mut checks = Checks::new();
        let Some(all) = values(block, 0) else {
            return self.stop("a comparison of what is no value");
        };
        let mut settled = Vec::new();
        for expr in &all {
            let term = self.settled(expr, &mut checks)?;
            settled.push((term, expr.ty));
        }
        let pairs: Vec<Term> = settled
            .windows(2)
            .map(|pair| crate::expression::compare(op, (&pair[0].0, pair[0].1), (&pair[1].0, pair[1].1)))
            .collect();
        let Some(term) = Term::all(&pairs) else {
            return self.stop("a comparison of one value");
        };
        let number = self.number();
        if checks.is_empty() {
            self.rungs.powers[step] = self.rungs.powers[en].and(number, term);
        } else {
            let term = self.when_checked(en, checks, &term);
            self.rungs.powers[step] = Power::of(number, term);
        }
        Ok(())
    }

    fn edge_contact(&mut self, block: &Block, en: usize, step: usize, rises: bool) -> Result<()> {
        let Some(all) = values(block, 0) else {
            return self.stop("an edge of what is no BOOL");
        };
        let [value] = all.as_slice() else {
            return self.stop("an edge of what is no BOOL");
        };
        let mut checks = Checks::new();
        let term = self.value(value, &mut checks)?;
        let base = match &value.kind {
            ExprKind::Read(place) => self.called(place),
            _ => "rung".into(),
        };
        let instance = self.edge_instance(&base, rises);
        let call = format!("{instance}(CLK := {});", term.text);
        let number = self.number();
        if checks.is_empty() {
            self.line(call);
            let edge = of_instance(&instance, "Q");
            self.rungs.powers[step] = self.rungs.powers[en].and(number, edge);
            return Ok(());
        }
        let name = self.temporary("power", Scalar::Bool);
        self.line(format!("{name} := FALSE;"));
        self.guarded(None, checks, &[call, format!("{name} := {instance}.Q;")], None);
        self.rungs.powers[step] = self.rungs.powers[en].and(number, Term::variable(&name));
        Ok(())
    }

    /// What a place is called, as part of a name.
    pub(crate) fn called(&self, place: &Place) -> String {
        match place.root() {
            Some(tag) => {
                let name = &self.project.source.program.tags[tag.0 as usize].name;
                crate::names::identifier(name)
            }
            None => "system".into(),
        }
    }

    fn edge_instance(&mut self, base: &str, rises: bool) -> String {
        let (word, ty) = if rises {
            ("rises", "R_TRIG")
        } else {
            self.project.used.pieces.insert("LADDER_F_TRIG");
            ("falls", "LADDER_F_TRIG")
        };
        match base {
            "rung" => self.numbered(word, ty),
            base => self.instance(&format!("{base}_{word}"), ty),
        }
    }

    /// Calls a block for an edge of power; comes back with the edge.
    pub(crate) fn edge_of_power(&mut self, en: usize, base: &str, rises: bool) -> Term {
        let power = self.entering(en, en);
        let instance = self.edge_instance(base, rises);
        let term = power.or_true();
        self.line(format!("{instance}(CLK := {});", term.text));
        of_instance(&instance, "Q")
    }

    /// A block that writes its first operand when power is high.
    fn data(&mut self, op: Op, block: &Block, en: usize, step: usize) -> Result<()> {
        if let Power::Dead = self.rungs.powers[en] {
            return Ok(());
        }
        let mut checks = Checks::new();
        let Some((lines, variable)) = self.data_act(op, block, &mut checks)? else {
            return self.stop("an instruction that Structured Text has no words for");
        };
        let power = self.entering(en, en);
        let done = self.done(step);
        self.keep(Some(&BTreeSet::from([variable])));
        self.guarded(power.term().as_ref(), checks, &lines, done.as_deref());
        self.is_done(step, done);
        Ok(())
    }

    /// The statements of such a block, and the variable that they write.
    fn data_act(
        &mut self,
        op: Op,
        block: &Block,
        checks: &mut Checks,
    ) -> Result<Option<(Vec<String>, String)>> {
        let arguments = by_place(block);
        if let Some(Argument::Parts(_)) = arguments.first() {
            return self.whole_act(op, block, checks).map(Some);
        }
        match op {
            Op::Bmov | Op::Fill => return self.range_act(op, block, checks).map(Some),
            Op::Scantime => return self.scan_time(block, checks).map(Some),
            Op::Pack | Op::Unpack | Op::Search => {
                return self.stop("an instruction that Structured Text has no words for: write what it does with other blocks");
            }
            _ => {}
        }
        let Some((to, ty)) = place(arguments.first().copied()) else {
            return self.stop("a result that is no tag");
        };
        let Some(operands) = values(block, 1) else {
            return self.stop("an operand that is no value");
        };
        let target = self.place(to, checks)?;
        let value = self.formula(op, ty, &operands, checks)?;
        let value = match ty {
            Scalar::String(length) if may_be_longer(op, length, &operands) => {
                Term::call("LEFT", &[&value, &Term::whole(length.to_string())])
            }
            _ => value,
        };
        Ok(Some((target.assign(&value), target.variable)))
    }

    fn formula(&mut self, op: Op, ty: Scalar, operands: &[&Expr], checks: &mut Checks) -> Result<Term> {
        let value = self.function(op, ty, operands, checks)?;
        // Assigning brings a whole number into its width; a real may be none.
        if ty.is_real() {
            Ok(self.settle(value, ty, checks))
        } else {
            Ok(value)
        }
    }

    fn scan_time(&mut self, block: &Block, checks: &mut Checks) -> Result<(Vec<String>, String)> {
        let arguments = by_place(block);
        let Some((to, ty)) = place(arguments.first().copied()) else {
            return self.stop("a port, which each system has in its own way");
        };
        if ty != Scalar::Dint && ty != Scalar::Lint {
            return self.stop(format!("the scan time in {ty}: use DINT"));
        }
        let target = self.place(to, checks)?;
        let time = self.service(Service::ScanTime);
        self.project.used.pieces.insert("LADDER_MILLISECONDS");
        let number = Term::call("LADDER_MILLISECONDS", &[&Term::variable(&time)]);
        let number = crate::expression::pass(number, Scalar::Lint, ty);
        Ok((target.assign(&number), target.variable))
    }

    /// A named operand that is a BOOL.
    pub(crate) fn named_bit(
        &mut self,
        block: &Block,
        name: &str,
        checks: &mut Checks,
    ) -> Result<Option<Term>> {
        match named(block, name) {
            Some(Argument::Value(value)) => self.value(value, checks).map(Some),
            Some(_) => self.stop("an operand that is no value"),
            None => Ok(None),
        }
    }
}

/// Whether a text may have more letters than there is room for.
fn may_be_longer(op: Op, room: u16, operands: &[&Expr]) -> bool {
    let length = |expr: &&Expr| match (&expr.kind, expr.ty) {
        (ExprKind::Constant(Value::Text(text)), _) => text.len(),
        (ExprKind::Pass(inner), _) => match inner.ty {
            Scalar::String(length) => usize::from(length),
            _ => 0,
        },
        (_, Scalar::String(length)) => usize::from(length),
        _ => 0,
    };
    let lengths = operands.iter().map(length);
    let most = match op {
        Op::Concat | Op::Insert | Op::Replace => lengths.sum(),
        _ => lengths.max().unwrap_or(0),
    };
    most > usize::from(room)
}

/// Whether a block writes its first operand when power is high, and nothing else.
fn is_data(op: Op) -> bool {
    ((Op::Mov..=Op::Fill).contains(&op) && op != Op::Shift) || matches!(op, Op::Lut | Op::Pwl | Op::Scantime)
}

/// The statements with the IF around them.
pub(crate) fn when_lines(power: &Power, lines: &[String]) -> Vec<String> {
    match power.term() {
        None => lines.to_vec(),
        Some(_) if matches!(power, Power::Dead) => Vec::new(),
        Some(term) => {
            let mut all = vec![format!("IF {} THEN", term.text)];
            all.extend(lines.iter().map(|line| format!("    {line}")));
            all.push("END_IF;".into());
            all
        }
    }
}

/// A member of a block that only this place has.
pub(crate) fn of_instance(instance: &str, member: &str) -> Term {
    let mut term = Term::whole(format!("{instance}.{member}"));
    term.reads.insert(instance.to_owned());
    term
}
