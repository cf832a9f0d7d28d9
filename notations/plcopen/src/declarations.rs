//! What a unit declares, as texts of IEC 61131-3 have it: `PROGRAM main`, and the sections of variables.

use super::model::{Body, Initial, Role, Type, Unit, UnitKind, Variable};
use ladder_format::program::Qualifier;
use ladder_notation::{LineColumn, ReadError, Report};

const KINDS: [(&str, UnitKind); 3] = [
    ("PROGRAM", UnitKind::Program),
    ("FUNCTION_BLOCK", UnitKind::FunctionBlock),
    ("FUNCTION", UnitKind::Function),
];

/// Whether a text begins as a unit does.
pub fn begins_unit(text: &str) -> bool {
    let text = without_comments(text);
    let word = text.split_whitespace().next().unwrap_or_default();
    KINDS.iter().any(|(name, _)| word.eq_ignore_ascii_case(name))
}

/// The unit that a text without comments declares. `place` says where an offset of it is.
///
/// # Errors
///
/// If it begins otherwise.
pub fn unit(head: &str, place: &dyn Fn(usize) -> LineColumn, report: &mut Report) -> Result<Unit, ReadError> {
    let at = head.len() - head.trim_start_matches('\u{feff}').trim_start().len();
    let mut words = head[at..].split_whitespace();
    let word = words.next().unwrap_or_default();
    let kind = KINDS.iter().find(|(name, _)| word.eq_ignore_ascii_case(name));
    let Some((_, kind)) = kind else {
        return Err(ReadError::at(
            place(at),
            "the file begins with `PROGRAM`, `FUNCTION_BLOCK` or `FUNCTION`",
        ));
    };
    let name = words.next().unwrap_or_default().trim_end_matches([':', ';']);
    let mut unit = Unit {
        place: place(at),
        name: name.to_owned(),
        kind: *kind,
        returns: None,
        variables: Vec::new(),
        comment: None,
        body: Body::Empty,
        parts: Vec::new(),
    };
    let mut section: Option<(Role, Option<Qualifier>)> = None;
    for (offset, statement) in statements(head) {
        let at = place(offset);
        let upper = statement.to_ascii_uppercase();
        let word = upper.split_whitespace().next().unwrap_or_default();
        if let Some(role) = role(word) {
            let has = |qualifier: &str| upper.split_whitespace().any(|word| word == qualifier);
            let qualifier = if has("CONSTANT") {
                Some(Qualifier::Constant)
            } else {
                (has("RETAIN") || has("PERSISTENT")).then_some(Qualifier::Retain)
            };
            section = Some((role, qualifier));
        } else if word == "END_VAR" {
            section = None;
        } else if let Some((role, qualifier)) = section {
            match variables(statement, role, qualifier, at) {
                Some(variables) => unit.variables.extend(variables),
                None => report.refused(at, statement, "this is no declaration: `name : TYPE;` is one"),
            }
        } else if upper.starts_with("FUNCTION") && upper.contains(':') {
            unit.returns = statement.rsplit(':').next().map(|ty| type_of(ty.trim()));
        } else if !KINDS.iter().any(|(name, _)| word == *name) {
            report.refused(at, statement, "it stands outside of a section of variables");
        }
    }
    Ok(unit)
}

fn role(word: &str) -> Option<Role> {
    Some(match word {
        "VAR" => Role::Local,
        "VAR_TEMP" => Role::Temp,
        "VAR_INPUT" => Role::Input,
        "VAR_OUTPUT" => Role::Output,
        "VAR_IN_OUT" => Role::InOut,
        "VAR_EXTERNAL" => Role::External,
        "VAR_GLOBAL" => Role::Local,
        _ => return None,
    })
}

/// The text with blanks in the place of comments, so that every byte stays where it is. Strings are passed over.
pub fn without_comments(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    let mut quote: Option<char> = None;
    while let Some(c) = rest.chars().next() {
        let comment = match quote {
            Some(_) => None,
            None if rest.starts_with("(*") => Some(rest[2..].find("*)").map_or(rest.len(), |end| end + 4)),
            None if rest.starts_with("//") => Some(rest.find('\n').unwrap_or(rest.len())),
            None => None,
        };
        if let Some(length) = comment {
            let blank = |c: char| {
                if c == '\n' {
                    "\n".to_owned()
                } else {
                    " ".repeat(c.len_utf8())
                }
            };
            out.extend(rest[..length].chars().map(blank));
            rest = &rest[length..];
            continue;
        }
        match quote {
            Some(open) if c == open || c == '\n' => quote = None,
            // What a sign before a quote makes of it ends no string: JSON has \, IEC has $.
            Some(_) if matches!(c, '\\' | '$') => {
                let next = rest[c.len_utf8()..].chars().next().filter(|next| *next != '\n');
                let length = c.len_utf8() + next.map_or(0, char::len_utf8);
                out.push_str(&rest[..length]);
                rest = &rest[length..];
                continue;
            }
            None if matches!(c, '\'' | '"') => quote = Some(c),
            _ => {}
        }
        out.push(c);
        rest = &rest[c.len_utf8()..];
    }
    out
}

/// The parts of a head, with their offsets: keywords on lines of their own, and what ends in `;`.
fn statements(head: &str) -> Vec<(usize, &str)> {
    let mut out = Vec::new();
    let mut at = 0;
    while at < head.len() {
        let rest = &head[at..];
        let blanks = rest.len()
            - rest
                .trim_start_matches(|c: char| c.is_whitespace() || c == ';' || c == '\u{feff}')
                .len();
        at += blanks;
        let rest = &head[at..];
        let line = rest.find('\n').unwrap_or(rest.len());
        let word = rest
            .split_whitespace()
            .next()
            .unwrap_or_default()
            .to_ascii_uppercase();
        let is_section = role(&word).is_some() || word.trim_end_matches(';') == "END_VAR";
        let end = if is_section {
            section_length(rest)
        } else if KINDS.iter().any(|(name, _)| word == *name) {
            line
        } else {
            rest.find(';').unwrap_or(rest.len())
        };
        let statement = rest[..end].trim().trim_end_matches(';');
        if !statement.is_empty() {
            out.push((at, statement));
        }
        at += end.max(usize::from(!rest.is_empty()));
        while !head.is_char_boundary(at) {
            at += 1;
        }
    }
    out
}

/// How long the keyword of a section is, with what qualifies it.
fn section_length(text: &str) -> usize {
    let mut end = 0;
    for (number, word) in text.split_whitespace().enumerate() {
        let upper = word.to_ascii_uppercase();
        let qualifies = matches!(
            upper.as_str(),
            "CONSTANT" | "RETAIN" | "PERSISTENT" | "NON_RETAIN"
        );
        if number > 0 && !qualifies {
            break;
        }
        end += text[end..].find(word).unwrap_or(0) + word.len();
        if upper.starts_with("END_VAR") {
            break;
        }
    }
    end
}

/// `a, b : INT AT %IW0 := 5`, with the address before or after the type.
fn variables(
    text: &str,
    role: Role,
    qualifier: Option<Qualifier>,
    place: LineColumn,
) -> Option<Vec<Variable>> {
    let (names, rest) = text
        .split_once(':')
        .filter(|(names, _)| !names.trim().is_empty())?;
    let (ty, initial) = match rest.split_once(":=") {
        Some((ty, initial)) => (ty, Some(Initial::Simple(initial.trim().to_owned()))),
        None => (rest, None),
    };
    let (names, before) = at(names);
    let (ty, after) = at(ty);
    let address = before.or(after).map(str::to_owned);
    if ty.is_empty() {
        return None;
    }
    let names = names.split(',').map(str::trim);
    let variable = |name: &str| Variable {
        place,
        name: name.to_owned(),
        role,
        qualifier,
        address: address.clone(),
        ty: type_of(ty),
        initial: initial.clone(),
        comment: None,
    };
    Some(names.filter(|name| !name.is_empty()).map(variable).collect())
}

/// What is before `AT`, and the address after it.
fn at(text: &str) -> (&str, Option<&str>) {
    let upper = text.to_ascii_uppercase();
    match upper.find(" AT ").or_else(|| upper.find("\tAT ")) {
        Some(at) => (text[..at].trim(), Some(text[at + 4..].trim())),
        None => (text.trim(), None),
    }
}

fn type_of(text: &str) -> Type {
    let upper = text.to_ascii_uppercase();
    if let Some(rest) = upper.strip_prefix("ARRAY") {
        let shown = || Type::Other(format!("`{text}`"));
        let (Some(open), Some(close)) = (rest.find('['), rest.find(']')) else {
            return shown();
        };
        let Some(of) = rest.find(" OF ").filter(|of| *of > close && open < close) else {
            return shown();
        };
        let offset = text.len() - rest.len();
        let bounds: Option<Vec<(String, String)>> = rest[open + 1..close]
            .split(',')
            .map(|bound| {
                let (low, high) = bound.split_once("..")?;
                Some((low.trim().to_owned(), high.trim().to_owned()))
            })
            .collect();
        let Some(bounds) = bounds else { return shown() };
        return Type::Array(
            bounds,
            Box::new(Type::Named(text[offset + of + 4..].trim().to_owned())),
        );
    }
    if let Some(rest) = upper.strip_prefix("STRING") {
        let length = rest.trim().trim_matches(['[', ']', '(', ')']).trim();
        return Type::Text(length.parse().ok());
    }
    Type::Named(text.to_owned())
}
