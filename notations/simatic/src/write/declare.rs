//! What a program declares as variables and structures.

use super::Project;
use super::operand::{self, literal};
use super::tags::Tags;
use super::units::Source;
use crate::model::{Kind, Role, Type, Unit, Variable};
use crate::scope::member;
use crate::standard::spelled;
use ladder_analysis::context::Context;
use ladder_analysis::names::scope::{Origin, SectionKind, TagFacts};
use ladder_analysis::program;
use ladder_analysis::values::compound::Compound;
use ladder_analysis::values::types::{DEFAULT_STRING, Scalar, Type as OwnType};
use ladder_analysis::values::value::{Value, real_text};
use ladder_analysis::written::type_spec::{MemberSpec, SpecKind};
use ladder_format::program::Expression;
use ladder_notation::Report;
use ladder_syntax::ast::{AstNode, Declaration, NodeView};
use ladder_syntax::{Name, TextRange, TextSize};

/// An array has no more dimensions where it is read again.
const MOST_DIMENSIONS: usize = 3;

/// A type.
///
/// # Errors
///
/// Why it has no form there.
pub(super) fn type_of(project: &Project<'_>, ty: OwnType) -> Result<Type, String> {
    let named = |own: &str| {
        let there = spelled(own).ok_or_else(|| format!("`{own}` has no form there"))?;
        Ok(Type::Named(there.to_owned()))
    };
    let bound = |(first, last): &(i64, i64)| (first.to_string(), last.to_string());
    match ty {
        OwnType::Scalar(ty) => scalar(ty),
        OwnType::State(state) => named(state.name()),
        OwnType::Array { first, last, element } => Ok(Type::Array(
            vec![bound(&(first, last))],
            Box::new(scalar(element)?),
        )),
        OwnType::Compound(id) => match id.get() {
            Compound::Structure(structure) => Ok(Type::Named(structure.name.to_string())),
            Compound::Block(name) => match project.unwritable.get(&Name::new(&name)) {
                Some(why) => Err(why.clone()),
                None => Ok(Type::Named(name[1..].to_owned())),
            },
            Compound::Array(array) => {
                let mut bounds: Vec<_> = array.dimensions.iter().map(bound).collect();
                // An array of arrays is one of several dimensions there.
                let of = match type_of(project, array.element)? {
                    Type::Array(inner, of) => {
                        bounds.extend(inner);
                        of
                    }
                    of => Box::new(of),
                };
                if bounds.len() > MOST_DIMENSIONS {
                    return Err(format!(
                        "an array of more than {MOST_DIMENSIONS} dimensions, those of the arrays in it included, has no form here"
                    ));
                }
                Ok(Type::Array(bounds, of))
            }
        },
    }
}

/// An elementary type.
fn scalar(ty: Scalar) -> Result<Type, String> {
    match ty {
        Scalar::String(DEFAULT_STRING) => Ok(Type::Text(None)),
        Scalar::String(length) => Ok(Type::Text(Some(length.into()))),
        ty => {
            let name = type_name(ty).ok_or_else(|| format!("`{}` has no form there", ty.name()))?;
            Ok(Type::Named(name.to_owned()))
        }
    }
}

/// The name of an elementary type.
pub(super) fn type_name(ty: Scalar) -> Option<&'static str> {
    match ty {
        Scalar::String(_) => Some("String"),
        Scalar::Enum(_) => Some("DInt"),
        other => spelled(other.name()),
    }
}

/// What a declaration says besides the type.
#[derive(Default)]
struct Written {
    initial: Option<String>,
    comment: Option<String>,
}

/// The declaration at a place.
fn written(context: &Context, at: TextSize) -> Written {
    let Some(line) = context
        .parse
        .line_at(at)
        .map(|number| &context.parse.lines()[number])
    else {
        return Written::default();
    };
    let tree = line.tree();
    let Some(found) = Declaration::cast(NodeView::root(&tree)) else {
        return Written::default();
    };
    let text = line.text();
    let slice = |range: TextRange| text[range].trim().to_owned();
    let comment = text.split_once(';').and_then(|(_, rest)| {
        let told = rest.trim().strip_prefix('#')?.split('#').next()?.trim();
        (!told.is_empty()).then(|| told.to_owned())
    });
    Written {
        initial: found.initial_value().map(|value| slice(value.range())),
        comment,
    }
}

/// A value at the start: as it is written where that has a form there, else as what it is.
///
/// # Errors
///
/// Why it has no form there.
fn initial(ty: OwnType, text: Option<&str>, values: &[Value]) -> Result<Option<String>, String> {
    let element = match ty {
        OwnType::Scalar(ty) | OwnType::Array { element: ty, .. } => Some(ty),
        OwnType::Compound(id) => id.with(|compound| match compound {
            Compound::Array(array) => array.element.element_scalar(),
            _ => None,
        }),
        OwnType::State(_) => None,
    };
    if let OwnType::Scalar(ty @ Scalar::Enum(_)) = ty {
        let zero = Value::zero(ty);
        return value_text(values.first().unwrap_or(&zero), ty).map(Some);
    }
    let as_written = match text {
        None if values.is_empty() => return Ok(None),
        None => Err("the first values that its type takes from another have no form there".to_owned()),
        Some("1") if ty == OwnType::BOOL => Ok("TRUE".to_owned()),
        Some("0") if ty == OwnType::BOOL => Ok("FALSE".to_owned()),
        Some(text) => initial_text(text),
    };
    match (as_written, element) {
        (Err(_), Some(element)) if !values.is_empty() => {
            if let OwnType::Scalar(ty) = ty {
                return value_text(&values[0], ty).map(Some);
            }
            list(values, element).map(Some)
        }
        (as_written, _) => as_written.map(Some),
    }
}

/// The values of an array, row by row: `[1, 6(0)]`.
fn list(values: &[Value], element: Scalar) -> Result<String, String> {
    let mut out: Vec<String> = Vec::new();
    for run in values.chunk_by(|one, other| one == other) {
        let text = value_text(&run[0], element)?;
        out.push(match run.len() {
            1 => text,
            count => format!("{count}({text})"),
        });
    }
    Ok(format!("[{}]", out.join(", ")))
}

/// A value of an elementary type.
fn value_text(value: &Value, ty: Scalar) -> Result<String, String> {
    match (value, ty) {
        (Value::Bool(on), _) => Ok(if *on { "TRUE" } else { "FALSE" }.to_owned()),
        (Value::Int(nanoseconds), Scalar::Time) => literal(&format!("T#{nanoseconds}ns")),
        (Value::Int(number), Scalar::Lword | Scalar::Ulint) => Ok((*number as u64).to_string()),
        (Value::Real(number), _) => Ok(real_text(*number, ty)),
        (Value::Int(number), _) if !matches!(ty, Scalar::Date | Scalar::Tod | Scalar::Dt) => {
            Ok(number.to_string())
        }
        _ => Err("its value at the start has no form there".to_owned()),
    }
}

/// A value at the start that is written as a literal, or as a list of them.
fn initial_text(text: &str) -> Result<String, String> {
    let value = |text: &str| {
        let found = match Expression::read(text.trim())? {
            Expression::Literal(found) => found.as_str().to_owned(),
            Expression::Unary(_, inner) if matches!(*inner, Expression::Literal(_)) => format!("-{inner}"),
            _ => return Err(format!("the first value `{text}` has no form there")),
        };
        literal(&found)
    };
    let Some(inner) = text.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) else {
        return value(text).map_err(|_| format!("the first value `{text}` has no form there"));
    };
    let values = inner.split(',').map(|text| {
        let text = text.trim();
        match text.strip_suffix(')').and_then(|rest| rest.split_once('(')) {
            Some((count, of)) => Ok(format!("{count}({})", value(of)?)),
            None => value(text),
        }
    });
    let values: Result<Vec<String>, String> = values.collect();
    Ok(format!("[{}]", values?.join(", ")))
}

/// The variables of a unit.
pub(super) fn variables(tags: &mut Tags<'_>, source: &Source, report: &mut Report) -> Vec<Variable> {
    let mut variables = Vec::new();
    let scope = &tags.project.analysis.context.scopes[source.scope];
    for tag in scope.tags.iter().filter(|tag| tag.is_declared()) {
        variables.extend(declared(tags, tag, report));
    }
    if source.scope == 0 {
        undeclared(tags, &mut variables, report);
    }
    variables
}

/// A tag that is declared.
fn declared(tags: &mut Tags<'_>, tag: &TagFacts, report: &mut Report) -> Option<Variable> {
    let project = tags.project;
    let context = &project.analysis.context;
    let Origin::Declared(section) = tag.origin else {
        return None;
    };
    let at = context.place_of(tag).start();
    let place = project.line(at);
    let shown = format!("tag `{}`", tag.name);
    let told = written(context, at);
    let made = tag
        .ty
        .ok_or_else(|| "its type is not known".to_owned())
        .and_then(|ty| {
            let initial = initial(ty, told.initial.as_deref(), &tag.cold.initial)?;
            Ok((ty, type_of(project, ty)?, initial))
        });
    let (ty, there, initial) = match made {
        Ok(made) => made,
        Err(why) => {
            let why = format!("`{}` cannot be declared: {why}", tag.name);
            report.refused(place, shown, why.clone());
            tags.insert(&tag.name, Err(why));
            return None;
        }
    };
    tags.insert(&tag.name, Ok(ty));
    let role = match section {
        _ if tag.constant => Role::Constant,
        SectionKind::Input => Role::Input,
        SectionKind::Output => Role::Output,
        SectionKind::InOut => Role::InOut,
        SectionKind::Var | SectionKind::Global | SectionKind::External => Role::Static,
    };
    if matches!(ty, OwnType::Scalar(Scalar::Enum(_))) {
        let why = "an enumeration is a DInt there, and its values are constants";
        report.approximated(place, shown, why);
    } else if matches!(section, SectionKind::Global | SectionKind::External) {
        let why = "other blocks do not see it: it is a variable of the block";
        report.approximated(place, shown, why);
    } else if let Some(address) = &tag.cold.address {
        let why = match role {
            Role::Input | Role::Output => format!(
                "a variable of a block has no address: the organization block connects it to {}",
                operand::address(address)
            ),
            _ => format!("a variable of a block has no address: {address} is not kept"),
        };
        report.approximated(place, shown, why);
    } else if tag.retain && role != Role::Static {
        let why = "it is not retentive there: only variables of the block itself are";
        report.approximated(place, shown, why);
    } else {
        report.translated(place, shown);
    }
    Some(Variable {
        place,
        name: tag.name.to_string(),
        role,
        retain: tag.retain && role == Role::Static,
        ty: there,
        initial,
        comment: told.comment,
    })
}

/// The tags that the program uses without declaring them. A block's body has none.
fn undeclared(tags: &mut Tags<'_>, variables: &mut Vec<Variable>, report: &mut Report) {
    let project = tags.project;
    for tag in &project.program.tags {
        let is_own =
            tag.block.is_none() && tag.location.file == 0 && !tag.name.contains(['.', '%', '[', '$']);
        if !is_own || tags.known(&tag.name).is_some() {
            continue;
        }
        let place = project.place(tag.location.range.start());
        match type_of(project, tag.ty) {
            Ok(ty) => {
                tags.insert(&tag.name, Ok(tag.ty));
                variables.push(Variable {
                    place,
                    name: tag.name.clone(),
                    role: match tag.role {
                        program::Role::Input => Role::Input,
                        program::Role::Output => Role::Output,
                        program::Role::Internal => Role::Static,
                    },
                    retain: tag.retain && tag.role == program::Role::Internal,
                    ty,
                    ..Variable::default()
                });
            }
            Err(why) => {
                let why = format!("`{}` cannot be declared: {why}", tag.name);
                report.refused(place, format!("tag `{}`", tag.name), why.clone());
                tags.insert(&tag.name, Err(why));
            }
        }
    }
}

/// The structures of a program, each a unit of its own.
pub(super) fn structures(project: &Project<'_>, report: &mut Report) -> Vec<Unit> {
    let context = &project.analysis.context;
    let mut types: Vec<_> = context.types.own().iter().collect();
    types.sort_by(|one, other| one.declaration.name.cmp(&other.declaration.name));
    let mut units = Vec::new();
    for named in types {
        let (SpecKind::Structure(members), Some(OwnType::Compound(id))) =
            (&named.declaration.declared.spec.kind, named.ty)
        else {
            continue;
        };
        let place = project.line(
            members
                .first()
                .map_or(named.declaration.at, |first| first.at)
                .start(),
        );
        let shown = format!("type {}", named.declaration.name);
        let made = members.iter().map(|own| structure_member(project, id.get(), own));
        match made.collect::<Result<Vec<Variable>, String>>() {
            Ok(variables) => {
                report.translated(place, shown);
                units.push(Unit {
                    place,
                    kind: Kind::Type,
                    name: named.declaration.name.to_string(),
                    variables,
                    ..Unit::default()
                });
            }
            Err(why) => report.refused(place, shown, why),
        }
    }
    units
}

fn structure_member(project: &Project<'_>, of: Compound, own: &MemberSpec) -> Result<Variable, String> {
    if member(&own.name) != *own.name {
        return Err(format!("the member `{}` has no form there", own.name));
    }
    let found = match &of {
        Compound::Structure(structure) => structure.member(&own.name),
        _ => None,
    };
    let (_, found) = found.ok_or_else(|| format!("the type of its member `{}` is not known", own.name))?;
    let told = written(&project.analysis.context, own.at.start());
    let values = found.initial.as_deref().unwrap_or_default();
    Ok(Variable {
        place: project.line(own.at.start()),
        name: own.name.to_string(),
        ty: type_of(project, found.ty)?,
        initial: initial(found.ty, told.initial.as_deref(), values)?,
        comment: told.comment,
        ..Variable::default()
    })
}
