//! Bodies in Structured Text.

use super::actions::WithActions;
use super::body::Made;
use super::initial::initial_text;
use crate::expression::{bound, type_text};
use crate::model::{Project, Role, Type, Unit, UnitKind, Variable};
use crate::scope::{BlockOf, Scope, Shared, local, member, trigger};
use crate::standard::{self, StandardBlock};
use ladder_analysis::values::types::Scalar;
use ladder_format::program::Expression;
use ladder_notation::{LineColumn, Reading};
use ladder_notation_st::read::{
    self as st, Dialect, Edge, Enumeration, Parameter, ParameterRole, Restarted, Shape, Structure,
};
use std::cell::OnceCell;
use std::collections::HashMap;
use std::rc::Rc;

/// Types are made of others no deeper.
const DEEPEST: usize = 16;

/// Reads the text of a unit's body, and says why it cannot be.
///
/// # Errors
///
/// What keeps it from being read.
pub(super) fn body(
    seen: &Seen<'_>,
    unit: &Unit,
    (text, place): (&str, LineColumn),
    made: &mut Made,
    reading: &mut Reading,
) -> Result<(), String> {
    let Seen { shared, .. } = seen;
    let scope = seen.in_text(&made.scope);
    let restarted = restarted(shared, unit);
    let whole = WithActions::of(unit, (text, place), seen.dialect());
    let text = whole.text.as_str();
    let source = st::Source {
        text,
        dialect: seen.dialect(),
        unit: &unit.name,
        scope: &scope,
        restarted: &restarted,
        instructions: None,
        first_origin: reading.places.len() as u32,
        first_label: 0,
    };
    let in_file = |at: usize| whole.place(at);
    let (names, unread) = (made.scope.names_mut(), &mut made.unread);
    let body = st::read_body(&source, names, unread, |at| in_file(at).line)?;
    body.note(text, in_file, reading);
    made.in_place.extend(whole.in_place);
    made.needed
        .extend(body.used.iter().map(|name| name.to_lowercase()));
    made.items.extend(body.items);
    for tag in body.tags {
        let names = tag.names.into_iter();
        made.helpers
            .extend(names.map(|name| (name, tag.ty.clone(), String::new())));
    }
    Ok(())
}

/// A place in a text that begins at a place.
pub(super) fn within(start: LineColumn, at: LineColumn) -> LineColumn {
    let column = if at.line == 1 {
        start.column + at.column - 1
    } else {
        at.column
    };
    LineColumn {
        line: start.line + at.line - 1,
        column,
    }
}

/// What begins again at each call.
fn restarted(shared: &Shared<'_>, unit: &Unit) -> Vec<Restarted> {
    let is_own = |role: Role| role == Role::Temp || unit.kind == UnitKind::Function && role == Role::Local;
    let result = unit.returns.as_ref().map(|_| Restarted {
        name: unit.name.clone(),
        initial: None,
        is_compound: false,
    });
    let locals = local(unit).filter(|variable| is_own(variable.role) && variable.qualifier.is_none());
    let locals = locals.map(|variable| {
        let text = variable
            .initial
            .as_ref()
            .and_then(|initial| initial_text(shared, &variable.ty, initial).ok());
        let initial = text.and_then(|text| Expression::read(&text).ok());
        let is_compound = variable.initial.is_some() && initial.is_none();
        Restarted {
            name: variable.name.clone(),
            initial,
            is_compound,
        }
    });
    result.into_iter().chain(locals).collect()
}

/// A project, and what all its bodies in Structured Text see of it, found where the first one is read.
pub(super) struct Seen<'s> {
    pub(super) shared: &'s Shared<'s>,
    pub(super) project: &'s Project,
    scopes: OnceCell<Scopes<'s>>,
}

impl<'s> Seen<'s> {
    pub(super) fn of(shared: &'s Shared<'s>, project: &'s Project) -> Seen<'s> {
        Seen {
            shared,
            project,
            scopes: OnceCell::new(),
        }
    }

    /// What its texts are written in.
    pub(super) fn dialect(&self) -> Dialect {
        if self.shared.is_compiled || self.project.is_own {
            Dialect::Iec
        } else {
            Dialect::Codesys
        }
    }

    /// What names mean in a text of a unit.
    pub(super) fn in_text(&self, unit: &Scope) -> st::Scope {
        let scopes = self.scopes.get_or_init(|| Scopes::of(self.shared, self.project));
        scopes.of_unit(unit)
    }
}

/// The types, blocks and globals of a project, as bodies in Structured Text see them.
#[derive(Clone)]
struct Scopes<'s> {
    shared: &'s Shared<'s>,
    known: HashMap<String, st::Type>,
    scope: st::Scope,
}

impl<'s> Scopes<'s> {
    fn of(shared: &'s Shared<'s>, project: &Project) -> Scopes<'s> {
        let mut scopes = Scopes {
            shared,
            known: HashMap::new(),
            scope: st::Scope::default(),
        };
        for declared in &project.types {
            let ty = scopes.declared(&Type::Named(declared.name.clone()));
            scopes.scope.data_type(&declared.name, ty);
        }
        for (name, block) in &shared.blocks {
            let shape = scopes.shape(block);
            if block.unit.kind == UnitKind::Function {
                scopes.scope.function(name, shape);
            } else {
                scopes.scope.data_type(name, st::Type::Block(shape));
            }
        }
        for (name, known) in shared.globals.all() {
            let ty = scopes.declared(&known.ty);
            scopes.scope.tag(name, known.path.clone(), ty, false);
        }
        scopes
    }

    fn of_unit(&self, unit: &Scope) -> st::Scope {
        let mut own = self.clone();
        own.scope.begin_unit();
        for (name, known) in unit.all() {
            let ty = own.declared(&known.ty);
            own.scope.tag(name, known.path.clone(), ty, false);
        }
        for (name, (active, elapsed)) in unit.steps() {
            own.scope.step(name, active.clone(), elapsed.clone());
        }
        own.scope
    }

    fn shape(&mut self, block: &BlockOf<'_>) -> Rc<Shape> {
        let mut parameters = Vec::new();
        for variable in local(block.unit) {
            let role = match variable.role {
                Role::Input => ParameterRole::Input,
                Role::Output => ParameterRole::Output,
                Role::InOut => ParameterRole::InOut,
                _ => continue,
            };
            let Some(known) = block.scope.get(&variable.name) else {
                continue;
            };
            let ty = self.declared(&variable.ty);
            parameters.push(Parameter {
                name: variable.name.clone(),
                spelled: known.path.to_string(),
                role,
                ty,
                has_default: variable.initial.is_some(),
            });
        }
        let returns = block.unit.returns.as_ref().and_then(|returns| {
            let known = block.scope.get(&block.unit.name)?;
            Some((known.path.to_string(), self.declared(returns)))
        });
        let name = block.name.trim_start_matches('$').to_owned();
        Rc::new(Shape {
            name,
            parameters,
            returns,
        })
    }

    /// The type of something that is declared, if its type is one here.
    fn declared(&mut self, ty: &Type) -> st::Type {
        match type_text(self.shared, ty) {
            Ok(_) => self.ty(ty, 0),
            Err(_) => st::Type::Unknown,
        }
    }

    /// A type by its name.
    fn named(&mut self, name: &str, depth: usize) -> st::Type {
        let key = name.to_lowercase();
        if let Some(known) = self.known.get(&key) {
            return known.clone();
        }
        let Some((spelled, ty)) = self.shared.types.get(&key).filter(|_| depth < DEEPEST) else {
            return self.elementary(name);
        };
        let made = match ty {
            Type::Enumeration(values) => {
                let values = values.iter().map(|(value, _)| member(value)).collect();
                st::Type::Enumeration(Rc::new(Enumeration {
                    name: spelled.clone(),
                    values,
                }))
            }
            Type::Structure(members) => {
                let members = members
                    .iter()
                    .map(|one: &Variable| (one.name.clone(), member(&one.name), self.ty(&one.ty, depth + 1)));
                let members = members.collect();
                st::Type::Structure(Rc::new(Structure {
                    name: spelled.clone(),
                    members,
                }))
            }
            other => self.ty(other, depth + 1),
        };
        self.known.insert(key, made.clone());
        made
    }

    fn elementary(&mut self, name: &str) -> st::Type {
        let block = self.shared.blocks.get(&name.to_lowercase());
        if let Some(block) = block.filter(|block| block.unit.kind == UnitKind::FunctionBlock) {
            // A block that has itself in it ends here: its state is not seen from outside.
            let key = name.to_lowercase();
            self.known.insert(key.clone(), st::Type::Unknown);
            let shape = st::Type::Block(self.shape(block));
            self.known.insert(key, shape.clone());
            return shape;
        }
        match standard::block(name) {
            Some(StandardBlock::Stateful(mnemonic, ..)) => st::Type::Standard(mnemonic),
            Some(StandardBlock::Rising) => st::Type::Trigger(Edge::Rising),
            Some(StandardBlock::Falling) => st::Type::Trigger(Edge::Falling),
            None => {
                let scalar = standard::elementary(name).and_then(Scalar::from_name);
                scalar.map_or(st::Type::Unknown, st::Type::Scalar)
            }
        }
    }

    fn ty(&mut self, ty: &Type, depth: usize) -> st::Type {
        match ty {
            Type::Named(name) => self.named(name, depth),
            Type::Text(length) => {
                let length = length.and_then(|length| u16::try_from(length).ok());
                st::Type::Scalar(Scalar::String(length.unwrap_or(80)))
            }
            // An array of edge detectors is not declared.
            Type::Array(_, of) if trigger(of).is_some() => st::Type::Unknown,
            Type::Array(bounds, of) => {
                let all: Result<Vec<_>, String> = bounds
                    .iter()
                    .map(|(low, high)| Ok((bound(self.shared, low)?, bound(self.shared, high)?)))
                    .collect();
                match (all, self.ty(of, depth + 1)) {
                    (Err(_), _) | (_, st::Type::Unknown) => st::Type::Unknown,
                    (Ok(bounds), of) => st::Type::Array(bounds, Box::new(of)),
                }
            }
            Type::Range(base, ..) => self.elementary(base),
            Type::Enumeration(_) | Type::Structure(_) | Type::Other(_) => st::Type::Unknown,
        }
    }
}

/// Whether a unit's body is read as Structured Text, with nothing else in the unit that must be read with it.
pub(super) fn text(unit: &Unit) -> Option<(&str, LineColumn)> {
    use crate::model::{Body, WORKSHEET};
    let Body::Text("ST", text, place) = &unit.body else {
        return None;
    };
    let is_alone = unit.parts.iter().all(|part| part.what != WORKSHEET);
    is_alone.then_some((text.as_str(), *place))
}
