//! Routines in Structured Text.

use crate::scope::{Kind, Symbol};
use crate::sketch::Sketcher;
use crate::types::{Elem, Ty};
use crate::unit::Owner;
use ladder_analysis::values::types::Scalar;
use ladder_drawings::neutral::Instruction;
use ladder_format::program::{Item, Path};
use ladder_notation::{LineColumn, Lines};
use ladder_notation_st::read::{self as st, Dialect, Parameter, ParameterRole, Shape, Structure};
use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;

/// What is before the text of a line.
const SECTION: &str = "<![CDATA[";

impl Sketcher<'_> {
    /// The networks of a routine in Structured Text.
    ///
    /// # Errors
    ///
    /// Why it is not read.
    pub(crate) fn structured(&mut self, number: usize, text: &str) -> Result<Vec<Item>, String> {
        let unit = &self.units[number];
        let (scope_number, at) = (unit.scope, unit.routine.at);
        let scope = self.seen_in_text(scope_number);
        let what = match unit.owner {
            Owner::Program(_) => unit.routine.name.clone(),
            Owner::Aoi(aoi) => format!(
                "{} of {}",
                unit.routine.name, self.translator.project.aois[aoi].name
            ),
        };
        let mut names = self.translator.tags.names(scope_number);
        let mut unread = std::mem::take(&mut self.translator.unread);
        let start = self.place(at);
        self.translator.routine.clone_from(&unit.routine.name);
        let translator = RefCell::new(&mut self.translator);
        let instructions = |name: &str, operands: &[&str], text: &str, origin| {
            let mut translator = translator.borrow_mut();
            let it = Instruction {
                name,
                at: 0,
                operands: operands.to_vec(),
                text,
            };
            let made = translator.translate(scope_number, &it, origin);
            let after = std::mem::take(&mut translator.after);
            made.map(|made| std::iter::once(made.circuit).chain(after).collect())
        };
        let source = st::Source {
            text,
            dialect: Dialect::Logix,
            unit: &what,
            scope: &scope,
            restarted: &[],
            instructions: Some(&instructions),
            first_origin: self.reading.places.len() as u32,
            first_label: 0,
        };
        let lines = Lines::of(text);
        let line = |at| lines.place(text, at).line;
        let read = st::read_body(&source, &mut names, &mut unread, line);
        self.translator.unread = unread;
        let body = read?;
        let begins = self.begins_of_lines(at, text);
        let place = |at: usize| {
            let place = lines.place(text, at);
            let column = place.column.saturating_sub(1);
            match begins.get(place.line as usize - 1) {
                Some(begin) => LineColumn {
                    line: begin.line,
                    column: begin.column + column,
                },
                None => start,
            }
        };
        body.note(text, place, &mut self.reading);
        for tag in body.tags {
            let elem =
                Elem::named(&tag.ty).ok_or_else(|| format!("it needs a tag of the type {}", tag.ty))?;
            for name in tag.names {
                let made = self.translator.tags.helper(scope_number, &name, elem, "");
                if made != Path::tag(&name) {
                    return Err(format!("two tags that it needs have the name {name}"));
                }
            }
        }
        Ok(body.items)
    }

    /// Where the lines of a routine's text begin in the file.
    fn begins_of_lines(&self, at: usize, text: &str) -> Vec<LineColumn> {
        let rest = &self.text[at..];
        let rest = &rest[..rest.find("</Routine>").unwrap_or(rest.len())];
        let sections = rest
            .match_indices(SECTION)
            .map(|(found, _)| at + found + SECTION.len());
        sections
            .take(text.lines().count())
            .map(|begin| self.place(begin))
            .collect()
    }

    /// What names mean in a text.
    fn seen_in_text(&mut self, scope: usize) -> Rc<st::Scope> {
        let count = self.translator.tags.named;
        if let Some((at, seen)) = self.seen.get(&scope)
            && *at == count
        {
            return Rc::clone(seen);
        }
        let mut types = TypesOfText {
            sketcher: self,
            structures: HashMap::new(),
        };
        let mut seen = st::Scope::default();
        for symbol in self.translator.tags.seen(scope) {
            let ty = types.ty(&symbol.ty, 0);
            seen.tag(
                &symbol.original,
                Path::tag(symbol.name.clone()),
                ty,
                symbol.kind == Kind::Constant,
            );
        }
        let seen = Rc::new(seen);
        self.seen.insert(scope, (count, Rc::clone(&seen)));
        seen
    }
}

/// Types are made of others no deeper.
const DEEPEST: usize = 16;

struct TypesOfText<'t, 'p> {
    sketcher: &'t Sketcher<'p>,
    structures: HashMap<usize, st::Type>,
}

impl TypesOfText<'_, '_> {
    fn ty(&mut self, ty: &Ty, depth: usize) -> st::Type {
        let translator = &self.sketcher.translator;
        match ty {
            Ty::Elem(Elem::String(length)) => {
                st::Type::Scalar(Scalar::String(u16::try_from(*length).unwrap_or(u16::MAX)))
            }
            Ty::Elem(elem) => Scalar::from_name(&elem.text()).map_or(st::Type::Unknown, st::Type::Scalar),
            Ty::Array(of, dimensions) => {
                let bounds = dimensions
                    .iter()
                    .map(|size| ("0".to_owned(), size.saturating_sub(1).to_string()));
                st::Type::Array(bounds.collect(), Box::new(self.ty(of, depth + 1)))
            }
            Ty::Structure(index) if depth < DEEPEST => {
                if let Some(known) = self.structures.get(index) {
                    return known.clone();
                }
                let structure = &translator.tags.types.all[*index];
                let members = structure.members.iter().map(|field| {
                    (
                        field.original.clone(),
                        field.name.clone(),
                        self.ty(&field.ty, depth + 1),
                    )
                });
                let members = members.collect();
                let made = st::Type::Structure(Rc::new(Structure {
                    name: structure.name.clone(),
                    members,
                }));
                self.structures.insert(*index, made.clone());
                made
            }
            Ty::Structure(_) => st::Type::Unknown,
            Ty::Aoi(index) => {
                let project = translator.project;
                let scope = 1 + project.programs.len() + index;
                let role = |symbol: &Symbol| match symbol.kind {
                    Kind::Input => Some(ParameterRole::Input),
                    Kind::Output => Some(ParameterRole::Output),
                    _ => None,
                };
                let seen = translator.tags.seen(scope).into_iter();
                let parameters = seen.filter_map(|symbol| {
                    Some(Parameter {
                        name: symbol.original.clone(),
                        spelled: symbol.name.clone(),
                        role: role(symbol)?,
                        ty: self.ty(&symbol.ty, depth + 1),
                        has_default: true,
                    })
                });
                let parameters = parameters.collect();
                let name = translator.aoi_names[*index].trim_start_matches('$').to_owned();
                st::Type::Block(Rc::new(Shape {
                    name,
                    parameters,
                    returns: None,
                }))
            }
        }
    }
}
