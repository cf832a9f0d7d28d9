//! Operands of ladder text as SIMATIC writes them.

use super::power::{POWER_IN, POWER_OUT};
use super::tags::Tags;
use crate::standard::SYSTEM;
use ladder_analysis::values::compound::Compound;
use ladder_analysis::values::types::Type;
use ladder_format::program::{Expression, Path, Sign, Step};
use ladder_instructions::StateType;

/// An operand.
///
/// # Errors
///
/// Why it has no form there.
pub(super) fn operand(text: &str, tags: &Tags<'_>) -> Result<String, String> {
    value(&Expression::read(text.trim())?, tags)
}

/// A value that is not a formula.
///
/// # Errors
///
/// Why it has no form there.
pub(super) fn value(expression: &Expression, tags: &Tags<'_>) -> Result<String, String> {
    match expression {
        Expression::Literal(found) => literal(found.as_str()),
        Expression::Unary(Sign::Minus, inner) => match &**inner {
            Expression::Literal(found) => literal(&format!("-{}", found.as_str())),
            _ => Err(only_calculate(expression)),
        },
        Expression::Path(found) => path(found, tags),
        _ => Err(only_calculate(expression)),
    }
}

fn only_calculate(expression: &Expression) -> String {
    format!("`{expression}` is an expression: only Calculate takes one")
}

/// A tag with members and indices.
fn path(of: &Path, tags: &Tags<'_>) -> Result<String, String> {
    let upper = of.root.to_ascii_uppercase();
    let name = match upper.as_str() {
        "SYS" => return system(of),
        "PI" if of.steps.is_empty() => return Ok(std::f64::consts::PI.to_string()),
        "EN" => POWER_IN,
        "ENO" => POWER_OUT,
        _ => of.root.as_str(),
    };
    if upper.starts_with('%') {
        return Ok(address(&upper));
    }
    let mut ty = match tags.known(&of.root) {
        Some(Ok(ty)) => Some(*ty),
        Some(Err(why)) => return Err(why.clone()),
        None if name != of.root => return Err(format!("`{upper}` is not a variable there")),
        None => return Err(format!("`{name}` is not a tag that is declared in this program")),
    };
    let mut out = format!("#\"{name}\"");
    for step in &of.steps {
        match step {
            Step::Range(..) => {
                return Err(format!("`{of}` is a range, which only coils on bit fields take"));
            }
            Step::Index(indices) => {
                let indices: Result<Vec<String>, String> =
                    indices.iter().map(|index| value(index, tags)).collect();
                // An array of arrays is one of several dimensions there.
                let opening = if out.ends_with(']') { ", " } else { "[" };
                out.truncate(out.len() - usize::from(out.ends_with(']')));
                out.push_str(&format!("{opening}{}]", indices?.join(", ")));
            }
            Step::Bit(bit) => out.push_str(&format!(".%X{bit}")),
            Step::Member(name) => match ty {
                Some(Type::State(state)) => out.push_str(&format!(".{}", state_member(name, state)?)),
                _ => out.push_str(&format!(".\"{name}\"")),
            },
        }
        ty = ty.and_then(|ty| part(ty, step));
    }
    Ok(out)
}

/// An address: `%IX0.0` is `%I0.0` there.
pub(super) fn address(own: &str) -> String {
    let upper = own.to_ascii_uppercase();
    match upper.split_at_checked(2) {
        Some((area, rest)) => format!("{area}{}", rest.strip_prefix('X').unwrap_or(rest)),
        None => upper,
    }
}

/// A tag of `SYS`.
fn system(of: &Path) -> Result<String, String> {
    let row = match &of.steps[..] {
        [Step::Member(own)] => SYSTEM
            .iter()
            .find(|(tag, _)| tag.name().eq_ignore_ascii_case(own)),
        _ => None,
    };
    let (_, name) = row.ok_or_else(|| format!("`{of}` has no counterpart"))?;
    Ok(format!("\"{name}\""))
}

/// The type of a part.
fn part(ty: Type, step: &Step) -> Option<Type> {
    match (ty, step) {
        (Type::Array { element, .. }, Step::Index(_)) => Some(Type::Scalar(element)),
        (Type::Compound(id), step) => id.with(|compound| match (compound, step) {
            (Compound::Array(array), Step::Index(_)) => Some(array.element),
            (Compound::Structure(structure), Step::Member(name)) => {
                structure.member(name).map(|(_, member)| member.ty)
            }
            _ => None,
        }),
        _ => None,
    }
}

/// The type of the tag, or part of one, that a path leads to.
pub(super) fn type_at(of: &Path, tags: &Tags<'_>) -> Option<Type> {
    let root = *tags.known(&of.root)?.as_ref().ok()?;
    of.steps.iter().try_fold(root, part)
}

/// Whether a type is that of a timer there.
pub(super) const fn is_timer(state: StateType) -> bool {
    matches!(
        state,
        StateType::Ton | StateType::Tof | StateType::Tp | StateType::Rto
    )
}

/// A member's name. Timers and counters answer to the names of other controllers here, and not there.
fn state_member(name: &str, state: StateType) -> Result<String, String> {
    let upper = name.to_ascii_uppercase();
    let is_timer = is_timer(state);
    Ok(match upper.as_str() {
        "DN" => "Q",
        "PRE" if is_timer => "PT",
        "PRE" => "PV",
        "AC" | "ACC" if is_timer => "ET",
        "AC" | "ACC" => "CV",
        "EN" if is_timer => "IN",
        "EN" => "CU",
        "TT" | "CC" => return Err(format!("the member `{upper}` has no counterpart")),
        other => other,
    }
    .to_owned())
}

/// A literal.
///
/// # Errors
///
/// If it has no form there.
pub(super) fn literal(text: &str) -> Result<String, String> {
    if text.starts_with('\'') {
        return Ok(text.to_owned());
    }
    let upper = text.to_ascii_uppercase();
    if let Some((kind, value)) = upper.split_once('#') {
        return match kind {
            "T" | "TIME" | "LTIME" => duration(value),
            "DT" | "DATE_AND_TIME" => Ok(format!("LDT#{value}")),
            "TOD" | "TIME_OF_DAY" => Ok(format!("TOD#{value}")),
            "D" | "DATE" => Ok(format!("D#{value}")),
            _ => Ok(upper),
        };
    }
    let is_word = upper == "TRUE" || upper == "FALSE";
    if !is_word && upper.contains(['S', 'M', 'H', 'D']) {
        return duration(&upper);
    }
    Ok(if is_word { upper } else { text.to_owned() })
}

/// A duration: whole milliseconds, as many as 32 bits hold.
fn duration(text: &str) -> Result<String, String> {
    let plain = text.to_ascii_lowercase().replace('_', "");
    let (sign, mut rest) = match plain.strip_prefix('-') {
        Some(rest) => ("-", rest),
        None => ("", plain.as_str()),
    };
    let mut nanoseconds = 0f64;
    let mut is_plain = true;
    while !rest.is_empty() {
        let end = rest.find(|c: char| c.is_ascii_alphabetic()).unwrap_or(rest.len());
        let (number, after) = rest.split_at(end);
        let end = after
            .find(|c: char| !c.is_ascii_alphabetic())
            .unwrap_or(after.len());
        let (unit, after) = after.split_at(end);
        let factor = match unit {
            "d" => 86_400e9,
            "h" => 3_600e9,
            "m" => 60e9,
            "s" => 1e9,
            "ms" => 1e6,
            "us" => 1e3,
            _ => 1.0,
        };
        is_plain &= !number.contains('.') && factor >= 1e6;
        nanoseconds += number
            .parse::<f64>()
            .map_err(|_| format!("`{text}` is not a duration"))?
            * factor;
        rest = after;
    }
    let milliseconds = nanoseconds / 1e6;
    if milliseconds.fract() != 0.0 || milliseconds > f64::from(i32::MAX) {
        return Err(format!(
            "a Time has whole milliseconds, and at most 24 days: `{text}` has no form there"
        ));
    }
    if is_plain {
        return Ok(format!("T#{sign}{}", plain.trim_start_matches('-')));
    }
    Ok(format!("T#{sign}{milliseconds}ms"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn durations_are_whole_milliseconds() {
        assert_eq!(duration("1H30M"), Ok("T#1h30m".to_owned()));
        assert_eq!(duration("1.5S"), Ok("T#1500ms".to_owned()));
        assert_eq!(duration("-250MS"), Ok("T#-250ms".to_owned()));
        assert!(duration("1.5MS").is_err());
        assert!(duration("25D").is_err());
        assert_eq!(literal("5s"), Ok("T#5s".to_owned()));
        assert_eq!(literal("-7"), Ok("-7".to_owned()));
    }
}
