//! Timers, counters, blocks and structures that functions share. A function is a function block in a project, and compilers hand no
//! instance to one: what it is handed in ladder text is a global there. The reader hands it on again.

use crate::graph::{End, Graph, Kind, Node, Output, Pin};
use crate::model::{Body, Project, Role, Unit, UnitKind, Variable};
use ladder_notation::LineColumn;
use std::collections::HashSet;

/// What the remark on such a global begins with. The comment on the tag follows.
const SHARED: &str = "handed to functions in ladder text.";

/// Makes globals of the variables of the last unit, the program, that have these names.
pub(crate) fn move_out(project: &mut Project, names: &HashSet<String>) {
    let Some(program) = project.units.last_mut() else {
        return;
    };
    for variable in &mut program.variables {
        if variable.role != Role::External && names.contains(&variable.name) {
            let told = variable.comment.take().unwrap_or_default();
            project.globals.push(Variable {
                role: Role::Global,
                comment: Some(format!("{SHARED} {told}").trim_end().to_owned()),
                ..variable.clone()
            });
            *variable = external(&variable.name, variable);
        }
    }
}

/// Makes tags of the program of these globals again, which calls hand on.
pub(crate) fn take_out(project: &mut Project) {
    let is_shared = |global: &mut Variable| {
        global
            .comment
            .as_deref()
            .is_some_and(|told| told.starts_with(SHARED))
    };
    let shared: Vec<Variable> = project.globals.extract_if(.., is_shared).collect();
    for mut global in shared {
        let told = global.comment.take().unwrap_or_default();
        global.comment = Some(told[SHARED.len()..].trim_start().to_owned()).filter(|told| !told.is_empty());
        let mut users = HashSet::new();
        for unit in &mut project.units {
            let is_program = unit.kind == UnitKind::Program;
            let mut variables = unit.variables.iter_mut();
            let Some(variable) = variables.find(|it| it.role == Role::External && it.name == global.name)
            else {
                continue;
            };
            if is_program {
                *variable = Variable {
                    role: Role::Local,
                    ..global.clone()
                };
            } else {
                variable.role = Role::InOut;
                users.insert(unit.name.clone());
            }
        }
        for unit in &mut project.units {
            hand_on(unit, &users, &global.name);
        }
    }
}

/// Hands a variable to each of these blocks where it is called.
fn hand_on(unit: &mut Unit, blocks: &HashSet<String>, variable: &str) {
    let Body::Graph(Graph { nodes, .. }) = &mut unit.body else {
        return;
    };
    for call in 0..nodes.len() {
        if !matches!(&nodes[call].kind, Kind::Block { name, .. } if blocks.contains(name)) {
            continue;
        }
        let value = Node::new(
            nodes[call].place,
            Kind::Value(variable.to_owned(), false),
            Vec::new(),
        );
        let (node, position) = (nodes.len(), nodes[call].position);
        nodes.push(Node { position, ..value });
        nodes[call].inputs.push(Pin {
            name: variable.to_owned(),
            from: vec![End { node, output: 0 }],
            in_out: true,
            ..Pin::default()
        });
        nodes[call].outputs.push(Output {
            name: variable.to_owned(),
            negated: false,
        });
    }
}

fn external(name: &str, like: &Variable) -> Variable {
    Variable {
        role: Role::External,
        ..Variable::local(LineColumn::START, name.to_owned(), like.ty.clone())
    }
}
