//! Operands of ladder text as source documents write them.

use super::power::{POWER_IN, POWER_OUT};
use crate::standard::SYSTEM;
use std::collections::HashMap;

/// What the names of a body are: the types of its tags as they are declared, by their names in small letters. What has no
/// form there says why.
pub(super) type Tags = HashMap<String, Result<String, String>>;

/// An operand.
///
/// # Errors
///
/// Why it has no form there.
pub(super) fn operand(text: &str, tags: &Tags) -> Result<String, String> {
    let text = text.trim();
    if let Some(literal) = literal(text)? {
        return Ok(literal);
    }
    let upper = text.to_ascii_uppercase();
    if let Some(own) = upper.strip_prefix("SYS.") {
        let row = SYSTEM.iter().find(|(tag, _)| tag.name() == own);
        let (_, name) = row.ok_or_else(|| format!("`{text}` has no counterpart"))?;
        return Ok(format!("\"{name}\""));
    }
    if let Some(address) = upper.strip_prefix('%') {
        let (area, rest) = address.split_at(1);
        return Ok(format!("%{area}{}", rest.strip_prefix('X').unwrap_or(rest)));
    }
    path(text, tags)
}

/// A tag with members and indices.
fn path(text: &str, tags: &Tags) -> Result<String, String> {
    let end = text.find(['.', '[', ' ']).unwrap_or(text.len());
    let (root, mut rest) = text.split_at(end);
    let is_name = !root.is_empty() && root.chars().all(|c| c.is_alphanumeric() || c == '_');
    if !is_name {
        return Err(format!("`{text}` is an expression: only Calculate takes one"));
    }
    let upper = root.to_ascii_uppercase();
    let name = match upper.as_str() {
        "EN" => POWER_IN,
        "ENO" => POWER_OUT,
        _ => root,
    };
    let ty = match tags.get(&root.to_lowercase()) {
        Some(Ok(ty)) => ty.as_str(),
        Some(Err(why)) => return Err(why.clone()),
        None if name != root => return Err(format!("`{upper}` is no variable there")),
        None => return Err(format!("`{root}` is no tag that is declared in this program")),
    };
    let mut out = format!("#\"{name}\"");
    let mut is_first = true;
    while !rest.is_empty() {
        rest = rest.trim_start();
        if let Some(after) = rest.strip_prefix('[') {
            let close = closing(after).ok_or_else(|| format!("`{text}` is no tag"))?;
            let indices: Result<Vec<String>, String> = after[..close]
                .split(',')
                .map(|index| {
                    if index.contains("..") {
                        return Err(format!(
                            "`{text}` is a range, which only coils on bit fields take"
                        ));
                    }
                    operand(index, tags)
                })
                .collect();
            // An array of arrays is one of several dimensions there.
            let opening = if out.ends_with(']') { ", " } else { "[" };
            out.truncate(out.len() - usize::from(out.ends_with(']')));
            out.push_str(&format!("{opening}{}]", indices?.join(", ")));
            rest = &after[close + 1..];
        } else if let Some(after) = rest.strip_prefix('.') {
            let end = after.find(['.', '[']).unwrap_or(after.len());
            let name = after[..end].trim();
            if name.bytes().all(|c| c.is_ascii_digit()) {
                out.push_str(&format!(".%X{name}"));
            } else {
                out.push_str(&format!(".{}", member(name, ty, is_first)?));
            }
            rest = &after[end..];
        } else {
            return Err(format!("`{text}` is an expression: only Calculate takes one"));
        }
        is_first = false;
    }
    Ok(out)
}

/// Where a bracket closes.
pub(super) fn closing(text: &str) -> Option<usize> {
    let mut depth = 1usize;
    text.char_indices().find_map(|(at, c)| {
        match c {
            '[' => depth += 1,
            ']' => depth -= 1,
            _ => {}
        }
        (depth == 0).then_some(at)
    })
}

/// A member's name. Timers and counters answer to the names of other controllers here, and not there.
fn member(name: &str, ty: &str, is_first: bool) -> Result<String, String> {
    let upper = name.to_ascii_uppercase();
    let is_timer = is_first && matches!(ty, "TON" | "TOF" | "TP" | "RTO");
    let is_counter = is_first && matches!(ty, "CTU" | "CTD" | "CTUD");
    if !is_timer && !is_counter {
        return Ok(format!("\"{name}\""));
    }
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

/// A literal, if it is one.
///
/// # Errors
///
/// If it has no form there.
pub(super) fn literal(text: &str) -> Result<Option<String>, String> {
    let upper = text.to_ascii_uppercase();
    if upper == "TRUE" || upper == "FALSE" || text.starts_with('\'') {
        return Ok(Some(if text.starts_with('\'') {
            text.to_owned()
        } else {
            upper
        }));
    }
    if let Some((kind, value)) = upper.split_once('#')
        && kind.chars().all(|c| c.is_alphanumeric() || c == '_')
    {
        return match kind {
            "T" | "TIME" | "LTIME" => duration(value).map(Some),
            "DT" | "DATE_AND_TIME" => Ok(Some(format!("LDT#{value}"))),
            "TOD" | "TIME_OF_DAY" => Ok(Some(format!("TOD#{value}"))),
            "D" | "DATE" => Ok(Some(format!("D#{value}"))),
            _ => Ok(Some(upper)),
        };
    }
    let digits = text.trim_start_matches(['-', '+']).trim_start();
    if !digits.starts_with(|c: char| c.is_ascii_digit()) {
        return Ok(None);
    }
    let lower = digits.to_ascii_lowercase();
    if lower.contains(['s', 'm', 'h', 'd']) {
        return duration(&upper).map(Some);
    }
    let is_number = lower.chars().all(|c| c.is_ascii_digit() || "._e+-".contains(c));
    Ok(is_number.then(|| text.replace(' ', "")))
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
            .map_err(|_| format!("`{text}` is no duration"))?
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
        assert_eq!(literal("5s"), Ok(Some("T#5s".to_owned())));
        assert_eq!(literal("-7"), Ok(Some("-7".to_owned())));
        assert_eq!(literal("x"), Ok(None));
    }
}
