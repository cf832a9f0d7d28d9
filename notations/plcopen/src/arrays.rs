//! Arrays that one unit hands to another. Compilers tell types apart by their names, so a project that is written has a type for each
//! of them. The reader puts the arrays back where these types are named.

use crate::model::{Project, Role, Type, TypeDeclaration, UnitKind, Variable};
use ladder_notation::LineColumn;

/// The remark on such a type.
const HANDED: &str = "an array that is handed to a block or is a global: both sides name one type";

/// Names the arrays that units hand each other: `fresh` makes a name that nothing has.
pub(crate) fn name_all(project: &mut Project, mut fresh: impl FnMut(&str) -> String) {
    let mut handed: Vec<Type> = Vec::new();
    for unit in &project.units {
        let is_called = unit.kind != UnitKind::Program;
        for variable in &unit.variables {
            let is_handed = match variable.role {
                Role::External => true,
                Role::Input | Role::Output | Role::InOut => is_called,
                _ => false,
            };
            let named = |name: &str| project.types.iter().find(|declared| declared.name == name);
            let ty = match &variable.ty {
                Type::Named(name) => named(name).map(|declared| &declared.ty),
                ty => Some(ty),
            };
            if let Some(ty @ Type::Array(..)) = ty.filter(|_| is_handed)
                && !handed.contains(ty)
            {
                handed.push(ty.clone());
            }
        }
    }
    for ty in handed {
        let mut known = project.types.iter().filter(|declared| declared.initial.is_none());
        let known = known
            .find(|declared| declared.ty == ty)
            .map(|declared| declared.name.clone());
        let name = known.clone().unwrap_or_else(|| fresh(&name_of(&ty)));
        each_variable(project, &mut |variable| {
            if variable.ty == ty {
                variable.ty = Type::Named(name.clone());
            }
        });
        if known.is_none() {
            project.types.push(TypeDeclaration {
                place: LineColumn::START,
                name,
                ty,
                initial: None,
                comment: Some(HANDED.to_owned()),
            });
        }
    }
}

/// Puts these arrays back where their types are named.
pub(crate) fn take_out(project: &mut Project) {
    let is_handed = |declared: &mut TypeDeclaration| {
        declared.comment.as_deref() == Some(HANDED) && declared.initial.is_none()
    };
    let handed: Vec<TypeDeclaration> = project.types.extract_if(.., is_handed).collect();
    for declared in handed {
        each_variable(project, &mut |variable| {
            if matches!(&variable.ty, Type::Named(name) if *name == declared.name) {
                variable.ty = declared.ty.clone();
            }
        });
        let title = format!("type {}", declared.name);
        project.report.translated(declared.place, title);
    }
}

/// `ARRAY_1_TO_3_OF_INT`
fn name_of(ty: &Type) -> String {
    match ty {
        Type::Array(bounds, element) => {
            let bounds: Vec<String> = bounds
                .iter()
                .map(|(first, last)| format!("{first}_TO_{last}"))
                .collect();
            format!("ARRAY_{}_OF_{}", bounds.join("_"), name_of(element))
        }
        Type::Named(name) => name.clone(),
        _ => "STRING".to_owned(),
    }
}

/// All variables of a project, with the members of its structures.
fn each_variable(project: &mut Project, change: &mut impl FnMut(&mut Variable)) {
    let members = project
        .types
        .iter_mut()
        .filter_map(|declared| match &mut declared.ty {
            Type::Structure(members) => Some(members),
            _ => None,
        });
    let of_units = project.units.iter_mut().map(|unit| &mut unit.variables);
    let all = of_units.chain(members).chain([&mut project.globals]);
    all.flatten().for_each(change);
}
