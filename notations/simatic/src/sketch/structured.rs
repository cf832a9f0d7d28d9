//! Networks in SCL.

use super::Sketcher;
use super::translate::Translator;
use crate::model::{Kind, Network, Role, Type, Unit, Variable};
use crate::scope::{Library, Scope, block_name, member};
use crate::standard::{SYSTEM, elementary, state_type, trigger};
use ladder_analysis::values::types::{DEFAULT_STRING, Scalar};
use ladder_format::program::{Item, Path};
use ladder_notation::Lines;
use ladder_notation_st::read::{self as st, Dialect, Parameter, ParameterRole, Shape, Structure};
use std::collections::HashMap;
use std::rc::Rc;

/// Types are made of others no deeper.
const DEEPEST: usize = 16;

impl Sketcher<'_> {
    /// The networks that the statements of one become.
    ///
    /// # Errors
    ///
    /// Why it is not read.
    pub(super) fn structured(
        &mut self,
        translator: &mut Translator<'_, '_>,
        (unit, number): (&Unit, usize),
        network: &Network,
    ) -> Result<Vec<Item>, String> {
        let text = &network.text;
        let scope = self.seen_in_text(translator.scope, unit, text);
        let source = st::Source {
            text,
            dialect: Dialect::Scl,
            unit: &format!("network {} of {} (SCL)", number + 1, unit.name),
            scope: &scope,
            restarted: &[],
            instructions: None,
            first_origin: self.reading.places.len() as u32,
            first_label: translator.labels.numbered,
        };
        let lines = Lines::of(text);
        let line = |at| lines.place(text, at).line;
        let names = translator.scope.names_mut();
        let body = st::read_body(&source, names, &mut self.unread, line)?;
        body.note(text, |at| network.place_in_text(at), &mut self.reading);
        translator.labels.numbered = body.last_label;
        for tag in body.tags {
            let helpers = tag
                .names
                .into_iter()
                .map(|name| (name, tag.ty.clone(), String::new()));
            translator.scope.helpers.extend(helpers);
        }
        Ok(body.items)
    }

    /// What names mean in a text. Those of the project are in quotes in it: `"Data".run`.
    fn seen_in_text(&mut self, scope: &mut Scope<'_>, unit: &Unit, text: &str) -> st::Scope {
        let mut seen = st::Scope::default();
        let mut types = TypesOfText {
            library: self.library,
            known: HashMap::new(),
        };
        let [own, of_project] = st::names_in_scl(text);
        for name in own {
            if let Some(known) = scope.own(name) {
                let ty = types.ty(&known.ty, &known.spelled, 0);
                seen.tag(name, known.path(), ty, known.is_constant);
            }
        }
        // What a function returns has its name, with quotes, too.
        if let (Kind::Function, Some(known)) = (unit.kind, scope.own("ret_val")) {
            let ty = types.ty(&known.ty, &known.spelled, 0);
            seen.tag(&format!("\"{}\"", unit.name), known.path(), ty, false);
        }
        for &name in &of_project {
            let full = format!("\"{name}\"");
            if let Some((own, _)) = SYSTEM.iter().find(|(_, system)| *system == name) {
                seen.tag(
                    &full,
                    Path::system(own.name()),
                    st::Type::Scalar(Scalar::Bool),
                    true,
                );
            } else if let Some(other) = scope.unit(name) {
                match other.kind {
                    Kind::Data | Kind::Tag => {
                        let ty = other
                            .returns
                            .clone()
                            .unwrap_or_else(|| Type::Named(other.name.clone()));
                        let known = scope.global(&other.name, ty);
                        let ty = types.ty(&known.ty, &known.spelled, 0);
                        seen.tag(&full, known.path(), ty, known.is_constant);
                    }
                    Kind::Function => {
                        let shape = types.shape(other, 0);
                        seen.function(&full, shape);
                    }
                    _ => {}
                }
            } else if let Some((_, known)) = scope.globals.get(&name.to_lowercase()) {
                let ty = types.ty(&known.ty, &known.spelled, 0);
                seen.tag(&full, known.path(), ty, false);
            }
        }
        for (name, ty) in st::undeclared(text, Dialect::Scl, &seen) {
            // A name without a sign, and one of the block, is declared here or nowhere.
            if let Some(plain) = name.strip_prefix('"') {
                let Some(text) = ty.text() else { continue };
                let known = scope.global(&plain.replace('"', ""), Type::Named(text));
                seen.tag(&name, known.path(), ty, false);
            }
        }
        self.called_in(scope, of_project);
        seen
    }
}

struct TypesOfText<'l> {
    library: &'l Library<'l>,
    /// The types of the project, by their names in small letters.
    known: HashMap<String, st::Type>,
}

impl TypesOfText<'_> {
    /// A type. `like` names a structure that has no name of its own.
    fn ty(&mut self, ty: &Type, like: &str, depth: usize) -> st::Type {
        match ty {
            Type::Text(length) => {
                let length = length.and_then(|length| u16::try_from(length).ok());
                st::Type::Scalar(Scalar::String(length.unwrap_or(DEFAULT_STRING)))
            }
            Type::Array(bounds, of) => match self.ty(of, like, depth + 1) {
                st::Type::Unknown => st::Type::Unknown,
                of => st::Type::Array(bounds.clone(), Box::new(of)),
            },
            Type::Structure(members) => self.structure(like, members, depth),
            Type::Named(name) => self.named(name, depth),
        }
    }

    fn named(&mut self, name: &str, depth: usize) -> st::Type {
        if let Some(scalar) = elementary(name).and_then(Scalar::from_name) {
            return st::Type::Scalar(scalar);
        }
        if let Some(edge) = trigger(name) {
            return st::Type::Trigger(edge);
        }
        if let Some(mnemonic) = state_type(name) {
            return st::Type::Standard(mnemonic);
        }
        let key = name.to_lowercase();
        if let Some(known) = self.known.get(&key) {
            return known.clone();
        }
        let Some(Ok(unit)) = self.library.get(&key).filter(|_| depth < DEEPEST) else {
            return st::Type::Unknown;
        };
        // What has itself in it ends here.
        self.known.insert(key.clone(), st::Type::Unknown);
        let made = match unit.kind {
            Kind::Type | Kind::Data => self.structure(&unit.name, &unit.variables, depth),
            Kind::FunctionBlock => st::Type::Block(self.shape(unit, depth)),
            _ => st::Type::Unknown,
        };
        self.known.insert(key, made.clone());
        made
    }

    fn structure(&mut self, name: &str, members: &[Variable], depth: usize) -> st::Type {
        if depth >= DEEPEST {
            return st::Type::Unknown;
        }
        let members = members.iter().map(|one| {
            let spelled = member(&one.name);
            let ty = self.ty(&one.ty, &format!("{name}_{spelled}"), depth + 1);
            (one.name.clone(), spelled, ty)
        });
        let members = members.collect();
        let name = name.to_owned();
        st::Type::Structure(Rc::new(Structure { name, members }))
    }

    fn shape(&mut self, unit: &Unit, depth: usize) -> Rc<Shape> {
        let own = Scope::of(unit, self.library);
        let parameters = unit.variables.iter().filter_map(|variable| {
            let role = match variable.role {
                Role::Input => ParameterRole::Input,
                Role::Output => ParameterRole::Output,
                Role::InOut => ParameterRole::InOut,
                _ => return None,
            };
            let spelled = own.own(&variable.name)?.spelled.clone();
            let ty = self.ty(&variable.ty, &spelled, depth + 1);
            Some(Parameter {
                name: variable.name.clone(),
                spelled,
                role,
                ty,
                // A function must be given all of them.
                has_default: true,
            })
        });
        let parameters = parameters.collect();
        let result = own.own("ret_val").filter(|_| unit.kind == Kind::Function);
        let returns = result.map(|known| {
            let ty = self.ty(&known.ty, &known.spelled, depth + 1);
            (known.spelled.clone(), ty)
        });
        Rc::new(Shape {
            name: block_name(&unit.name)[1..].to_owned(),
            parameters,
            returns,
        })
    }
}
