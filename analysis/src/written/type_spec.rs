//! Types as declarations write them, before the names in them are looked up. That follows from a file's own text alone, so
//! this is what one file shows to the others.

use super::refused_name::{Place, refused_name};
use crate::findings::did_you_mean;
use crate::values::literal::{Literal, literal};
use crate::values::types::{Scalar, Type};
use crate::values::value::Value;
use crate::written::facts::{self, Node};
use ladder_instructions::StateType;
use ladder_syntax::ast::{AstNode, Bound, Expression, TypeRef};
use ladder_syntax::{Name, SyntaxKind, TextRange, TextSize};
use rustc_hash::{FxHashMap, FxHashSet};
use smol_str::SmolStr;
use std::sync::Arc;

/// The longest array: what still shows and saves quickly.
const MAX_ELEMENTS: i128 = 1_000_000;
/// The longest STRING.
const MAX_STRING: i128 = 32_767;
/// IEC 61131-3 leaves the number of dimensions to the implementer.
const MOST_DIMENSIONS: usize = 3;

/// What is wrong with a type, and where.
pub(crate) type TypeProblem = (TextRange, String);

/// Whole numbers that are CONSTANT in a file, for bounds.
pub(crate) type Constants = FxHashMap<Name, i128>;

/// The lowest and the highest value.
pub(crate) type Limits = (i128, i128);

/// A type as it is written. Places do not count where two are compared.
#[derive(Debug, Clone)]
pub struct TypeSpec {
    /// What it is.
    pub kind: SpecKind,
    /// Where it is, from the start of the file.
    pub range: TextRange,
}

/// The forms of a type.
#[derive(Debug, Clone)]
pub enum SpecKind {
    /// An elementary type, a state, an array of elementary values.
    Known(Type),
    /// `INT(5..9)`: such a tag starts with the lowest value.
    Subrange(Scalar, Limits),
    /// `Motor`
    Named(SmolStr),
    /// `$Motor`
    Block(SmolStr),
    /// Any other array: first and last index of each dimension, and the type of its elements.
    Array(Vec<(i64, i64)>, Box<TypeSpec>),
    /// `(IDLE, FILLING)`: names with their places and numbers.
    Enumeration(Vec<(SmolStr, TextRange, i32)>),
    /// `STRUCT`
    Structure(Vec<MemberSpec>),
    /// A member's type that means nothing: something was reported about that.
    Unread,
}

/// A member of a structure as it is written.
#[derive(Debug, Clone)]
pub struct MemberSpec {
    /// As declared.
    pub name: SmolStr,
    /// Where its name is, from the start of the file.
    pub at: TextRange,
    /// Its type and value.
    pub declared: Declared,
}

/// What a declaration says of a tag, member or type: its type and its value at the start.
#[derive(Debug, Clone)]
pub struct Declared {
    /// The type.
    pub spec: TypeSpec,
    /// The value.
    pub initial: Option<Initial>,
}

/// A value at the start as it is written.
#[derive(Debug, Clone)]
pub struct Initial {
    /// The value; its places count from the start of its line.
    pub node: Node,
    /// Where that line starts.
    pub start: TextSize,
    /// The text of that line up to the end of the value: it may be a line of another file.
    pub line: SmolStr,
}

/// A type as its file declares it.
#[derive(Debug, Clone, PartialEq)]
pub struct DeclaredType {
    /// As declared.
    pub name: SmolStr,
    /// As it is compared.
    pub key: Name,
    /// Where its name is, from the start of the file.
    pub at: TextRange,
    /// What it says.
    pub declared: Arc<Declared>,
}

impl PartialEq for TypeSpec {
    fn eq(&self, other: &TypeSpec) -> bool {
        let same = |one: &SmolStr, other: &SmolStr| Name::new(one) == Name::new(other);
        match (&self.kind, &other.kind) {
            (SpecKind::Known(one), SpecKind::Known(other)) => one == other,
            (SpecKind::Subrange(one, limits), SpecKind::Subrange(other, limits_too)) => {
                (one, limits) == (other, limits_too)
            }
            (SpecKind::Named(one), SpecKind::Named(other))
            | (SpecKind::Block(one), SpecKind::Block(other)) => same(one, other),
            (SpecKind::Array(bounds, element), SpecKind::Array(bounds_too, element_too)) => {
                bounds == bounds_too && element == element_too
            }
            (SpecKind::Enumeration(one), SpecKind::Enumeration(other)) => {
                let values = one.iter().zip(other);
                one.len() == other.len()
                    && values
                        .into_iter()
                        .all(|(one, other)| (&one.0, one.2) == (&other.0, other.2))
            }
            (SpecKind::Structure(one), SpecKind::Structure(other)) => {
                let members = one.iter().zip(other);
                one.len() == other.len()
                    && members
                        .into_iter()
                        .all(|(one, other)| one.name == other.name && one.declared == other.declared)
            }
            (SpecKind::Unread, SpecKind::Unread) => true,
            // Each kind by name: one that is forgotten here would not even equal itself.
            (
                SpecKind::Known(_)
                | SpecKind::Subrange(..)
                | SpecKind::Named(_)
                | SpecKind::Block(_)
                | SpecKind::Array(..)
                | SpecKind::Enumeration(_)
                | SpecKind::Structure(_)
                | SpecKind::Unread,
                _,
            ) => false,
        }
    }
}

impl PartialEq for Declared {
    fn eq(&self, other: &Declared) -> bool {
        let written = |declared: &Declared| declared.initial.as_ref().map(Initial::without_blanks);
        self.spec == other.spec && written(self) == written(other)
    }
}

impl Initial {
    /// The value that is written so on a line that starts here and has this text.
    pub(crate) fn new(value: &Expression<'_>, start: TextSize, line: &str) -> Initial {
        Initial {
            node: facts::node(value),
            start,
            line: line[..usize::from(value.range().end())].into(),
        }
    }

    /// As it is written, but for blanks outside of texts: to compare two.
    fn without_blanks(&self) -> String {
        let mut quoted = false;
        let written = self.line[usize::from(self.node.range.start())..].chars();
        let kept = written.filter(|c| {
            quoted ^= *c == '\'';
            quoted || !c.is_whitespace()
        });
        kept.collect()
    }
}

impl TypeSpec {
    /// Whether it says all by itself: no name in it is to be looked up.
    pub(crate) fn known(&self) -> Option<Type> {
        match self.kind {
            SpecKind::Known(ty) => Some(ty),
            _ => None,
        }
    }

    /// Every user-defined block whose state is in it, with the place of its name.
    pub fn each_block<'s>(&'s self, give: &mut impl FnMut(&'s SmolStr, TextRange)) {
        match &self.kind {
            SpecKind::Block(name) => give(name, self.range),
            SpecKind::Array(_, element) => element.each_block(give),
            SpecKind::Structure(members) => {
                for member in members {
                    member.declared.spec.each_block(give);
                }
            }
            _ => {}
        }
    }

    /// Every member of the structure that it is, or that is written in it.
    pub(crate) fn each_member<'s>(&'s self, give: &mut impl FnMut(&'s MemberSpec)) {
        match &self.kind {
            SpecKind::Array(_, element) => element.each_member(give),
            SpecKind::Structure(members) => members.iter().for_each(give),
            _ => {}
        }
    }

    /// Every name of a type in it, with its place.
    pub fn each_name<'s>(&'s self, give: &mut impl FnMut(&'s SmolStr, TextRange)) {
        match &self.kind {
            SpecKind::Named(name) => give(name, self.range),
            SpecKind::Array(_, element) => element.each_name(give),
            SpecKind::Structure(members) => {
                for member in members {
                    member.declared.spec.each_name(give);
                }
            }
            _ => {}
        }
    }
}

/// The type that a declaration writes, on a line that starts here. None: something is wrong with all of it, which is among the
/// problems, or the parser said it. Places of problems count from the start of the line.
pub(crate) fn read(
    type_ref: &TypeRef<'_>,
    start: TextSize,
    constants: &Constants,
    out: &mut Vec<TypeProblem>,
) -> Option<TypeSpec> {
    spec(type_ref, start, constants, out).unwrap_or_else(|problem| {
        out.push(problem);
        None
    })
}

fn spec(
    type_ref: &TypeRef<'_>,
    start: TextSize,
    constants: &Constants,
    out: &mut Vec<TypeProblem>,
) -> Result<Option<TypeSpec>, TypeProblem> {
    let range = type_ref.range() + start;
    if type_ref.is_enumeration() {
        let kind = enumeration(type_ref, start, constants, out);
        return Ok(kind.map(|kind| TypeSpec { kind, range }));
    }
    let mut dimensions = Vec::new();
    let bounds = type_ref.dimensions();
    if type_ref.is_array() && (bounds.is_empty() || !bounds.len().is_multiple_of(2)) {
        return Ok(None);
    }
    if bounds.len() > 2 * MOST_DIMENSIONS {
        return Err((
            type_ref.range(),
            format!("an array has at most {MOST_DIMENSIONS} dimensions: make its elements arrays"),
        ));
    }
    for pair in bounds.chunks_exact(2) {
        dimensions.push(dimension(type_ref, &pair[0], &pair[1], constants)?);
    }
    let element = match type_ref.element() {
        Some(inner) => spec(&inner, start, constants, out)?,
        None => simple(type_ref, start, constants)?,
    };
    let Some(element) = element else { return Ok(None) };
    let kind = match (dimensions.as_slice(), &element.kind) {
        ([], _) => return Ok(Some(element)),
        (&[(first, last)], SpecKind::Known(Type::Scalar(element))) => SpecKind::Known(Type::Array {
            first,
            last,
            element: *element,
        }),
        _ => SpecKind::Array(dimensions, Box::new(element)),
    };
    Ok(Some(TypeSpec { kind, range }))
}

/// One dimension of an array.
fn dimension(
    type_ref: &TypeRef<'_>,
    first: &Bound<'_>,
    last: &Bound<'_>,
    constants: &Constants,
) -> Result<(i64, i64), TypeProblem> {
    let (first, last) = (number(first, constants)?, number(last, constants)?);
    if last < first {
        return Err((
            type_ref.range(),
            format!("the last index {last} is below the first {first}: swap them"),
        ));
    }
    if last - first >= MAX_ELEMENTS || first < -i128::from(i32::MAX) || last > i128::from(i32::MAX) {
        return Err((
            type_ref.range(),
            format!("an array has at most {MAX_ELEMENTS} elements"),
        ));
    }
    Ok((first as i64, last as i64))
}

/// What a type's name means, with what is in brackets after it.
fn simple(
    type_ref: &TypeRef<'_>,
    start: TextSize,
    constants: &Constants,
) -> Result<Option<TypeSpec>, TypeProblem> {
    let Some(name) = type_ref.name() else {
        return Ok(None);
    };
    let limits = type_ref.limits();
    let kind = if name.kind() == SyntaxKind::BLOCK_NAME {
        SpecKind::Block(name.text().into())
    } else {
        match Scalar::from_name(name.text()) {
            Some(Scalar::String(default)) => {
                let length = match limits.first() {
                    Some(length) => number(length, constants)?,
                    None => i128::from(default),
                };
                if !(1..=MAX_STRING).contains(&length) {
                    return Err((
                        type_ref.range(),
                        format!("a STRING holds 1 to {MAX_STRING} characters"),
                    ));
                }
                SpecKind::Known(Type::Scalar(Scalar::String(length as u16)))
            }
            Some(scalar) if limits.len() == 2 => subrange(type_ref, scalar, &limits, constants)?,
            Some(scalar) => SpecKind::Known(Type::Scalar(scalar)),
            None => {
                let mut states = StateType::ALL.into_iter();
                match states.find(|state| state.name().eq_ignore_ascii_case(name.text())) {
                    Some(state) => SpecKind::Known(Type::State(state)),
                    None => SpecKind::Named(name.text().into()),
                }
            }
        }
    };
    if limits.len() == 2 && !matches!(kind, SpecKind::Subrange(..)) {
        let message = format!(
            "`{}` is no integer: only those have a range of values",
            name.text()
        );
        return Err((type_ref.range(), message));
    }
    let range = name.text_range() + start;
    Ok(Some(TypeSpec { kind, range }))
}

/// `INT(0..100)`. As in IEC 61131-3 it starts with its lowest value.
fn subrange(
    type_ref: &TypeRef<'_>,
    scalar: Scalar,
    limits: &[Bound<'_>],
    constants: &Constants,
) -> Result<SpecKind, TypeProblem> {
    let (low, high) = (number(&limits[0], constants)?, number(&limits[1], constants)?);
    let Some((least, most)) = scalar.bounds().filter(|_| scalar.is_integer()) else {
        let message = format!("{scalar} is no integer: only those have a range of values");
        return Err((type_ref.range(), message));
    };
    if low < least || high > most || low > high {
        let message = format!("{low}..{high} is no range within {scalar}, which holds {least} to {most}");
        return Err((type_ref.range(), message));
    }
    Ok(SpecKind::Subrange(scalar, (low, high)))
}

/// `(IDLE, FILLING, MIXING := 10)`: from 0, or one past the one before. A value whose number means nothing has another one, so that
/// it is known where it is named.
fn enumeration(
    type_ref: &TypeRef<'_>,
    start: TextSize,
    constants: &Constants,
    out: &mut Vec<TypeProblem>,
) -> Option<SpecKind> {
    let mut values: Vec<(SmolStr, TextRange, i32)> = Vec::new();
    let mut names = FxHashSet::default();
    let mut numbers = FxHashMap::default();
    let mut next = 0i128;
    for value in type_ref.values() {
        let Some(name) = value.name() else { continue };
        let range = name.text_range();
        if let Some(message) = refused_name(name.text(), Place::Value) {
            out.push((range, message));
            continue;
        }
        if !names.insert(Name::new(name.text())) {
            out.push((range, format!("the value `{}` is there twice", name.text())));
            continue;
        }
        match value.number().map(|own| number(&own, constants)) {
            Some(Ok(own)) => next = own,
            Some(Err(problem)) => out.push(problem),
            None => {}
        }
        let own = i32::try_from(next).unwrap_or_else(|_| {
            let message = format!("the number of `{}` is {next}, which is no DINT", name.text());
            out.push((range, message));
            0
        });
        if let Some(other) = numbers.get(&own).filter(|_| i128::from(own) == next) {
            let message = format!(
                "`{}` has the number {own}, which is that of `{other}`",
                name.text()
            );
            out.push((range, message));
        }
        let free = (own..=i32::MAX)
            .chain(0..own)
            .find(|number| !numbers.contains_key(number))?;
        numbers.insert(free, name.text());
        values.push((name.text().into(), range + start, free));
        next = i128::from(free) + 1;
    }
    (!values.is_empty()).then_some(SpecKind::Enumeration(values))
}

/// A bound: a number, or a CONSTANT tag.
fn number(bound: &Bound<'_>, constants: &Constants) -> Result<i128, TypeProblem> {
    let (token, text) = (bound.token, bound.token.text());
    let found = if token.kind() == SyntaxKind::IDENT {
        constants
            .get(&Name::new(text))
            .copied()
            .ok_or_else(|| format!("`{text}` is no CONSTANT of this file with a whole number as its value"))
    } else {
        match literal(text) {
            Ok(Literal::Int(n)) => Ok(n),
            _ => Err(format!("`{text}` is not a whole number")),
        }
    };
    match found {
        Ok(n) => Ok(if bound.negative { -n } else { n }),
        Err(message) => Err((token.text_range(), message)),
    }
}

/// The types that are likeliest meant come first.
const TYPE_NAMES: [&str; 31] = [
    "BOOL", "INT", "DINT", "REAL", "TIME", "STRING", "WORD", "BYTE", "DWORD", "LWORD", "SINT", "LINT",
    "USINT", "UINT", "UDINT", "ULINT", "LREAL", "DATE", "TOD", "DT", "TON", "TOF", "TP", "RTO", "RTOF",
    "CTU", "CTD", "CTUD", "CTC", "SR", "RS",
];

/// The type that a name which nobody declares probably means: one of the language or one of these.
pub(crate) fn nearest_type<'n>(name: &str, declared: impl Iterator<Item = &'n str>) -> Option<&'n str> {
    let all = TYPE_NAMES.into_iter().chain(declared);
    did_you_mean::closest(name, all)
}

/// The value of a type's elementary part, of which there is only one.
pub(crate) fn one(value: i64) -> std::sync::Arc<[Value]> {
    [Value::Int(value)].into()
}
