//! Initial values.

use crate::expression::{Meaning, computed, operand, type_text};
use crate::model::{Initial, Type};
use crate::scope::{Scope, Shared, member};
use crate::standard;
use ladder_format::program::{Expression, Literal};

/// What an input has that nothing is wired to.
pub(super) fn zero(shared: &Shared<'_>, ty: &Type) -> Option<Literal> {
    let text = type_text(shared, shared.real(ty)).ok()?;
    let zero = match text.as_str() {
        "BOOL" => "FALSE",
        "REAL" | "LREAL" => "0.0",
        "TIME" => "T#0s",
        "DATE" | "TOD" | "DT" => return None,
        _ if text.starts_with("STRING") => "''",
        _ if standard::elementary(&text).is_some() => "0",
        _ => return None,
    };
    Literal::read(zero).ok()
}

/// An initial value as it is written here.
///
/// # Errors
///
/// Why it has no counterpart.
pub(super) fn initial_text(shared: &Shared<'_>, ty: &Type, initial: &Initial) -> Result<String, String> {
    match initial {
        Initial::Simple(text) => simple(shared, ty, text),
        Initial::Array(values) => {
            let Type::Array(_, of) = shared.real(ty) else {
                return Err("only an array begins with several values".to_owned());
            };
            let values: Result<Vec<String>, String> = values
                .iter()
                .map(|(times, value)| {
                    let value = initial_text(shared, of, value)?;
                    Ok(if *times == 1 {
                        value
                    } else {
                        format!("{times}({value})")
                    })
                })
                .collect();
            Ok(format!("[{}]", values?.join(", ")))
        }
        Initial::Structure(values) => {
            let members = shared.members(ty).ok_or("only a structure begins with members")?;
            let values: Result<Vec<String>, String> = values
                .iter()
                .map(|(name, value)| {
                    let found = members.iter().find(|one| one.name.eq_ignore_ascii_case(name));
                    let found = found.ok_or_else(|| format!("its type has no member `{name}`"))?;
                    Ok(format!(
                        "{} := {}",
                        member(&found.name),
                        initial_text(shared, &found.ty, value)?
                    ))
                })
                .collect();
            Ok(format!("({})", values?.join(", ")))
        }
    }
}

fn simple(shared: &Shared<'_>, ty: &Type, text: &str) -> Result<String, String> {
    let real = shared.real(ty);
    let name = match real {
        Type::Named(name) => standard::elementary(name),
        Type::Text(_) => Some("STRING"),
        _ => None,
    };
    match (name, text) {
        (Some("BOOL"), "0") => return Ok("FALSE".to_owned()),
        (Some("BOOL"), "1") => return Ok("TRUE".to_owned()),
        (Some("STRING"), text) if !text.starts_with(['\'', '"']) => {
            return Ok(Literal::text(text).as_str().to_owned());
        }
        _ => {}
    }
    let value = operand(
        text,
        Meaning {
            shared,
            scope: &Scope::default(),
        },
    )?;
    let value = match &value.value {
        Expression::Literal(_) | Expression::Path(_) => value.value.to_string(),
        other => {
            let number = computed(shared, other).ok_or("it is not a value")?;
            number.as_str().to_owned()
        }
    };
    let is_real = |name: &str| matches!(name, "REAL" | "LREAL");
    if value.contains('.')
        && name.is_some_and(|name| name != "STRING" && !is_real(name))
        && Literal::read(&*value).is_ok_and(|it| it.as_str().parse::<f64>().is_ok())
    {
        return Err("it is not a value".to_owned());
    }
    let is_whole = value.bytes().all(|c| c.is_ascii_digit() || c == b'-');
    Ok(match name {
        Some("REAL" | "LREAL") if is_whole => value + ".0",
        _ => value,
    })
}
