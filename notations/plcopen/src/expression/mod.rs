//! Expressions of IEC 61131-3 as operands of ladder text.

mod tokens;

use super::model::Type;
use super::own;
use super::scope::{Scope, Shared, member, trigger};
use super::standard;
use ladder_analysis::values::types::{Scalar, passes};
use tokens::{Token, tokens};

/// An operand.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Operand {
    /// As it is written here.
    pub(crate) text: String,
    pub(crate) form: Form,
    /// Its type, where that is known.
    pub(crate) ty: Option<Type>,
    /// The tags that it reads, each without members and indices, in small letters.
    pub(crate) reads: Vec<String>,
}

/// What an operand is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Form {
    Literal,
    /// A tag, or a part of one.
    Path,
    /// `NOT` of a tag.
    NotPath,
    /// A TIME of which the number of milliseconds is meant; the text is the TIME.
    Milliseconds,
    /// Anything else.
    Expression,
}

/// Parentheses nest no deeper.
const DEEPEST: usize = 40;

/// What names mean in a unit.
#[derive(Clone, Copy)]
pub(crate) struct Meaning<'m> {
    pub(crate) shared: &'m Shared<'m>,
    pub(crate) scope: &'m Scope,
}

/// The operand that an expression is.
///
/// # Errors
///
/// Why it has no counterpart.
pub(crate) fn operand(text: &str, meaning: Meaning<'_>) -> Result<Operand, String> {
    if let Some((call, inner)) = text
        .trim()
        .strip_suffix(')')
        .and_then(|text| text.split_once('('))
        && let Some(standard::Function::Convert(to)) = standard::function(call.trim())
        && let Ok(inner) = operand(inner, meaning)
        && inner
            .ty
            .as_ref()
            .is_some_and(|from| passes_to(meaning.shared.real(from), to))
    {
        return Ok(Operand {
            ty: Some(named(to)),
            ..inner
        });
    }
    if let Some(bit) = own::as_bit(text)
        && let Ok(bit) = operand(&bit, meaning)
    {
        return Ok(Operand {
            ty: Some(named("BOOL")),
            ..bit
        });
    }
    if let Some(time) = own::in_milliseconds(text) {
        let time = operand(time, meaning)?;
        let is_time = time.form != Form::Expression && time.ty == Some(named("TIME"));
        return is_time
            .then_some(Operand {
                form: Form::Milliseconds,
                ty: Some(named("LREAL")),
                ..time
            })
            .ok_or_else(|| "a number of milliseconds is that of a TIME".to_owned());
    }
    let tokens = tokens(text, meaning)?;
    let mut parser = Parser {
        tokens: &tokens,
        at: 0,
        meaning,
        depth: 0,
        reads: Vec::new(),
        compares: false,
        has_real: false,
        pieces: 0,
    };
    if tokens.is_empty() {
        return Err("there is no variable".to_owned());
    }
    let (out, ty) = parser.sequence()?;
    if parser.at < tokens.len() {
        return Err("its parentheses do not match".to_owned());
    }
    let form = match (&tokens[..], parser.pieces) {
        ([Token::Literal(..)] | [Token::Sign("-"), Token::Literal(..)], _) => Form::Literal,
        ([Token::Word(word)], _) if is_truth(word) => Form::Literal,
        ([Token::Word(_) | Token::Enumerator(_), ..], 1) if tokens.get(1) != Some(&Token::Sign("(")) => {
            Form::Path
        }
        ([Token::Word(_), ..], 2)
            if out
                .strip_prefix("NOT ")
                .is_some_and(|rest| !rest.contains([' ', '('])) =>
        {
            Form::NotPath
        }
        _ => Form::Expression,
    };
    if out.len() > LONGEST {
        return Err(format!("it is longer than {LONGEST} characters"));
    }
    if !is_well_formed(&out) {
        return Err("it is no expression".to_owned());
    }
    let ty = match ty {
        _ if parser.compares => Some(named("BOOL")),
        None if parser.has_real => Some(named("LREAL")),
        ty => ty,
    };
    Ok(Operand {
        text: out,
        form,
        ty,
        reads: parser.reads,
    })
}

/// Whether ladder text can have it as an operand.
fn is_well_formed(text: &str) -> bool {
    let is_name = |c: char| c.is_alphanumeric() || c == '_';
    (text.chars().all(is_name) && !ladder_syntax::is_reserved(text))
        || ladder_syntax::parse(&format!("+--[CALC]( y, {text} )--+\n"))
            .errors()
            .is_empty()
}

/// An operand is no longer: it is drawn wherever it is used.
const LONGEST: usize = 500;

fn named(name: &str) -> Type {
    Type::Named(name.to_owned())
}

/// Whether a value passes to a type without being converted.
fn passes_to(from: &Type, to: &str) -> bool {
    let scalar = |name: &str| Scalar::from_name(standard::elementary(name)?);
    let from = match from {
        Type::Named(name) => scalar(name),
        _ => None,
    };
    from.zip(scalar(to)).is_some_and(|(from, to)| passes(from, to))
}

fn is_truth(word: &str) -> bool {
    word.eq_ignore_ascii_case("TRUE") || word.eq_ignore_ascii_case("FALSE")
}

struct Parser<'t, 'm> {
    tokens: &'t [Token],
    at: usize,
    meaning: Meaning<'m>,
    depth: usize,
    reads: Vec<String>,
    compares: bool,
    /// A number with a point is in it.
    has_real: bool,
    /// How many things stand next to each other outside parentheses; one in parentheses is what it is without.
    pieces: usize,
}

impl Parser<'_, '_> {
    /// Everything up to a closing parenthesis, or the end.
    fn sequence(&mut self) -> Result<(String, Option<Type>), String> {
        if self.depth > DEEPEST {
            return Err(format!("its parentheses nest deeper than {DEEPEST}"));
        }
        let mut out = String::new();
        let mut found: Option<Type> = None;
        while let Some(token) = self.tokens.get(self.at) {
            let (piece, ty) = match token {
                Token::Sign(")" | "]" | ",") => break,
                Token::Sign("(") => {
                    self.at += 1;
                    let (inner, ty) = self.nested(")")?;
                    // NOT( a ) is NOT a.
                    let alone = out == "NOT" && !inner.contains(' ');
                    (if alone { inner } else { format!("({inner})") }, ty)
                }
                Token::Sign(sign @ ("[" | ".")) => return Err(format!("a `{sign}` has nothing before it")),
                Token::Enumerator(text) => {
                    self.at += 1;
                    (text.clone(), None)
                }
                Token::Sign(sign) => {
                    self.at += 1;
                    self.compares |= matches!(*sign, "=" | "<>" | "<" | "<=" | ">" | ">=");
                    ((*sign).to_owned(), None)
                }
                // A number takes the type of what is next to it.
                Token::Literal(text, Some("LREAL")) if !text.contains('#') => {
                    self.at += 1;
                    self.has_real = true;
                    (text.clone(), None)
                }
                Token::Literal(text, ty) => {
                    self.at += 1;
                    (text.clone(), ty.map(named))
                }
                Token::Word(word) => self.word(word)?,
            };
            found = found.or(ty);
            self.pieces += usize::from(self.depth == 0);
            let sign = out.is_empty() || out.ends_with('(') || (out.len() == 1 && out.starts_with('-'));
            if !sign {
                out.push(' ');
            }
            out.push_str(&piece);
        }
        if out.is_empty() {
            return Err("something is missing in it".to_owned());
        }
        Ok((out, found))
    }

    /// What is in parentheses, with what closes them.
    fn nested(&mut self, close: &'static str) -> Result<(String, Option<Type>), String> {
        self.depth += 1;
        let mut parts = Vec::new();
        let mut found = None;
        loop {
            let (part, ty) = self.sequence()?;
            found = found.or(ty);
            parts.push(part);
            match self.tokens.get(self.at) {
                Some(Token::Sign(",")) => self.at += 1,
                Some(Token::Sign(sign)) if *sign == close => break,
                _ => return Err("its parentheses do not match".to_owned()),
            }
        }
        self.at += 1;
        self.depth -= 1;
        Ok((parts.join(", "), found))
    }

    fn word(&mut self, word: &str) -> Result<(String, Option<Type>), String> {
        self.at += 1;
        let upper = word.to_ascii_uppercase();
        if matches!(upper.as_str(), "AND" | "OR" | "XOR" | "NOT" | "MOD") {
            return Ok((upper, None));
        }
        if is_truth(word) {
            return Ok((upper, Some(named("BOOL"))));
        }
        if self.next_is("(") {
            return self.call(word);
        }
        self.path(word)
    }

    fn next_is(&self, sign: &str) -> bool {
        matches!(self.tokens.get(self.at), Some(Token::Sign(next)) if *next == sign)
    }

    fn call(&mut self, word: &str) -> Result<(String, Option<Type>), String> {
        let unknown = || format!("`{word}` is no function that an expression can have here");
        let function = standard::function(word).ok_or_else(unknown)?;
        self.at += 1;
        let (inner, ty) = self.nested(")")?;
        match function {
            standard::Function::Value(mnemonic) => Ok((format!("{mnemonic}({inner})"), ty)),
            standard::Function::Convert(to)
                if ty
                    .as_ref()
                    .is_some_and(|from| passes_to(self.meaning.shared.real(from), to)) =>
            {
                let is_single = !inner.contains([' ', ',']);
                let text = if is_single { inner } else { format!("({inner})") };
                Ok((text, Some(named(to))))
            }
            _ => Err(unknown()),
        }
    }

    /// A variable, with members and indices.
    fn path(&mut self, word: &str) -> Result<(String, Option<Type>), String> {
        if let Some(address) = word.strip_prefix('%') {
            let text = address_of(word).ok_or_else(|| format!("`%{address}` is no address here"))?;
            self.reads.push(text.to_lowercase());
            let ty = match text.as_bytes()[2] {
                b'X' => "BOOL",
                b'B' => "BYTE",
                b'W' => "WORD",
                b'D' => "DWORD",
                _ => "LWORD",
            };
            return Ok((text, Some(named(ty))));
        }
        let Meaning { shared, scope } = self.meaning;
        let known = scope.get(word).or_else(|| shared.globals.get(word));
        let (mut out, mut ty) = match known {
            Some(known) => (known.spelled.clone(), Some(known.ty.clone())),
            // A list of globals in CODESYS: GVL.name.
            None => match self.global_in_list() {
                Some(found) => found,
                None => (member(word), None),
            },
        };
        self.reads.push(out.to_lowercase());
        loop {
            if self.next_is("[") {
                self.at += 1;
                let (inner, _) = self.nested("]")?;
                out.push_str(&format!("[{inner}]"));
                ty = ty.and_then(|ty| match shared.real(&ty) {
                    Type::Array(_, of) => Some((**of).clone()),
                    _ => None,
                });
                continue;
            }
            if !self.next_is(".") {
                break;
            }
            self.at += 1;
            match self.tokens.get(self.at) {
                Some(Token::Word(name)) => {
                    self.at += 1;
                    if ty.as_ref().and_then(trigger).is_some() {
                        ty = Some(named("BOOL"));
                        continue;
                    }
                    (out, ty) = self.member(out, ty, name);
                }
                Some(Token::Literal(bit, None)) if bit.bytes().all(|c| c.is_ascii_digit()) => {
                    self.at += 1;
                    out.push_str(&format!(".{bit}"));
                    ty = Some(named("BOOL"));
                }
                _ => return Err("a point stands where nothing follows".to_owned()),
            }
        }
        Ok((out, ty))
    }

    fn global_in_list(&mut self) -> Option<(String, Option<Type>)> {
        let (Some(Token::Sign(".")), Some(Token::Word(name))) =
            (self.tokens.get(self.at), self.tokens.get(self.at + 1))
        else {
            return None;
        };
        let known = self.meaning.shared.globals.get(name)?;
        self.at += 2;
        Some((known.spelled.clone(), Some(known.ty.clone())))
    }

    fn member(&self, of: String, ty: Option<Type>, name: &str) -> (String, Option<Type>) {
        let shared = self.meaning.shared;
        let Some(ty) = ty else {
            return (format!("{of}.{}", member(name)), None);
        };
        if let Some(block) = shared.block_of(&ty)
            && let Some(known) = block.scope.get(name)
        {
            return (format!("{of}.{}", known.spelled), Some(known.ty.clone()));
        }
        if let Type::Named(block) = &ty
            && standard::block(block).is_some()
        {
            let name = name.to_ascii_uppercase();
            let ty = standard::output_type(&name);
            return (format!("{of}.{name}"), Some(named(ty)));
        }
        let found = shared.members(&ty).and_then(|members| {
            let found = members.iter().find(|one| one.name.eq_ignore_ascii_case(name));
            found.map(|found| (member(&found.name), found.ty.clone()))
        });
        match found {
            Some((name, ty)) => (format!("{of}.{name}"), Some(ty)),
            None => (format!("{of}.{}", member(name)), None),
        }
    }
}

/// An address as ladder text has it: `%IX0.3`. None: it has more levels than there are here, or none.
pub(crate) fn address_of(text: &str) -> Option<String> {
    let upper = text.trim().to_ascii_uppercase();
    let rest = upper.strip_prefix('%')?;
    let area = rest.chars().next().filter(|area| "IQM".contains(*area))?;
    let rest = &rest[1..];
    let (size, number) = match rest.chars().next()? {
        size @ ('X' | 'B' | 'W' | 'D' | 'L') => (size, &rest[1..]),
        _ => ('X', rest),
    };
    let mut levels = number.split('.');
    let mut level = || -> Option<u32> { levels.next()?.parse().ok() };
    let first = level()?;
    let text = match (size, level()) {
        ('X', bit) => format!("%{area}X{first}.{}", bit?),
        (_, None) if !number.contains('.') => format!("%{area}{size}{first}"),
        _ => return None,
    };
    (levels.next().is_none()).then_some(text)
}
