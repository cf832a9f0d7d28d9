//! Add-On Instructions: each is a block, its instances are tags.

use super::{Result, Translator};
use crate::blocks::Blocks;
use crate::mnemonic::Role;
use crate::model::Project;
use crate::operand::Expr;
use crate::scope::{Kind, Place};
use crate::types::{Elem, Ty};
use ladder_format::Circuit;
use ladder_format::program::{Element, Expression, Operand};
use ladder_instructions::Op;
use ladder_notation::{BlockNames, block_name};

/// The name of the block that each Add-On Instruction becomes, with its `$`.
pub(super) fn names(project: &Project) -> Vec<String> {
    let mut taken = BlockNames::default();
    let mut name = |original: &str| {
        let near = block_name(original, "A");
        let suffix = if Blocks::has(&near) { "AOI" } else { "" };
        format!("${}", taken.free(&(near + suffix), "A"))
    };
    project.aois.iter().map(|aoi| name(&aoi.name)).collect()
}

impl Translator<'_> {
    /// The Add-On Instruction with this name.
    pub(crate) fn aoi(&self, name: &str) -> Option<usize> {
        let mut all = self.project.aois.iter();
        all.position(|aoi| aoi.name.eq_ignore_ascii_case(name))
    }

    /// `Motor( m1, start, stop )`
    pub(super) fn aoi_call(&mut self, aoi: usize, operands: &[&str]) -> Result<Circuit<Element>> {
        let project = self.project;
        let definition = &project.aois[aoi];
        let (instance, rest) = operands.split_first().ok_or("the instance is missing")?;
        let Expr::Path(path) = self.expr(instance)? else {
            return Err(format!("`{instance}` is no tag"));
        };
        let own = self.tags.place(self.scope, &path, Role::Word)?;
        let aoi = match own.ty {
            Ty::Aoi(own) if own == aoi || project.aois[own].sized_from == Some(aoi) => own,
            _ => return Err(format!("`{instance}` is no {}", definition.name)),
        };
        let definition = &project.aois[aoi];
        let scope = 1 + project.programs.len() + aoi;
        let mut rest = rest.iter();
        // In the order of the sections that declare them.
        let mut handed: Vec<(u8, Operand)> = vec![(0, Operand::from(&own.path))];
        let mut before = Vec::new();
        for parameter in &definition.parameters {
            let Some(symbol) = self.tags.parameter_symbol(scope, &parameter.name) else {
                if parameter.is_given() {
                    rest.next();
                }
                continue;
            };
            let (name, ty, kind) = {
                let symbol = &self.tags.symbols[symbol];
                (symbol.name.clone(), symbol.ty.clone(), symbol.kind)
            };
            // Such an input is a member of the instance, which the program and the instruction write.
            if !parameter.is_given() {
                continue;
            }
            let Some(text) = rest.next() else {
                return Err(format!("the operand for {} is missing", parameter.name));
            };
            match (kind, &ty) {
                (Kind::Input, Ty::Elem(elem)) => {
                    let value = self.input(text, *elem, &mut before)?;
                    handed.push((1, Operand::Given(name, value)));
                }
                (Kind::Output, Ty::Elem(elem)) => {
                    let is_bit = *elem == Elem::Bool;
                    let place = self.target(text, if is_bit { Role::Bit } else { Role::Value })?;
                    if place.ty != ty {
                        return Err(format!("`{text}` has another type than {}", parameter.name));
                    }
                    handed.push((3, Operand::Taken(name, place.path.into())));
                }
                _ => {
                    let place = self.in_out(text, &ty)?;
                    if place.ty != ty {
                        return Err(format!("`{text}` has another type than {}", parameter.name));
                    }
                    handed.push((2, Operand::Given(name, place.path.into())));
                }
            }
        }
        if rest.next().is_some() {
            return Err(format!("{} does not have so many operands", definition.name));
        }
        handed.sort_by_key(|(section, _)| *section);
        let handed = handed.into_iter().map(|(_, operand)| operand);
        before.push(self.user(self.aoi_names[aoi].trim_start_matches('$'), handed)?);
        Ok(Circuit::Series(before))
    }

    /// What is handed over for an in-out. The first element of an array means the whole.
    fn in_out(&mut self, text: &str, ty: &Ty) -> Result<Place> {
        if let (Ty::Array(..), Some(whole)) = (ty, text.strip_suffix("[0]")) {
            return self.target(whole, Role::Array);
        }
        self.target(text, Role::Array)
    }

    /// The value of an input; one of another type is brought to it before.
    fn input(&mut self, text: &str, elem: Elem, before: &mut Vec<Circuit<Element>>) -> Result<Expression> {
        let expr = self.expr(text)?;
        if let (Elem::Bool, Expr::Path(path)) = (elem, &expr) {
            if let Some(is_on) = self.is_computed_bit_on(text)? {
                let helper = self.helper("bit", Elem::Bool, text);
                before.push(self.put(Op::Calc, &helper, is_on)?);
                return Ok(helper.into());
            }
            return Ok(self.tags.place(self.scope, path, Role::Bit)?.path.into());
        }
        let (value, own) = self.value(&expr, elem)?;
        if own.is_none_or(|own| own == elem || own.widens_to(elem)) {
            return Ok(value);
        }
        let helper = self.helper("input", elem, text);
        before.push(self.put(Op::Typ, &helper, value)?);
        Ok(helper.into())
    }
}
