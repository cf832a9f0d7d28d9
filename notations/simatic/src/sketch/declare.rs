//! Declarations: sections of variables, and the types that they need.

use super::Sketcher;
use crate::model::{Kind, Role, Type, Unit, Variable};
use crate::operand::literal;
use crate::scope::{Scope, block_name, member};
use crate::standard::{elementary, state_type, trigger};
use ladder_format::program::{Declaration, Item, Qualifier, Section, SectionKind, comment_on_line};
use ladder_notation::LineColumn;

/// Sections with what was declared so far.
#[derive(Default)]
pub(super) struct Sections(Vec<Section>);

impl Sections {
    pub(super) fn push(&mut self, kind: SectionKind, qualifier: Option<Qualifier>, declaration: Declaration) {
        let same = |section: &&mut Section| section.kind == kind && section.qualifier == qualifier;
        if let Some(section) = self.0.iter_mut().find(same) {
            section.declarations.push(declaration);
            return;
        }
        self.0.push(Section {
            kind,
            qualifier,
            declarations: vec![declaration],
        });
    }

    pub(super) fn items(self) -> Vec<Item> {
        self.0.into_iter().map(Item::Section).collect()
    }
}

impl Sketcher<'_> {
    /// The variables of a block. `is_memory` says of which no one needs to know: the bits that remember an edge.
    pub(super) fn variables(
        &mut self,
        unit: &Unit,
        scope: &Scope<'_>,
        is_block: bool,
        is_memory: impl Fn(&str) -> bool,
    ) -> Sections {
        let mut sections = Sections::default();
        for variable in &unit.variables {
            let shown = format!("variable {}", variable.name);
            let local = matches!(variable.role, Role::Static | Role::Temp);
            if local && is_memory(&variable.name) {
                self.reading.report.translated(variable.place, shown);
                continue;
            }
            let Some(known) = scope.own(&variable.name) else {
                continue;
            };
            let kind = match variable.role {
                Role::Input => SectionKind::VarInput,
                Role::Output => SectionKind::VarOutput,
                Role::InOut if is_block => SectionKind::VarInOut,
                _ => SectionKind::Var,
            };
            let qualifier = match variable.role {
                Role::Constant => Some(Qualifier::Constant),
                _ if variable.retain => Some(Qualifier::Retain),
                _ => None,
            };
            let spelled = known.spelled.clone();
            if let Some(declaration) = self.declaration(variable, &spelled) {
                sections.push(kind, qualifier, declaration);
                let why = match variable.role {
                    Role::Temp => Some("it keeps its value from one scan to the next here"),
                    _ => None,
                };
                self.declared(variable.place, shown, &spelled, &variable.name, why);
            }
        }
        if let (Some(returns), Kind::Function) = (&unit.returns, unit.kind) {
            let result = Variable {
                place: unit.place,
                name: unit.name.clone(),
                ty: returns.clone(),
                comment: Some("what the function returns".to_owned()),
                ..Variable::default()
            };
            let spelled = scope.own("ret_val").map(|known| known.spelled.clone());
            let spelled = spelled.unwrap_or_default();
            if let Some(declaration) = self.declaration(&result, &spelled) {
                sections.push(SectionKind::VarOutput, None, declaration);
            }
        }
        for (name, ty, what) in &scope.helpers {
            let mut declaration = Declaration::new(name.clone(), ty.clone());
            declaration.comment = Some(what.clone()).filter(|what| !what.is_empty());
            sections.push(SectionKind::Var, None, declaration);
        }
        sections
    }

    /// What is used of the rest of the project.
    pub(super) fn globals(&mut self, scope: &Scope<'_>, sections: &mut Sections) {
        for (path, known) in scope.globals.values() {
            let ty = match self.type_text(&known.ty, &known.spelled) {
                Ok(ty) => ty,
                Err(why) => {
                    self.reading
                        .report
                        .refused(LineColumn::START, format!("tag {path}"), why);
                    continue;
                }
            };
            let mut declaration = Declaration::new(known.spelled.clone(), ty);
            let unit = scope.unit(path).filter(|unit| unit.kind.is_tag());
            if unit.is_none() {
                let why =
                    "another file of the project declares it: its type is the one that its place asks for";
                self.reading
                    .report
                    .approximated(LineColumn::START, format!("tag {path}"), why);
            }
            if !known.spelled.eq_ignore_ascii_case(path) {
                declaration.comment = Some(format!("{path} in the project"));
            }
            if let Some(constant) = unit.and_then(Unit::constant) {
                declaration.initial = constant.initial.as_deref().and_then(initial_text);
                sections.push(SectionKind::Var, Some(Qualifier::Constant), declaration);
                continue;
            }
            sections.push(SectionKind::VarGlobal, None, declaration);
        }
    }

    fn declared(&mut self, place: LineColumn, shown: String, spelled: &str, name: &str, why: Option<&str>) {
        let report = &mut self.reading.report;
        match why {
            _ if spelled != name => {
                report.approximated(place, shown, format!("it is spelled `{spelled}` here"));
            }
            Some(why) => report.approximated(place, shown, why),
            None => report.translated(place, shown),
        }
    }

    fn declaration(&mut self, variable: &Variable, spelled: &str) -> Option<Declaration> {
        let shown = || format!("variable {}", variable.name);
        let ty = match self.type_text(&variable.ty, spelled) {
            Ok(ty) => ty,
            Err(why) => {
                self.reading.report.approximated(
                    variable.place,
                    shown(),
                    format!("it is not declared here: {why}"),
                );
                return None;
            }
        };
        let mut declaration = Declaration::new(spelled, ty);
        declaration.comment = with_first_name(&variable.name, spelled, variable.comment.as_deref());
        declaration.origin = Some(self.reading.origin(variable.place));
        if let Some(initial) = &variable.initial {
            declaration.initial = initial_text(initial);
            if declaration.initial.is_none() {
                let why = format!("its initial value `{initial}` is left out: it has no counterpart");
                self.reading.report.approximated(variable.place, shown(), why);
            }
        }
        Some(declaration)
    }

    /// A type as it is written here. `like` names a structure that has no name of its own.
    ///
    /// # Errors
    ///
    /// Why it has no counterpart.
    pub(super) fn type_text(&mut self, ty: &Type, like: &str) -> Result<String, String> {
        match ty {
            Type::Text(None) => Ok("STRING".to_owned()),
            Type::Text(Some(length)) => Ok(format!("STRING[{length}]")),
            Type::Array(bounds, of) => {
                let is_number = |bound: &String| bound.parse::<i64>().is_ok();
                if bounds.is_empty() || bounds.len() > 3 {
                    return Err("an array has one to three dimensions here".to_owned());
                }
                if let Some((low, high)) = bounds
                    .iter()
                    .find(|(low, high)| !is_number(low) || !is_number(high))
                {
                    return Err(format!("the bounds `{low}..{high}` of an array are no numbers"));
                }
                let bounds: Vec<String> = bounds
                    .iter()
                    .map(|(low, high)| format!("{low}..{high}"))
                    .collect();
                let of = self.type_text(of, like)?;
                if of.starts_with("ARRAY") {
                    return Err("an array of arrays is one of several dimensions here".to_owned());
                }
                Ok(format!("ARRAY[{}] OF {of}", bounds.join(", ")))
            }
            Type::Structure(members) => self.structure(&format!("{like}_type"), members, None),
            Type::Named(name) => {
                if let Some(known) = elementary(name).or_else(|| state_type(name)) {
                    return Ok(known.to_owned());
                }
                // It holds the output of the edge detector.
                if trigger(name).is_some() {
                    return Ok("BOOL".to_owned());
                }
                match self.library.get(&name.to_lowercase()) {
                    Some(Ok(unit)) => match unit.kind {
                        Kind::Type => self.structure(name, &unit.variables, Some(name)),
                        Kind::Data => self.structure(&format!("{name}_type"), &unit.variables, Some(name)),
                        Kind::FunctionBlock => {
                            self.needed.push(name.clone());
                            Ok(block_name(name))
                        }
                        _ => Err(format!("`{name}` is no type")),
                    },
                    Some(Err(why)) => Err(format!("the type `{name}` cannot be read: {why}")),
                    None => Err(format!(
                        "the type `{name}` is declared in no file of the project (the folder that is converted or opened, or one above with a ladder.toml)"
                    )),
                }
            }
        }
    }

    /// A structure, which is declared under a name.
    fn structure(
        &mut self,
        like: &str,
        members: &[Variable],
        original: Option<&str>,
    ) -> Result<String, String> {
        if let Some(known) = original.and_then(|name| self.types.get(&name.to_lowercase())) {
            return known
                .clone()
                .ok_or_else(|| format!("the type `{like}` contains itself, or has no counterpart"));
        }
        let spelled = self.type_names.fresh(like);
        if let Some(name) = original {
            self.types.insert(name.to_lowercase(), None);
        }
        if members.is_empty() {
            return Err(format!("the type `{like}` has no members"));
        }
        let mut text = String::from("STRUCT\n");
        for variable in members {
            let name = member(&variable.name);
            let ty = self
                .type_text(&variable.ty, &format!("{spelled}_{name}"))
                .map_err(|why| format!("member `{}`: {why}", variable.name))?;
            text.push_str(&format!("{name} : {ty}"));
            if let Some(initial) = variable.initial.as_deref().and_then(initial_text) {
                text.push_str(&format!(" := {initial}"));
            }
            let comment = with_first_name(&variable.name, &name, variable.comment.as_deref());
            let comment = comment.map(|told| format!("  {}", comment_on_line(&told)));
            text.push_str(&format!(";{}\n", comment.unwrap_or_default()));
        }
        let mut declaration = Declaration::new(spelled.clone(), text + "END_STRUCT");
        declaration.comment = original.and_then(|name| with_first_name(name, &spelled, None));
        self.type_section.declarations.push(declaration);
        if let Some(name) = original {
            self.types.insert(name.to_lowercase(), Some(spelled.clone()));
        }
        Ok(spelled)
    }
}

fn with_first_name(name: &str, spelled: &str, comment: Option<&str>) -> Option<String> {
    let first = (name != spelled).then(|| format!("{name} in the project"));
    match (first, comment) {
        (Some(first), Some(comment)) => Some(format!("{first}: {comment}")),
        (first, comment) => first.or(comment.map(str::to_owned)),
    }
}

/// An initial value: a literal, or those of an array.
fn initial_text(text: &str) -> Option<String> {
    let text = text.trim();
    if let Some(inner) = text.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) {
        let values = inner.split(',').map(|value| {
            let value = value.trim();
            match value.strip_suffix(')').and_then(|rest| rest.split_once('(')) {
                Some((count, value)) => {
                    let count: u32 = count.trim().parse().ok()?;
                    Some(format!("{count}({})", literal_text(value.trim())?))
                }
                None => literal_text(value),
            }
        });
        let values: Option<Vec<String>> = values.collect();
        return values.map(|values| format!("[{}]", values.join(", ")));
    }
    literal_text(text)
}

fn literal_text(text: &str) -> Option<String> {
    Some(literal(text)?.ok()?.value.to_string())
}
