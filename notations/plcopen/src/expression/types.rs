//! Types as ladder text has them, with the bounds in them.

use super::{Meaning, operand};
use crate::model::{Type, UnitKind};
use crate::scope::{Scope, Shared, trigger};
use crate::standard::{self, StandardBlock};
use ladder_format::program::{Expression, Literal};
use ladder_notation::folded;

/// A type as it is written here.
///
/// # Errors
///
/// Why it has no counterpart.
pub(crate) fn type_text(shared: &Shared<'_>, ty: &Type) -> Result<String, String> {
    type_text_in(shared, ty, 0)
}

/// Types are made of others no deeper.
const DEEPEST: usize = 16;

fn type_text_in(shared: &Shared<'_>, ty: &Type, depth: usize) -> Result<String, String> {
    Ok(match ty {
        Type::Named(name) => {
            let key = name.to_lowercase();
            if let Some((spelled, declared)) = shared.types.get(&key) {
                let known = shared.not_declared.borrow().get(&key).cloned();
                let why = match known {
                    Some(why) => why,
                    None => match is_declared(shared, declared, depth) {
                        Ok(()) => return Ok(spelled.clone()),
                        Err(why) => why,
                    },
                };
                let told = Err(format!("the type `{name}` is not declared: {why}"));
                shared.not_declared.borrow_mut().insert(key, why);
                return told;
            }
            if let Some(block) = shared.block_of(ty) {
                return match block.unit.kind {
                    UnitKind::FunctionBlock => Ok(block.name.clone()),
                    _ => Err(format!("`{name}` is a function, and no type")),
                };
            }
            match standard::block(name) {
                Some(StandardBlock::Stateful(mnemonic, ..)) => return Ok(mnemonic.to_owned()),
                Some(_) => return Ok("BOOL".to_owned()),
                None => {}
            }
            let known = standard::elementary(name).map(str::to_owned);
            known.ok_or_else(|| format!("the project has no type `{name}`, and neither has ladder text"))?
        }
        Type::Text(None) => "STRING".to_owned(),
        Type::Text(Some(length)) => format!("STRING[{length}]"),
        Type::Array(bounds, of) => {
            if trigger(of).is_some() {
                return Err("edge detectors have no state of their own here".to_owned());
            }
            if bounds.is_empty() || bounds.len() > 3 {
                return Err("an array has one to three dimensions here".to_owned());
            }
            let bounds: Result<Vec<String>, String> = bounds
                .iter()
                .map(|(low, high)| Ok(format!("{}..{}", bound(shared, low)?, bound(shared, high)?)))
                .collect();
            format!(
                "ARRAY[{}] OF {}",
                bounds?.join(", "),
                type_text_in(shared, of, depth + 1)?
            )
        }
        Type::Range(base, low, high) => {
            let base = type_text_in(shared, &Type::Named(base.clone()), depth + 1)?;
            format!("{base}({}..{})", bound(shared, low)?, bound(shared, high)?)
        }
        Type::Enumeration(_) | Type::Structure(_) => {
            return Err("such a type is declared with a name here".to_owned());
        }
        Type::Other(what) => return Err(format!("{what} has no counterpart")),
    })
}

/// Whether a type of the project is declared here: of a structure one of its members is enough, and the others are not there.
pub(crate) fn is_declared(shared: &Shared<'_>, declared: &Type, depth: usize) -> Result<(), String> {
    if depth >= DEEPEST {
        return Ok(());
    }
    match declared {
        Type::Structure(members) => {
            let mut why = "it has no members".to_owned();
            for member in members {
                match type_text_in(shared, &member.ty, depth + 1) {
                    Ok(_) => return Ok(()),
                    Err(because) => why = because,
                }
            }
            Err(why)
        }
        Type::Enumeration(values) if values.is_empty() => Err("it has no values".to_owned()),
        Type::Enumeration(values) => {
            let mut numbers = values.iter().filter_map(|(_, number)| number.as_ref());
            numbers.try_for_each(|number| bound(shared, number).map(drop))
        }
        other => type_text_in(shared, other, depth + 1).map(drop),
    }
}

/// A bound of an array or a range, as it is written here.
///
/// # Errors
///
/// It is neither a number nor the name of a constant.
pub(crate) fn bound(shared: &Shared<'_>, text: &str) -> Result<String, String> {
    let scope = Scope::default();
    let meaning = Meaning {
        shared,
        scope: &scope,
    };
    let bound = operand(text, meaning).map_err(|why| format!("of the bound `{text}`: {why}"))?;
    if let Some(number) = computed(shared, &bound.value) {
        return Ok(number.as_str().to_owned());
    }
    // A number or the name of a constant; no address, no text.
    let bound = bound.value.to_string();
    let is_known = |c: char| c.is_alphanumeric() || matches!(c, '_' | '-' | '+' | '#');
    if bound.chars().all(is_known) {
        Ok(bound)
    } else {
        Err(format!("the bound `{text}` is no number"))
    }
}

/// The number that an expression of numbers and constants of the project is, where it is more than one of them.
pub(crate) fn computed(shared: &Shared<'_>, expression: &Expression) -> Option<Literal> {
    if matches!(expression, Expression::Literal(_) | Expression::Path(_)) {
        return None;
    }
    let scope = Scope::default();
    folded(expression, &|path| {
        let text = shared.constants.get(&path.whole()?.to_lowercase())?;
        let value = operand(
            text,
            Meaning {
                shared,
                scope: &scope,
            },
        );
        value.ok().map(|value| value.value)
    })
}
