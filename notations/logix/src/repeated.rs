//! Things of one name: a controller takes none of them but the first.

use crate::model::{Project, Tag};
use std::collections::HashSet;

/// What has the name of another one of its sort is refused, and goes.
pub(crate) fn refuse_repeated(project: &mut Project) {
    let mut refused = Vec::new();
    let mut types: HashSet<String> = HashSet::new();
    project.types.retain_mut(|ty| {
        let mut members = HashSet::new();
        let owner = format!(" of type {}", ty.name);
        ty.members.retain(|member| {
            first(&mut members, &mut refused, ty.at, &member.name, || {
                format!("member {}{owner}", member.name)
            })
        });
        first(&mut types, &mut refused, ty.at, &ty.name, || {
            format!("type {}", ty.name)
        })
    });
    project.aois.retain_mut(|aoi| {
        let mut tags = HashSet::new();
        let owner = format!(" of Add-On Instruction {}", aoi.name);
        aoi.parameters
            .retain(|tag| first_tag(&mut tags, &mut refused, tag, &owner));
        aoi.locals
            .retain(|tag| first_tag(&mut tags, &mut refused, tag, &owner));
        let mut routines = HashSet::new();
        aoi.routines.retain(|routine| {
            first(&mut routines, &mut refused, routine.at, &routine.name, || {
                format!("routine {}{owner}", routine.name)
            })
        });
        // They share their names with types.
        first(&mut types, &mut refused, aoi.at, &aoi.name, || {
            format!("Add-On Instruction {}", aoi.name)
        })
    });
    let mut tags = HashSet::new();
    project
        .tags
        .retain(|tag| first_tag(&mut tags, &mut refused, tag, ""));
    let mut programs = HashSet::new();
    project.programs.retain_mut(|program| {
        let mut tags = HashSet::new();
        let owner = format!(" of program {}", program.name);
        program
            .tags
            .retain(|tag| first_tag(&mut tags, &mut refused, tag, &owner));
        let mut routines = HashSet::new();
        program.routines.retain(|routine| {
            first(&mut routines, &mut refused, routine.at, &routine.name, || {
                format!("routine {}{owner}", routine.name)
            })
        });
        first(&mut programs, &mut refused, program.at, &program.name, || {
            format!("program {}", program.name)
        })
    });
    project.refused.extend(refused);
}

/// Whether a name is the first of its kind; one that is not is refused.
fn first(
    names: &mut HashSet<String>,
    refused: &mut Vec<(usize, String, String)>,
    at: usize,
    name: &str,
    what: impl Fn() -> String,
) -> bool {
    let is_first = names.insert(name.to_ascii_uppercase());
    if !is_first {
        refused.push((
            at,
            what(),
            "there is another one of that name before it".to_owned(),
        ));
    }
    is_first
}

fn first_tag(
    names: &mut HashSet<String>,
    refused: &mut Vec<(usize, String, String)>,
    tag: &Tag,
    owner: &str,
) -> bool {
    first(names, refused, tag.at, &tag.name, || {
        format!("tag {}{owner}", tag.name)
    })
}
