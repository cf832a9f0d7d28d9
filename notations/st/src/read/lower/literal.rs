//! Literals of Structured Text as those of ladder text.

use super::super::scope::{Scope, Type, elementary};
use super::super::tree::LiteralKind;
use super::Lowered;
use super::value::Value;
use ladder_analysis::values::types::{DEFAULT_STRING, Scalar};
use ladder_format::program::{Literal, Path};

/// The value of a literal.
pub(super) fn literal(kind: LiteralKind, text: &str, scope: &Scope) -> Lowered<Value> {
    match kind {
        LiteralKind::Integer => {
            let number = number_of(text).ok_or_else(|| format!("`{text}` is not a number that is read"))?;
            Ok(Value::number(number, Literal::read(text)?))
        }
        LiteralKind::Real => {
            let mut value = Value::of(Literal::read(text)?, Type::Scalar(Scalar::Lreal));
            value.is_free = true;
            Ok(value)
        }
        LiteralKind::Text => {
            let text = string(text)?;
            Ok(Value::of(
                Literal::read(text)?,
                Type::Scalar(Scalar::String(DEFAULT_STRING)),
            ))
        }
        LiteralKind::Typed => typed(text, scope),
    }
}

/// The number that digits are: `1_000`, `16#FF`
pub(super) fn number_of(text: &str) -> Option<i128> {
    let digits: String = text.chars().filter(|c| *c != '_').collect();
    let (sign, digits) = match digits.strip_prefix('-') {
        Some(rest) => (-1, rest.to_owned()),
        None => (1, digits),
    };
    let number = match digits.split_once('#') {
        Some((base, digits)) => {
            let base = base.parse().ok().filter(|base| (2..=16).contains(base))?;
            i128::from_str_radix(digits, base).ok()?
        }
        None => digits.parse().ok()?,
    };
    Some(sign * number)
}

/// A string with single quotes.
fn string(text: &str) -> Lowered<String> {
    let Some(inside) = text.strip_prefix('"') else {
        return Ok(text.to_owned());
    };
    let inside = inside.strip_suffix('"').unwrap_or(inside);
    if inside.contains('$') || !inside.is_ascii() {
        return Err("texts of wide characters are not read".to_owned());
    }
    Ok(format!("'{}'", inside.replace('\'', "$'")))
}

fn typed(text: &str, scope: &Scope) -> Lowered<Value> {
    let (prefix, rest) = text.split_once('#').unwrap_or((text, ""));
    if let Some(Type::Enumeration(all)) = scope.type_named(prefix) {
        let value = all.values.iter().find(|value| value.eq_ignore_ascii_case(rest));
        let value = value.ok_or_else(|| format!("`{prefix}` has no value `{rest}`"))?;
        let path = Path::tag(all.name.clone()).member(value.clone());
        return Ok(Value::of(path, Type::Enumeration(all)));
    }
    let upper = prefix.to_ascii_uppercase();
    let ty = match upper.as_str() {
        "T" | "LT" => Scalar::Time,
        "D" | "LD" => Scalar::Date,
        _ => elementary(prefix).ok_or_else(|| format!("`{prefix}` is not a type that is known here"))?,
    };
    if let Some(number) = number_of(rest).filter(|_| ty.is_integer() || ty.is_bits() || ty == Scalar::Bool) {
        if ty == Scalar::Bool {
            return Ok(Value::of(Literal::from(number != 0), Type::BOOL));
        }
        // A literal holds one `#`.
        let text = if rest.contains('#') {
            rest.to_owned()
        } else {
            format!("{upper}#{rest}")
        };
        let mut value = Value::of(Literal::read(text)?, Type::Scalar(ty));
        value.range = (number, number);
        value.hull = value.range;
        return Ok(value);
    }
    if ty == Scalar::Bool {
        return Ok(Value::of(
            Literal::from(rest.eq_ignore_ascii_case("TRUE")),
            Type::BOOL,
        ));
    }
    let prefix = match ty {
        Scalar::Time => "T",
        Scalar::Date => "D",
        Scalar::Tod => "TOD",
        Scalar::Dt => "DT",
        _ => upper.as_str(),
    };
    let rest = rest.strip_prefix('+').unwrap_or(rest);
    let literal = Literal::read(format!("{prefix}#{rest}"))?;
    Ok(Value::of(literal, Type::Scalar(ty)))
}
