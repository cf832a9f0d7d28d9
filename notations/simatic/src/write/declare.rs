//! Declarations of ladder text as sections of source documents.

use super::operand::literal;
use crate::scope::member;
use ladder_notation::Unwritable;
use ladder_syntax::ast::{AstNode, Declaration, NodeView, SectionHeader, StructHeader};
use ladder_syntax::{LineKind, Parse, Section};
use std::collections::HashMap;

/// What is declared on a line.
#[derive(Debug, Clone)]
pub(super) struct Declared {
    pub(super) names: Vec<String>,
    pub(super) address: Option<String>,
    pub(super) ty: String,
    pub(super) initial: Option<String>,
    pub(super) comment: Option<String>,
    /// Where it is in the text.
    pub(super) at: usize,
}

/// A section.
#[derive(Debug, Clone)]
pub(super) struct Declarations {
    /// `VAR_INPUT`
    pub(super) keyword: String,
    /// `RETAIN`
    pub(super) qualifier: Option<String>,
    pub(super) declared: Vec<Declared>,
    /// The structures of a section of types: the name, and the members.
    pub(super) structures: Vec<(String, Vec<Declared>)>,
}

/// The declarations of a section.
pub(super) fn section(parse: &Parse, section: &Section) -> Declarations {
    let mut out = Declarations {
        keyword: String::new(),
        qualifier: None,
        declared: Vec::new(),
        structures: Vec::new(),
    };
    let mut is_open = false;
    for number in section.lines.clone() {
        let line = &parse.lines()[number];
        let tree = line.tree();
        let node = NodeView::root(&tree);
        match line.kind {
            LineKind::StructHeader => {
                let name = StructHeader::cast(node).and_then(|header| header.names().next());
                let name = name.map(|name| name.text().to_owned()).unwrap_or_default();
                out.structures.push((name, Vec::new()));
                is_open = true;
            }
            LineKind::StructEnd => is_open = false,
            LineKind::Declaration => {
                let Some(found) = Declaration::cast(node) else {
                    continue;
                };
                let declared = declared(&found, line.text(), usize::from(parse.line_start(number)));
                match out.structures.last_mut().filter(|_| is_open) {
                    Some((_, members)) => members.push(declared),
                    None => out.declared.push(declared),
                }
            }
            _ => {
                if let Some(header) = SectionHeader::cast(node)
                    && let Some(keyword) = header.section().filter(|_| out.keyword.is_empty())
                {
                    out.keyword = keyword.text().to_ascii_uppercase();
                    out.qualifier = header
                        .qualifiers()
                        .next()
                        .map(|word| word.text().to_ascii_uppercase());
                }
            }
        }
    }
    out
}

fn declared(found: &Declaration<'_>, text: &str, at: usize) -> Declared {
    let slice = |range: ladder_syntax::TextRange| text[range].trim().to_owned();
    let comment = text.split_once(';').and_then(|(_, rest)| {
        let said = rest
            .trim()
            .strip_prefix('#')?
            .split('#')
            .next()?
            .trim()
            .to_owned();
        (!said.is_empty()).then_some(said)
    });
    Declared {
        names: found.names().map(|name| name.text().to_owned()).collect(),
        address: found.address().map(|address| address.text().to_owned()),
        ty: found.type_ref().map(|ty| slice(ty.range())).unwrap_or_default(),
        initial: found.initial_value().map(|value| slice(value.range())),
        comment,
        at,
    }
}

/// A type that a section declares.
#[derive(Debug, Clone)]
pub(super) enum TypeForm {
    Structure(Vec<Declared>),
    /// Another name for this type, with a first value of its own.
    Alias(Declared),
    /// No type, but a number that the bounds of arrays may name.
    Constant(i64),
    /// A block that is not written; why.
    Missing(String),
}

/// The types of blocks that are not written.
pub(super) fn missing(blocks: &Unwritable) -> Types {
    let all = blocks.iter().map(|(name, why)| {
        let name = name.as_str().to_owned();
        (name.clone(), (name, TypeForm::Missing(why.clone())))
    });
    all.collect()
}

/// Types by their names in small letters, each with its name.
pub(super) type Types = HashMap<String, (String, TypeForm)>;

/// An array has no more dimensions where it is read again.
const MOST_DIMENSIONS: usize = 3;

/// So many types stand for one another at most.
const DEEPEST: usize = 16;

/// A type as it is written there.
///
/// # Errors
///
/// Why it has no form there.
pub(super) fn type_text(text: &str, types: &Types, depth: usize) -> Result<String, String> {
    let text = text.trim();
    if depth > DEEPEST {
        return Err(format!("the type `{text}` stands for too many others"));
    }
    let upper = text.to_ascii_uppercase();
    if text.starts_with('(') {
        return Err("enumerations have no form there".to_owned());
    }
    if let Some(rest) = upper.strip_prefix("ARRAY") {
        let start = text.len() - rest.trim_start().trim_start_matches('[').len();
        let end = text.find(']').ok_or("an array is not closed")?;
        let mut bounds = Vec::new();
        for bound in text[start..end].split(',') {
            let (low, high) = bound.split_once("..").ok_or("an array has no range")?;
            let number = |bound: &str| match types.get(&bound.trim().to_lowercase()) {
                Some((_, TypeForm::Constant(number))) => Some(*number),
                _ => bound.trim().replace(' ', "").parse::<i64>().ok(),
            };
            let (Some(low), Some(high)) = (number(low), number(high)) else {
                return Err("the bounds of an array are numbers there".to_owned());
            };
            bounds.push(format!("{low}..{high}"));
        }
        let of = text[end + 1..].trim_start();
        let of = of.get(2..).ok_or("an array says OF what it is")?;
        let mut of = type_text(of, types, depth + 1)?;
        // An array of arrays is one of several dimensions there.
        if let Some((inner, element)) = of.strip_prefix("Array[").and_then(|of| of.split_once("] of ")) {
            bounds.push(inner.to_owned());
            of = element.to_owned();
        }
        let bounds = bounds.join(", ");
        if bounds.matches("..").count() > MOST_DIMENSIONS {
            return Err(format!(
                "an array of more than {MOST_DIMENSIONS} dimensions, those of the arrays in it included, has no form here"
            ));
        }
        return Ok(format!("Array[{bounds}] of {of}"));
    }
    if let Some(rest) = upper.strip_prefix("STRING") {
        return Ok(format!("String{}", rest.replace(' ', "")));
    }
    if let Some(block) = text.strip_prefix('$') {
        if let Some((_, TypeForm::Missing(why))) = types.get(&text.to_lowercase()) {
            return Err(why.clone());
        }
        return Ok(format!("\"{block}\""));
    }
    let base = upper.split('(').next().unwrap_or_default().trim();
    if let Some(known) = elementary(base).or_else(|| state(base)) {
        return Ok(known.to_owned());
    }
    match types.get(&text.to_lowercase()) {
        Some((name, TypeForm::Structure(_))) => Ok(format!("\"{name}\"")),
        Some((_, TypeForm::Alias(alias))) if alias.ty.starts_with('(') => Ok("DInt".to_owned()),
        Some((_, TypeForm::Alias(alias))) => type_text(&alias.ty, types, depth + 1),
        Some((_, TypeForm::Missing(why))) => Err(why.clone()),
        Some((_, TypeForm::Constant(_))) | None => Err(format!("`{text}` has no form there")),
    }
}

/// An elementary type.
pub(super) fn elementary(upper: &str) -> Option<&'static str> {
    Some(match upper {
        "BOOL" => "Bool",
        "BYTE" => "Byte",
        "WORD" => "Word",
        "DWORD" => "DWord",
        "LWORD" => "LWord",
        "SINT" => "SInt",
        "INT" => "Int",
        "DINT" => "DInt",
        "LINT" => "LInt",
        "USINT" => "USInt",
        "UINT" => "UInt",
        "UDINT" => "UDInt",
        "ULINT" => "ULInt",
        "REAL" => "Real",
        "LREAL" => "LReal",
        "TIME" => "Time",
        "DATE" => "Date",
        "TOD" => "Time_Of_Day",
        "DT" => "LDT",
        _ => return None,
    })
}

/// The type of what holds a state.
fn state(upper: &str) -> Option<&'static str> {
    Some(match upper {
        "TON" => "TON_TIME",
        "TOF" => "TOF_TIME",
        "TP" => "TP_TIME",
        "RTO" => "TONR_TIME",
        "CTU" => "CTU_DINT",
        "CTD" => "CTD_DINT",
        "CTUD" => "CTUD_DINT",
        _ => return None,
    })
}

/// The values of an enumeration, if a type is one, and the first value of the type.
pub(super) fn enumeration<'t>(ty: &str, types: &'t Types) -> Option<(Vec<(&'t str, i64)>, &'t str)> {
    let Some((_, TypeForm::Alias(alias))) = types.get(&ty.trim().to_lowercase()) else {
        return None;
    };
    let inner = alias.ty.strip_prefix('(')?.strip_suffix(')')?;
    let mut values: Vec<(&str, i64)> = Vec::new();
    for value in inner.split(',') {
        let (name, number) = match value.split_once(":=") {
            Some((name, number)) => (name.trim(), number.trim().replace(' ', "").parse().ok()?),
            None => (value.trim(), values.last().map_or(0, |(_, before)| before + 1)),
        };
        values.push((name, number));
    }
    let first = alias.initial.as_deref().unwrap_or(values.first()?.0);
    Some((values, first))
}

/// A first value.
///
/// # Errors
///
/// Why it has no form there.
pub(super) fn initial_text(text: &str) -> Result<String, String> {
    let none = || format!("the first value `{text}` has no form there");
    if let Some(inner) = text.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) {
        let values = inner.split(',').map(|value| {
            let value = value.trim();
            match value.strip_suffix(')').and_then(|rest| rest.split_once('(')) {
                Some((count, value)) => Ok(format!("{count}({})", literal(value.trim())?.ok_or_else(none)?)),
                None => literal(value)?.ok_or_else(none),
            }
        });
        let values: Result<Vec<String>, String> = values.collect();
        return Ok(format!("[{}]", values?.join(", ")));
    }
    literal(text)?.ok_or_else(none)
}

/// Whether a type, or that of the elements of an array, is another name for one with first values.
fn begins_with_values(text: &str, types: &Types, depth: usize) -> bool {
    if depth > DEEPEST {
        return false;
    }
    if text
        .get(..5)
        .is_some_and(|word| word.eq_ignore_ascii_case("ARRAY"))
    {
        let element = text.split_once(']').and_then(|(_, of)| of.trim_start().get(2..));
        return element.is_some_and(|element| begins_with_values(element.trim(), types, depth + 1));
    }
    match types.get(&text.to_lowercase()) {
        Some((_, TypeForm::Alias(alias))) => {
            alias.initial.is_some()
                || enumeration(text, types)
                    .is_some_and(|(values, _)| values.first().is_some_and(|(_, number)| *number != 0))
                || begins_with_values(&alias.ty, types, depth + 1)
        }
        _ => false,
    }
}

/// A declaration there, without its pragma.
///
/// # Errors
///
/// Why it has no form there.
pub(super) fn declaration(
    name: &str,
    ty: &str,
    initial: Option<&str>,
    types: &Types,
) -> Result<String, String> {
    let alias = match types.get(&ty.to_lowercase()) {
        Some((_, TypeForm::Alias(alias))) => alias.initial.as_deref(),
        _ => None,
    };
    let numbered = enumeration(ty, types).and_then(|(values, first)| {
        let name = initial.unwrap_or(first);
        let name = name.rsplit('.').next().unwrap_or(name);
        let (_, number) = values
            .into_iter()
            .find(|(own, _)| own.eq_ignore_ascii_case(name))?;
        Some(number.to_string())
    });
    let initial = numbered.as_deref().or(initial);
    let initial = initial.or(alias);
    if initial.is_none() && begins_with_values(ty, types, 0) {
        return Err("the first values that its type takes from another have no form there".to_owned());
    }
    let ty = type_text(ty, types, 0)?;
    let initial = match initial {
        Some("1") if ty == "Bool" => " := TRUE".to_owned(),
        Some("0") if ty == "Bool" => " := FALSE".to_owned(),
        Some(initial) => format!(" := {}", initial_text(initial)?),
        None => String::new(),
    };
    Ok(format!("\"{name}\" : {ty}{initial};"))
}

/// A structure as a document of its own.
///
/// # Errors
///
/// Why it has no form there.
pub(super) fn structure(
    name: &str,
    members: &[Declared],
    types: &Types,
    pragma: &mut impl FnMut(&Declared) -> String,
) -> Result<String, String> {
    let mut out =
        format!("\u{feff}{{\r\n    S7_Version := \"0.1\"\r\n}}\r\nTYPE \"{name}\"\r\n    STRUCT\r\n");
    for declared in members {
        for own in &declared.names {
            if member(own) != *own {
                return Err(format!("the member `{own}` has no form there"));
            }
            let line = declaration(own, &declared.ty, declared.initial.as_deref(), types)?;
            out.push_str(&format!("        {}{line}\r\n", pragma(declared)));
        }
    }
    out.push_str("    END_STRUCT;\r\nEND_TYPE\r\n");
    Ok(out)
}
