//! What units, types and globals declare, as texts of IEC 61131-3 have it: `PROGRAM main`, and the sections of variables.

pub mod text;

use super::model::{Body, Initial, Role, Type, TypeDeclaration, Unit, UnitKind, Variable};
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

/// What texts of IEC 61131-3 declare: a text, the same without comments and pragmas, and where an offset is in the file.
pub struct Declared<'d> {
    /// With comments.
    pub text: &'d str,
    /// See [`without_comments`]: each byte is where it was.
    pub plain: &'d str,
    /// Where an offset of both is.
    pub place: &'d dyn Fn(usize) -> LineColumn,
}

impl Declared<'_> {
    /// The unit that is declared.
    ///
    /// # Errors
    ///
    /// If the text begins otherwise.
    pub fn unit(&self, report: &mut Report) -> Result<Unit, ReadError> {
        let at = self.start();
        let mut words = self.plain[at..].split_whitespace();
        let word = words.next().unwrap_or_default();
        let kind = KINDS.iter().find(|(name, _)| word.eq_ignore_ascii_case(name));
        let Some((_, kind)) = kind else {
            return Err(ReadError::at(
                (self.place)(at),
                "the file begins with `PROGRAM`, `FUNCTION_BLOCK` or `FUNCTION`",
            ));
        };
        let name = words.next().unwrap_or_default().trim_end_matches([':', ';']);
        let mut unit = Unit {
            place: (self.place)(at),
            name: name.to_owned(),
            kind: *kind,
            returns: None,
            variables: Vec::new(),
            comment: self.comment_above(at),
            body: Body::Empty,
            parts: Vec::new(),
        };
        let mut variables = self.variables(report, |statement| {
            let upper = statement.to_ascii_uppercase();
            if upper.starts_with("FUNCTION") && upper.contains(':') {
                unit.returns = statement.rsplit(':').next().map(|ty| type_of(ty.trim()));
                return true;
            }
            let word = upper.split_whitespace().next().unwrap_or_default();
            KINDS.iter().any(|(name, _)| word == *name)
        });
        // A program is there once.
        if *kind != UnitKind::Program {
            for (variable, _) in variables.iter_mut().filter(|(_, is_static)| *is_static) {
                variable.ty = Type::Other("a variable that all instances have in common".to_owned());
            }
        }
        unit.variables = variables.into_iter().map(|(variable, _)| variable).collect();
        Ok(unit)
    }

    /// The globals that are declared.
    pub fn globals(&self, report: &mut Report) -> Vec<Variable> {
        let globals = self.variables(report, |_| false).into_iter();
        let global = |(variable, _)| Variable {
            role: Role::Global,
            ..variable
        };
        globals.map(global).collect()
    }

    /// The type that is declared, as in `TYPE Phase : (IDLE, FILLING); END_TYPE`.
    pub fn data_type(&self, report: &mut Report) -> Option<TypeDeclaration> {
        let at = self.start();
        let upper = self.plain.to_ascii_uppercase();
        let end = upper.rfind("END_TYPE").unwrap_or(upper.len());
        let is_type = upper[at..].starts_with("TYPE");
        let colon = upper.get(at..end)?.find(':').filter(|_| is_type)? + at;
        let name = self.plain[at + "TYPE".len()..colon].trim();
        let rest = self.plain[colon + 1..end].trim().trim_end_matches(';').trim_end();
        let declared = |ty, initial: Option<&str>| TypeDeclaration {
            place: (self.place)(at),
            name: name.to_owned(),
            ty,
            initial: initial.map(initial_of),
            comment: self.comment_above(at),
        };
        if upper[colon + 1..].trim_start().starts_with("STRUCT") {
            let start = colon + 1 + upper[colon + 1..].find("STRUCT")? + "STRUCT".len();
            let end = upper[start..end].find("END_STRUCT").map_or(end, |at| start + at);
            let mut members = Vec::new();
            for (offset, statement) in statements(&self.plain[start..end]) {
                members.extend(self.variable((start + offset, statement), (Role::Local, None), report));
            }
            return Some(declared(Type::Structure(members), None));
        }
        if let Some(inside) = rest.strip_prefix('(') {
            let (values, after) = inside.split_once(')')?;
            let values = values.split(',').map(|value| match value.split_once(":=") {
                Some((name, number)) => (name.trim().to_owned(), Some(number.trim().to_owned())),
                None => (value.trim().to_owned(), None),
            });
            let initial = after.split_once(":=").map(|(_, initial)| initial);
            return Some(declared(Type::Enumeration(values.collect()), initial));
        }
        Some(match rest.split_once(":=") {
            Some((ty, initial)) => declared(type_of(ty.trim()), Some(initial)),
            None => declared(type_of(rest), None),
        })
    }

    fn start(&self) -> usize {
        self.plain.len() - self.plain.trim_start_matches('\u{feff}').trim_start().len()
    }

    /// The variables of all sections, each with whether it is in `VAR_STAT`. What is outside of them is an error, unless it is `known`.
    fn variables(&self, report: &mut Report, mut known: impl FnMut(&str) -> bool) -> Vec<(Variable, bool)> {
        let mut variables = Vec::new();
        let mut section: Option<(Role, Option<Qualifier>)> = None;
        let mut is_static = false;
        for (offset, statement) in statements(self.plain) {
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
                is_static = word == STATIC;
            } else if word == "END_VAR" {
                section = None;
            } else if let Some(section) = section {
                let declared = self.variable((offset, statement), section, report);
                variables.extend(declared.into_iter().map(|variable| (variable, is_static)));
            } else if !known(statement) {
                let at = (self.place)(offset);
                report.refused(at, statement, "it is outside of a section of variables");
            }
        }
        variables
    }

    /// The variables that a statement declares, with the comments on them after it.
    fn variable(
        &self,
        (offset, statement): (usize, &str),
        (role, qualifier): (Role, Option<Qualifier>),
        report: &mut Report,
    ) -> Vec<Variable> {
        let at = (self.place)(offset);
        let Some(mut all) = variables(statement, role, qualifier, at) else {
            report.refused(at, statement, "this is not a declaration: `name : TYPE;` is one");
            return Vec::new();
        };
        let given = statement.split_once(':').and_then(|(_, rest)| constructed(rest));
        if let Some((ty, given, _)) = given.filter(|(_, given, _)| !given.trim().is_empty()) {
            let why = "constructors are not run: what is handed to it is left out";
            report.approximated(at, format!("{ty}({given})"), why);
        }
        let told = self.comment_behind(offset + statement.len());
        for variable in &mut all {
            variable.comment.clone_from(&told);
        }
        all
    }

    /// The comment on the rest of a line.
    fn comment_behind(&self, end: usize) -> Option<String> {
        let rest = self.text[end..].lines().next()?;
        let rest = rest.trim_start().trim_start_matches(';').trim_start();
        told(rest)
    }

    /// The comment on the lines above.
    fn comment_above(&self, at: usize) -> Option<String> {
        let lines: Vec<String> = self.text[..at]
            .lines()
            .filter_map(|line| told(line.trim()))
            .collect();
        (!lines.is_empty()).then(|| lines.join("\n"))
    }
}

/// The words of a text that is a comment.
fn told(text: &str) -> Option<String> {
    let inside = match text.strip_prefix("(*") {
        Some(inside) => inside.split("*)").next()?,
        None => text.strip_prefix("//")?,
    };
    let inside = inside.trim();
    (!inside.is_empty()).then(|| inside.to_owned())
}

/// What begins a section of variables that all instances of a unit have in common.
const STATIC: &str = "VAR_STAT";

fn role(word: &str) -> Option<Role> {
    Some(match word {
        "VAR" | "VAR_INST" | STATIC => Role::Local,
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
            Some(open) if c == '$' || c == '\\' && open == '"' => {
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
            declaration_length(rest)
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

/// How long a text is up to the `;` that is not in a string.
fn declaration_length(text: &str) -> usize {
    let mut quote: Option<char> = None;
    let mut is_plain = true;
    let end = text.find(|c| {
        match quote {
            _ if !is_plain => is_plain = true,
            Some(_) if c == '$' => is_plain = false,
            Some(open) if c == open || c == '\n' => quote = None,
            None if matches!(c, '\'' | '"') => quote = Some(c),
            _ => {}
        }
        c == ';' && quote.is_none()
    });
    end.unwrap_or(text.len())
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
    let (ty, rest) = match constructed(rest) {
        Some((ty, _, after)) => (Some(ty), after),
        None => (None, rest),
    };
    let (before_value, initial) = match rest.split_once(":=") {
        Some((before, initial)) => (before, Some(initial_of(initial))),
        None => (rest, None),
    };
    let ty = ty.unwrap_or(before_value);
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

/// A type with what is handed to its constructor, as in `pump : FB_Pump(2, name := 'P1')`: the type, that, and what is after it.
fn constructed(rest: &str) -> Option<(&str, &str, &str)> {
    let rest = rest.trim_start();
    let is_name = |c: char| c.is_alphanumeric() || matches!(c, '_' | '.');
    let (ty, after) = rest.split_at(rest.find(|c| !is_name(c))?);
    let inside = after.trim_start().strip_prefix('(')?;
    let has_length = ["STRING", "WSTRING", "ARRAY"]
        .iter()
        .any(|own| own.eq_ignore_ascii_case(ty));
    if ty.is_empty() || has_length {
        return None;
    }
    let mut depth = 1_u32;
    let end = inside.find(|c| {
        match c {
            '(' => depth += 1,
            ')' => depth -= 1,
            _ => {}
        }
        depth == 0
    })?;
    let given = &inside[..end];
    // `INT(0..100)` is a part of a type.
    (!given.contains("..")).then_some((ty, given, &inside[end + 1..]))
}

/// What is before `AT`, and the address after it.
fn at(text: &str) -> (&str, Option<&str>) {
    let upper = text.to_ascii_uppercase();
    match upper.find(" AT ").or_else(|| upper.find("\tAT ")) {
        Some(at) => (text[..at].trim(), Some(text[at + 4..].trim())),
        None => (text.trim(), None),
    }
}

/// A value as it is written: `5`, `[1, 2(0)]`, `(speed := 1.5)`.
/// What a text says that a variable begins with.
pub fn initial_of(text: &str) -> Initial {
    initial_in(text, 0)
}

fn initial_in(text: &str, depth: usize) -> Initial {
    let text = text.trim();
    let inside = |open, close| text.strip_prefix(open)?.strip_suffix(close);
    let repeated = |part: &str| {
        let (times, value) = part.split_once('(')?;
        let value = initial_in(value.strip_suffix(')')?, depth + 1);
        Some((times.trim().parse().ok()?, value))
    };
    if let Some(values) = inside('[', ']').filter(|_| depth < DEEPEST) {
        let values =
            parts(values).map(|part| repeated(part).unwrap_or_else(|| (1, initial_in(part, depth + 1))));
        return Initial::Array(values.collect());
    }
    let members = inside('(', ')').filter(|_| depth < DEEPEST);
    let members = members.and_then(|members| {
        let members = parts(members).map(|part| {
            let (name, value) = part.split_once(":=")?;
            Some((name.trim().to_owned(), initial_in(value, depth + 1)))
        });
        members.collect()
    });
    members.map_or_else(|| Initial::Simple(text.to_owned()), Initial::Structure)
}

/// The parts of a list between its commas, each without blanks around it.
fn parts(text: &str) -> impl Iterator<Item = &str> {
    let (mut depth, mut is_text, mut is_plain) = (0_i32, false, true);
    text.split(move |c| {
        match c {
            _ if !is_plain => is_plain = true,
            '$' if is_text => is_plain = false,
            '\'' => is_text = !is_text,
            '(' | '[' if !is_text => depth += 1,
            ')' | ']' if !is_text => depth -= 1,
            _ => {}
        }
        c == ',' && depth == 0 && !is_text
    })
    .map(str::trim)
}

/// The type that a text names.
pub fn type_of(text: &str) -> Type {
    type_in(text, 0)
}

/// Arrays are of arrays no deeper.
const DEEPEST: usize = 8;

fn type_in(text: &str, depth: usize) -> Type {
    let upper = text.to_ascii_uppercase();
    let word = upper.split_whitespace().next().unwrap_or_default();
    match word {
        "POINTER" | "REFERENCE" => return Type::Other(format!("`{text}`, which is an address,")),
        "UNION" => return Type::Other("a UNION, which is memory by address,".to_owned()),
        _ => {}
    }
    if let Some(rest) = upper.strip_prefix("ARRAY") {
        let shown = || Type::Other(format!("`{text}`"));
        let (Some(open), Some(close)) = (rest.find('['), rest.find(']')) else {
            return shown();
        };
        let after = rest.get(close + 1..).unwrap_or_default();
        let blanks = after.len() - after.trim_start().len();
        let is_of = after
            .trim_start()
            .strip_prefix("OF")
            .is_some_and(|ty| ty.starts_with([' ', '\t', '\r', '\n']));
        if !is_of || open > close || depth >= DEEPEST {
            return shown();
        }
        let of = close + 1 + blanks + "OF".len();
        let offset = text.len() - rest.len();
        let bounds: Option<Vec<(String, String)>> = rest[open + 1..close]
            .split(',')
            .map(|bound| {
                let (low, high) = bound.split_once("..")?;
                Some((low.trim().to_owned(), high.trim().to_owned()))
            })
            .collect();
        let Some(bounds) = bounds else { return shown() };
        return Type::Array(bounds, Box::new(type_in(text[offset + of..].trim(), depth + 1)));
    }
    let is_end = |rest: &&str| !rest.starts_with(|c: char| c.is_alphanumeric() || c == '_');
    if let Some(rest) = upper.strip_prefix("STRING").filter(is_end) {
        let length = rest.trim().trim_matches(['[', ']', '(', ')']).trim();
        if !length.is_empty() && length.parse::<u32>().is_err() {
            return Type::Other(format!("`{text}`, whose length is computed,"));
        }
        return Type::Text(length.parse().ok());
    }
    if let Some((ty, range)) = text.strip_suffix(')').and_then(|text| text.split_once('('))
        && let Some((low, high)) = range.split_once("..")
    {
        return Type::Range(
            ty.trim().to_owned(),
            low.trim().to_owned(),
            high.trim().to_owned(),
        );
    }
    // The name of a library is before the name in it.
    let is_path = text
        .chars()
        .all(|c| c.is_alphanumeric() || matches!(c, '_' | '.'));
    let name = text.rsplit('.').next().filter(|_| is_path).unwrap_or(text);
    Type::Named(name.to_owned())
}
