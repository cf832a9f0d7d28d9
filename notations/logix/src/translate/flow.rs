//! Jumps, subroutines and their parameters.

use super::{Result, Translator};
use crate::calls::called;
use crate::mnemonic::{Op, Role, instruction};
use crate::model::Language;
use crate::operand::Expr;
use crate::scope::{Place, Tags};
use crate::types::{Elem, Ty};
use crate::unit::{Unit, operand};
use ladder_format::Circuit;
use ladder_format::program::{Block, Element, Path};
use ladder_instructions::Op as Own;
use std::collections::HashMap;

/// What is known of the routines that others call.
#[derive(Debug, Default)]
pub(crate) struct Routines {
    known: HashMap<(usize, String), Subroutine>,
}

/// A routine of ladder logic.
#[derive(Debug, Default)]
struct Subroutine {
    function: String,
    /// What takes its inputs.
    inputs: Vec<String>,
    /// The tags that hold what it returns.
    returned: Vec<(Path, Elem)>,
    /// The bit with which it ends the loop that calls it.
    leaves: Option<Path>,
    /// It is in another language: what it returns is not known.
    is_foreign: bool,
}

impl Routines {
    /// The parameters of each routine of a program. `functions` are their names.
    pub(crate) fn of(
        units: &[Unit<'_>],
        functions: &[String],
        tags: &mut Tags,
        family: crate::model::Family,
    ) -> Routines {
        let mut routines = Routines::default();
        for (unit, function) in units.iter().zip(functions) {
            let mut subroutine = Subroutine {
                function: function.clone(),
                is_foreign: unit
                    .routine
                    .foreign
                    .as_ref()
                    .is_some_and(|own| own.language != Language::StructuredText),
                ..Subroutine::default()
            };
            let mut returned: Vec<String> = Vec::new();
            let mut breaks = false;
            for (name, operands) in called(unit) {
                match instruction(&name, operands.len()) {
                    Some(Op::Sbr) => subroutine.inputs = operands,
                    Some(Op::Brk) => breaks = true,
                    Some(Op::Ret) if operands.len() > returned.len() => returned = operands,
                    _ => {}
                }
            }
            for (number, text) in returned.iter().enumerate() {
                let elem = match operand(family, text) {
                    Ok(Expr::Path(path)) => {
                        let place = tags.place(unit.scope, &path, Role::Value);
                        place.ok().and_then(|place| place.elem()).unwrap_or(Elem::Dint)
                    }
                    Ok(Expr::Real(_)) => Elem::Real,
                    _ => Elem::Dint,
                };
                let like = format!("{function}_RET{}", number + 1);
                let helper = tags.helper(
                    unit.scope,
                    &like,
                    elem,
                    &format!("helper: what {function} returns"),
                );
                subroutine.returned.push((helper, elem));
            }
            if breaks {
                let what = format!("helper: {function} ends the loop that calls it");
                let helper = tags.helper(unit.scope, &format!("{function}_BRK"), Elem::Bool, &what);
                subroutine.leaves = Some(helper);
            }
            let key = (unit.scope, unit.routine.name.to_ascii_uppercase());
            routines.known.entry(key).or_insert(subroutine);
        }
        routines
    }

    fn named(&self, scope: usize, routine: &str) -> Option<&Subroutine> {
        self.known.get(&(scope, routine.to_ascii_uppercase()))
    }
}

impl Translator<'_> {
    /// The tags in which a routine leaves something for what calls it.
    pub(crate) fn left_by(&self, scope: usize, routine: &str) -> Vec<String> {
        let known = self.routines.named(scope, routine);
        known.map_or_else(Vec::new, |known| {
            let returned = known.returned.iter().map(|(helper, _)| helper);
            returned.chain(&known.leaves).map(ToString::to_string).collect()
        })
    }

    /// `JMP` and `LBL`
    pub(super) fn label(&mut self, own: Own, name: &str) -> Result<Circuit<Element>> {
        // Of a label that is not there the rules tell.
        let label = self
            .labels
            .get(&name.to_ascii_uppercase())
            .map_or(name, String::as_str);
        let drawn = self.op(own, [Path::tag(label)]);
        drawn.map_err(|_| format!("there is no label `{name}` in the routine"))
    }

    /// `JSR( routine, count, inputs .., results .. )`: values are copied into what its `SBR` names, and back.
    pub(super) fn call(&mut self, operands: &[&str]) -> Result<Circuit<Element>> {
        let (routine, rest) = operands
            .split_first()
            .ok_or("the name of the routine is missing")?;
        let routine = routine.trim_start_matches("U:");
        let Some(subroutine) = self.routines.named(self.scope, routine) else {
            return Err(format!("there is no routine `{routine}` in the program"));
        };
        let (function, targets) = (subroutine.function.clone(), subroutine.inputs.clone());
        let (returned, is_foreign) = (subroutine.returned.clone(), subroutine.is_foreign);
        let (inputs, results) = match rest.split_first() {
            Some((count, rest)) => match count.parse::<usize>() {
                Ok(count) => rest.split_at_checked(count).ok_or("operands are missing")?,
                Err(_) => (&operands[1..], &[][..]),
            },
            None => (rest, rest),
        };
        if is_foreign && !results.is_empty() {
            return Err(format!("what the routine `{routine}` returns is not read"));
        }
        let mut circuit = Vec::new();
        for (input, target) in inputs.iter().zip(&targets) {
            let from = self.expr(input)?;
            let to = self.target(target, Role::Value)?;
            circuit.push(self.handed(&from, &to)?);
        }
        if inputs.len() > targets.len() {
            self.note("the routine takes fewer values than it is given");
        } else if inputs.len() < targets.len() {
            self.note("the routine takes more values than it is given: a controller would stop");
        }
        circuit.push(self.block(Block::call(&function)));
        for (result, (helper, elem)) in results.iter().zip(&returned) {
            let to = self.target(result, Role::Value)?;
            let own = if to.ty == Ty::Elem(*elem) {
                Own::Mov
            } else {
                Own::Typ
            };
            circuit.push(self.put(own, &to.path, helper)?);
        }
        Ok(Circuit::Series(circuit))
    }

    /// The function that a routine is, and the bit with which it ends the loop that calls it.
    pub(super) fn called(&self, routine: &str) -> Result<(String, Option<Path>)> {
        match self.routines.named(self.scope, routine) {
            Some(found) => Ok((found.function.clone(), found.leaves.clone())),
            None => Err(format!("there is no routine `{routine}` in the program")),
        }
    }

    /// A value that becomes a parameter.
    fn handed(&mut self, from: &Expr, to: &Place) -> Result<Circuit<Element>> {
        if to.elem() == Some(Elem::Bool) {
            let (from, _) = self.value(from, Elem::Bool)?;
            return self.put(Own::Mov, &to.path, from);
        }
        self.moved(from, to)
    }

    /// `RET( values .. )`
    pub(super) fn ret(&mut self, operands: &[&str]) -> Result<Circuit<Element>> {
        let mut circuit = Vec::new();
        let known = self.routines.named(self.scope, &self.routine);
        let of_this = known.map_or_else(Vec::new, |known| known.returned.clone());
        for (text, (helper, elem)) in operands.iter().zip(of_this) {
            let from = self.expr(text)?;
            let to = Place::of(helper, Ty::Elem(elem));
            circuit.push(self.handed(&from, &to)?);
        }
        circuit.push(self.block(Block::ret()));
        Ok(Circuit::Series(circuit))
    }
}
