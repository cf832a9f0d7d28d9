//! Declarations: types, variables, initial values.

use super::initial::{initial_text, zero};
use super::structured;
use crate::along;
use crate::expression::{address_of, bound, is_declared, type_text};
use crate::graph::Kind;
use crate::model::{Body, Project, Role, Type, Unit, UnitKind, Variable};
use crate::own;
use crate::scope::{Scope, Shared, local, member, trigger};
use crate::standard;
use ladder_analysis::values::types::Scalar;
use ladder_format::program::{Declaration, Item, Qualifier, Section, SectionKind};
use ladder_notation::address::is_as_wide;
use ladder_notation::{LineColumn, Reading};

/// Whether a variable of a type may lie at an address.
fn may_be_at(shared: &Shared<'_>, address: &str, ty: &Type) -> bool {
    let Type::Named(name) = shared.real(ty) else {
        return false;
    };
    let scalar = standard::elementary(name).and_then(Scalar::from_name);
    scalar.is_some_and(|ty| is_as_wide(address, ty))
}

/// Whether a variable is the instance of a block that neither the project nor ladder text has.
fn is_state_of_unknown(shared: &Shared<'_>, unit: &Unit, variable: &Variable) -> bool {
    let bodies = unit.parts.iter().map(|part| &part.body).chain([&unit.body]);
    let mut nodes = bodies.flat_map(|body| match body {
        Body::Graph(graph) => &graph.nodes[..],
        _ => &[],
    });
    type_text(shared, &variable.ty).is_err()
        && nodes.any(|node| {
            let is_own = |name: &String| name.eq_ignore_ascii_case(&variable.name);
            matches!(&node.kind, Kind::Block { instance, .. } if instance.as_ref().is_some_and(is_own))
        })
}

/// What a type is in its declaration, with what is inside of it. The names of members that are not there are added to `left_out`.
fn definition(
    shared: &Shared<'_>,
    ty: &Type,
    left_out: &mut Vec<(String, String)>,
) -> Result<String, String> {
    is_declared(shared, ty, 0)?;
    match ty {
        Type::Enumeration(values) if !values.is_empty() => {
            let values: Result<Vec<String>, String> = values
                .iter()
                .map(|(name, number)| match number {
                    Some(number) => Ok(format!("{} := {}", member(name), bound(shared, number)?)),
                    None => Ok(member(name)),
                })
                .collect();
            Ok(format!("({})", values?.join(", ")))
        }
        Type::Structure(members) if !members.is_empty() => {
            let mut out = String::from("STRUCT\n");
            for variable in members {
                let ty = match type_text(shared, &variable.ty) {
                    Ok(ty) => ty,
                    Err(why) => {
                        left_out.push((variable.name.clone(), why));
                        continue;
                    }
                };
                out.push_str(&format!("{} : {ty}", member(&variable.name)));
                if let Some(Ok(initial)) = variable
                    .initial
                    .as_ref()
                    .map(|it| initial_text(shared, &variable.ty, it))
                {
                    out.push_str(&format!(" := {initial}"));
                }
                out.push_str(";\n");
            }
            Ok(out + "END_STRUCT")
        }
        Type::Structure(_) | Type::Enumeration(_) => Err("it has no members".to_owned()),
        other => type_text(shared, other),
    }
}

/// What becomes of something that has no type here: what uses it is unread.
fn not_declared(why: &str) -> String {
    format!("{why}; it is not declared")
}

/// The types of the project.
pub(super) fn types(shared: &Shared<'_>, project: &Project, reading: &mut Reading) -> Vec<Item> {
    let mut section = Section::new(SectionKind::Type);
    for declared in &project.types {
        let shown = format!("type {}", declared.name);
        let known = shared.types.get(&declared.name.to_lowercase());
        let Some((spelled, _)) = known.filter(|(_, ty)| std::ptr::eq(*ty, &raw const declared.ty)) else {
            reading
                .report
                .refused(declared.place, shown, "another type has this name, and is read");
            continue;
        };
        let mut left_out = Vec::new();
        let ty = match definition(shared, &declared.ty, &mut left_out) {
            Ok(ty) => ty,
            Err(why) => {
                reading
                    .report
                    .approximated(declared.place, shown, not_declared(&why));
                continue;
            }
        };
        for (member, why) in left_out {
            let shown = format!("member {member} of {}", declared.name);
            reading
                .report
                .approximated(declared.place, shown, not_declared(&why));
        }
        let initial = declared
            .initial
            .as_ref()
            .map(|it| initial_text(shared, &declared.ty, it));
        let mut declaration = Declaration::new(spelled.clone(), ty);
        declaration.initial = initial.and_then(Result::ok);
        declaration.comment = with_first_name(&declared.name, spelled, declared.comment.as_deref());
        declaration.origin = Some(reading.origin(declared.place));
        renamed(reading, declared.place, shown, spelled, &declared.name);
        section.declarations.push(declaration);
    }
    if section.declarations.is_empty() {
        Vec::new()
    } else {
        vec![Item::Section(section)]
    }
}

/// An entry for what is declared, under another name or the same.
fn renamed(reading: &mut Reading, place: LineColumn, shown: String, spelled: &str, name: &str) {
    if spelled == name {
        reading.report.translated(place, shown);
    } else {
        reading
            .report
            .approximated(place, shown, format!("it is spelled `{spelled}` here"));
    }
}

fn with_first_name(name: &str, spelled: &str, comment: Option<&str>) -> Option<String> {
    let comment = comment.map(|comment| comment.split_whitespace().collect::<Vec<_>>().join(" "));
    let first = (name != spelled).then(|| format!("{name} in the project"));
    match (first, comment) {
        (Some(first), Some(comment)) => Some(format!("{first}: {comment}")),
        (first, comment) => first.or(comment),
    }
}

/// The globals.
pub(super) fn globals(shared: &Shared<'_>, project: &Project, reading: &mut Reading) -> Vec<Item> {
    let mut sections = Sections::default();
    let mut seen = std::collections::HashSet::new();
    for variable in &project.globals {
        if along::system(variable).is_some() {
            reading
                .report
                .translated(variable.place, format!("variable {}", variable.name));
            continue;
        }
        if !seen.insert(variable.name.to_lowercase()) {
            let why = "another global has this name, and is read";
            reading
                .report
                .refused(variable.place, format!("variable {}", variable.name), why);
            continue;
        }
        sections.variable(
            shared,
            &shared.globals,
            variable,
            SectionKind::VarGlobal,
            false,
            reading,
        );
    }
    sections.items()
}

/// The variables of a unit. `reads` says whether a tag is read by name: an edge detector becomes one only then.
pub(super) fn variables(
    shared: &Shared<'_>,
    project: &Project,
    unit: &Unit,
    scope: &Scope,
    is_needed: impl Fn(&str) -> bool,
    reading: &mut Reading,
) -> Sections {
    let mut sections = Sections::default();
    let is_program = unit.kind == UnitKind::Program;
    // A text sets them at the start of each call.
    let begins_again = structured::text(unit).is_some();
    let mut seen = std::collections::HashSet::new();
    for variable in &unit.variables {
        let shown = format!("variable {}", variable.name);
        if variable.role == Role::External {
            let is_there = project
                .globals
                .iter()
                .any(|global| global.name.eq_ignore_ascii_case(&variable.name));
            if is_there {
                reading.report.translated(variable.place, shown);
            } else {
                let why = not_declared("the project has no global of this name");
                reading.report.approximated(variable.place, shown, why);
            }
            continue;
        }
        if !seen.insert(variable.name.to_lowercase()) {
            reading.report.refused(
                variable.place,
                shown,
                "another variable has this name, and is read",
            );
            continue;
        }
        let is_power = ["EN", "ENO"]
            .iter()
            .any(|name| variable.name.eq_ignore_ascii_case(name))
            || own::power(variable).is_some();
        if !is_program && is_power {
            reading.report.translated(variable.place, shown);
            continue;
        }
        let spelled = scope.get(&variable.name).map_or("", |known| &known.path.root);
        if trigger(&variable.ty).is_some() {
            reading.report.translated(variable.place, shown);
            if is_needed(spelled) {
                let comment = format!("the output of {}", variable.name);
                sections.helper(spelled, "BOOL", &comment, Some(reading.origin(variable.place)));
            }
            continue;
        }
        if is_state_of_unknown(shared, unit, variable) && !is_needed(spelled) {
            let why = "it holds the state of a block that is not read, and is left out with that";
            reading.report.approximated(variable.place, shown, why);
            continue;
        }
        let kind = match variable.role {
            Role::Input => SectionKind::VarInput,
            Role::Output => SectionKind::VarOutput,
            Role::InOut if !is_program => SectionKind::VarInOut,
            _ => SectionKind::Var,
        };
        if variable.role == Role::Temp && !begins_again {
            let why = "it keeps its value from one scan to the next here";
            reading.report.approximated(variable.place, &shown, why);
        }
        sections.variable(shared, scope, variable, kind, !is_program, reading);
    }
    if let Some(returns) = &unit.returns {
        let spelled = scope
            .get(&unit.name)
            .map_or(unit.name.as_str(), |known| &known.path.root);
        match type_text(shared, returns) {
            Ok(ty) => {
                let mut declaration = Declaration::new(spelled, ty);
                declaration.comment = Some("what the function returns".to_owned());
                sections.push(SectionKind::VarOutput, None, declaration);
            }
            Err(why) => reading.report.approximated(
                unit.place,
                format!("result of {}", unit.name),
                not_declared(&why),
            ),
        }
    }
    let has_state = local(unit).any(|variable| matches!(variable.role, Role::Local | Role::Temp));
    if unit.kind == UnitKind::Function && has_state && !begins_again {
        let why = "its own variables keep their values from one call to the next here";
        reading
            .report
            .approximated(unit.place, format!("function {}", unit.name), why);
    }
    sections
}

/// Sections with what was declared so far.
#[derive(Default)]
pub(super) struct Sections {
    sections: Vec<Section>,
}

impl Sections {
    pub(super) fn items(self) -> Vec<Item> {
        self.sections.into_iter().map(Item::Section).collect()
    }

    /// A tag that the source does not have.
    pub(super) fn helper(&mut self, name: &str, ty: &str, comment: &str, origin: Option<u32>) {
        let mut declaration = Declaration::new(name, ty);
        declaration.comment = (!comment.is_empty()).then(|| comment.to_owned());
        declaration.origin = origin;
        self.push(SectionKind::Var, None, declaration);
    }

    /// A tag that the source does not have, as it is to be declared.
    pub(super) fn declared(&mut self, declaration: Declaration) {
        self.push(SectionKind::Var, None, declaration);
    }

    fn push(&mut self, kind: SectionKind, qualifier: Option<Qualifier>, declaration: Declaration) {
        let same = |section: &&mut Section| section.kind == kind && section.qualifier == qualifier;
        match self.sections.iter_mut().find(same) {
            Some(section) => section.declarations.push(declaration),
            None => self.sections.push(Section {
                kind,
                qualifier,
                declarations: vec![declaration],
            }),
        }
    }

    fn variable(
        &mut self,
        shared: &Shared<'_>,
        scope: &Scope,
        variable: &Variable,
        mut kind: SectionKind,
        is_block: bool,
        reading: &mut Reading,
    ) {
        let shown = format!("variable {}", variable.name);
        let Some(known) = scope.get(&variable.name) else {
            return;
        };
        let ty = match &variable.ty {
            // What is declared where it is used has no name.
            Type::Enumeration(_) | Type::Structure(_) => {
                Err("a variable's type has a name here: declare it first".to_owned())
            }
            ty => type_text(shared, ty),
        };
        let ty = match ty {
            Ok(ty) => ty,
            Err(why) => {
                reading
                    .report
                    .approximated(variable.place, shown, not_declared(&why));
                return;
            }
        };
        let mut declaration = Declaration::new(known.path.root.clone(), ty);
        let mut comment = variable.comment.clone();
        let mut note = |reading: &mut Reading, told: String, why: &str| {
            reading
                .report
                .approximated(variable.place, format!("{shown} {told}"), why);
            let before = comment
                .take()
                .map(|comment| format!("{comment}; "))
                .unwrap_or_default();
            comment = Some(format!("{before}{told} in the project"));
        };
        if let Some(address) = &variable.address {
            let is_one =
                |address: &String| kind != SectionKind::VarInOut && may_be_at(shared, address, &variable.ty);
            declaration.address = address_of(address).filter(is_one);
            if declaration.address.is_none() && shared.several.contains(&address.to_ascii_uppercase()) {
                let why = not_declared(&format!("another variable is at `{address}`, too"));
                reading.report.approximated(variable.place, shown, why);
                return;
            }
            if declaration.address.is_none() {
                // What comes from outside is an input.
                let is_input = address.to_ascii_uppercase().starts_with("%I");
                if kind == SectionKind::Var && !is_block && is_input {
                    kind = SectionKind::VarInput;
                }
                note(
                    reading,
                    format!("AT {address}"),
                    "there is no such address here: the tag has none",
                );
            }
        }
        match variable
            .initial
            .as_ref()
            .map(|it| initial_text(shared, &variable.ty, it))
        {
            Some(Ok(initial)) if kind != SectionKind::VarInOut => declaration.initial = Some(initial),
            Some(Err(why)) => note(reading, "an initial value".to_owned(), &why),
            _ => {}
        }
        // An input of a block may be left out where it is called, if it has a value of its own.
        if kind == SectionKind::VarInput && is_block && declaration.initial.is_none() {
            let zero = zero(shared, &variable.ty);
            declaration.initial = zero.map(|zero| zero.as_str().to_owned());
        }
        declaration.comment = with_first_name(&variable.name, &known.path.root, comment.as_deref());
        declaration.origin = Some(reading.origin(variable.place));
        renamed(
            reading,
            variable.place,
            shown.clone(),
            &known.path.root,
            &variable.name,
        );
        let qualifier = variable.qualifier.filter(|_| kind != SectionKind::VarInOut);
        self.push(kind, qualifier, declaration);
    }
}
