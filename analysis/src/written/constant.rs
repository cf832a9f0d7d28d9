//! Constants: literals brought to the type that their place asks for, and initial values.

use crate::findings::article::with_article;
use crate::findings::did_you_mean::closest;
use crate::values::compound::{Compound, EnumId};
use crate::values::literal::{Literal, LiteralProblem};
use crate::values::types::{Scalar, Type, passes};
use crate::values::value::{Value, wrap};
use crate::written::facts::{Node, NodeKind, Operator};
use ladder_syntax::{Name, TextRange, TextSize};

/// What is wrong with a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ConstantFault {
    /// It is written in no form that the language has.
    Malformed,
    /// It is too small, too large or too long.
    OutOfRange,
    /// It is of another type.
    OtherType,
    /// It is not an initial value for what is declared.
    NotInitial,
}

/// Why a value does not fit its place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct ConstantProblem {
    pub(crate) fault: ConstantFault,
    pub(crate) range: TextRange,
    pub(crate) message: String,
}

impl ConstantProblem {
    /// Of a number that its place may not have.
    pub(crate) fn out_of_range(range: TextRange, message: String) -> ConstantProblem {
        ConstantProblem::new(ConstantFault::OutOfRange, range, message)
    }

    fn new(fault: ConstantFault, range: TextRange, message: impl Into<String>) -> ConstantProblem {
        ConstantProblem {
            fault,
            range,
            message: message.into(),
        }
    }

    /// With its place counted from `start` bytes further up.
    pub(crate) fn moved_by(self, start: TextSize) -> ConstantProblem {
        ConstantProblem {
            range: self.range + start,
            ..self
        }
    }
}

/// What a malformed literal is reported as.
pub(crate) fn literal_problem(problem: &LiteralProblem, range: TextRange) -> ConstantProblem {
    match problem {
        LiteralProblem::Malformed(message) => {
            ConstantProblem::new(ConstantFault::Malformed, range, message.clone())
        }
        LiteralProblem::OutOfRange(message) => {
            ConstantProblem::new(ConstantFault::OutOfRange, range, message.clone())
        }
    }
}

/// The value of a literal in a type (an untyped literal takes the type of its place, and must fit it).
/// `negative` stands for a minus before it.
pub(crate) fn place(
    literal: &Literal,
    negative: bool,
    ty: Scalar,
    range: TextRange,
) -> Result<Value, ConstantProblem> {
    let mismatch = || {
        ConstantProblem::new(
            ConstantFault::OtherType,
            range,
            format!("{} is given, {ty} is expected", describe(literal)),
        )
    };
    if let Literal::Typed(own, inner) = literal {
        if !passes(*own, ty) {
            let message = format!(
                "{} does not pass to {ty}: convert it with [TYP]",
                with_article(own)
            );
            return Err(ConstantProblem::new(ConstantFault::OtherType, range, message));
        }
        let value = place(inner, negative, *own, range)?;
        return Ok(pass(value, *own, ty));
    }
    match (literal, ty) {
        (Literal::Bool(value), Scalar::Bool) if !negative => Ok(Value::Bool(*value)),
        (Literal::Int(0 | 1), Scalar::Bool) if !negative => Ok(Value::Bool(*literal == Literal::Int(1))),
        (Literal::Int(n), _) if ty.bounds().is_some() => {
            let n = if negative { -n } else { *n };
            let (low, high) = ty.bounds().unwrap_or((0, 0));
            if !(low..=high).contains(&n) {
                let message = format!("{n} is outside of {ty}, which holds {low} to {high}");
                return Err(ConstantProblem::new(ConstantFault::OutOfRange, range, message));
            }
            // ULINT and LWORD are kept as the same 64 bits.
            Ok(Value::Int(n as i64))
        }
        (Literal::Int(n), Scalar::Real | Scalar::Lreal) => {
            real(if negative { -n } else { *n } as f64, ty, range)
        }
        (Literal::Real(r), Scalar::Real | Scalar::Lreal) => real(if negative { -r } else { *r }, ty, range),
        (Literal::Time(t), Scalar::Time) => Ok(Value::Int(if negative { t.wrapping_neg() } else { *t })),
        (Literal::Date(t), Scalar::Date) | (Literal::Tod(t), Scalar::Tod) | (Literal::Dt(t), Scalar::Dt)
            if !negative =>
        {
            Ok(Value::Int(*t))
        }
        (Literal::Text(text), Scalar::String(length)) if !negative => {
            if text.len() > usize::from(length) {
                let message = format!("the text has {} characters, {ty} holds {length}", text.len());
                return Err(ConstantProblem::new(ConstantFault::OutOfRange, range, message));
            }
            Ok(Value::Text(text.clone()))
        }
        _ => Err(mismatch()),
    }
}

fn real(value: f64, ty: Scalar, range: TextRange) -> Result<Value, ConstantProblem> {
    let value = if ty == Scalar::Real {
        f64::from(value as f32)
    } else {
        value
    };
    if !value.is_finite() {
        return Err(ConstantProblem::new(
            ConstantFault::OutOfRange,
            range,
            format!("the number is too large for {ty}"),
        ));
    }
    Ok(Value::Real(value))
}

/// A value that passes from one type to another without `[TYP]`. The types must allow it.
pub fn pass(value: Value, from: Scalar, to: Scalar) -> Value {
    match value {
        Value::Int(n) if to.is_real() => Value::Real(if from == Scalar::Ulint {
            n as u64 as f64
        } else {
            n as f64
        }),
        Value::Int(n) => Value::Int(wrap(n, to)),
        Value::Real(r) if to == Scalar::Real => Value::Real(f64::from(r as f32)),
        other => other,
    }
}

/// What a literal is, for a message.
pub(crate) fn describe(literal: &Literal) -> String {
    match literal {
        Literal::Bool(true) => "TRUE".to_owned(),
        Literal::Bool(false) => "FALSE".to_owned(),
        Literal::Int(n) => format!("the number {n}"),
        Literal::Real(r) => format!("the real number {r}"),
        Literal::Time(_) => "a duration".to_owned(),
        Literal::Date(_) => "a date".to_owned(),
        Literal::Tod(_) => "a time of day".to_owned(),
        Literal::Dt(_) => "a date and time".to_owned(),
        Literal::Text(_) => "a text".to_owned(),
        Literal::Typed(scalar, _) => with_article(scalar),
    }
}

/// The type that an untyped literal has where its place asks for none.
pub(crate) fn natural_type(literal: &Literal, negative: bool) -> Scalar {
    match literal {
        Literal::Bool(_) => Scalar::Bool,
        Literal::Int(n) => {
            let n = if negative { -n } else { *n };
            let (low, high) = (i128::from(i32::MIN), i128::from(i32::MAX));
            if (low..=high).contains(&n) {
                Scalar::Dint
            } else if n <= i128::from(i64::MAX) {
                Scalar::Lint
            } else {
                Scalar::Ulint
            }
        }
        Literal::Real(_) => Scalar::Lreal,
        Literal::Time(_) => Scalar::Time,
        Literal::Date(_) => Scalar::Date,
        Literal::Tod(_) => Scalar::Tod,
        Literal::Dt(_) => Scalar::Dt,
        Literal::Text(text) => Scalar::String(u16::try_from(text.len()).unwrap_or(u16::MAX).max(1)),
        Literal::Typed(scalar, _) => *scalar,
    }
}

/// A literal with its sign, if the node is no more than that.
pub(crate) fn signed_literal(node: &Node) -> Option<(&Result<Literal, LiteralProblem>, bool)> {
    match &node.kind {
        NodeKind::Literal(literal) => Some((literal, false)),
        NodeKind::Unary(Operator::Sub, inner) => match &inner.kind {
            NodeKind::Literal(literal) => {
                use Literal::{Int, Real, Time};
                let can_be_negative = matches!(**literal, Ok(Int(_) | Real(_) | Time(_)) | Err(_));
                can_be_negative.then_some((&**literal, true))
            }
            _ => None,
        },
        NodeKind::Paren(inner) => signed_literal(inner),
        _ => None,
    }
}

/// The initial values of a declaration: one for each elementary part, in the order of
/// [`Type::initial_values`]. What is left out has its type's own; `element` are those of an element, if it is an array whose
/// elements' type has values of its own.
pub(crate) fn initial_values(
    node: &Node,
    ty: Type,
    element: Option<&[Value]>,
) -> Result<Vec<Value>, ConstantProblem> {
    let mut values = Vec::new();
    add_values(node, ty, element, &mut values)?;
    Ok(values)
}

fn not_initial(range: TextRange, message: impl Into<String>) -> ConstantProblem {
    ConstantProblem::new(ConstantFault::NotInitial, range, message)
}

/// Adds the values of a part.
fn add_values(
    node: &Node,
    ty: Type,
    own: Option<&[Value]>,
    values: &mut Vec<Value>,
) -> Result<(), ConstantProblem> {
    if let Some((dimensions, element)) = ty.array() {
        let most = dimensions.iter().fold(1u64, |all, (first, last)| {
            all.saturating_mul(last.abs_diff(*first) + 1)
        });
        let own = own.map_or_else(|| element.initial_values(), <[Value]>::to_vec);
        return add_elements(node, element, (most, &own), values);
    }
    let id = match ty {
        Type::Scalar(scalar) => {
            values.push(initial_value(node, scalar)?);
            return Ok(());
        }
        Type::State(state) => {
            let message = format!(
                "{} starts cleared: it has no initial value",
                with_article(state.name())
            );
            return Err(not_initial(node.range, message));
        }
        Type::Compound(id) => id,
        Type::Array { .. } => return Ok(()),
    };
    let Compound::Structure(structure) = id.get() else {
        let message = format!("{id} starts as its block says: it has no initial value");
        return Err(not_initial(node.range, message));
    };
    let NodeKind::Members(given) = &node.kind else {
        let first = structure.members.first().map_or("member", |member| &member.name);
        let message = format!("the values of {id} belong in parentheses: ({first} := ...)");
        return Err(not_initial(node.range, message));
    };
    let mut by_member: Vec<Option<&Node>> = vec![None; structure.members.len()];
    for (name, value) in given {
        let Some((number, _)) = structure.member(&name.text) else {
            if !structure.is_whole {
                continue;
            }
            return Err(not_initial(
                name.range,
                format!("{id} has no member `{}`", name.text),
            ));
        };
        if by_member[number].replace(value).is_some() {
            let message = format!("`{}` has a value already", name.text);
            return Err(not_initial(name.range, message));
        }
    }
    for (member, given) in structure.members.iter().zip(by_member) {
        match (given, &member.initial) {
            (Some(value), _) => add_values(value, member.ty, member.element.as_deref(), values)?,
            (None, Some(initial)) => values.extend_from_slice(initial),
            (None, None) => values.extend(member.ty.initial_values()),
        }
    }
    Ok(())
}

/// Adds the values of an array, row by row.
fn add_elements(
    node: &Node,
    element: Type,
    (most, own): (u64, &[Value]),
    values: &mut Vec<Value>,
) -> Result<(), ConstantProblem> {
    let NodeKind::Array(nodes) = &node.kind else {
        let message = "an array's values belong in brackets: [1, 2, 3]";
        return Err(not_initial(node.range, message));
    };
    let before = values.len();
    let mut given = 0;
    for node in nodes {
        given += add_element(node, element, (most, own), values)?;
    }
    if given > most {
        let message = format!("there are {given} values for {most} elements");
        values.truncate(before);
        return Err(not_initial(node.range, message));
    }
    for _ in given..most {
        values.extend_from_slice(own);
    }
    Ok(())
}

/// Adds one value of an array's list, or a repeated one: `4(0)`, `4()`. Returns for how many elements.
fn add_element(
    node: &Node,
    element: Type,
    (most, own): (u64, &[Value]),
    values: &mut Vec<Value>,
) -> Result<u64, ConstantProblem> {
    let NodeKind::Repeat(count, repeated) = &node.kind else {
        add_values(node, element, None, values)?;
        return Ok(1);
    };
    let Some(&Literal::Int(count)) = count.literal() else {
        return Err(not_initial(count.range, "a count is a whole number: 4(0)"));
    };
    let count = u64::try_from(count).unwrap_or(u64::MAX);
    let each = repeated.len().max(1) as u64;
    if count.saturating_mul(each) > most {
        let message = format!("there are more values than the array's {most} elements");
        return Err(not_initial(node.range, message));
    }
    let mut once = Vec::new();
    for value in repeated {
        add_values(value, element, None, &mut once)?;
    }
    if repeated.is_empty() {
        once = own.to_vec();
    }
    for _ in 0..count {
        values.extend_from_slice(&once);
    }
    Ok(count * each)
}

fn initial_value(node: &Node, ty: Scalar) -> Result<Value, ConstantProblem> {
    if let Scalar::Enum(id) = ty {
        return enumeration_value(node, id);
    }
    match signed_literal(node) {
        Some((Ok(literal), negative)) => place(literal, negative, ty, node.range),
        Some((Err(problem), _)) => Err(literal_problem(problem, node.range)),
        None => Err(not_initial(node.range, "an initial value is a literal")),
    }
}

/// `FILLING`, `Phase.FILLING`
fn enumeration_value(node: &Node, id: EnumId) -> Result<Value, ConstantProblem> {
    let enumeration = id.get();
    let written = match &node.kind {
        NodeKind::Name(name) => Some(name),
        NodeKind::Member(base, word) => match &base.kind {
            NodeKind::Name(name) if Name::new(name) == Name::new(&enumeration.name) => Some(&word.text),
            _ => None,
        },
        _ => None,
    };
    match written.map(|name| (name, enumeration.number(name))) {
        Some((_, Some(number))) => Ok(Value::Int(i64::from(number))),
        Some((name, None)) => {
            let values = enumeration.values.iter().map(|(name, _)| name.as_str());
            let near = did_you_mean(name, values);
            Err(not_initial(
                node.range,
                format!("{} has no value `{name}`{near}", enumeration.name),
            ))
        }
        None => Err(not_initial(
            node.range,
            format!("one of the values of {} is expected here", enumeration.name),
        )),
    }
}

/// `: did you mean FILLING?`, or nothing.
fn did_you_mean<'n>(name: &str, known: impl Iterator<Item = &'n str>) -> String {
    closest(name, known).map_or_else(String::new, |near| format!(": did you mean {near}?"))
}

/// A literal with the type that it has by itself, for people: `T#5s` is "TIME, 5000 ms".
pub fn natural_literal(literal: &Literal) -> String {
    match literal {
        Literal::Time(ns) => format!("TIME literal, {} ms", *ns as f64 / 1e6),
        Literal::Typed(scalar, _) => format!("{scalar} literal"),
        Literal::Int(n) if *n > 9 => format!("Number {n} (16#{n:X})"),
        other => {
            let described = describe(other);
            described
                .chars()
                .take(1)
                .flat_map(char::to_uppercase)
                .chain(described.chars().skip(1))
                .collect()
        }
    }
}
