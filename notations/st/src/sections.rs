//! Variables in their sections, and the configuration that runs the program.

use crate::comment;
use crate::literal;
use crate::names;
use crate::project::declare::Variable;
use crate::project::{Project, UnitKind};
use crate::unit::{Local, Variables};
use ladder_analysis::program::{ParameterKind, Role};
use std::collections::BTreeMap;

/// A unit that is written, but for its declarations.
pub(crate) struct Body {
    pub(crate) kind: UnitKind,
    /// What gives variables the values that they begin with.
    pub(crate) first: Vec<String>,
    pub(crate) lines: Vec<String>,
    /// Of the program: the tags that others use, too.
    pub(crate) shared: BTreeMap<String, String>,
    pub(crate) declared: Variables,
}

pub(crate) fn section(head: &str, variables: &[Local], out: &mut String) {
    if variables.is_empty() {
        return;
    }
    out.push_str(head);
    out.push('\n');
    for Local { name, ty } in variables {
        out.push_str(&format!("    {name} : {ty};\n"));
    }
    out.push_str("END_VAR\n");
}

pub(crate) fn own_variables(body: &Body, out: &mut String) {
    section("VAR RETAIN", &body.declared.retained, out);
    section("VAR", &body.declared.instances, out);
    section("VAR", &body.declared.temporaries, out);
}

/// A declaration with what it starts with, its address and its comment.
fn declaration(project: &Project<'_>, variable: &Variable<'_>, name: &str, with_address: bool) -> String {
    let mut line = String::new();
    let is_own = variable.tag.location.file == 0;
    let at = variable.tag.location.range.start();
    let above = if is_own && !variable.is_part() {
        comment::above(project.source.parse, project.source.text, at)
    } else {
        Vec::new()
    };
    for told in above {
        line.push_str(&format!("    {}\n", comment::comment(&told)));
    }
    line.push_str(&format!("    {name}"));
    if let Some(address) = variable.tag.address.as_ref().filter(|_| with_address) {
        line.push_str(&format!(" AT {address}"));
    }
    line.push_str(&format!(" : {}", project.type_of_variable(variable)));
    if let Some(value) = project.initial(variable) {
        line.push_str(&format!(" := {value}"));
    }
    line.push(';');
    let mut told = Vec::new();
    if !name.eq_ignore_ascii_case(variable.root) {
        told.push(format!("called {}", variable.root));
    }
    if is_own {
        told.extend(comment::of_line(project.source.parse, at));
    }
    if !told.is_empty() {
        line.push_str(&format!("  {}", comment::comment(&told.join("; "))));
    }
    line.push('\n');
    line
}

pub(crate) fn program_variables(
    project: &Project<'_>,
    body: &Body,
    shared: &BTreeMap<&String, &String>,
    out: &mut String,
) {
    let mut sections: BTreeMap<(u8, &str), String> = BTreeMap::new();
    for variable in project.variables(None) {
        let Some(name) = body.declared.of_tags.get(variable.root) else {
            continue;
        };
        if shared.contains_key(name) && project.is_shared(variable.root) && !project.is_passed(variable.root)
        {
            continue;
        }
        let head = head(&variable);
        sections
            .entry(head)
            .or_default()
            .push_str(&declaration(project, &variable, name, true));
    }
    for ((_, head), text) in sections {
        out.push_str(&format!("{head}\n{text}END_VAR\n"));
    }
}

/// The section that a tag of the program belongs to. One at an address is neither input nor output, as the address says it, and
/// is apart from those without.
fn head(variable: &Variable<'_>) -> (u8, &'static str) {
    let tag = variable.tag;
    match (tag.address.is_some(), tag.role, tag.retain, tag.constant) {
        (true, _, _, true) => (9, "VAR CONSTANT"),
        (true, _, true, _) => (8, "VAR RETAIN"),
        (true, ..) => (7, "VAR"),
        (_, _, _, true) => (6, "VAR CONSTANT"),
        (_, Role::Input, false, _) => (0, "VAR_INPUT"),
        (_, Role::Output, false, _) => (1, "VAR_OUTPUT"),
        (_, Role::Input, true, _) => (2, "VAR_INPUT RETAIN"),
        (_, Role::Output, true, _) => (3, "VAR_OUTPUT RETAIN"),
        (_, _, true, _) => (5, "VAR RETAIN"),
        _ => (4, "VAR"),
    }
}

pub(crate) fn block_variables(project: &Project<'_>, block: usize, body: &Body, out: &mut String) {
    let program = project.source.program;
    let user = &program.blocks[block];
    let variables = project.variables(Some(block));
    let of = |kind: ParameterKind| {
        let mut text = String::new();
        for (tag, own) in &user.parameters {
            let root = project.root(*tag);
            if *own == kind
                && let Some(variable) = variables.iter().find(|variable| variable.root == root)
            {
                text.push_str(&declaration(project, variable, &names::member(root), false));
            }
        }
        text
    };
    out.push_str(&format!(
        "VAR_INPUT\n    power_in : BOOL;\n{}END_VAR\n",
        of(ParameterKind::Input)
    ));
    out.push_str(&format!(
        "VAR_OUTPUT\n    power_out : BOOL;\n{}END_VAR\n",
        of(ParameterKind::Output)
    ));
    let in_outs = of(ParameterKind::InOut) + &passed(project, UnitKind::Block(block));
    if !in_outs.is_empty() {
        out.push_str(&format!("VAR_IN_OUT\n{in_outs}END_VAR\n"));
    }
    let mut sections: BTreeMap<&str, String> = BTreeMap::new();
    for variable in &variables {
        let Some(name) = body.declared.of_tags.get(variable.root) else {
            continue;
        };
        let head = match (variable.tag.constant, variable.tag.retain) {
            (true, _) => "VAR CONSTANT",
            (_, true) => "VAR RETAIN",
            _ => "VAR",
        };
        sections
            .entry(head)
            .or_default()
            .push_str(&declaration(project, variable, name, false));
    }
    for (head, text) in sections {
        out.push_str(&format!("{head}\n{text}END_VAR\n"));
    }
}

/// The parameters of a unit for variables of the program that it uses: arrays, structures and enumerations.
pub(crate) fn passed(project: &Project<'_>, unit: UnitKind) -> String {
    let line = |root: &String| {
        let ty = project.declared_type(None, root).map(|ty| project.type_name(ty));
        format!(
            "    {} : {};\n",
            project.name_of_shared(root),
            ty.unwrap_or_default()
        )
    };
    project.passed(unit).iter().map(line).collect()
}

/// What a unit uses of the configuration. Constants there are constants in the unit, too.
pub(crate) fn externals(project: &Project<'_>, all: Vec<Local>, out: &mut String) {
    let variables = project.variables(None);
    let is_constant = |local: &Local| {
        let root = project.shared_root(&local.name);
        root.is_some_and(|root| variables.iter().any(|it| it.root == root && it.tag.constant))
    };
    let (constants, others): (Vec<_>, Vec<_>) = all.into_iter().partition(is_constant);
    section("VAR_EXTERNAL", &others, out);
    section("VAR_EXTERNAL CONSTANT", &constants, out);
}

/// What units share, and the program that runs.
pub(crate) fn configuration(
    project: &Project<'_>,
    program: &str,
    shared: &BTreeMap<&String, &String>,
    out: &mut String,
) {
    let mut sections: BTreeMap<&str, String> = BTreeMap::new();
    let variables = project.variables(None);
    for (name, ty) in shared {
        let root = project.shared_root(name);
        let variable = root.and_then(|root| variables.iter().find(|variable| variable.root == root));
        match variable {
            Some(variable) => {
                let head = match (variable.tag.constant, variable.tag.retain) {
                    (true, _) => "VAR_GLOBAL CONSTANT",
                    (_, true) => "VAR_GLOBAL RETAIN",
                    _ => "VAR_GLOBAL",
                };
                sections
                    .entry(head)
                    .or_default()
                    .push_str(&declaration(project, variable, name, true));
            }
            None => sections
                .entry("VAR_GLOBAL")
                .or_default()
                .push_str(&format!("    {name} : {ty};\n")),
        }
    }
    out.push_str("\nCONFIGURATION config\n");
    for (head, text) in sections {
        out.push_str(&format!("{head}\n{text}END_VAR\n"));
    }
    out.push_str(&format!(
        "RESOURCE plc ON PLC\n    TASK scan_task(INTERVAL := {}, PRIORITY := 0);\n    PROGRAM main_program WITH scan_task : {program};\n\
         END_RESOURCE\nEND_CONFIGURATION\n",
        literal::duration(project.source.cycle)
    ));
}
