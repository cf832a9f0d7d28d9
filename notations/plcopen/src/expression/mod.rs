//! Expressions of IEC 61131-3 as those of ladder text, with their types.

mod tokens;
mod types;

use super::model::Type;
use super::own;
use super::scope::{Known, Scope, Shared, member, trigger};
use super::standard;
use ladder_analysis::values::types::{Scalar, passes};
use ladder_format::program::{Expression, Literal, Operator, Path, Sign};
use tokens::{Token, tokens};
pub(crate) use types::{bound, computed, is_declared, type_text};

/// An expression and its type.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Typed {
    pub(crate) value: Expression,
    /// Where it is known.
    pub(crate) ty: Option<Type>,
    /// The value is a TIME, and the number of its milliseconds is meant.
    pub(crate) in_milliseconds: bool,
}

/// What an expression is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Form<'e> {
    Literal(&'e Literal),
    /// A tag, or a part of one.
    Path(&'e Path),
    /// `NOT` of a tag.
    NotPath(&'e Path),
    /// The number of milliseconds of a TIME.
    Milliseconds,
    /// Anything else.
    Formula,
}

impl Typed {
    pub(crate) fn of(value: impl Into<Expression>, ty: Option<Type>) -> Typed {
        Typed {
            value: value.into(),
            ty,
            in_milliseconds: false,
        }
    }

    pub(crate) fn form(&self) -> Form<'_> {
        match &self.value {
            _ if self.in_milliseconds => Form::Milliseconds,
            Expression::Literal(literal) => Form::Literal(literal),
            Expression::Path(path) => Form::Path(path),
            Expression::Unary(Sign::Not, inner) => inner.path().map_or(Form::Formula, Form::NotPath),
            _ => Form::Formula,
        }
    }

    /// Whether it is TRUE or FALSE, if it is one of them.
    pub(crate) fn truth(&self) -> Option<bool> {
        let Form::Literal(literal) = self.form() else {
            return None;
        };
        match literal.as_str() {
            "TRUE" | "BOOL#TRUE" | "BOOL#1" => Some(true),
            "FALSE" | "BOOL#FALSE" | "BOOL#0" => Some(false),
            _ => None,
        }
    }
}

/// The tags that an expression reads, each without members and indices, in small letters.
pub(crate) fn reads(value: &Expression) -> Vec<String> {
    let mut reads = Vec::new();
    value.paths(&mut |path| reads.push(path.root.to_lowercase()));
    reads
}

/// Parentheses and signs nest no deeper.
const DEEPEST: usize = 40;

/// An operand is no longer: it is drawn wherever it is used.
const LONGEST: usize = 500;

/// What names mean in a unit.
#[derive(Clone, Copy)]
pub(crate) struct Meaning<'m> {
    pub(crate) shared: &'m Shared<'m>,
    pub(crate) scope: &'m Scope,
}

/// The operand that a text is.
///
/// # Errors
///
/// Why it has no counterpart.
pub(crate) fn operand(text: &str, meaning: Meaning<'_>) -> Result<Typed, String> {
    if let Some((number, bit)) = own::as_bit(text)
        && let Ok(Expression::Path(path)) = operand(number, meaning).map(|number| number.value)
    {
        return Ok(Typed::of(path.bit(bit), Some(named("BOOL"))));
    }
    if let Some(time) = own::in_milliseconds(text) {
        let time = operand(time, meaning)?;
        let is_time = time.form() != Form::Formula && time.ty == Some(named("TIME"));
        return is_time
            .then_some(Typed {
                in_milliseconds: true,
                ty: Some(named("LREAL")),
                ..time
            })
            .ok_or_else(|| "a number of milliseconds is that of a TIME".to_owned());
    }
    let tokens = tokens(text, meaning)?;
    if tokens.is_empty() {
        return Err("there is no variable".to_owned());
    }
    let mut parser = Parser {
        tokens: &tokens,
        at: 0,
        meaning,
        depth: 0,
        has_real: false,
    };
    let (value, ty) = parser.expression(0)?;
    match parser.token() {
        None => {}
        Some(Token::Sign(")" | "]" | ",")) => return Err("its parentheses do not match".to_owned()),
        Some(_) => return Err("it is no expression".to_owned()),
    }
    value.check()?;
    if value.to_string().len() > LONGEST {
        return Err(format!("it is longer than {LONGEST} characters"));
    }
    let ty = ty.or_else(|| parser.has_real.then(|| named("LREAL")));
    // A number with its sign is one literal where nothing else is.
    if let Expression::Unary(Sign::Minus, inner) = &value
        && let Expression::Literal(number) = &**inner
        && let Ok(negative) = Literal::read(format!("-{}", number.as_str()))
    {
        return Ok(Typed::of(negative, ty));
    }
    Ok(Typed::of(value, ty))
}

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

/// An expression, and its type where that is known.
type Found<E> = Result<(E, Option<Type>), String>;

struct Parser<'t, 'm> {
    tokens: &'t [Token],
    at: usize,
    meaning: Meaning<'m>,
    depth: usize,
    /// A number with a point is in it.
    has_real: bool,
}

impl<'t, 'm> Parser<'t, 'm> {
    fn token(&self) -> Option<&'t Token> {
        self.tokens.get(self.at)
    }

    fn next_is(&self, sign: &str) -> bool {
        matches!(self.token(), Some(Token::Sign(next)) if *next == sign)
    }

    /// An expression whose operators all bind more tightly than `floor`.
    fn expression(&mut self, floor: u8) -> Found<Expression> {
        let (mut left, mut ty) = self.signed()?;
        while let Some(operator) = self.operator().filter(|operator| operator.binding() > floor) {
            self.at += 1;
            let (right, other) = self.expression(operator.binding())?;
            left = left.with(operator, right);
            ty = if operator.compares() {
                Some(named("BOOL"))
            } else {
                ty.or(other)
            };
        }
        Ok((left, ty))
    }

    fn operator(&self) -> Option<Operator> {
        match self.token()? {
            Token::Sign(sign) => Operator::of(sign),
            Token::Word(word) => Operator::of(&word.to_ascii_uppercase()),
            _ => None,
        }
    }

    /// A value with the signs before it.
    fn signed(&mut self) -> Found<Expression> {
        if self.depth > DEEPEST {
            return Err(format!("its parentheses nest deeper than {DEEPEST}"));
        }
        let sign = match self.token() {
            Some(Token::Sign("-")) => Sign::Minus,
            Some(Token::Word(word)) if word.eq_ignore_ascii_case("NOT") => Sign::Not,
            _ => return self.value(),
        };
        self.at += 1;
        self.depth += 1;
        let (inner, ty) = self.signed()?;
        self.depth -= 1;
        let inner = match inner {
            // NOT( a ) is NOT a.
            Expression::Group(alone) if alone.path().is_some() => alone,
            inner => Box::new(inner),
        };
        Ok((Expression::Unary(sign, inner), ty))
    }

    fn value(&mut self) -> Found<Expression> {
        let (value, ty) = match self.token() {
            Some(Token::Sign("(")) => {
                let (inner, ty) = self.nested(")")?;
                return Ok((Expression::Group(Box::new(single(inner)?)), ty));
            }
            Some(Token::Sign(sign @ ("[" | "."))) => return Err(format!("a `{sign}` has nothing before it")),
            Some(Token::Word(word)) if self.operator().is_none() => return self.word(word),
            Some(Token::Enumerator(path)) => (path.into(), None),
            // A number takes the type of what is next to it.
            Some(Token::Literal(literal, Some("LREAL"))) if !literal.as_str().contains('#') => {
                self.has_real = true;
                (literal.clone().into(), None)
            }
            Some(Token::Literal(literal, ty)) => (literal.clone().into(), ty.map(named)),
            _ => return Err("something is missing in it".to_owned()),
        };
        self.at += 1;
        Ok((value, ty))
    }

    /// What is in parentheses, from the sign that opens them to the one that closes them.
    fn nested(&mut self, close: &'static str) -> Found<Vec<Expression>> {
        self.at += 1;
        self.depth += 1;
        let mut parts = Vec::new();
        let mut found = None;
        loop {
            let (part, ty) = self.expression(0)?;
            found = found.or(ty);
            parts.push(part);
            match self.token() {
                Some(Token::Sign(",")) => self.at += 1,
                Some(Token::Sign(sign)) if *sign == close => break,
                _ => return Err("its parentheses do not match".to_owned()),
            }
        }
        self.at += 1;
        self.depth -= 1;
        Ok((parts, found))
    }

    fn word(&mut self, word: &str) -> Found<Expression> {
        self.at += 1;
        for truth in [true, false] {
            let literal = Literal::from(truth);
            if literal.as_str().eq_ignore_ascii_case(word) {
                return Ok((literal.into(), Some(named("BOOL"))));
            }
        }
        if self.next_is("(") {
            return self.call(word);
        }
        self.path(word).map(|(path, ty)| (path.into(), ty))
    }

    fn call(&mut self, word: &str) -> Found<Expression> {
        let unknown = || format!("`{word}` is no function that an expression can have here");
        let function = standard::function(word).ok_or_else(unknown)?;
        let (inner, ty) = self.nested(")")?;
        match function {
            standard::Function::Value(mnemonic) => Ok((Expression::call(mnemonic, inner), ty)),
            standard::Function::Convert(to)
                if ty
                    .as_ref()
                    .is_some_and(|from| passes_to(self.meaning.shared.real(from), to)) =>
            {
                Ok((single(inner)?, Some(named(to))))
            }
            _ => Err(unknown()),
        }
    }

    /// A variable, with members and indices.
    fn path(&mut self, word: &str) -> Found<Path> {
        if let Some(address) = word.strip_prefix('%') {
            let text = address_of(word).ok_or_else(|| format!("`%{address}` is no address here"))?;
            let ty = match text.as_bytes()[2] {
                b'X' => "BOOL",
                b'B' => "BYTE",
                b'W' => "WORD",
                b'D' => "DWORD",
                _ => "LWORD",
            };
            return Ok((Path::tag(text), Some(named(ty))));
        }
        let Meaning { shared, scope } = self.meaning;
        if let (true, Some(Token::Word(member))) = (self.next_is("."), self.tokens.get(self.at + 1))
            && let Some((path, ty)) = scope.of_step(word, member)
        {
            self.at += 2;
            return Ok((path, Some(ty)));
        }
        let known = scope.get(word).or_else(|| shared.globals.get(word));
        // A list of globals in CODESYS: GVL.name.
        let known = known.or_else(|| self.global_in_list());
        let (mut path, mut ty) = match known {
            Some(known) => (known.path.clone(), Some(known.ty.clone())),
            None => (Path::tag(member(word)), None),
        };
        loop {
            if let Some(Err(why)) = ty.as_ref().map(|ty| type_text(shared, ty)) {
                return Err(format!("`{path}` is not declared here: {why}"));
            }
            if self.next_is("[") {
                let (indices, _) = self.nested("]")?;
                path = path.index(indices);
                ty = ty.and_then(|ty| match shared.real(&ty) {
                    Type::Array(_, of) => Some((**of).clone()),
                    _ => None,
                });
                continue;
            }
            if !self.next_is(".") {
                break;
            }
            let next = self.tokens.get(self.at + 1);
            self.at += 2;
            match next {
                Some(Token::Word(_)) if ty.as_ref().and_then(trigger).is_some() => {
                    ty = Some(named("BOOL"));
                }
                Some(Token::Word(name)) => {
                    let (member, of) = self.member(ty, name);
                    path = path.member(member);
                    ty = of;
                }
                Some(Token::Literal(bit, None)) => {
                    let bit = bit.as_str().parse();
                    path = path.bit(bit.map_err(|_| "there is no bit of such a number")?);
                    ty = Some(named("BOOL"));
                }
                _ => return Err("a point stands where nothing follows".to_owned()),
            }
        }
        Ok((path, ty))
    }

    fn global_in_list(&mut self) -> Option<&'m Known> {
        let (Some(Token::Sign(".")), Some(Token::Word(name))) = (self.token(), self.tokens.get(self.at + 1))
        else {
            return None;
        };
        let known = self.meaning.shared.globals.get(name)?;
        self.at += 2;
        Some(known)
    }

    /// A member of something, and its type.
    fn member(&self, of: Option<Type>, name: &str) -> (String, Option<Type>) {
        let shared = self.meaning.shared;
        let Some(of) = of else {
            return (member(name), None);
        };
        if let Some(block) = shared.block_of(&of)
            && let Some(known) = block.scope.get(name)
        {
            return (known.path.root.clone(), Some(known.ty.clone()));
        }
        if let Type::Named(block) = &of
            && standard::block(block).is_some()
        {
            let name = name.to_ascii_uppercase();
            let ty = standard::output_type(&name);
            return (name, Some(named(ty)));
        }
        let mut members = shared.members(&of).into_iter().flatten();
        match members.find(|one| one.name.eq_ignore_ascii_case(name)) {
            Some(found) => (member(&found.name), Some(found.ty.clone())),
            None => (member(name), None),
        }
    }
}

/// The one expression that parentheses hold.
fn single(parts: Vec<Expression>) -> Result<Expression, String> {
    let [one] = <[Expression; 1]>::try_from(parts).map_err(|_| "it is no expression")?;
    Ok(one)
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
