//! Initial values.

use super::declared::Initial;
use super::lower;
use super::scope::{Scope, Type};
use super::tree::{ExpressionKind, Step};

/// An initial value as it is written here.
///
/// # Errors
///
/// Why it cannot be.
pub(super) fn initial_text(initial: &Initial, ty: &Type, scope: &Scope) -> Result<String, String> {
    match (initial, ty) {
        (Initial::Value(value), Type::Enumeration(all)) => {
            let ExpressionKind::Place(place) = &value.kind else {
                return match &value.kind {
                    ExpressionKind::Literal(_, text) => {
                        Ok(text.split('#').next_back().unwrap_or(text).to_owned())
                    }
                    _ => Err("its initial value is not one of its names".to_owned()),
                };
            };
            let name = match &place.steps[..] {
                [Step::Member(name)] => name,
                _ => &place.root,
            };
            let own = all.values.iter().find(|own| own.eq_ignore_ascii_case(name));
            own.cloned()
                .ok_or_else(|| "its initial value is not one of its names".to_owned())
        }
        (Initial::Value(value), ty) => {
            let scalar = ty.scalar().ok_or("an initial value is of another type")?;
            lower::constant(value, scalar, scope)
        }
        (Initial::List(all), Type::Array(_, inner)) => {
            let mut shown = Vec::new();
            for (count, one) in all {
                let one = one
                    .as_ref()
                    .map(|one| initial_text(one, inner, scope))
                    .transpose()?
                    .unwrap_or_default();
                shown.push(if *count == 1 {
                    one
                } else {
                    format!("{count}({one})")
                });
            }
            Ok(format!("[{}]", shown.join(", ")))
        }
        (Initial::Members(all), Type::Structure(_)) => {
            let mut shown = Vec::new();
            for (name, one) in all {
                let (spelled, of) = ty
                    .member(name)
                    .ok_or_else(|| format!("there is no member `{name}`"))?;
                shown.push(format!("{spelled} := {}", initial_text(one, &of, scope)?));
            }
            Ok(format!("({})", shown.join(", ")))
        }
        _ => Err("an initial value is of another type".to_owned()),
    }
}
