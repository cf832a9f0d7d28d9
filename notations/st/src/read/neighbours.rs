//! What the other files of a workspace declare, as a file of Structured Text sees it: types, blocks, functions and globals.

use super::declared::{File, Role, Unit, UnitKind};
use super::dialect::Dialect;
use super::scope::{Enumeration, Parameter, ParameterRole, Scope, Shape, Structure, Type};
use super::{types, units};
use ladder_analysis::Exports;
use ladder_analysis::program::ParameterKind;
use ladder_analysis::values::types as ladder_types;
use ladder_analysis::written::type_spec::{Declared, SpecKind, TypeSpec};
use ladder_format::program::{Path, Qualifier};
use ladder_notation::{BlockNames, Companion, Names};
use ladder_syntax::parse;
use std::collections::HashSet;
use std::rc::Rc;
use std::sync::Arc;

/// What a file declares.
#[derive(Clone)]
enum Other {
    StructuredText(Arc<File>),
    Ladder(Arc<Exports>),
    Nothing,
}

/// A type as its file declares it, under its name here.
struct Candidate<'f> {
    name: &'f str,
    spelled: String,
    text: Text<'f>,
}

#[derive(Clone, Copy)]
enum Text<'f> {
    StructuredText(&'f super::declared::TypeText),
    Ladder(&'f TypeSpec),
}

/// Declares what is in the other files, the nearest first; of two that declare one name the first counts. Types of theirs may be
/// made of the types of `own`.
pub(super) fn declare(companions: &[Companion], own: &File, scope: &mut Scope) {
    let others: Vec<Other> = companions.iter().map(read).collect();
    let mut names: Vec<Names> = others.iter().map(|_| Names::default()).collect();
    let mut own_names = Names::default();
    let mut candidates: Vec<Candidate<'_>> = in_structured_text(own, &mut own_names).collect();
    for (other, names) in others.iter().zip(&mut names) {
        match other {
            Other::StructuredText(file) => candidates.extend(in_structured_text(file, names)),
            Other::Ladder(exports) => candidates.extend(exports.types.iter().map(|ty| Candidate {
                name: &ty.name,
                spelled: ty.name.to_string(),
                text: Text::Ladder(&ty.declared.spec),
            })),
            Other::Nothing => {}
        }
    }
    let mut seen = HashSet::new();
    candidates.retain(|candidate| seen.insert(candidate.name.to_lowercase()));
    declare_types(candidates, scope);
    // The nearest is the last to be entered.
    for other in others.iter().rev() {
        match other {
            Other::StructuredText(file) => blocks_in_structured_text(file, scope),
            Other::Ladder(exports) => blocks_in_ladder(exports, scope),
            Other::Nothing => {}
        }
    }
    for (other, names) in others.iter().zip(&mut names).rev() {
        match other {
            Other::StructuredText(file) => {
                for global in &file.globals {
                    let spelled = names.spell(&global.name).to_owned();
                    if let Ok(ty) = types::of(&global.ty, scope) {
                        let is_constant = global.qualifier == Some(Qualifier::Constant);
                        scope.tag(&global.name, Path::tag(spelled), ty, is_constant);
                    }
                }
            }
            Other::Ladder(exports) => {
                for global in &exports.globals {
                    if let Some(ty) = in_ladder(global.ty, global.declared.as_deref(), scope) {
                        scope.tag(&global.name, Path::tag(global.name.clone()), ty, global.constant);
                    }
                }
            }
            Other::Nothing => {}
        }
    }
}

fn read(companion: &Companion) -> Other {
    let is_structured_text = companion.name.to_ascii_lowercase().ends_with(".st");
    companion.bytes.made(|bytes| {
        let Ok(text) = std::str::from_utf8(bytes) else {
            return Other::Nothing;
        };
        if is_structured_text {
            Other::StructuredText(Arc::new(units::file(text, Dialect::Iec).0))
        } else {
            Other::Ladder(Arc::new(ladder_analysis::exports(&Arc::new(parse(text)), "")))
        }
    })
}

fn in_structured_text<'f>(file: &'f File, names: &'f mut Names) -> impl Iterator<Item = Candidate<'f>> {
    file.types.iter().map(|declared| Candidate {
        name: &declared.name,
        spelled: names.spell(&declared.name).to_owned(),
        text: Text::StructuredText(&declared.ty),
    })
}

/// A type may be declared before what it is made of.
fn declare_types(mut left: Vec<Candidate<'_>>, scope: &mut Scope) {
    loop {
        let before = left.len();
        left.retain(|candidate| {
            let ty = match candidate.text {
                Text::StructuredText(text) => types::declared(&candidate.spelled, text, scope)
                    .ok()
                    .map(|(ty, _)| ty),
                Text::Ladder(spec) => of_spec(Some(candidate.name), spec, scope),
            };
            let is_left = ty.is_none();
            if let Some(ty) = ty {
                scope.data_type(candidate.name, ty);
            }
            is_left
        });
        if left.is_empty() || left.len() == before {
            return;
        }
    }
}

fn blocks_in_structured_text(file: &File, scope: &mut Scope) {
    let mut names = BlockNames::default();
    for unit in &file.units {
        enter(unit, &mut names, scope);
    }
}

/// Enters what a block or a function is called with.
pub(super) fn enter(unit: &Unit, blocks: &mut BlockNames, scope: &mut Scope) {
    if unit.kind == UnitKind::Program {
        return;
    }
    let name = blocks.free(&unit.name, "B");
    let mut names = Names::default();
    let mut parameters = Vec::new();
    for variable in &unit.variables {
        let spelled = names.spell(&variable.name).to_owned();
        let role = match variable.role {
            Role::Input => ParameterRole::Input,
            Role::Output => ParameterRole::Output,
            Role::InOut => ParameterRole::InOut,
            _ => continue,
        };
        let ty = types::of(&variable.ty, scope).unwrap_or(Type::Unknown);
        parameters.push(Parameter {
            name: variable.name.clone(),
            spelled,
            role,
            ty,
            has_default: variable.initial.is_some(),
        });
    }
    let returns = unit.returns.as_ref().map(|returns| {
        let ty = types::of(returns, scope).unwrap_or(Type::Unknown);
        (names.spell(&unit.name).to_owned(), ty)
    });
    let shape = Rc::new(Shape {
        name,
        parameters,
        returns,
    });
    if unit.kind == UnitKind::Function {
        scope.function(&unit.name, shape);
    } else {
        scope.data_type(&unit.name, Type::Block(shape));
    }
}

/// The blocks of ladder text that a call of an instance means the same of.
fn blocks_in_ladder(exports: &Exports, scope: &mut Scope) {
    for block in &exports.blocks {
        let facts = &block.facts;
        if facts.doubtful || facts.shape != ladder_instructions::Shape::Logical {
            continue;
        }
        let name = facts.name.trim_start_matches('$');
        let parameters = facts.parameters.iter().map(|parameter| Parameter {
            name: parameter.name.clone(),
            spelled: parameter.name.clone(),
            role: match parameter.kind {
                ParameterKind::Input => ParameterRole::Input,
                ParameterKind::Output => ParameterRole::Output,
                ParameterKind::InOut => ParameterRole::InOut,
            },
            ty: in_ladder(parameter.ty, parameter.declared.as_deref(), scope).unwrap_or(Type::Unknown),
            has_default: parameter.has_default,
        });
        let shape = Shape {
            name: name.to_owned(),
            parameters: parameters.collect(),
            returns: None,
        };
        scope.data_type(name, Type::Block(Rc::new(shape)));
    }
}

/// The type of something that ladder text declares.
fn in_ladder(ty: Option<ladder_types::Type>, declared: Option<&Declared>, scope: &Scope) -> Option<Type> {
    match declared {
        Some(declared) => of_spec(None, &declared.spec, scope),
        None => known(ty?),
    }
}

fn known(ty: ladder_types::Type) -> Option<Type> {
    match ty {
        ladder_types::Type::Scalar(scalar) => Some(Type::Scalar(scalar)),
        ladder_types::Type::State(state) => Some(Type::Standard(state.name())),
        ladder_types::Type::Array { first, last, element } => {
            let bounds = vec![(first.to_string(), last.to_string())];
            Some(Type::Array(bounds, Box::new(Type::Scalar(element))))
        }
        ladder_types::Type::Compound(_) => None,
    }
}

/// A type as ladder text writes it; `name` is the one that it is declared under.
fn of_spec(name: Option<&str>, spec: &TypeSpec, scope: &Scope) -> Option<Type> {
    match &spec.kind {
        SpecKind::Known(ty) => known(*ty),
        SpecKind::Subrange(scalar, _) => Some(Type::Scalar(*scalar)),
        SpecKind::Named(name) => scope.type_named(name),
        SpecKind::Block(name) => scope.type_named(name.trim_start_matches('$')),
        SpecKind::Array(bounds, of) => {
            let bounds = bounds
                .iter()
                .map(|(first, last)| (first.to_string(), last.to_string()));
            Some(Type::Array(bounds.collect(), Box::new(of_spec(None, of, scope)?)))
        }
        SpecKind::Enumeration(values) => Some(Type::Enumeration(Rc::new(Enumeration {
            name: name?.to_owned(),
            values: values.iter().map(|(value, ..)| value.to_string()).collect(),
        }))),
        SpecKind::Structure(members) => {
            let members = members.iter().map(|member| {
                let ty = of_spec(None, &member.declared.spec, scope)?;
                Some((member.name.to_string(), member.name.to_string(), ty))
            });
            Some(Type::Structure(Rc::new(Structure {
                name: name?.to_owned(),
                members: members.collect::<Option<_>>()?,
            })))
        }
        SpecKind::Unread => None,
    }
}
