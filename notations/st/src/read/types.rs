//! Types as they are here.

use super::declared::TypeText;
use super::initial::initial_text;
use super::lower;
use super::scope::{Enumeration, Scope, Structure, Type};
use super::tree::{Expression, ExpressionKind};
use ladder_analysis::values::types::Scalar;
use ladder_notation::Names;
use std::rc::Rc;

/// The type that a text means.
///
/// # Errors
///
/// Why there is none.
pub(super) fn of(text: &TypeText, scope: &Scope) -> Result<Type, String> {
    match text {
        TypeText::Named(name) => scope
            .type_named(name)
            .ok_or_else(|| format!("the type `{name}` is not known here")),
        TypeText::Text(None) => Ok(Type::Scalar(Scalar::String(
            ladder_analysis::values::types::DEFAULT_STRING,
        ))),
        TypeText::Text(Some(length)) => {
            let length = bound(length, scope)?
                .parse::<u16>()
                .ok()
                .filter(|length| (1..=254).contains(length));
            let length = length.ok_or("a text has at most 254 characters here")?;
            Ok(Type::Scalar(Scalar::String(length)))
        }
        TypeText::Array(bounds, inner) => {
            let inner = of(inner, scope)?;
            let mut all = Vec::new();
            for (first, last) in bounds {
                all.push((bound(first, scope)?, bound(last, scope)?));
            }
            if let Type::Array(more, inner) = inner {
                all.extend(more);
                return array(all, *inner);
            }
            array(all, inner)
        }
        TypeText::Range(name, _) => of(&TypeText::Named(name.clone()), scope),
        TypeText::Structure(_) | TypeText::Enumeration(_) => {
            Err("such a type has a name of its own here: declare it in TYPE".to_owned())
        }
        TypeText::Other(what) => Err(format!(
            "{what} works on memory by address, which ladder text does not have"
        )),
    }
}

fn array(bounds: Vec<(String, String)>, inner: Type) -> Result<Type, String> {
    if bounds.len() > 3 {
        return Err("an array has at most three dimensions here".to_owned());
    }
    Ok(Type::Array(bounds, Box::new(inner)))
}

/// A bound or a length: a number, or the name of a constant.
pub(super) fn bound(expression: &Expression, scope: &Scope) -> Result<String, String> {
    match &expression.kind {
        ExpressionKind::Literal(_, text) => {
            Ok(lower::plain_number(text).map_or_else(|| text.clone(), |number| number.to_string()))
        }
        ExpressionKind::Place(place) if place.steps.is_empty() => {
            let known = scope.known(&place.root).map(|known| known.path.to_string());
            known.ok_or_else(|| format!("`{}` is not declared here", place.root))
        }
        ExpressionKind::Group(inner) => bound(inner, scope),
        _ => Err("a bound that is computed is not read".to_owned()),
    }
}

/// The text of a type, with the range that the other system gives it.
pub(super) fn type_text(text: &TypeText, ty: &Type, scope: &Scope) -> Result<String, String> {
    let own = ty.text().ok_or("its type is not known here")?;
    match text {
        TypeText::Range(_, bounds) => {
            let (first, last) = (bound(&bounds.0, scope)?, bound(&bounds.1, scope)?);
            Ok(format!("{own}({first}..{last})"))
        }
        _ => Ok(own),
    }
}

/// A type that is declared under a name: what it is, and its text.
pub(super) fn declared(name: &str, text: &TypeText, scope: &Scope) -> Result<(Type, String), String> {
    match text {
        TypeText::Enumeration(values) => {
            let mut names = Names::default();
            let mut shown = Vec::new();
            let mut spelled = Vec::new();
            for (value, number) in values {
                let value = names.spell(value).to_owned();
                shown.push(match number {
                    Some(number) => format!("{value} := {}", bound(number, scope)?),
                    None => value.clone(),
                });
                spelled.push(value);
            }
            let ty = Type::Enumeration(Rc::new(Enumeration {
                name: name.to_owned(),
                values: spelled,
            }));
            Ok((ty, format!("({})", shown.join(", "))))
        }
        TypeText::Structure(members) => {
            let mut names = Names::default();
            let mut all = Vec::new();
            let mut shown = String::from("STRUCT\n");
            for member in members {
                let ty = of(&member.ty, scope).map_err(|why| format!("member `{}`: {why}", member.name))?;
                let spelled = names.spell(&member.name).to_owned();
                let initial = member
                    .initial
                    .as_ref()
                    .map(|initial| initial_text(initial, &ty, scope))
                    .transpose()?;
                let text = type_text(&member.ty, &ty, scope)?;
                shown.push_str(&format!("{spelled} : {text}"));
                if let Some(initial) = initial {
                    shown.push_str(&format!(" := {initial}"));
                }
                shown.push(';');
                if let Some(comment) = &member.comment {
                    shown.push_str(&format!("  # {} #", lower::comment_of(comment).replace('#', "")));
                }
                shown.push('\n');
                all.push((member.name.clone(), spelled, ty));
            }
            let ty = Type::Structure(Rc::new(Structure {
                name: name.to_owned(),
                members: all,
            }));
            Ok((ty, shown + "END_STRUCT"))
        }
        other => {
            let ty = of(other, scope)?;
            let text = type_text(other, &ty, scope)?;
            Ok((ty, text))
        }
    }
}
