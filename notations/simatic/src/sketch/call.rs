//! Calls of blocks of the project.

use super::translate::{Translated, Translator};
use crate::model::{Kind, Part, Role, Type, Unit, Value, Variable};
use crate::operand::{at_pin, operand};
use crate::scope::{Scope, block_name, plain};
use ladder_format::program::{Block, Expression, Operand};
use ladder_notation::Names;

/// A call.
pub(super) struct Call<'l> {
    pub(super) callee: &'l Unit,
    /// The tag that holds the state of a function block.
    instance: Option<Expression>,
}

impl<'l> Call<'l> {
    /// What a part calls.
    ///
    /// # Errors
    ///
    /// If it is not known.
    pub(super) fn of(translator: &mut Translator<'_, 'l>, part: &Part) -> Result<Call<'l>, String> {
        let scope = &mut *translator.scope;
        let name = part.name.trim();
        let plain_name = name
            .trim_start_matches("_.")
            .trim_start_matches('#')
            .trim_matches('"');
        let library = scope.library;
        if let Some(Err(why)) = library.get(&plain_name.to_lowercase()) {
            return Err(format!("the file of `{plain_name}` cannot be read: {why}"));
        }
        let is_own = name.starts_with('#') || scope.own(plain_name).is_some();
        if !is_own && let Some(callee) = scope.unit(plain_name).filter(|unit| unit.kind == Kind::Function) {
            return Ok(Call {
                callee,
                instance: None,
            });
        }
        if !is_own && scope.unit(plain_name).is_none() {
            return Err(format!(
                "`{plain_name}` is no instruction that is known here, and no block of the project"
            ));
        }
        let instance = operand(scope, name, "")?;
        let Some(Type::Named(of)) = &instance.ty else {
            return Err(format!("`{plain_name}` holds no state of a block"));
        };
        let callee = scope.unit(of).filter(|unit| unit.kind == Kind::FunctionBlock);
        let callee = callee.ok_or_else(|| format!("the block `{of}` is in no file of the project"))?;
        Ok(Call {
            callee,
            instance: Some(instance.value),
        })
    }

    /// `[$Motor]( pump, start := a, running => b )`
    pub(super) fn translated(
        self,
        translator: &mut Translator<'_, 'l>,
        part: &Part,
    ) -> Result<Translated, String> {
        let own = Scope::of(self.callee, translator.scope.library);
        let has_instance = self.instance.is_some();
        let mut operands: Vec<Operand> = self.instance.into_iter().map(Operand::Value).collect();
        let mut note = None;
        let result = self
            .callee
            .returns
            .as_ref()
            .filter(|_| self.callee.kind == Kind::Function);
        let result = result.map(|ty| Variable {
            name: "Ret_Val".to_owned(),
            role: Role::Output,
            ty: ty.clone(),
            ..Variable::default()
        });
        for parameter in self.callee.variables.iter().chain(&result) {
            let spelled = match own.own(&parameter.name) {
                Some(known) => known.spelled.clone(),
                None => continue,
            };
            let wanted = plain(&parameter.ty).unwrap_or("INT");
            let given = at_pin(translator.scope, part.pin(&parameter.name), wanted).transpose()?;
            match (parameter.role, given) {
                (Role::Input | Role::InOut, Some(it)) => operands.push(Operand::Given(spelled, it.value)),
                (Role::Output, Some(it)) => operands.push(Operand::Taken(spelled, it.value)),
                // A block that has its own state keeps there what is open at its pin, as it does in ladder text.
                (Role::Input, None) if parameter.initial.is_none() && !has_instance => {
                    let value = zero(&parameter.ty)
                        .ok_or_else(|| format!("nothing is at its pin `{}`", parameter.name))?;
                    operands.push(Operand::Given(spelled, Expression::literal(value)?));
                    note = Some(format!(
                        "`{}` is left out: it has its first value here",
                        parameter.name
                    ));
                }
                (Role::InOut, None) => return Err(format!("nothing is at its pin `{}`", parameter.name)),
                _ => {}
            }
        }
        let unknown = part
            .arguments
            .iter()
            .filter(|given| given.value != Value::Open)
            .find(|given| {
                let pin = given.pin.as_deref().unwrap_or_default();
                own.own(pin).is_none()
            });
        if let Some(unknown) = unknown {
            let pin = unknown.pin.as_deref().unwrap_or_default();
            return Err(format!("the block has no pin `{pin}`"));
        }
        Ok(Translated {
            blocks: vec![Block::user(&block_name(&self.callee.name)[1..], operands)?],
            note,
            ..Translated::default()
        })
    }
}

/// The value that a parameter has when it is not given.
fn zero(ty: &Type) -> Option<&'static str> {
    Some(match plain(ty)? {
        "BOOL" => "FALSE",
        "REAL" | "LREAL" => "0.0",
        "TIME" => "T#0s",
        "STRING" => "''",
        "BYTE" | "WORD" | "DWORD" | "LWORD" | "SINT" | "INT" | "DINT" | "LINT" | "USINT" | "UINT"
        | "UDINT" | "ULINT" => "0",
        _ => return None,
    })
}

/// Labels of a block.
#[derive(Default)]
pub(super) struct Labels {
    names: Names,
    spelled: std::collections::HashMap<String, String>,
    /// The highest number of a label that networks in SCL have.
    pub(super) numbered: u32,
}

impl Labels {
    /// A label as it is spelled here.
    pub(super) fn spell(&mut self, name: &str) -> String {
        let name = name.trim().trim_matches('"');
        let names = &mut self.names;
        let spelled = self.spelled.entry(name.to_lowercase());
        spelled.or_insert_with(|| names.fresh(name)).clone()
    }
}
