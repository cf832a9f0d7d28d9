//! Operands: `#run`, `"Data".motor[3].speed`, `%I0.3`, `T#5s`.

use crate::model::{Argument, Type, Value};
use crate::scope::{Scope, member, plain};
use crate::standard::{SYSTEM, elementary, trigger};
use ladder_format::program::{Expression, Literal, Path};

/// An operand as it is written here.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Operand {
    pub(crate) value: Expression,
    pub(crate) ty: Option<Type>,
}

impl Operand {
    /// What is of an elementary type.
    pub(crate) fn new(value: impl Into<Expression>, ty: &str) -> Operand {
        Operand {
            value: value.into(),
            ty: Some(Type::Named(ty.to_owned())),
        }
    }

    pub(crate) const fn is_literal(&self) -> bool {
        matches!(self.value, Expression::Literal(_))
    }

    /// The tag, or the part of one.
    ///
    /// # Errors
    ///
    /// If it is a literal.
    pub(crate) fn path(self) -> Result<Path, String> {
        match self.value {
            Expression::Path(path) => Ok(path),
            literal => Err(format!("`{literal}` is not a tag")),
        }
    }

    /// Its type, if that is elementary or holds a state.
    pub(crate) fn plain(&self) -> Option<&'static str> {
        self.ty.as_ref().and_then(plain)
    }
}

/// Indices nest no deeper.
const DEEPEST: usize = 8;

/// What an operand is here. `wanted` is the type that its place asks for: a tag that nobody declares has it.
///
/// # Errors
///
/// Why it has no counterpart.
pub(crate) fn operand(scope: &mut Scope<'_>, text: &str, wanted: &str) -> Result<Operand, String> {
    read(scope, text.trim(), wanted, 0)
}

/// What is at a pin. None: nothing, or the power at a point.
pub(crate) fn at_pin(
    scope: &mut Scope<'_>,
    argument: Option<&Argument>,
    wanted: &str,
) -> Option<Result<Operand, String>> {
    match &argument?.value {
        Value::Operand(text) => Some(operand(scope, text, wanted)),
        Value::Helper(tag) => Some(Ok(Operand::new(Path::tag(tag), "BOOL"))),
        Value::Power(_) | Value::Open => None,
    }
}

fn read(scope: &mut Scope<'_>, text: &str, wanted: &str, depth: usize) -> Result<Operand, String> {
    if depth > DEEPEST {
        return Err("its indices nest too deep".to_owned());
    }
    if text.is_empty() {
        return Err("an operand is missing".to_owned());
    }
    if let Some(address) = text.strip_prefix('%') {
        return address_of(address)
            .map(|(path, ty)| Operand::new(path, ty))
            .ok_or_else(|| format!("`{text}` is no address here"));
    }
    let system = SYSTEM.iter().find(|(_, name)| text.trim_matches('"') == *name);
    if let Some((own, _)) = system.filter(|(_, name)| scope.own(name).is_none()) {
        return Ok(Operand::new(Path::system(own.name()), "BOOL"));
    }
    let first = text.chars().next().unwrap_or_default();
    if first == '#' || first == '"' {
        return path(scope, text, wanted, depth);
    }
    if let Some(found) = literal(text) {
        return found;
    }
    // The names of a block's own variables come without their sign too.
    let word = text.split(['.', '[']).next().unwrap_or_default();
    if scope.own(word).is_some() || text.starts_with("_.") {
        return path(scope, text.trim_start_matches("_."), wanted, depth);
    }
    let is_name = |c: char| c.is_alphanumeric() || "_.[]%, ".contains(c);
    if text.chars().all(is_name) {
        return path(scope, text, wanted, depth);
    }
    Err(format!("`{text}` is no operand here"))
}

/// Whether neither the project nor ladder text has a type.
fn is_unknown(scope: &Scope<'_>, ty: &Type) -> bool {
    match ty {
        Type::Named(name) => {
            plain(ty).is_none()
                && trigger(name).is_none()
                && !scope.library.contains_key(&name.to_lowercase())
        }
        Type::Array(_, of) => is_unknown(scope, of),
        _ => false,
    }
}

/// One step of a path.
pub(crate) enum Step {
    Member(String),
    Index(String),
    Bit(u32),
}

fn path(scope: &mut Scope<'_>, text: &str, wanted: &str, depth: usize) -> Result<Operand, String> {
    let (is_own, rest) = match text.strip_prefix('#') {
        Some(rest) => (true, rest),
        None => (false, text),
    };
    let (root, steps) = split(rest).ok_or_else(|| format!("`{text}` is no name"))?;
    let is_own = is_own || (!text.starts_with('"') && scope.own(&root).is_some());
    let mut steps = steps.into_iter().peekable();
    let (mut out, mut ty) = if is_own {
        match scope.own(&root) {
            Some(known) if is_unknown(scope, &known.ty) => {
                return Err(format!(
                    "`{root}` is not declared here: the project does not have its type"
                ));
            }
            Some(known) => (known.path(), Some(known.ty.clone())),
            None => return Err(format!("the block declares no `{root}`")),
        }
    } else if let Some(unit) = scope.unit(&root).filter(|unit| unit.kind.is_tag()) {
        let ty = match &unit.returns {
            Some(of) => of.clone(),
            None => Type::Named(unit.name.clone()),
        };
        let known = scope.global(&unit.name.clone(), ty);
        // The members of a data block are those of its own type.
        if unit.returns.is_none()
            && let Some(Step::Member(name)) = steps.next_if(|step| matches!(step, Step::Member(_)))
        {
            let found = unit
                .variables
                .iter()
                .find(|own| own.name.eq_ignore_ascii_case(&name));
            let found = found.ok_or_else(|| format!("the data block `{root}` has no `{name}`"))?;
            (known.path().member(member(&name)), Some(found.ty.clone()))
        } else {
            (known.path(), Some(known.ty))
        }
    } else {
        // A part of what is declared elsewhere is a tag by itself, up to what a state has.
        let mut name = root.clone();
        while !scope.globals.contains_key(&name.to_lowercase()) {
            let next = steps.next_if(|step| match step {
                Step::Member(_) => true,
                Step::Index(index) => index.bytes().all(|c| c.is_ascii_digit()),
                Step::Bit(_) => false,
            });
            match next {
                Some(Step::Member(part) | Step::Index(part)) => name = format!("{name}.{part}"),
                _ => break,
            }
        }
        let ty = match steps.peek() {
            None => wanted,
            Some(Step::Bit(_)) => "WORD",
            Some(_) => {
                return Err(format!(
                    "`{root}` is declared in another file, and has a computed index"
                ));
            }
        };
        let known = scope.global(&name, Type::Named(ty.to_owned()));
        (known.path(), Some(known.ty))
    };
    for step in steps {
        match step {
            Step::Member(name) => {
                if let Some(Type::Named(of)) = &ty
                    && trigger(of).is_some()
                {
                    // The tag of an edge detector holds its output.
                    if !name.eq_ignore_ascii_case("Q") {
                        return Err(format!("`{name}` of an edge detector is not kept here"));
                    }
                    ty = Some(Type::Named("BOOL".to_owned()));
                    continue;
                }
                let state = ty.as_ref().and_then(plain).filter(|ty| elementary(ty).is_none());
                let of = ty.take();
                if state.is_some() {
                    let name = name.to_ascii_uppercase();
                    ty = Some(Type::Named(state_member(&name).to_owned()));
                    out = out.member(name);
                    continue;
                }
                let members = of.as_ref().and_then(|of| match of {
                    Type::Structure(members) => Some(members.clone()),
                    of => scope.members(of).map(<[_]>::to_vec),
                });
                let found = members.and_then(|members| {
                    members
                        .into_iter()
                        .find(|own| own.name.eq_ignore_ascii_case(&name))
                });
                ty = found.map(|found| found.ty);
                out = out.member(member(&name));
            }
            Step::Index(text) => {
                let mut indices = Vec::new();
                for index in indices_of(&text) {
                    indices.push(read(scope, index, "INT", depth + 1)?.value);
                }
                out = out.index(indices);
                ty = match ty {
                    Some(Type::Array(_, of)) => Some(*of),
                    _ => None,
                };
            }
            Step::Bit(bit) => {
                out = out.bit(bit);
                ty = Some(Type::Named("BOOL".to_owned()));
            }
        }
    }
    Ok(Operand {
        value: out.into(),
        ty,
    })
}

/// The indices in a pair of brackets.
pub(crate) fn indices_of(text: &str) -> impl Iterator<Item = &str> {
    let mut depth = 0usize;
    let parts = text.split(move |c| {
        match c {
            '[' => depth += 1,
            ']' => depth = depth.saturating_sub(1),
            _ => {}
        }
        c == ',' && depth == 0
    });
    parts.map(str::trim)
}

fn state_member(name: &str) -> &'static str {
    match name {
        "ET" | "PT" => "TIME",
        "CV" | "PV" => "DINT",
        _ => "BOOL",
    }
}

/// The first name of a path, and the steps after it.
pub(crate) fn split(text: &str) -> Option<(String, Vec<Step>)> {
    let mut rest = text.trim();
    let mut name = || -> Option<String> {
        if let Some(inner) = rest.strip_prefix('"') {
            let end = inner.find('"')?;
            let name = inner[..end].to_owned();
            rest = &inner[end + 1..];
            return Some(name);
        }
        let end = rest.find(['.', '[']).unwrap_or(rest.len());
        let name = rest[..end].trim();
        rest = &rest[end..];
        let is_name = !name.is_empty() && name.chars().all(|c| c.is_alphanumeric() || "_%".contains(c));
        is_name.then(|| name.to_owned())
    };
    let root = name()?;
    let mut tail = rest;
    let mut steps = Vec::new();
    while !tail.is_empty() {
        if let Some(after) = tail.strip_prefix('[') {
            let mut depth = 1usize;
            let end = after.char_indices().find(|(_, c)| {
                match c {
                    '[' => depth += 1,
                    ']' => depth -= 1,
                    _ => {}
                }
                depth == 0
            });
            let (end, _) = end?;
            steps.push(Step::Index(after[..end].to_owned()));
            tail = &after[end + 1..];
            continue;
        }
        let after = tail.trim_start().strip_prefix('.')?;
        if let Some(bit) = after.strip_prefix("%X").or_else(|| after.strip_prefix("%x")) {
            let end = bit.find(|c: char| !c.is_ascii_digit()).unwrap_or(bit.len());
            let number: u8 = bit[..end].parse().ok()?;
            steps.push(Step::Bit(number.into()));
            tail = &bit[end..];
            continue;
        }
        let (part, next) = match after.strip_prefix('"') {
            Some(inner) => inner.split_once('"')?,
            None => after.split_at(after.find(['.', '[']).unwrap_or(after.len())),
        };
        let is_name = !part.is_empty() && !part.contains('%');
        steps.push(is_name.then(|| Step::Member(part.trim().to_owned()))?);
        tail = next;
    }
    Some((root, steps))
}

/// An address as it is written here, and its type.
fn address_of(text: &str) -> Option<(Path, &'static str)> {
    let upper = text.trim().to_ascii_uppercase();
    let area = match upper.chars().next()? {
        'I' | 'E' => 'I',
        'Q' | 'A' => 'Q',
        'M' => 'M',
        _ => return None,
    };
    let rest = &upper[1..];
    let (size, number) = match rest.chars().next()? {
        size @ ('X' | 'B' | 'W' | 'D' | 'L') => (size, &rest[1..]),
        _ => ('X', rest),
    };
    let is_number = |text: &str| text.parse::<u32>().is_ok();
    let ty = match size {
        'X' => "BOOL",
        'B' => "BYTE",
        'W' => "WORD",
        'D' => "DWORD",
        _ => "LWORD",
    };
    let is_right = match number.split_once('.') {
        Some((byte, bit)) => size == 'X' && is_number(byte) && is_number(bit),
        None => size != 'X' && is_number(number),
    };
    is_right.then(|| (Path::tag(format!("%{area}{size}{number}")), ty))
}

/// A literal. None: the text is something else.
pub(crate) fn literal(text: &str) -> Option<Result<Operand, String>> {
    let upper = text.to_ascii_uppercase();
    let of = |text: String, ty: Option<&str>| {
        let made = |value| Operand {
            value: Expression::Literal(value),
            ty: ty.map(|ty| Type::Named(ty.to_owned())),
        };
        Some(Literal::read(text).map(made).map_err(String::from))
    };
    if upper == "TRUE" || upper == "FALSE" {
        return of(upper, Some("BOOL"));
    }
    if text.starts_with('\'') && text.ends_with('\'') && text.len() > 1 {
        return of(text.to_owned(), Some("STRING"));
    }
    if let Some((kind, value)) = upper.split_once('#')
        && kind.chars().all(|c| c.is_alphanumeric() || c == '_')
    {
        if value.is_empty()
            || !value
                .chars()
                .all(|c| c.is_ascii_alphanumeric() || "_.:+-".contains(c))
        {
            return None;
        }
        return match kind {
            "T" | "TIME" | "LT" | "LTIME" | "S5T" | "S5TIME" => {
                of(format!("T#{}", value.to_ascii_lowercase()), Some("TIME"))
            }
            "B" => of(format!("BYTE#{value}"), Some("BYTE")),
            "W" => of(format!("WORD#{value}"), Some("WORD")),
            "DW" => of(format!("DWORD#{value}"), Some("DWORD")),
            "LW" => of(format!("LWORD#{value}"), Some("LWORD")),
            "L" => of(format!("DINT#{value}"), Some("DINT")),
            "2" | "8" | "16" => of(upper.clone(), None),
            kind => {
                let ty = elementary(kind).or(match kind {
                    "D" => Some("DATE"),
                    _ => None,
                })?;
                of(format!("{ty}#{value}"), Some(ty))
            }
        };
    }
    let digits = text.trim_start_matches(['+', '-']);
    let is_number = digits.starts_with(|c: char| c.is_ascii_digit())
        && digits
            .chars()
            .all(|c| c.is_ascii_alphanumeric() || ".+-_".contains(c))
        && !digits.contains('%');
    if !is_number {
        return None;
    }
    let number = text.trim_start_matches('+').replace('_', "");
    let is_integer = number.trim_start_matches('-').bytes().all(|c| c.is_ascii_digit());
    if !is_integer && number.parse::<f64>().is_err() {
        return None;
    }
    of(
        text.trim_start_matches('+').to_owned(),
        (!is_integer).then_some("REAL"),
    )
}
